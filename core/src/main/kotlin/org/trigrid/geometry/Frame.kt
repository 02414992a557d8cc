package org.trigrid.geometry

/**
 * A frame of a figure's own: its centre, a direction, and a grid to which places are rounded.
 *
 * A figure that is moved or turned has other coordinates in every last bit; told in a frame that moves and turns with it, it has the
 * same ones to the last bit, but for a place that lies halfway between two of the grid.
 */
internal class Frame(
    private val centreX: Double,
    private val centreY: Double,
    private val cos: Double,
    private val sin: Double,
    /** Of the grid; a power of two, so that rounding to it is exact. Far above what coordinates are rounded by. */
    val step: Double,
) {
    /** x in the frame of a place outside of it. */
    fun x(x: Double, y: Double): Double = onGrid(cos * (x - centreX) + sin * (y - centreY))

    /** As [x]. */
    fun y(x: Double, y: Double): Double = onGrid(cos * (y - centreY) - sin * (x - centreX))

    /** x outside of the frame of a place in it. */
    fun givenX(x: Double, y: Double): Double = centreX + (cos * x - sin * y)

    /** As [givenX]. */
    fun givenY(x: Double, y: Double): Double = centreY + (sin * x + cos * y)

    // The zero added makes one of the two zeros.
    private fun onGrid(value: Double): Double = Math.rint(value / step) * step + 0.0
}
