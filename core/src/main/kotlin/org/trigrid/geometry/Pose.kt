package org.trigrid.geometry

/**
 * A way to lay the plane: mirrored at the x axis or not, then turned anticlockwise about the origin by quarter turns.
 * These eight are the movements that floating point does exactly. With a [frame], what is mirrored and turned are places as it
 * tells them, and the way back is exact but for rounding.
 */
internal class Pose(
    /** Whether what ran anticlockwise runs clockwise now. */
    val isMirrored: Boolean,
    /** 0 to 3. */
    private val quarterTurns: Int,
    /** That of the places before, or null where they are taken as given. */
    val frame: Frame? = null,
) {
    /** x of a given place as it is laid. */
    fun x(x: Double, y: Double): Double =
        if (frame == null) plainX(x, y) else plainX(frame.x(x, y), frame.y(x, y))

    /** As [x]. */
    fun y(x: Double, y: Double): Double =
        if (frame == null) plainY(x, y) else plainY(frame.x(x, y), frame.y(x, y))

    /** x of a laid place as it was given. */
    fun givenX(x: Double, y: Double): Double =
        if (frame == null) plainGivenX(x, y) else frame.givenX(plainGivenX(x, y), plainGivenY(x, y))

    /** As [givenX]. */
    fun givenY(x: Double, y: Double): Double =
        if (frame == null) plainGivenY(x, y) else frame.givenY(plainGivenX(x, y), plainGivenY(x, y))

    /** The same with a [frame] before. */
    fun after(frame: Frame): Pose = Pose(isMirrored, quarterTurns, frame)

    private fun plainX(x: Double, y: Double): Double = turnedX(quarterTurns, x, if (isMirrored) -y else y)

    private fun plainY(x: Double, y: Double): Double = turnedY(quarterTurns, x, if (isMirrored) -y else y)

    private fun plainGivenX(x: Double, y: Double): Double = turnedX(4 - quarterTurns and 3, x, y)

    private fun plainGivenY(x: Double, y: Double): Double {
        val turned = turnedY(4 - quarterTurns and 3, x, y)
        return if (isMirrored) -turned else turned
    }

    private fun turnedX(turns: Int, x: Double, y: Double): Double = when (turns) {
        0 -> x
        1 -> -y
        2 -> -x
        else -> y
    }

    private fun turnedY(turns: Int, x: Double, y: Double): Double = when (turns) {
        0 -> y
        1 -> x
        2 -> -y
        else -> -x
    }

    companion object {
        /** As given. */
        val AS_GIVEN = Pose(false, 0)
    }
}
