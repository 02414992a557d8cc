package org.trigrid.io

/** Arithmetic of a `.geo` script: + - * / % ^, brackets, functions of one or two numbers, variables. */
internal class GeoExpressions(
    private val tokens: GeoTokens,
    /** Values of names that Gmsh gives itself, such as `newp`; null for others. */
    private val given: (String) -> Double? = { null },
) {
    private val variables = HashMap<String, Double>()
    private val lists = HashMap<String, ArrayList<Double>>()
    private var valuesLeft = MOST_ALTOGETHER
    private var depth = 0

    fun define(name: String, value: Double) {
        variables[name] = value
    }

    fun valueOf(name: String): Double? = variables[name]

    /** @param isMore whether the values come to those that the list has. */
    fun defineList(name: String, values: List<Double>, isMore: Boolean) {
        if (!isMore) lists.remove(name)
        lists.getOrPut(name) { ArrayList() }.addAll(values)
    }

    /** What is true is 1, what is not is 0, and all but 0 counts as true. */
    fun number(): Double {
        if (++depth > MAX_DEPTH) tokens.fail("more than $MAX_DEPTH brackets in one another")
        var value = conjunction()
        while (tokens.takeSigns("||")) value = truth(conjunction() != 0.0 || value != 0.0)
        depth--
        return value
    }

    private fun conjunction(): Double {
        var value = comparison()
        while (tokens.takeSigns("&&")) value = truth(comparison() != 0.0 && value != 0.0)
        return value
    }

    private fun comparison(): Double {
        val value = sum()
        return when {
            tokens.takeSigns("==") -> truth(value == sum())
            tokens.takeSigns("!=") -> truth(value != sum())
            tokens.takeSigns("<=") -> truth(value <= sum())
            tokens.takeSigns(">=") -> truth(value >= sum())
            tokens.takeSigns("<") -> truth(value < sum())
            tokens.takeSigns(">") -> truth(value > sum())
            else -> value
        }
    }

    private fun truth(isTrue: Boolean) = if (isTrue) 1.0 else 0.0

    private fun sum(): Double {
        var sum = product()
        while (true) {
            if (tokens.takeIf("+")) sum += product() else if (tokens.takeIf("-")) sum -= product() else break
        }
        return sum
    }

    fun whole(what: String): Int {
        val place = tokens.start
        val value = number()
        val whole = value.toInt()
        if (whole.toDouble() != value) tokens.failAt(place, "$what must be a whole number, not $value")
        return whole
    }

    /** `{a, b:c, b:c:d, names[], …}` */
    fun list(): List<Double> {
        tokens.expect("{")
        val values = ArrayList<Double>()
        if (tokens.takeIf("}")) return values
        do addTo(values) while (tokens.takeIf(","))
        tokens.expect("}")
        return values
    }

    /** As [list], or one part of one without braces. */
    fun listOrPart(): List<Double> = if (tokens.word == "{") list() else ArrayList<Double>().also { addTo(it) }

    /** A number, a range or a whole list. */
    private fun addTo(values: ArrayList<Double>) {
        val place = tokens.start
        val isNegative = tokens.takeIf("-")
        val whole = wholeList()
        if (whole == null) {
            tokens.goTo(place)
            return addRange(values, place)
        }
        spend(whole.size, place)
        for (it in whole) values.add(if (isNegative) -it else it)
    }

    private fun addRange(values: ArrayList<Double>, place: Int) {
        val from = number()
        if (!tokens.takeIf(":")) {
            spend(1, place)
            values.add(from)
            return
        }
        val range = rangeFrom(from, place)
        if (range.isEmpty()) tokens.failAt(place, "the range is empty")
        spend(range.size, place)
        values.addAll(range)
    }

    /** What follows `from:`; empty if the step leads away from the end. */
    fun rangeFrom(from: Double, place: Int): List<Double> {
        val to = number()
        val step = if (tokens.takeIf(":")) number() else if (to < from) -1.0 else 1.0
        val count = Math.floor((to - from) / step + ROUNDING) + 1
        if (!(count <= MOST)) tokens.failAt(place, "the range from $from to $to by $step is too long")
        return List(Math.max(count, 0.0).toInt()) { from + it * step }
    }

    /** `name[]` or `name()` of a list, or null, having gone on. */
    private fun wholeList(): List<Double>? {
        if (tokens.kind != GeoTokens.Kind.NAME) return null
        val list = lists[tokens.word] ?: return null
        tokens.next()
        return if (tokens.takeIf("[")) list.takeIf { tokens.takeIf("]") } else if (tokens.takeIf("(")) list.takeIf { tokens.takeIf(")") } else null
    }

    /** Loops must not make much of a small file. */
    private fun spend(count: Int, place: Int) {
        valuesLeft -= count
        if (valuesLeft < 0) tokens.failAt(place, "the lists of the script have more than $MOST_ALTOGETHER numbers")
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
        if (tokens.takeIf("!")) return truth(sign() == 0.0)
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
                if (tokens.takeIf("#")) return (wholeList() ?: tokens.failAt(place, "there is no such list")).size.toDouble()
                if (!tokens.takeIf("(")) tokens.fail("expected a number, found ${tokens.shown()}")
                val value = number()
                tokens.expect(")")
                return value
            }
        }
    }

    private fun call(name: String, place: Int, closing: String): Double {
        val list = lists[name]
        val x = number()
        val y = if (tokens.takeIf(",")) number() else Double.NaN
        tokens.expect(closing)
        if (list != null) return list.getOrNull(x.toInt()) ?: tokens.failAt(place, "the list $name has no place ${x.toInt()}, only ${list.size} from 0")
        return GeoFunctions.of(name, x, y) ?: tokens.failAt(place, "the function $name" + (if (y.isNaN()) "" else " of two numbers") + " is unknown")
    }

    private companion object {
        const val MAX_DEPTH = 100
        const val MOST = 100_000.0
        const val MOST_ALTOGETHER = 5_000_000
        const val ROUNDING = 1e-9
    }
}
