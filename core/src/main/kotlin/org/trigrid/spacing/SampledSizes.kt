package org.trigrid.spacing

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.diagnostics.InvalidSizeException
import org.trigrid.geometry.IntList
import org.trigrid.geometry.Pose

/**
 * The user's sizes, sampled once and limited to the gradation.
 *
 * A quadtree over the domain's square box holds values of the function at the corners of its cells. A cell is divided while
 * the value at its middle or at the middle of a side differs by more than [TOLERANCE] from the bilinear value of its corners,
 * as long as the cell is larger than the sizes in it; the first [EVEN_LEVELS] levels are divided everywhere. So a feature is
 * seen if it is larger than 1/64 of the box, or lies beside a change that is, and then followed down to the element size. At
 * most about [MAX_CALLS] calls are made; when they run out the largest cells have been served first.
 *
 * Then each sample is lowered to `min over samples j of (h_j + g |x - x_j|)`, which keeps the gradation between samples.
 * Inside a cell the values are bilinear, so the slope is at most g * sqrt(2).
 *
 * Infinity is a size ("as large as may be"). Outside of the domain any value will do; what is no size there is ignored.
 *
 * @throws InvalidSizeException where the function gives no size inside the domain.
 */
internal class SampledSizes(
    private val function: SizeFunction,
    private val pose: Pose,
    private val minX: Double,
    private val minY: Double,
    private val extent: Double,
    private val locator: InsideLocator,
    gradation: Double,
    private val checkpoint: Checkpoint = Checkpoint.unheard(),
) {
    /** Per cell: the first of its four children, or -1. */
    private val children = IntList()

    /** Per cell 4 samples: lower left, lower right, upper left, upper right. */
    private val corners = IntList()
    private val gridX = IntList()
    private val gridY = IntList()
    private val levels = IntList()
    private val samples = SampleTable()
    private val values: DoubleArray

    /** Side of the cells that are made everywhere. */
    val evenCell: Double get() = extent / (1 shl EVEN_LEVELS)

    init {
        addCell(0, 0, 0)
        var cell = 0
        while (cell < levels.size) {
            if (samples.size < MAX_CALLS && mustDivide(cell)) divide(cell)
            cell++
        }
        values = limited(gradation)
    }

    private fun addCell(x: Int, y: Int, level: Int) {
        val side = FULL ushr level
        children.add(-1)
        gridX.add(x)
        gridY.add(y)
        levels.add(level)
        corners.add(sampleAt(x, y))
        corners.add(sampleAt(x + side, y))
        corners.add(sampleAt(x, y + side))
        corners.add(sampleAt(x + side, y + side))
    }

    private fun divide(cell: Int) {
        val half = FULL ushr (levels[cell] + 1)
        children[cell] = levels.size
        for (k in 0..3) addCell(gridX[cell] + (k and 1) * half, gridY[cell] + (k shr 1) * half, levels[cell] + 1)
    }

    private fun mustDivide(cell: Int): Boolean {
        val level = levels[cell]
        if (level < EVEN_LEVELS) return true
        if (level == MAX_LEVEL) return false
        val a = samples.value(corners[4 * cell])
        val b = samples.value(corners[4 * cell + 1])
        val c = samples.value(corners[4 * cell + 2])
        val d = samples.value(corners[4 * cell + 3])
        val side = extent / (1 shl level)
        if (side <= Math.min(Math.min(a, b), Math.min(c, d))) return false
        val half = FULL ushr (level + 1)
        val x = gridX[cell]
        val y = gridY[cell]
        return differs(sampleAt(x + half, y + half), 0.25 * (a + b + c + d)) ||
            differs(sampleAt(x + half, y), 0.5 * (a + b)) || differs(sampleAt(x, y + half), 0.5 * (a + c)) ||
            differs(sampleAt(x + 2 * half, y + half), 0.5 * (b + d)) || differs(sampleAt(x + half, y + 2 * half), 0.5 * (c + d))
    }

    /** A sample outside of the domain that the function has no size for agrees with anything. */
    private fun differs(sample: Int, expected: Double): Boolean {
        val value = samples.value(sample)
        if (value == Double.POSITIVE_INFINITY && expected == Double.POSITIVE_INFINITY) return false
        return !(Math.abs(value - expected) <= TOLERANCE * Math.min(value, expected))
    }

    private fun sampleAt(gx: Int, gy: Int): Int {
        checkpoint.pass()
        val key = gx.toLong() * (FULL + 1L) + gy
        val known = samples.find(key)
        if (known >= 0) return known
        val x = minX + extent * (gx.toDouble() / FULL)
        val y = minY + extent * (gy.toDouble() / FULL)
        return samples.add(key, x, y, valueAt(x, y))
    }

    private fun valueAt(x: Double, y: Double): Double {
        val givenX = pose.givenX(x, y)
        val givenY = pose.givenY(x, y)
        val value = function.sizeAt(givenX, givenY)
        if (value > 0) return value
        if (locator.isInside(x, y)) throw InvalidSizeException(givenX, givenY, value)
        return Double.POSITIVE_INFINITY
    }

    private fun limited(gradation: Double): DoubleArray {
        val xy = samples.places()
        val cones = ConeTree(xy, DoubleArray(samples.size) { samples.value(it) }, gradation, checkpoint)
        return DoubleArray(samples.size) {
            checkpoint.pass()
            cones.min(xy[2 * it], xy[2 * it + 1], it, UNLIMITED)
        }
    }

    /** The limited size at a place; that of the nearest place of the box when it lies outside. */
    fun sizeAt(x: Double, y: Double): Double {
        var u = Math.max(0.0, Math.min(1.0, (x - minX) / extent))
        var v = Math.max(0.0, Math.min(1.0, (y - minY) / extent))
        var cell = 0
        while (children[cell] >= 0) {
            u *= 2
            v *= 2
            val right = u >= 1
            val upper = v >= 1
            if (right) u -= 1
            if (upper) v -= 1
            cell = children[cell] + (if (right) 1 else 0) + (if (upper) 2 else 0)
        }
        val c = 4 * cell
        val low = values[corners[c]] + u * (values[corners[c + 1]] - values[corners[c]])
        val high = values[corners[c + 2]] + u * (values[corners[c + 3]] - values[corners[c + 2]])
        return low + v * (high - low)
    }

    companion object {
        const val MAX_CALLS = 400_000

        /** Stands for infinity, so that differences of samples stay numbers. */
        private const val UNLIMITED = 1e300
        private const val EVEN_LEVELS = 5
        private const val MAX_LEVEL = 24
        private const val FULL = 1 shl MAX_LEVEL
        private const val TOLERANCE = 0.05
    }
}
