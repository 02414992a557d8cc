package org.trigrid.editor.inspector

import org.trigrid.editor.tool.Figures

/**
 * A number that a dialog asks for. Immutable.
 *
 * @param suggested what stands in the field at first, to six digits; left as it is, the number is taken in full.
 * @param check makes a number of a text; throws [IllegalArgumentException] with what to type instead.
 */
internal class NumberQuestion(
    val label: String,
    private val suggested: Double,
    private val check: (String) -> Double = FieldNumbers::any,
) {
    val text: String = Figures.length(suggested)

    /** @throws IllegalArgumentException if [typed] is no answer. */
    fun answer(typed: String): Double = check(if (typed == text) Figures.exact(suggested) else typed)

    companion object {
        fun positive(label: String, suggested: Double) = NumberQuestion(label, suggested, FieldNumbers::positive)

        fun whole(label: String, suggested: Int, range: IntRange) =
            NumberQuestion(label, suggested.toDouble()) { FieldNumbers.whole(it, range).toDouble() }
    }
}
