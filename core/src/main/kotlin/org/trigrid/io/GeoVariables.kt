package org.trigrid.io

/** The statements of a `.geo` script that give variables and lists their values. */
internal class GeoVariables(private val tokens: GeoTokens, private val expressions: GeoExpressions) {
    /** What follows the name of a variable, or of a list with its brackets; false if that is no assignment. */
    fun readAssignment(name: String): Boolean {
        for ((opening, closing) in BRACKETS) {
            if (tokens.takeIf(opening)) return tokens.takeIf(closing) && readList(name)
        }
        val change = tokens.word.takeIf { it in SIGNS }
        if (change != null) tokens.next()
        if ((change == "+" || change == "-") && tokens.takeIf(change)) {
            expressions.define(name, old(name) + if (change == "+") 1 else -1)
            return true
        }
        if (!tokens.takeIf("=")) return false
        if (tokens.kind == GeoTokens.Kind.STRING || tokens.word == "{") tokens.fail("only numbers can be the value of a variable")
        val value = if (tokens.takeIf("DefineNumber")) definedNumber() else expressions.number()
        expressions.define(
            name,
            when (change) {
                "+" -> old(name) + value
                "-" -> old(name) - value
                "*" -> old(name) * value
                "/" -> old(name) / value
                else -> value
            },
        )
        return true
    }

    private fun old(name: String): Double = expressions.valueOf(name) ?: tokens.fail("there is no variable $name")

    /** `= {…}` or `+= {…}` */
    private fun readList(name: String): Boolean {
        val isMore = tokens.takeIf("+")
        if (!tokens.takeIf("=")) return false
        val values = expressions.listOrPart()
        expressions.defineList(name, values, isMore)
        return true
    }

    /** `[a = 1, b = {2, Name "…"}, …]`; what is defined already stays. */
    fun readConstants() {
        val closing = if (tokens.takeIf("[")) "]" else ")"
        if (closing == ")") tokens.expect("(")
        do {
            if (tokens.kind != GeoTokens.Kind.NAME) tokens.fail("expected a variable, found ${tokens.shown()}")
            val name = tokens.word
            tokens.next()
            val value = if (tokens.takeIf("=")) constant() else 0.0
            if (expressions.valueOf(name) == null) expressions.define(name, value)
        } while (tokens.takeIf(","))
        tokens.expect(closing)
    }

    private fun constant(): Double {
        if (!tokens.takeIf("{")) return expressions.number()
        return expressions.number().also { skipTo("}") }
    }

    /** `[1, Name "…"]` */
    private fun definedNumber(): Double {
        val closing = if (tokens.takeIf("[")) "]" else ")"
        if (closing == ")") tokens.expect("(")
        return expressions.number().also { skipTo(closing) }
    }

    /** How a value is shown to the user of Gmsh, in brackets that may have others in them. */
    private fun skipTo(closing: String) {
        var depth = 0
        while (tokens.kind != GeoTokens.Kind.END) {
            if (depth == 0 && tokens.takeIf(closing)) return
            if (tokens.kind == GeoTokens.Kind.SIGN && tokens.word in "{[(") depth++
            if (tokens.kind == GeoTokens.Kind.SIGN && tokens.word in "}])") depth--
            tokens.next()
        }
        tokens.fail("expected '$closing', found the end of the file")
    }

    private companion object {
        val BRACKETS = listOf("[" to "]", "(" to ")")
        val SIGNS = setOf("+", "-", "*", "/")
    }
}
