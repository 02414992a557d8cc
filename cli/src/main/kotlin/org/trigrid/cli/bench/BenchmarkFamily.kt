package org.trigrid.cli.bench

/**
 * The kinds of domains on which speed is measured.
 *
 * @property elementsAtUnitSpacing elements of the mesh times the square of the spacing; measured at 1e5 elements.
 */
enum class BenchmarkFamily(@get:JvmName("elementsAtUnitSpacing") val elementsAtUnitSpacing: Double) {
    /** A unit square of one size. */
    SQUARE(2.3094),

    /** A disc of one size. */
    CIRCLE(7.3),

    /** A ring whose sizes halve from its outside to the hole. */
    ANNULUS(12.2),

    /** A wing section in a far field of sizes 1 to 1000. */
    AIRFOIL(0.04),

    /** A plate of 200 round holes. */
    PLATE(4.22),

    /** A ragged, unevenly spaced shore with five islands. */
    COAST(7.1),

    /** A square plate with one round hole. */
    HOLE(2.2),

    /** A square plate with 10,000 round holes. */
    SIEVE(2.4),
}
