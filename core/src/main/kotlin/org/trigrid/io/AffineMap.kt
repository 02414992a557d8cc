package org.trigrid.io

/** (x, y) to (a x + c y + e, b x + d y + f), as SVG writes `matrix(a b c d e f)`. */
internal class AffineMap(val a: Double, val b: Double, val c: Double, val d: Double, val e: Double, val f: Double) {
    fun x(x: Double, y: Double): Double = a * x + c * y + e

    fun y(x: Double, y: Double): Double = b * x + d * y + f

    /** First [inner], then this one. */
    operator fun times(inner: AffineMap): AffineMap = AffineMap(
        a * inner.a + c * inner.b, b * inner.a + d * inner.b,
        a * inner.c + c * inner.d, b * inner.c + d * inner.d,
        a * inner.e + c * inner.f + e, b * inner.e + d * inner.f + f,
    )

    companion object {
        val IDENTITY = AffineMap(1.0, 0.0, 0.0, 1.0, 0.0, 0.0)

        fun translation(x: Double, y: Double) = AffineMap(1.0, 0.0, 0.0, 1.0, x, y)

        fun rotation(degrees: Double): AffineMap {
            val cos = org.trigrid.shape.Turn.cos(degrees / 360)
            val sin = org.trigrid.shape.Turn.sin(degrees / 360)
            return AffineMap(cos, sin, -sin, cos, 0.0, 0.0)
        }
    }
}
