package org.trigrid.spacing

/**
 * Wanted edge length at every place of the domain; what the front and the improvement steer by.
 *
 * Not thread safe: an evaluation may move the field's own cursor.
 */
internal interface SizeField {
    /**
     * Wanted edge length at ([x], [y]), > 0.
     *
     * @param hint where the search may start: the value of [lastHint] at a place near by, or -1.
     */
    fun sizeAt(x: Double, y: Double, hint: Int): Double

    /** Distance below which user's sizes, or those at points, may change; infinity where there are none. */
    val detail: Double get() = Double.POSITIVE_INFINITY

    /** Where the last evaluation ended; a good hint for places near it. */
    val lastHint: Int

    /** Hint for a place at node [node] of the domain; -1 for a node that the field does not know, such as an embedded point. */
    fun hintOf(node: Int): Int
}
