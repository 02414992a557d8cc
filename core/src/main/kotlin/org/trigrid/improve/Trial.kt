package org.trigrid.improve

import org.trigrid.improve.Connectivity.Companion.next
import org.trigrid.improve.Connectivity.Companion.previous
import org.trigrid.quality.TriangleQuality

/** Tries flips for the sake of the mean quality of a patch after smoothing it. */
internal class Trial(
    private val connectivity: Connectivity,
    private val ideal: IdealValence,
    private val changes: Changes,
) {
    private val mesh = connectivity.mesh
    private val star = Star()
    private val seeds = IntArray(4)
    private var nodes = IntArray(256)
    private var nodeCount = 0
    private var saved = DoubleArray(512)
    private var mark = IntArray(mesh.nodeCount)
    private var stamp = 0
    private var elementMark = IntArray(mesh.elementCount)
    var tried = 0
    var done = 0

    fun pass() {
        val m3 = 3 * mesh.elementCount
        for (h in 0 until m3) {
            if (mesh.elements[h - h % 3] < 0 || mesh.twins[h] < h) continue
            tryFlip(h)
        }
    }

    fun tryFlip(h: Int): Boolean {
        val g = mesh.twins[h]
        val a = mesh.elements[h]
        val b = mesh.elements[g]
        val c = mesh.elements[previous(h)]
        val d = mesh.elements[previous(g)]
        val v = connectivity.valence
        val gain = 2 * (v[a] - ideal.of(a) + v[b] - ideal.of(b) - v[c] + ideal.of(c) - v[d] + ideal.of(d)) - 4
        if (gain < LEAST_GAIN && (gain < LEAST_GAIN_POOR || minOf(area(a, b, c), area(b, a, d)) > POOR - 0.1)) return false
        if (v[a] <= (if (connectivity.isFree(a)) 4 else 1) || v[b] <= (if (connectivity.isFree(b)) 4 else 1)) return false
        if (!mesh.embedded.isEmpty && mesh.isEmbedded(a, b)) return false
        if (area(a, d, c) <= 0 || area(b, c, d) <= 0) return false
        if (!(changed(a) || changed(b) || changed(c) || changed(d))) return false
        tried++
        collect(a, b, c, d)
        val before = energy()
        connectivity.flip(h)
        relax()
        if (energy() < before - ENOUGH) {
            done++
            for (i in 0 until nodeCount) changes.touch(nodes[i])
            return true
        }
        connectivity.flip(next(h))
        for (i in 0 until nodeCount) {
            mesh.xy[2 * nodes[i]] = saved[2 * i]
            mesh.xy[2 * nodes[i] + 1] = saved[2 * i + 1]
        }
        return false
    }

    private fun changed(n: Int) = true

    private fun area(a: Int, b: Int, c: Int): Double {
        val xy = mesh.xy
        return TriangleQuality.shape(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1]) - 0.1
    }

    private fun collect(a: Int, b: Int, c: Int, d: Int) {
        stamp++
        nodeCount = 0
        add(a)
        add(b)
        add(c)
        add(d)
        val core = nodeCount
        for (i in 0 until core) {
            val n = nodes[i]
            if (!connectivity.isFree(n)) continue
            star.gather(connectivity, n)
            for (k in 0 until star.count) add(star.ring[k])
        }
        for (i in 0 until nodeCount) {
            saved[2 * i] = mesh.xy[2 * nodes[i]]
            saved[2 * i + 1] = mesh.xy[2 * nodes[i] + 1]
        }
    }

    private fun add(n: Int) {
        if (n >= mark.size) mark = mark.copyOf(2 * n + 1)
        if (mark[n] == stamp || !connectivity.isFree(n)) return
        mark[n] = stamp
        if (nodeCount == nodes.size) {
            nodes = nodes.copyOf(2 * nodeCount)
            saved = saved.copyOf(4 * nodeCount)
        }
        nodes[nodeCount++] = n
    }

    private fun relax() {
        for (sweep in 0 until SWEEPS) {
            for (i in 0 until nodeCount) {
                star.gather(connectivity, nodes[i])
                if (star.newtonStep()) {
                    mesh.xy[2 * nodes[i]] = star.x
                    mesh.xy[2 * nodes[i] + 1] = star.y
                }
            }
        }
    }

    private var energyStamp = 0

    private fun energy(): Double {
        if (elementMark.size < mesh.elements.size / 3) elementMark = elementMark.copyOf(mesh.elements.size / 3)
        energyStamp++
        var sum = 0.0
        for (i in 0 until nodeCount) {
            val first = connectivity.outgoing[nodes[i]]
            var h = first
            do {
                val t = h / 3
                if (elementMark[t] != energyStamp) {
                    elementMark[t] = energyStamp
                    val a = mesh.elements[3 * t]
                    val b = mesh.elements[3 * t + 1]
                    val c = mesh.elements[3 * t + 2]
                    val xy = mesh.xy
                    val q = TriangleQuality.shape(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1])
                    sum += if (POWER == 0) 1 - q else 1 / q
                }
                h = mesh.twins[previous(h)]
            } while (h != first)
        }
        return sum
    }

    companion object {
        @JvmField var LEAST_GAIN = -1.01
        @JvmField var LEAST_GAIN_POOR = -2.01
        @JvmField var POOR = 0.9
        @JvmField var SWEEPS = 2
        @JvmField var ENOUGH = 0.001
        @JvmField var POWER = 0
    }
}
