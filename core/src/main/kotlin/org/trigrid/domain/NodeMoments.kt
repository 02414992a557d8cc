package org.trigrid.domain

import org.trigrid.diagnostics.Checkpoint

/**
 * Where the nodes of a domain lie about their centroid, told by complex moments: the sums of z^p conj(z)^q over the
 * nodes. Turning the domain by t multiplies a moment by exp(i (p - q) t), mirroring it conjugates it; so the moments
 * tell a direction that turns with the domain, and whether two domains are mirror images.
 *
 * Source: J. Flusser (2000), "On the independence of rotation moment invariants", Pattern Recognition 33:1405-1412.
 */
internal class NodeMoments(domain: Domain, private val checkpoint: Checkpoint) {
    private val count = domain.nodeCount
    private val zx = DoubleArray(count)
    private val zy = DoubleArray(count)

    /** Real and imaginary part of each moment of [POWERS], and the sum of |z|^(p + q), its largest value. */
    private val real = DoubleArray(POWERS.size)
    private val imaginary = DoubleArray(POWERS.size)
    private val largest = DoubleArray(POWERS.size)
    private val reference: Int

    /**
     * A direction that turns and mirrors with the domain, as an angle from the x axis. For a domain that is the same
     * after part of a turn, one of several; for one that is the same after any turn, 0.
     */
    val phase: Double

    /** As many directions as [phase] may be of, all of the same right; 0 for a domain all of whose moments vanish. */
    val phaseCount: Int get() = if (reference < 0) 0 else turns(reference)

    init {
        centre(domain)
        for (i in 0 until count) {
            checkpoint.pass()
            add(zx[i], zy[i])
        }
        reference = POWERS.indices.firstOrNull { Math.hypot(real[it], imaginary[it]) > NOTABLE * largest[it] } ?: -1
        phase = if (reference < 0) 0.0 else StrictMath.atan2(imaginary[reference], real[reference]) / turns(reference)
    }

    /**
     * Whether the nodes beside [phase] lie rather clockwise of it; true for exactly one of two mirror images, false for a
     * domain that is its own.
     */
    val isMirrored: Boolean by lazy {
        if (reference < 0) return@lazy false
        for (k in POWERS.indices) {
            if (turns(k) % turns(reference) != 0) continue
            val angle = turns(k) * phase
            val side = imaginary[k] * StrictMath.cos(angle) - real[k] * StrictMath.sin(angle)
            if (Math.abs(side) > NOTABLE * largest[k]) return@lazy side < 0
        }
        false
    }

    private fun turns(k: Int): Int = POWERS[k][0] - POWERS[k][1]

    /** Places relative to the centroid, within about -1..1 whatever the scale and the offset. */
    private fun centre(domain: Domain) {
        var minX = Double.POSITIVE_INFINITY
        var minY = Double.POSITIVE_INFINITY
        var maxX = Double.NEGATIVE_INFINITY
        var maxY = Double.NEGATIVE_INFINITY
        for (i in 0 until count) {
            checkpoint.pass()
            minX = Math.min(minX, domain.x(i))
            maxX = Math.max(maxX, domain.x(i))
            minY = Math.min(minY, domain.y(i))
            maxY = Math.max(maxY, domain.y(i))
        }
        // Halves, as the whole extent of finite places may be beyond the range of doubles.
        val extent = Math.max(maxX / 2 - minX / 2, maxY / 2 - minY / 2)
        var sumX = 0.0
        var sumY = 0.0
        for (i in 0 until count) {
            checkpoint.pass()
            zx[i] = (domain.x(i) / 2 - minX / 2) / extent
            zy[i] = (domain.y(i) / 2 - minY / 2) / extent
            sumX += zx[i]
            sumY += zy[i]
        }
        for (i in 0 until count) {
            zx[i] -= sumX / count
            zy[i] -= sumY / count
        }
    }

    private fun add(x: Double, y: Double) {
        val square = x * x + y * y
        val radius = Math.sqrt(square)
        for (k in POWERS.indices) {
            var re = 1.0
            var im = 0.0
            for (i in 0 until turns(k)) {
                val next = re * x - im * y
                im = re * y + im * x
                re = next
            }
            var size = if (turns(k) % 2 == 0) 1.0 else radius
            for (i in 0 until turns(k) / 2) size *= square
            for (i in 0 until POWERS[k][1]) {
                re *= square
                im *= square
                size *= square
            }
            real[k] += re
            imaginary[k] += im
            largest[k] += size
        }
    }

    private companion object {
        /** p and q of the moments; the first notable one gives the direction, so those that turn once come first. */
        val POWERS = arrayOf(
            intArrayOf(2, 1), intArrayOf(3, 2), intArrayOf(2, 0), intArrayOf(3, 1), intArrayOf(3, 0), intArrayOf(4, 1),
            intArrayOf(4, 0), intArrayOf(5, 1), intArrayOf(5, 0), intArrayOf(6, 0),
        )

        /** Share of its largest value from which a moment is no rounding error. */
        const val NOTABLE = 1e-6
    }
}
