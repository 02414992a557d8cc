package org.trigrid.editor.tool

/** Lines at round distances that suit the scale: 1, 2 or 5 times a power of ten. */
internal object Grid {
    /** Distance of grid lines, in the domain's unit, where a pixel is [pixel] long. */
    fun stepFor(pixel: Double): Double {
        val least = LEAST_PIXELS * pixel
        val power = Math.floor(Math.log10(least))
        val ten = Math.pow(10.0, power)
        for (factor in FACTORS) if (factor * ten >= least) return round(factor, power)
        return round(1.0, power + 1)
    }

    /** Every this many lines is a strong one. */
    fun strongEvery(step: Double): Int {
        val lead = step / Math.pow(10.0, Math.floor(Math.log10(step) + 1e-9))
        return if (lead < 1.5 || lead > 4) if (lead > 4) 2 else 10 else 5
    }

    /** The multiple of [step] nearest to [value]; decimal where the step is. */
    fun nearest(value: Double, step: Double): Double {
        val count = Math.rint(value / step)
        return if (step < 1) count / Math.rint(1 / step).coerceAtLeast(1.0) else count * step
    }

    private fun round(factor: Double, power: Double): Double =
        if (power >= 0) factor * Math.pow(10.0, power) else factor / Math.pow(10.0, -power)

    private val FACTORS = doubleArrayOf(1.0, 2.0, 5.0)
    private const val LEAST_PIXELS = 14.0
}
