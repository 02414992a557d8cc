package org.trigrid.improve

import org.trigrid.geometry.HalfEdges.next
import org.trigrid.geometry.HalfEdges.previous
import org.trigrid.quality.TriangleQuality

/**
 * The free nodes around a piece of surgery that is tried: the *seeds*, where it is done, and later their neighbours. Their
 * places can be smoothed, measured and put back.
 */
internal class Patch(private val connectivity: Connectivity) {
    private val mesh = connectivity.mesh
    private val star = Star()
    private var nodes = IntArray(64)
    private var saved = DoubleArray(128)
    private var seeds = 0
    private var count = 0
    private var marks = IntArray(mesh.nodeCount)
    private var mark = 0
    private var elementMarks = IntArray(mesh.elements.size / 3)
    private var elementMark = 0

    /** Least q of the elements that the last sum of energies went over. */
    var minQuality = 0.0
        private set

    /** Begins with the free ones of four nodes as seeds, and remembers their places. */
    fun begin(a: Int, b: Int, c: Int, d: Int) {
        mark++
        count = 0
        add(a)
        add(b)
        add(c)
        add(d)
        seeds = count
    }

    /** Adds a node that the surgery has made to the seeds. */
    fun addSeed(node: Int) {
        add(node)
        seeds = count
    }

    private fun add(node: Int) {
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

    /** Adds the free neighbours of the seeds, and returns the energy of the elements that are new with them. */
    fun widen(): Double {
        for (i in 0 until seeds) {
            val node = nodes[i]
            if (connectivity.outgoing[node] < 0) continue
            star.gather(connectivity, node)
            for (k in 0 until star.count) add(star.ring[k])
        }
        var sum = 0.0
        for (i in seeds until count) sum += energyAround(nodes[i])
        return sum
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

    /** Smooths the neighbours, if there are any yet, and then the seeds. */
    fun smooth() {
        for (i in seeds until count) smooth(nodes[i])
        for (i in 0 until seeds) smooth(nodes[i])
    }

    private fun smooth(node: Int) {
        if (connectivity.outgoing[node] < 0) return
        star.gather(connectivity, node)
        if (!star.smoothingStep()) return
        mesh.xy[2 * node] = star.x
        mesh.xy[2 * node + 1] = star.y
    }

    /**
     * What surgery shall lower: the sum over the elements around the nodes of how far they are from equilateral, bad ones
     * counting more, and of how far their edges are from the wanted length. The elements around [fixed], a fixed node in
     * whose fan the surgery is, are counted too, and so are [t] and [s] even if all their nodes are fixed; -1 for none.
     */
    fun energy(t: Int, s: Int, fixed: Int): Double {
        if (elementMarks.size < mesh.elements.size / 3) elementMarks = elementMarks.copyOf(mesh.elements.size / 3)
        elementMark++
        minQuality = 1.0
        var sum = energyOnce(t) + energyOnce(s)
        if (fixed >= 0) sum += energyInFan(fixed)
        for (i in 0 until count) sum += energyAround(nodes[i])
        return sum
    }

    private fun energyAround(node: Int): Double {
        val first = connectivity.outgoing[node]
        if (first < 0) return 0.0
        var sum = 0.0
        var h = first
        do {
            sum += energyOnce(h / 3)
            h = mesh.twins[previous(h)]
        } while (h != first)
        return sum
    }

    private fun energyInFan(node: Int): Double {
        val first = connectivity.outgoing[node]
        var sum = 0.0
        var h = first
        do {
            sum += energyOnce(h / 3)
            h = mesh.twins[previous(h)]
        } while (h >= 0 && h != first)
        if (h == first) return sum
        h = mesh.twins[first]
        while (h >= 0) {
            h = next(h)
            sum += energyOnce(h / 3)
            h = mesh.twins[h]
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
        val size = 0.5 * (mesh.sizes[a] + mesh.sizes[b])
        val length2 = dx * dx + dy * dy
        val size2 = size * size
        val difference = length2 - size2
        return difference * difference / (length2 * size2)
    }

    private companion object {
        const val STEEPNESS = 2.0

        /** Half of an edge's weight, for it is met from both sides. */
        const val LENGTH_WEIGHT = 0.025
    }
}
