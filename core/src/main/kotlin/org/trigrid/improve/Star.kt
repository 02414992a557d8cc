package org.trigrid.improve

import org.trigrid.quality.TriangleQuality

/**
 * A closed ring of nodes, anticlockwise, and a place inside it that is sought: the elements between the place and the
 * ring's edges shall be as good as can be. Scratch memory, filled anew for each node.
 */
internal class Star {
    @JvmField
    var count: Int = 0

    /** Node numbers of the ring. */
    @JvmField
    var ring: IntArray = IntArray(32)

    /** x0, y0, x1, y1, … of the ring, and the first node once more. */
    @JvmField
    var xy: DoubleArray = DoubleArray(66)

    /** The place; result of the searches. */
    @JvmField
    var x: Double = 0.0

    @JvmField
    var y: Double = 0.0

    /** Sum over the elements of 1/q as of the last [newtonStep]. */
    private var gradientX = 0.0
    private var gradientY = 0.0
    private var hessianXx = 0.0
    private var hessianXy = 0.0
    private var hessianYy = 0.0

    /** Fills the ring of a free node and puts the place at the node. */
    fun gather(connectivity: Connectivity, node: Int) {
        val elements = connectivity.mesh.elements
        val twins = connectivity.mesh.twins
        val nodes = connectivity.mesh.xy
        val size = connectivity.valence[node]
        reserve(size)
        var h = connectivity.outgoing[node]
        for (i in 0 until size) {
            val t = h - h % 3
            val n: Int
            val back: Int
            if (h == t) {
                n = elements[t + 1]
                back = t + 2
            } else if (h == t + 1) {
                n = elements[t + 2]
                back = t
            } else {
                n = elements[t]
                back = t + 1
            }
            ring[i] = n
            xy[2 * i] = nodes[2 * n]
            xy[2 * i + 1] = nodes[2 * n + 1]
            h = twins[back]
        }
        count = size
        close()
        x = nodes[2 * node]
        y = nodes[2 * node + 1]
    }

    /** Starts an empty ring. */
    fun clear() {
        count = 0
    }

    /** Appends a node to the ring; [close] ends it. */
    fun add(node: Int, nodeX: Double, nodeY: Double) {
        reserve(count + 1)
        ring[count] = node
        xy[2 * count] = nodeX
        xy[2 * count + 1] = nodeY
        count++
    }

    fun close() {
        xy[2 * count] = xy[0]
        xy[2 * count + 1] = xy[1]
    }

    /** Puts the place at the mean of the ring. */
    fun centre() {
        var sumX = 0.0
        var sumY = 0.0
        for (i in 0 until count) {
            sumX += xy[2 * i]
            sumY += xy[2 * i + 1]
        }
        x = sumX / count
        y = sumY / count
    }

    /** Least q of the elements around the place ([px], [py]); negative or zero where one is not positive. */
    fun minQuality(px: Double, py: Double): Double {
        var least = 2.0
        for (i in 0 until count) {
            val q = TriangleQuality.shape(px, py, xy[2 * i], xy[2 * i + 1], xy[2 * i + 2], xy[2 * i + 3])
            if (q < least) least = q
        }
        return least
    }

    /** q of the element between the place and ring edge [i]. */
    fun quality(i: Int): Double = TriangleQuality.shape(x, y, xy[2 * i], xy[2 * i + 1], xy[2 * i + 2], xy[2 * i + 3])

    /** Sum of q of the elements around the place. */
    fun sumQuality(px: Double, py: Double): Double {
        var sum = 0.0
        for (i in 0 until count) sum += TriangleQuality.shape(px, py, xy[2 * i], xy[2 * i + 1], xy[2 * i + 2], xy[2 * i + 3])
        return sum
    }

    /** Sum of 1/q, up to a constant factor, around ([px], [py]); infinite where an element is not surely positive. */
    fun inverseQuality(px: Double, py: Double): Double {
        var sum = 0.0
        for (i in 0 until count) {
            val ax = xy[2 * i] - px
            val ay = xy[2 * i + 1] - py
            val bx = xy[2 * i + 2] - px
            val by = xy[2 * i + 3] - py
            val ex = bx - ax
            val ey = by - ay
            val d = ax * by - ay * bx
            val n = ax * ax + ay * ay + bx * bx + by * by + ex * ex + ey * ey
            if (d <= SURELY_POSITIVE * n) return Double.POSITIVE_INFINITY
            sum += n / d
        }
        return sum
    }

    /**
     * One Newton step towards the least sum of 1/q, halved until the sum falls; that sum is convex wherever all elements
     * are positive and infinite at the rim, so no step can leave it. Returns whether the place moved.
     */
    fun newtonStep(): Boolean {
        val before = derive()
        if (before == Double.POSITIVE_INFINITY) return false
        val det = hessianXx * hessianYy - hessianXy * hessianXy
        if (!(det > 0)) return false
        var stepX = -(hessianYy * gradientX - hessianXy * gradientY) / det
        var stepY = -(hessianXx * gradientY - hessianXy * gradientX) / det
        for (trial in 0..3) {
            val px = x + stepX
            val py = y + stepY
            if (inverseQuality(px, py) < before) {
                x = px
                y = py
                return true
            }
            stepX *= 0.5
            stepY *= 0.5
        }
        return false
    }

