package org.trigrid.editor.tool

import org.trigrid.geometry.Point2

/**
 * Places as people type them: `3,4` as it stands, `@1,0` from the last point, `@2<30` from it by length and angle in
 * degrees, `2<30` from the origin. A blank or a semicolon does for the comma.
 */
internal object CoordinateEntry {
    private const val NUMBER = """[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"""
    private val PAIR = Regex("""\s*(@?)\s*($NUMBER)\s*(?:[,;]|\s)\s*($NUMBER)\s*""")
    private val POLAR = Regex("""\s*(@?)\s*($NUMBER)\s*<\s*($NUMBER)\s*""")

    private val SINGLE = Regex("""\s*@?\s*$NUMBER\s*""")

    /** The place that [text] means, or null if it means none. @param last the point that `@` counts from. */
    fun parse(text: String, last: Point2?): Point2? {
        val pair = PAIR.matchEntire(text)
        val match = pair ?: POLAR.matchEntire(text) ?: return null
        val (at, first, second) = match.destructured
        val a = first.toDouble()
        val b = second.toDouble()
        val from = if (at.isEmpty()) ORIGIN else last ?: ORIGIN
        val place = if (pair != null) Point2(from.x + a, from.y + b) else polar(from, a, b)
        return place.takeIf { it.x.isFinite() && it.y.isFinite() }
    }

    /** Whether [text] is the first number of two, so that Tab may go on to the second. */
    fun awaitsSecond(text: String): Boolean = SINGLE.matches(text)

    /** [text], the first number of two, and what stands between them. */
    fun withSeparator(text: String): String = text.trim() + ","

    private fun polar(from: Point2, length: Double, degrees: Double): Point2 {
        val turned = org.trigrid.shape.Similarity.rotation(ORIGIN, degrees).apply(Point2(length, 0.0))
        return Point2(from.x + turned.x, from.y + turned.y)
    }

    private val ORIGIN = Point2(0.0, 0.0)
}
