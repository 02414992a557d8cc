package org.trigrid.improve

import org.trigrid.improve.Connectivity.Companion.next
import org.trigrid.improve.Connectivity.Companion.previous
import org.trigrid.quality.TriangleQuality

/** Flips edges from a work-list until none is left that pays. */
internal class Flipper(
    private val connectivity: Connectivity,
    private val ideal: IdealValence,
    private val changes: Changes,
) {
    private val mesh = connectivity.mesh
    private var stack = IntArray(1024)
    private var height = 0
    private var waiting = ByteArray(mesh.elements.size)

    /** Whether flips follow the quality alone, no longer the valences. */
    var byQuality: Boolean = false

    fun pushAll() {
        for (h in 3 * mesh.elementCount - 1 downTo 0) if (mesh.elements[h - h % 3] >= 0 && mesh.twins[h] > h) push(h)
    }

    /** Adds the edges of the element of [h]. */
    fun pushElement(h: Int) {
        val t = h - h % 3
        push(t)
        push(t + 1)
        push(t + 2)
    }

    /** Adds all edges of the elements around a free node. */
    fun pushStar(node: Int) {
        val first = connectivity.outgoing[node]
        var h = first
        do {
            pushElement(h)
            h = mesh.twins[previous(h)]
        } while (h != first && h >= 0)
    }

    /** Works the list off; returns the number of flips. */
    fun run(): Int {
        var flips = 0
        while (height > 0) {
            val h = stack[--height]
            waiting[h] = 0
            if (!connectivity.isAlive(h) || mesh.twins[h] < 0) continue
            if (!isFlipGood(h)) continue
            val g = mesh.twins[h]
            connectivity.flip(h)
            flips++
            changes.touch(mesh.elements[h])
            changes.touch(mesh.elements[g])
            changes.touch(mesh.elements[previous(h)])
            changes.touch(mesh.elements[previous(g)])
            push(h)
            push(previous(h))
            push(g)
            push(previous(g))
        }
        return flips
    }

    private fun push(h: Int) {
        if (waiting.size < mesh.elements.size) waiting = waiting.copyOf(mesh.elements.size)
        val g = mesh.twins[h]
        if (g < 0 || waiting[h] != 0.toByte() || waiting[g] != 0.toByte()) return
        if (height == stack.size) stack = stack.copyOf(2 * height)
        stack[height++] = h
        waiting[h] = 1
    }

    private fun isFlipGood(h: Int): Boolean {
        val elements = mesh.elements
        val g = mesh.twins[h]
        val a = elements[h]
        val b = elements[g]
        val c = elements[previous(h)]
        val d = elements[previous(g)]
        val valence = connectivity.valence
        var gain = 0.0
        if (!byQuality) {
            gain = 2 * (valence[a] - ideal.of(a) + valence[b] - ideal.of(b) - valence[c] + ideal.of(c) - valence[d] + ideal.of(d)) - 4
            if (gain < -EQUAL) return false
        }
        if (isTooFew(a) || isTooFew(b)) return false
        val xy = mesh.xy
        val ax = xy[2 * a]
        val ay = xy[2 * a + 1]
        val bx = xy[2 * b]
        val by = xy[2 * b + 1]
        val cx = xy[2 * c]
        val cy = xy[2 * c + 1]
        val dx = xy[2 * d]
        val dy = xy[2 * d + 1]
        // The quadrilateral runs a, d, b, c.
        val after = minOf(TriangleQuality.shape(ax, ay, dx, dy, cx, cy), TriangleQuality.shape(bx, by, cx, cy, dx, dy))
        if (after < Star.SURELY_POSITIVE) return false
        val before = minOf(TriangleQuality.shape(ax, ay, bx, by, cx, cy), TriangleQuality.shape(bx, by, ax, ay, dx, dy))
        val pays = if (gain > EQUAL) {
            after >= before || after > LEAST_QUALITY && after > LEAST_SHARE * before
        } else {
            after > before * (1 + EQUAL)
        }
        return pays && (mesh.embedded.isEmpty || !mesh.isEmbedded(a, b))
    }

    private fun isTooFew(node: Int): Boolean = connectivity.valence[node] <= if (connectivity.isFree(node)) 3 else 1

    companion object {
        private const val EQUAL = 1e-9

        /** A flip for the valences' sake may lower the quality, but not below these. */
        @JvmField var LEAST_QUALITY = 0.35
        @JvmField var LEAST_SHARE = 0.6
    }
}