    /** Sum of N/D (N the squared sides, D twice the area) with its derivatives at the place, by the quotient rule. */
    private fun derive(): Double {
        var sum = 0.0
        var gx = 0.0
        var gy = 0.0
        var hxx = 0.0
        var hxy = 0.0
        var hyy = 0.0
        val px = x
        val py = y
        val xy = xy
        var ax = xy[0] - px
        var ay = xy[1] - py
        var aa = ax * ax + ay * ay
        for (i in 1..count) {
            val bx = xy[2 * i] - px
            val by = xy[2 * i + 1] - py
            val bb = bx * bx + by * by
            val ex = bx - ax
            val ey = by - ay
            val d = ax * by - ay * bx
            val n = aa + bb + ex * ex + ey * ey
            if (d <= SURELY_POSITIVE * n) return Double.POSITIVE_INFINITY
            val inverse = 1 / d
            val f = n * inverse
            // grad D = (-ey, ex), grad N = -2 (a + b)
            val fx = (-2 * (ax + bx) + f * ey) * inverse
            val fy = (-2 * (ay + by) - f * ex) * inverse
            sum += f
            gx += fx
            gy += fy
            hxx += (4 + 2 * fx * ey) * inverse
            hyy += (4 - 2 * fy * ex) * inverse
            hxy += (fy * ey - fx * ex) * inverse
            ax = bx
            ay = by
            aa = bb
        }
        gradientX = gx
        gradientY = gy
        hessianXx = hxx
        hessianXy = hxy
        hessianYy = hyy
        return sum
    }

    /**
     * As [newtonStep] for the sum of (1/q)^8, convex too, which cares for the worst element nearly alone.
     */
    fun steepStep(): Boolean {
        val before = deriveSteep()
        if (before == Double.POSITIVE_INFINITY) return false
        val det = hessianXx * hessianYy - hessianXy * hessianXy
        if (!(det > 0)) return false
        var stepX = -(hessianYy * gradientX - hessianXy * gradientY) / det
        var stepY = -(hessianXx * gradientY - hessianXy * gradientX) / det
        for (trial in 0..3) {
            val px = x + stepX
            val py = y + stepY
            if (steepSum(px, py) < before) {
                x = px
                y = py
                return true
            }
            stepX *= 0.5
            stepY *= 0.5
        }
        return false
    }

    private fun steepSum(px: Double, py: Double): Double {
        var sum = 0.0
        for (i in 0 until count) {
            val ax = xy[2 * i] - px
            val ay = xy[2 * i + 1] - py
            val bx = xy[2 * i + 2] - px
            val by = xy[2 * i + 3] - py
            val ex = bx - ax
            val ey = by - ay
            val d = ax * by - ay * bx
            val n = ax * ax + ay * ay + bx * bx + by * by + ex * ex + ey * ey
            if (d <= SURELY_POSITIVE * n) return Double.POSITIVE_INFINITY
            val f = SCALE * n / d
            val f2 = f * f
            val f4 = f2 * f2
            sum += f4 * f4
        }
        return sum
    }

    private fun deriveSteep(): Double {
        var sum = 0.0
        var gx = 0.0
        var gy = 0.0
        var hxx = 0.0
        var hxy = 0.0
        var hyy = 0.0
        for (i in 0 until count) {
            val ax = xy[2 * i] - x
            val ay = xy[2 * i + 1] - y
            val bx = xy[2 * i + 2] - x
            val by = xy[2 * i + 3] - y
            val ex = bx - ax
            val ey = by - ay
            val d = ax * by - ay * bx
            val n = ax * ax + ay * ay + bx * bx + by * by + ex * ex + ey * ey
            if (d <= SURELY_POSITIVE * n) return Double.POSITIVE_INFINITY
            val inverse = SCALE / d
            val f = n * inverse
            val slope = f / SCALE
            val fx = (-2 * (ax + bx) + slope * ey) * inverse
            val fy = (-2 * (ay + by) - slope * ex) * inverse
            val f2 = f * f
            val f6 = f2 * f2 * f2
            val w1 = 8 * f6 * f
            val w2 = 56 * f6
            sum += f6 * f2
            gx += w1 * fx
            gy += w1 * fy
            hxx += w1 * (4 * inverse + 2 * fx * ey / d) + w2 * fx * fx
            hyy += w1 * (4 * inverse - 2 * fy * ex / d) + w2 * fy * fy
            hxy += w1 * (fy * ey - fx * ex) / d + w2 * fx * fy
        }
        gradientX = gx
        gradientY = gy
        hessianXx = hxx
        hessianXy = hxy
        hessianYy = hyy
        return sum
    }

    private fun reserve(size: Int) {
        if (size >= ring.size) {
            ring = ring.copyOf(2 * size)
            xy = xy.copyOf(4 * size + 2)
        }
    }

    companion object {
        /** D above this share of N is positive beyond any rounding, hence by the exact predicate too. */
        const val SURELY_POSITIVE: Double = 1e-12

        /** 1 over the least N/D, that of an equilateral triangle. */
        private const val SCALE = 0.28867513459481287
    }
}
