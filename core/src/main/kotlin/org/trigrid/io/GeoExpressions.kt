package org.trigrid.io

/** Arithmetic of a `.geo` script: + - * / % ^, brackets, functions of one or two numbers, variables. */
internal class GeoExpressions(
    private val tokens: GeoTokens,
    /** Values of names that Gmsh gives itself, such as `newp`; null for others. */
    private val given: (String) -> Double? = { null },
) {
    private val variables = HashMap<String, Double>()
    private var depth = 0

    fun define(name: String, value: Double) {
        variables[name] = value
    }

    fun valueOf(name: String): Double? = variables[name]

    fun number(): Double {
        if (++depth > MAX_DEPTH) tokens.fail("more than $MAX_DEPTH brackets in one another")
        var sum = product()
        while (true) {
            if (tokens.takeIf("+")) sum += product() else if (tokens.takeIf("-")) sum -= product() else break
        }
        depth--
        return sum
    }

    fun whole(what: String): Int {
        val place = tokens.start
        val value = number()
        val whole = value.toInt()
        if (whole.toDouble() != value) tokens.failAt(place, "$what must be a whole number, not $value")
        return whole
    }

    /** `{a, b:c, b:c:d, …}` */
    fun list(): List<Double> {
        tokens.expect("{")
        val values = ArrayList<Double>()
        if (tokens.takeIf("}")) return values
        do {
            val place = tokens.start
            val from = number()
            if (!tokens.takeIf(":")) {
                values.add(from)
                continue
            }
            val to = number()
            val step = if (tokens.takeIf(":")) number() else if (to < from) -1.0 else 1.0
            val count = Math.floor((to - from) / step + ROUNDING) + 1
            if (!(count >= 1 && count <= MOST)) tokens.failAt(place, "the range from $from to $to by $step is empty or too long")
            for (i in 0 until count.toInt()) values.add(from + i * step)
        } while (tokens.takeIf(","))
        tokens.expect("}")
        return values
    }

    private fun product(): Double {
        var value = sign()
        while (true) {
            if (tokens.takeIf("*")) value *= sign()
            else if (tokens.takeIf("/")) value /= sign()
            else if (tokens.takeIf("%")) value %= sign()
            else return value
        }
    }

    private fun sign(): Double {
        var isNegative = false
        while (true) {
            if (tokens.takeIf("-")) isNegative = !isNegative else if (!tokens.takeIf("+")) break
        }
        val value = power()
        return if (isNegative) -value else value
    }

    private fun power(): Double {
        val base = atom()
        if (!tokens.takeIf("^")) return base
        if (++depth > MAX_DEPTH) tokens.fail("more than $MAX_DEPTH powers of one another")
        val value = StrictMath.pow(base, sign())
        depth--
        return value
    }

    private fun atom(): Double {
        val place = tokens.start
        when (tokens.kind) {
            GeoTokens.Kind.NUMBER -> {
                val small = tokens.smallNumber()
                val word = if (small < 0) tokens.word else ""
                tokens.next()
                if (small >= 0) return small.toDouble()
                val value = RingPoints.decimal(word)
                if (value.isNaN()) tokens.failAt(place, "'$word' is not a number")
                return value
            }
            GeoTokens.Kind.NAME -> {
                val word = tokens.word
                tokens.next()
                if (tokens.takeIf("(")) return call(word, place, ")")
                if (tokens.takeIf("[")) return call(word, place, "]")
                if (word == "Pi") return Math.PI
                return variables[word] ?: given(word) ?: tokens.failAt(place, "there is no variable $word")
            }
            else -> {
                if (!tokens.takeIf("(")) tokens.fail("expected a number, found ${tokens.shown()}")
                val value = number()
                tokens.expect(")")
                return value
            }
        }
    }

    private fun call(name: String, place: Int, closing: String): Double {
        val x = number()
        val y = if (tokens.takeIf(",")) number() else Double.NaN
        tokens.expect(closing)
        if (!y.isNaN()) {
            return when (name) {
                "Atan2" -> StrictMath.atan2(x, y)
                "Hypot" -> StrictMath.hypot(x, y)
                "Fmod" -> x % y
                "Max" -> maxOf(x, y)
                "Min" -> minOf(x, y)
                else -> tokens.failAt(place, "the function $name of two numbers is unknown")
            }
        }
        return when (name) {
            "Sin" -> StrictMath.sin(x)
            "Cos" -> StrictMath.cos(x)
            "Tan" -> StrictMath.tan(x)
            "Asin" -> StrictMath.asin(x)
            "Acos" -> StrictMath.acos(x)
            "Atan" -> StrictMath.atan(x)
            "Sqrt" -> Math.sqrt(x)
            "Exp" -> StrictMath.exp(x)
            "Log" -> StrictMath.log(x)
            "Log10" -> StrictMath.log10(x)
            "Fabs", "Abs" -> Math.abs(x)
            "Floor" -> Math.floor(x)
            "Ceil" -> Math.ceil(x)
            "Round" -> Math.floor(x + 0.5)
            else -> tokens.failAt(place, "the function $name is unknown")
        }
    }

    private companion object {
        const val MAX_DEPTH = 100
        const val MOST = 100_000.0
        const val ROUNDING = 1e-9
    }
}
