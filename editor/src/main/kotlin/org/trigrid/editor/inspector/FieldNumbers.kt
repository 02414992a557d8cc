package org.trigrid.editor.inspector

/** Numbers typed into fields, checked; messages say what to type instead. */
internal object FieldNumbers {
    fun any(text: String): Double =
        text.trim().replace(',', '.').toDoubleOrNull()?.takeIf { it.isFinite() } ?: refuse("Type a number, such as 0.25")

    fun positive(text: String): Double = any(text).also { if (it <= 0) refuse("Type a number above 0") }

    fun notNegative(text: String): Double = any(text).also { if (it < 0) refuse("Type 0 or a number above") }

    fun whole(text: String, range: IntRange): Int =
        text.trim().toIntOrNull()?.takeIf { it in range } ?: refuse("Type a whole number from ${range.first} to ${range.last}")

    /** Above 0, or nothing typed for none. */
    fun positiveOrNone(text: String): Double = if (text.isBlank()) Double.POSITIVE_INFINITY else positive(text)

    private fun refuse(message: String): Nothing = throw IllegalArgumentException(message)
}
