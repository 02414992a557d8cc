package org.trigrid.editor.meshing

import org.trigrid.editor.tool.Figures
import org.trigrid.front.FrontTrace

/** The front's advance as a film: how many elements are made, whether it runs and how fast. No controls. */
internal class FrontPlayback(val trace: FrontTrace) {
    /** Elements made. */
    var position: Int = 0
        private set

    var isPlaying: Boolean = false
        private set

    var speed: Speed = Speed.of(trace.elementCount)

    /** Elements due but not made yet, less than one when up to date. */
    private var due = 0.0
    private var known: Pair<Int, IntArray>? = null

    enum class Speed(val perSecond: Double) {
        SLOWEST(1.0), SLOW(5.0), MEDIUM(25.0), FAST(200.0), FASTEST(2000.0);

        val label: String get() = "${Figures.plain(perSecond, 4)} a second"

        companion object {
            /** A film of some twenty seconds. */
            fun of(elements: Int): Speed = entries.minByOrNull { Math.abs(Math.log(elements / TYPICAL_SECONDS / it.perSecond)) } ?: MEDIUM

            private const val TYPICAL_SECONDS = 20.0
        }
    }

    val length: Int get() = trace.elementCount

    /** Two nodes a side. */
    val front: IntArray
        get() {
            known?.let { if (it.first == position) return it.second }
            return trace.frontAfter(position).also { known = position to it }
        }

    /** The element made last, or -1. */
    val lastElement: Int get() = position - 1

    /** The side over which the next element is made, two nodes; null at the end. */
    val currentSide: IntArray?
        get() = if (position == length) null else intArrayOf(trace.nodeOf(position, 0), trace.nodeOf(position, 1))

    val words: String
        get() = "${Figures.count(position)} of ${Figures.count(length)} elements, front of ${Figures.count(front.size / 2)} sides"

    /** Goes to a number of elements; what runs goes on from there. */
    fun goTo(elements: Int) {
        position = elements.coerceIn(0, length)
        due = 0.0
        if (position == length) isPlaying = false
    }

    /** Makes [elements] more, or takes some back, and stands still. */
    fun step(elements: Int) {
        isPlaying = false
        goTo(position + elements)
    }

    /** Runs, from the beginning where it stands at the end; or stands still. */
    fun toggle() {
        isPlaying = !isPlaying
        if (isPlaying && position == length) {
            position = 0
            due = 0.0
        }
    }

    /** Time passes. @return whether there is something new to see. */
    fun pass(seconds: Double): Boolean {
        if (!isPlaying) return false
        due += seconds * speed.perSecond
        val whole = due.toInt()
        if (whole == 0) return false
        val rest = due - whole
        goTo(position + whole)
        due = rest
        return true
    }

    companion object {
        /** Elements up to which the front is played. */
        const val MOST_ELEMENTS = 200_000
    }
}
