package org.trigrid.io

/** The `For` and `If` of a `.geo` script: where it goes on, and how often. */
internal class GeoFlow(private val tokens: GeoTokens, private val expressions: GeoExpressions) {
    /** @param place of the statement. */
    private class Block(val isLoop: Boolean, val place: Int, val variable: String? = null, val values: List<Double> = emptyList(), val body: Int = 0) {
        var round = 0
    }

    private val open = ArrayList<Block>()
    private var rounds = 0

    /** Obeys the statement that [word] has begun, if it is one of these; false for others. */
    fun obey(word: String, place: Int): Boolean {
        when (word) {
            "For" -> begin(place)
            "EndFor" -> repeat(place)
            "If" -> choose(place)
            // A branch that was taken ends here.
            "Else", "ElseIf" -> {
                leaveBranch(word, place)
                if (word == "ElseIf") expressions.number()
                skipToEndIf(place)
            }
            "EndIf" -> leaveBranch(word, place)
            else -> return false
        }
        return true
    }

    /** What is begun must be ended. */
    fun checkEnd() {
        open.lastOrNull()?.let { tokens.failAt(it.place, (if (it.isLoop) "For" else "If") + " has no end") }
    }

    /** `For i In {a:b:c}` or `For (a:b:c)` */
    private fun begin(place: Int) {
        if (open.size >= MOST_OPEN) tokens.failAt(place, "more than $MOST_OPEN For and If in one another")
        var variable: String? = null
        val closing = if (tokens.takeIf("(")) ")" else "}"
        if (closing == "}") {
            if (tokens.kind != GeoTokens.Kind.NAME) tokens.fail("expected a variable, found ${tokens.shown()}")
            variable = tokens.word
            tokens.next()
            tokens.expect("In")
            tokens.expect("{")
        }
        val from = expressions.number()
        tokens.expect(":")
        val values = expressions.rangeFrom(from, place)
        tokens.expect(closing)
        if (values.isEmpty()) return skipLoop(place)
        val block = Block(true, place, variable, values, tokens.start)
        open.add(block)
        define(block)
    }

    private fun define(block: Block) {
        if (++rounds > MOST_ROUNDS) tokens.failAt(block.place, "the loops of the script go round more than $MOST_ROUNDS times")
        block.variable?.let { expressions.define(it, block.values[block.round]) }
    }

    private fun repeat(place: Int) {
        val block = open.lastOrNull()?.takeIf { it.isLoop } ?: tokens.failAt(place, "there is no For to this EndFor")
        if (++block.round < block.values.size) {
            define(block)
            tokens.goTo(block.body)
        } else {
            open.removeLast()
        }
    }

    private fun choose(place: Int) {
        if (open.size >= MOST_OPEN) tokens.failAt(place, "more than $MOST_OPEN For and If in one another")
        var isTrue = expressions.number() != 0.0
        while (!isTrue) {
            when (skipBranch(place)) {
                "ElseIf" -> isTrue = expressions.number() != 0.0
                "Else" -> isTrue = true
                else -> return
            }
        }
        open.add(Block(false, place))
    }

    private fun leaveBranch(word: String, place: Int) {
        val block = open.removeLastOrNull()
        if (block == null || block.isLoop) tokens.failAt(place, "there is no If to this $word")
    }

    private fun skipToEndIf(place: Int) {
        var word = skipBranch(place)
        while (word != "EndIf") word = skipBranch(place)
    }

    /** Goes on behind the next `ElseIf`, `Else` or `EndIf` of the same `If`, and tells which. */
    private fun skipBranch(place: Int): String {
        var depth = 0
        while (tokens.kind != GeoTokens.Kind.END) {
            val word = if (tokens.kind == GeoTokens.Kind.NAME) tokens.word else ""
            tokens.next()
            when (word) {
                "If" -> depth++
                "ElseIf", "Else" -> if (depth == 0) return word
                "EndIf" -> if (depth-- == 0) return word
            }
        }
        tokens.failAt(place, "If has no end")
    }

    private fun skipLoop(place: Int) {
        var depth = 1
        while (depth > 0) {
            if (tokens.kind == GeoTokens.Kind.END) tokens.failAt(place, "For has no end")
            if (tokens.takeIf("For")) depth++ else if (tokens.takeIf("EndFor")) depth-- else tokens.next()
        }
    }

    private companion object {
        const val MOST_OPEN = 100
        const val MOST_ROUNDS = 200_000
    }
}
