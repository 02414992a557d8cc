package org.trigrid.improve

import org.trigrid.quality.TriangleQuality

/**
 * A closed ring of nodes, anticlockwise, and a place inside it that is sought: the elements between the place and the
 * ring's edges shall be as good as can be. Scratch memory, filled anew for each node.
 *
 * With N the sum of an element's squared sides and D twice its area, 1/q is N / (2 sqrt(3) D). As a function of the
 * place N is a convex quadratic and D is linear, so 1/q and its powers are convex where D > 0, and infinite at the rim:
 * Newton steps that lower their sum find the one best place and never leave the elements' positive side.
 */
internal class Star {
    @JvmField var count: Int = 0

    /** Node numbers of the ring. */
    @JvmField var ring: IntArray = IntArray(32)

    /** x0, y0, x1, y1, … of the ring, and the first node once more. */
    @JvmField var xy: DoubleArray = DoubleArray(66)

    /** The place; result of the searches. */
    @JvmField var x: Double = 0.0

    @JvmField var y: Double = 0.0

    private var gradientX = 0.0
    private var gradientY = 0.0
    private var hessianXx = 0.0
    private var hessianXy = 0.0
    private var hessianYy = 0.0
    private var shortestEdge2 = 0.0
    private var stepX = 0.0
    private var stepY = 0.0

