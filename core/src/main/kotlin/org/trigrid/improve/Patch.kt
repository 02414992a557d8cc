package org.trigrid.improve

import org.trigrid.improve.Connectivity.Companion.previous
import org.trigrid.quality.TriangleQuality

/**
 * The free nodes around a piece of surgery that is tried: their places can be smoothed, measured and put back.
 */
internal class Patch(private val connectivity: Connectivity) {
    private val mesh = connectivity.mesh
    private val star = Star()
    private var nodes = IntArray(64)
    private var saved = DoubleArray(128)
    private var count = 0
    private var marks = IntArray(mesh.nodeCount)
    private var mark = 0
    private var elementMarks = IntArray(mesh.elements.size / 3)
    private var elementMark = 0

    /** Least q at the last [energy]. */
    var minQuality = 0.0
        private set

    /** Takes the free ones of four nodes and of their neighbours, and remembers their places. */
    fun collect(a: Int, b: Int, c: Int, d: Int) {
        mark++
        count = 0
        add(a)
        add(b)
        add(c)
        add(d)
        val seeds = count
        for (i in 0 until seeds) {
            star.gather(connectivity, nodes[i])
            for (k in 0 until star.count) add(star.ring[k])
        }
    }

    /** Adds a node that the surgery has made. */
    fun add(node: Int) {
        if (!connectivity.isFree(node)) return
        if (node >= marks.size) marks = marks.copyOf(node + node / 2 + 16)
        if (marks[node] == mark) return
        marks[node] = mark
        if (count == nodes.size) {
            nodes = nodes.copyOf(2 * count)
            saved = saved.copyOf(4 * count)
        }
        saved[2 * count] = mesh.xy[2 * node]
        saved[2 * count + 1] = mesh.xy[2 * node + 1]
        nodes[count++] = node
    }

    /** Puts the nodes back to where they were. */
    fun restore() {
        for (i in 0 until count) {
            mesh.xy[2 * nodes[i]] = saved[2 * i]
            mesh.xy[2 * nodes[i] + 1] = saved[2 * i + 1]
        }
    }

    fun touch(changes: Changes) {
        for (i in 0 until count) changes.touch(nodes[i])
    }

    /** Smooths the nodes. */
    fun smooth() {
        for (sweep in 0 until SWEEPS) {
            for (i in 0 until count) {
                if (connectivity.outgoing[nodes[i]] < 0) continue
                star.gather(connectivity, nodes[i])
                if (star.newtonStep(steep = false)) {
                    mesh.xy[2 * nodes[i]] = star.x
                    mesh.xy[2 * nodes[i] + 1] = star.y
                }
            }
        }
    }

    /**
     * What surgery shall lower: the sum over the elements around the nodes of how far they are from equilateral, bad ones
     * counting more, and of how far their edges are from the wanted length. The elements [t] and [s] are counted even
     * if all their nodes are fixed; -1 for none.
     */
    fun energy(t: Int, s: Int): Double {
        if (elementMarks.size < mesh.elements.size / 3) elementMarks = elementMarks.copyOf(mesh.elements.size / 3)
        elementMark++
        minQuality = 1.0
        var sum = energyOnce(t) + energyOnce(s)
        for (i in 0 until count) {
            val first = connectivity.outgoing[nodes[i]]
            if (first < 0) continue
            var h = first
            do {
                sum += energyOnce(h / 3)
                h = mesh.twins[previous(h)]
            } while (h != first)
        }
        return sum
    }

    /** Energy of element [t] unless it has been counted or is none. */
    private fun energyOnce(t: Int): Double {
        if (t < 0 || elementMarks[t] == elementMark) return 0.0
        elementMarks[t] = elementMark
        return energyOf(t)
    }

    private fun energyOf(t: Int): Double {
        val a = mesh.elements[3 * t]
        val b = mesh.elements[3 * t + 1]
        val c = mesh.elements[3 * t + 2]
        val xy = mesh.xy
        val q = TriangleQuality.shape(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1])
        if (q < minQuality) minQuality = q
        val lack = 1 - q
        return lack + STEEPNESS * lack * lack + LENGTH_WEIGHT * (lengthError(a, b) + lengthError(b, c) + lengthError(c, a))
    }

    /** r + 1/r - 2 for r = (length / wanted)^2: near 1 it is 4 times the squared logarithm of length over wanted. */
    private fun lengthError(a: Int, b: Int): Double {
        val dx = mesh.xy[2 * a] - mesh.xy[2 * b]
        val dy = mesh.xy[2 * a + 1] - mesh.xy[2 * b + 1]
        val size = mesh.sizes[a] + mesh.sizes[b]
        val r = 4 * (dx * dx + dy * dy) / (size * size)
        return r + 1 / r - 2
    }

    private companion object {
        const val SWEEPS = 2
        const val STEEPNESS = 2.0

        /** Half of an edge's weight, for it is met from both sides. */
        const val LENGTH_WEIGHT = 0.025
    }
}
