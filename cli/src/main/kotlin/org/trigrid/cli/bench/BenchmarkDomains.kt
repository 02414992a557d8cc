package org.trigrid.cli.bench

import org.trigrid.domain.Domain

/** Domains of any size for measurements of speed: the same ones on every machine. */
object BenchmarkDomains {
    /** The domain of [family] whose mesh, with default options, has about [elements] elements. */
    @JvmStatic
    fun create(family: BenchmarkFamily, elements: Double): Domain {
        require(elements >= 1 && elements <= MOST) { "a domain has 1 to 1e8 elements, not $elements" }
        val spacing = Math.sqrt(family.elementsAtUnitSpacing / elements)
        return when (family) {
            BenchmarkFamily.SQUARE -> Domain.of(Outlines.rectangle(1.0, 1.0, spacing))
            BenchmarkFamily.CIRCLE -> Domain.of(circle(0.0, 0.0, 1.0, spacing))
            BenchmarkFamily.ANNULUS -> Domain.of(circle(0.0, 0.0, 1.0, spacing), circle(0.0, 0.0, 0.3, 0.5 * spacing))
            BenchmarkFamily.AIRFOIL -> airfoil(spacing)
            BenchmarkFamily.PLATE -> plate(20, 10, 0.3, spacing)
            BenchmarkFamily.COAST -> coast(spacing)
            BenchmarkFamily.HOLE -> plate(1, 1, 0.3, spacing)
            BenchmarkFamily.SIEVE -> plate(100, 100, 0.3, spacing)
        }
    }

    private fun circle(x: Double, y: Double, radius: Double, spacing: Double): DoubleArray =
        Outlines.circle(x, y, radius, Math.max(LEAST_NODES, Math.round(2 * Math.PI * radius / spacing).toInt()))

    /** A section in a far field of 15 chords; nodes are 5 times as dense at its ends as between, 1000 times as outside. */
    private fun airfoil(spacing: Double): Domain {
        val fine = Outlines.airfoil(fineSteps(2.0, spacing))
        val section = Outlines.spaced(fine, 0.0) { x, _ -> spacing * (1 + 4 * Math.min(1.0, Math.min(x, 1 - x) / 0.2)) }
        return Domain.of(circle(0.5, 0.0, 15.0, 1000 * spacing), section)
    }

    /** Round holes in rows and columns, each of the part [share] of its square's side across. */
    private fun plate(columns: Int, rows: Int, share: Double, spacing: Double): Domain {
        val cell = 1.0 / rows
        val holes = Array(columns * rows) {
            // Radii differ, so that no two holes of a neighbourhood are alike.
            val radius = 0.5 * share * cell * (1 + 0.3 * ((it * 7) % 11 - 5) / 5.0)
            circle((it % columns + 0.5) * cell, (it / columns + 0.5) * cell, radius, spacing)
        }
        val builder = Domain.builder().outer(Outlines.rectangle(columns * cell, 1.0, spacing))
        for (hole in holes) builder.hole(hole)
        return builder.build()
    }

    /** A land with a ragged shore and five islands in its lake; node distances differ by a factor of 2 and more. */
    private fun coast(spacing: Double): Domain {
        val steps = fineSteps(12.0, spacing)
        val loops = Array(6) {
            val angle = 2 * Math.PI * it / 5
            if (it == 0) {
                Outlines.coast(0.0, 0.0, 1.0, WAVES, 1, steps)
            } else {
                Outlines.coast(0.4 * StrictMath.cos(angle), 0.4 * StrictMath.sin(angle), 0.1, WAVES / 4, 1L + it, steps / 8)
            }
        }
        return Domain.of(*Array(loops.size) { Outlines.spaced(loops[it], JITTER) { _, _ -> spacing } })
    }

    /** Enough steps along a line of about [length] for many of them to lie in each segment. */
    private fun fineSteps(length: Double, spacing: Double) = Math.max(2000, (20 * length / spacing).toInt())

    private const val MOST = 1e8
    private const val LEAST_NODES = 6
    private const val WAVES = 80
    private const val JITTER = 0.6
}
