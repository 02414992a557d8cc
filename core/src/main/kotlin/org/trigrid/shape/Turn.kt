package org.trigrid.shape

/**
 * Sine and cosine of angles given in turns (1 turn = 360 degrees), the same on every platform and exact at quarter
 * turns, so that a circle's nodes on its axes have exact coordinates and mirrored nodes mirrored ones.
 */
internal object Turn {
    fun cos(turns: Double): Double = sin(0.25 - Math.abs(turns - Math.rint(turns)))

    fun sin(turns: Double): Double {
        val t = turns - Math.rint(turns)
        val size = Math.abs(t)
        // Within an eighth of a turn of an axis each function is computed from the angle to that axis.
        val folded = if (size > 0.25) 0.5 - size else size
        val value = if (folded <= 0.125) {
            StrictMath.sin(2 * Math.PI * folded)
        } else {
            StrictMath.cos(2 * Math.PI * (0.25 - folded))
        }
        return if (t < 0) -value else value
    }

    /** Angle of the vector (x, y) in turns, -0.5..0.5. */
    fun of(x: Double, y: Double): Double = StrictMath.atan2(y, x) / (2 * Math.PI)
}