    /** Fills the ring of a free node and puts the place at the node. */
    fun gather(connectivity: Connectivity, node: Int) {
        val elements = connectivity.mesh.elements
        val twins = connectivity.mesh.twins
        val nodes = connectivity.mesh.xy
        val size = connectivity.valence[node]
        reserve(size)
        var h = connectivity.outgoing[node]
        for (i in 0 until size) {
            val corner = h % 3
            val n = elements[h + 1 - 3 * (corner shr 1)]
            ring[i] = n
            xy[2 * i] = nodes[2 * n]
            xy[2 * i + 1] = nodes[2 * n + 1]
            h = twins[h - 1 + 3 * (2 - corner shr 1)]
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

    /** Distance from the place to ring node [i]. */
    fun distance(i: Int): Double {
        val dx = xy[2 * i] - x
        val dy = xy[2 * i + 1] - y
        return Math.sqrt(dx * dx + dy * dy)
    }

    /** Mean distance from the place to the ring's nodes. */
    fun meanDistance(): Double {
        var sum = 0.0
        for (i in 0 until count) sum += distance(i)
        return sum / count
    }

    /** q of the element between the place and ring edge [i]. */
    fun quality(i: Int): Double = TriangleQuality.shape(x, y, xy[2 * i], xy[2 * i + 1], xy[2 * i + 2], xy[2 * i + 3])

    /** Sum of q around the place. */
    fun sumQuality(): Double {
        var sum = 0.0
        for (i in 0 until count) sum += quality(i)
        return sum
    }

    /** Least q around the place; negative or zero where an element is not positive. */
    fun minQuality(): Double {
        var least = 2.0
        for (i in 0 until count) least = Math.min(least, quality(i))
        return least
    }

    /**
     * A step beyond the least sum of 1/q as Newton's method sees it, [EAGERNESS] times as far: the neighbours will follow, and
     * sweeps over many nodes converge faster. Returns whether the place moved.
     *
     * No element's 1/q is above F = sum - (count - 1), the others being 1 at least. As N is at least 1.5 times the squared ring
     * edge e, the place is 0.43 e / F away from the edge's line or more: a step of half of that is safe without a look.
     */
    fun smoothingStep(): Boolean {
        val before = derive()
        if (!prepareStep(before)) return false
        val farX = x + EAGERNESS * stepX
        val farY = y + EAGERNESS * stepY
        // The step as it is after rounding, which matters where elements are a few units in the last place wide.
        val dx = farX - x
        val dy = farY - y
        val highest = before - (count - 1)
        val isShort = (dx * dx + dy * dy) * highest * highest < SAFE * shortestEdge2
        if (!isShort && !(sumAt(farX, farY, steep = false) < before)) return shortenedStep(before, steep = false)
        x = farX
        y = farY
        return true
    }

    /**
     * One Newton step towards the least sum of (1/q)^8, which cares for the worst element nearly alone; halved until the sum
     * falls. Returns whether the place moved.
     */
    fun worstFirstStep(): Boolean {
        val before = deriveSteep()
        return prepareStep(before) && shortenedStep(before, steep = true)
    }

    /** Newton's step from the derivatives at hand; false where there is none. */
    private fun prepareStep(before: Double): Boolean {
        val det = hessianXx * hessianYy - hessianXy * hessianXy
        if (before == Double.POSITIVE_INFINITY || !(det > 0)) return false
        val inverse = 1 / det
        stepX = (hessianXy * gradientY - hessianYy * gradientX) * inverse
        stepY = (hessianXy * gradientX - hessianXx * gradientY) * inverse
        return true
    }

    /** Takes the step, halved until the sum falls below [before]. */
    private fun shortenedStep(before: Double, steep: Boolean): Boolean {
        for (trial in 0..MAX_HALVINGS) {
            if (sumAt(x + stepX, y + stepY, steep) < before) {
                x += stepX
                y += stepY
                return true
            }
            stepX *= 0.5
            stepY *= 0.5
        }
        return false
    }

    /** The sum of 1/q or, if [steep], of (1/q)^8; infinite where an element is not surely positive. */
    private fun sumAt(px: Double, py: Double, steep: Boolean): Double {
        var sum = 0.0
        var ax = xy[0] - px
        var ay = xy[1] - py
        for (i in 1..count) {
            val bx = xy[2 * i] - px
            val by = xy[2 * i + 1] - py
            val ex = bx - ax
            val ey = by - ay
            val d = ax * by - ay * bx
            val n = ax * ax + ay * ay + bx * bx + by * by + ex * ex + ey * ey
            if (d <= SURELY_POSITIVE * n) return Double.POSITIVE_INFINITY
            val f = SCALE * n / d
            sum += if (steep) power8(f) else f
            ax = bx
            ay = by
        }
        return sum
    }

    /** [sumAt] of the place for the sum of 1/q, with its gradient and Hessian by the quotient rule. */
    private fun derive(): Double {
        var sum = 0.0
        var sumInverse = 0.0
        var gx = 0.0
        var gy = 0.0
        var hxx = 0.0
        var hxy = 0.0
        var hyy = 0.0
        var shortest = Double.POSITIVE_INFINITY
        var ax = xy[0] - x
        var ay = xy[1] - y
        var a2 = ax * ax + ay * ay
        for (i in 1..count) {
            val bx = xy[2 * i] - x
            val by = xy[2 * i + 1] - y
            val b2 = bx * bx + by * by
            val ex = bx - ax
            val ey = by - ay
            val d = ax * by - ay * bx
            val e2 = ex * ex + ey * ey
            val n = a2 + b2 + e2
            if (d <= SURELY_POSITIVE * n) return Double.POSITIVE_INFINITY
            shortest = Math.min(shortest, e2)
            // grad D = (-ey, ex), grad N = -2 (a + b), second derivatives of N: 4 on the diagonal.
            val inverse = 1 / d
            val f = n * inverse
            val fx = (f * ey - 2 * (ax + bx)) * inverse
            val fy = (f * ex + 2 * (ay + by)) * inverse
            val slopeX = fx * inverse
            val slopeY = fy * inverse
            sum += f
            sumInverse += inverse
            gx += fx
            gy -= fy
            hxx += ey * slopeX
            hyy += ex * slopeY
            hxy += ey * slopeY + ex * slopeX
            ax = bx
            ay = by
            a2 = b2
        }
        gradientX = SCALE * gx
        gradientY = SCALE * gy
        hessianXx = SCALE * (4 * sumInverse + 2 * hxx)
        hessianXy = -SCALE * hxy
        hessianYy = SCALE * (4 * sumInverse + 2 * hyy)
        shortestEdge2 = shortest
        return SCALE * sum
    }

    /** [sumAt] of the place for the sum of (1/q)^8, as [derive]. */
    private fun deriveSteep(): Double {
        var sum = 0.0
        var gx = 0.0
        var gy = 0.0
        var hxx = 0.0
        var hxy = 0.0
        var hyy = 0.0
        var ax = xy[0] - x
        var ay = xy[1] - y
        for (i in 1..count) {
            val bx = xy[2 * i] - x
            val by = xy[2 * i + 1] - y
            val ex = bx - ax
            val ey = by - ay
            val d = ax * by - ay * bx
            val n = ax * ax + ay * ay + bx * bx + by * by + ex * ex + ey * ey
            if (d <= SURELY_POSITIVE * n) return Double.POSITIVE_INFINITY
            val inverse = 1 / d
            val f = SCALE * n * inverse
            val fx = (f * ey - 2 * SCALE * (ax + bx)) * inverse
            val fy = (-f * ex - 2 * SCALE * (ay + by)) * inverse
            val fxx = (4 * SCALE + 2 * fx * ey) * inverse
            val fyy = (4 * SCALE - 2 * fy * ex) * inverse
            val fxy = (fy * ey - fx * ex) * inverse
            val f6 = f * f * f * f * f * f
            val slope = 8 * f6 * f
            val bend = 56 * f6
            sum += power8(f)
            gx += slope * fx
            gy += slope * fy
            hxx += slope * fxx + bend * fx * fx
            hxy += slope * fxy + bend * fx * fy
            hyy += slope * fyy + bend * fy * fy
            ax = bx
            ay = by
        }
        gradientX = gx
        gradientY = gy
        hessianXx = hxx
        hessianXy = hxy
        hessianYy = hyy
        return sum
    }

    private fun power8(f: Double): Double {
        val f2 = f * f
        val f4 = f2 * f2
        return f4 * f4
    }

    private fun reserve(size: Int) {
        if (size >= ring.size) {
            ring = ring.copyOf(2 * size)
            xy = xy.copyOf(4 * size + 2)
        }
    }

    companion object {
        /** D, or q, above this share of N is positive beyond any rounding, hence by the exact predicate too. */
        const val SURELY_POSITIVE: Double = 1e-12

        /** Turns N / D into 1/q: 1 / (2 sqrt(3)). */
        private const val SCALE = 0.28867513459481287
        private const val MAX_HALVINGS = 3

        /** Factor of over-relaxation. */
        private const val EAGERNESS = 1.4

        /** Square of half of sqrt(3) / 4. */
        private const val SAFE = 0.046
    }
}
