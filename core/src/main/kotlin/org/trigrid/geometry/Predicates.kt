package org.trigrid.geometry

import org.locationtech.jts.math.DD
import java.math.BigDecimal

/**
 * Signs of geometric determinants, exact for all finite coordinates whose products neither overflow nor vanish.
 *
 * Each test runs in up to three steps: plain doubles with a proven error bound (Shewchuk 1997, Discrete Comput. Geom.
 * 18:305-363, section 4), an exact product where the coordinate differences are themselves exact, and else JTS's
 * double-double arithmetic, backed by exact decimals where even that cannot tell the sign from zero.
 */
internal object Predicates {
    private const val ORIENT_BOUND = 3.3306690738754716e-16
    private const val INCIRCLE_BOUND = 1.1102230246251577e-15

    /** Double-double results are good to about 2^-100 of the products; below this share of them the sign is not trusted. */
    private const val DD_BOUND = 1e-28

    /** > 0 if a, b, c turn anticlockwise, < 0 if clockwise, 0 if they lie on one line; only the sign has a meaning. */
    @JvmStatic
    fun orient(ax: Double, ay: Double, bx: Double, by: Double, cx: Double, cy: Double): Double {
        val left = (ax - cx) * (by - cy)
        val right = (ay - cy) * (bx - cx)
        val det = left - right
        val bound = ORIENT_BOUND * (Math.abs(left) + Math.abs(right))
        return if (det > bound || -det > bound) det else orientExact(ax, ay, bx, by, cx, cy)
    }

    /** > 0 if d lies inside the circle through a, b, c (anticlockwise), < 0 outside, 0 on it. */
    @JvmStatic
    fun inCircle(
        ax: Double, ay: Double, bx: Double, by: Double, cx: Double, cy: Double, dx: Double, dy: Double,
    ): Double {
        val det = inCircleFiltered(ax, ay, bx, by, cx, cy, dx, dy)
        return if (det != 0.0) det else inCircleExact(ax, ay, bx, by, cx, cy, dx, dy)
    }

    /** As [inCircle] where plain doubles can tell the sign, and 0 where they cannot. */
    @JvmStatic
    fun inCircleFiltered(
        ax: Double, ay: Double, bx: Double, by: Double, cx: Double, cy: Double, dx: Double, dy: Double,
    ): Double {
        val adx = ax - dx
        val ady = ay - dy
        val bdx = bx - dx
        val bdy = by - dy
        val cdx = cx - dx
        val cdy = cy - dy
        val bc1 = bdx * cdy
        val bc2 = cdx * bdy
        val alift = adx * adx + ady * ady
        val ca1 = cdx * ady
        val ca2 = adx * cdy
        val blift = bdx * bdx + bdy * bdy
        val ab1 = adx * bdy
        val ab2 = bdx * ady
        val clift = cdx * cdx + cdy * cdy
        val det = alift * (bc1 - bc2) + blift * (ca1 - ca2) + clift * (ab1 - ab2)
        val permanent = (Math.abs(bc1) + Math.abs(bc2)) * alift +
            (Math.abs(ca1) + Math.abs(ca2)) * blift + (Math.abs(ab1) + Math.abs(ab2)) * clift
        val bound = INCIRCLE_BOUND * permanent
        return if (det > bound || -det > bound) det else 0.0
    }

    private fun orientExact(ax: Double, ay: Double, bx: Double, by: Double, cx: Double, cy: Double): Double {
        val acx = ax - cx
        val acy = ay - cy
        val bcx = bx - cx
        val bcy = by - cy
        if (isExact(ax, cx, acx) && isExact(ay, cy, acy) && isExact(bx, cx, bcx) && isExact(by, cy, bcy)) {
            return compareProducts(acx, bcy, acy, bcx)
        }
        val left = DD.valueOf(ax).selfSubtract(cx).selfMultiply(DD.valueOf(by).selfSubtract(cy))
        val right = DD.valueOf(ay).selfSubtract(cy).selfMultiply(DD.valueOf(bx).selfSubtract(cx))
        val bound = DD_BOUND * (Math.abs(left.doubleValue()) + Math.abs(right.doubleValue()))
        val det = left.selfSubtract(right).doubleValue()
        return if (Math.abs(det) > bound) det else orientDecimal(ax, ay, bx, by, cx, cy)
    }

    /** Whether `a - b == difference` without rounding (the tail of Knuth's two-difference is zero). */
    private fun isExact(a: Double, b: Double, difference: Double): Boolean {
        val bVirtual = a - difference
        val aVirtual = difference + bVirtual
        return (bVirtual - b) + (a - aVirtual) == 0.0
    }

    /** Sign of `a * b - c * d`, exact: a product is its rounding plus the remainder that fma gives. */
    private fun compareProducts(a: Double, b: Double, c: Double, d: Double): Double {
        val ab = a * b
        val cd = c * d
        if (ab != cd) return ab - cd
        return Math.fma(a, b, -ab) - Math.fma(c, d, -cd)
    }

    private fun orientDecimal(ax: Double, ay: Double, bx: Double, by: Double, cx: Double, cy: Double): Double {
        val left = minus(ax, cx).multiply(minus(by, cy))
        val right = minus(ay, cy).multiply(minus(bx, cx))
        return left.compareTo(right).toDouble()
    }

    private fun inCircleExact(
        ax: Double, ay: Double, bx: Double, by: Double, cx: Double, cy: Double, dx: Double, dy: Double,
    ): Double {
        val adx = minus(ax, dx)
        val ady = minus(ay, dy)
        val bdx = minus(bx, dx)
        val bdy = minus(by, dy)
        val cdx = minus(cx, dx)
        val cdy = minus(cy, dy)
        val a = (adx * adx + ady * ady) * (bdx * cdy - cdx * bdy)
        val b = (bdx * bdx + bdy * bdy) * (cdx * ady - adx * cdy)
        val c = (cdx * cdx + cdy * cdy) * (adx * bdy - bdx * ady)
        return (a + b + c).signum().toDouble()
    }

    private fun minus(a: Double, b: Double): BigDecimal = BigDecimal(a).subtract(BigDecimal(b))
}
