package org.trigrid.improve

import org.trigrid.geometry.HalfEdges.next
import org.trigrid.geometry.HalfEdges.previous
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

    /** Looks at all edges and at those that flips change. */
    fun runAll(progress: ImproveProgress) {
        changes.clear(Changes.FLIPS)
        val count = 3 * mesh.elementCount
        if (waiting.size < mesh.elements.size) waiting = waiting.copyOf(mesh.elements.size)
        if (stack.size < count / 2 + 2) stack = stack.copyOf(count / 2 + 2)
        for (h in count - 1 downTo 0) {
            progress.pass()
            // Which of two twins has the lower number could not be foreseen by a branch: 1 for a live edge's first half.
            val isFirst = (h - mesh.twins[h] ushr 31) and (mesh.elements[h - h % 3].inv() ushr 31)
            stack[height] = h
            height += isFirst
            waiting[h] = isFirst.toByte()
        }
        run(progress)
    }

    /** Looks at the edges of all elements around which something has changed since the last look. */
    fun runChanged(progress: ImproveProgress) {
        var due = 0
        for (n in 0 until mesh.nodeCount) if (changes.has(n, Changes.FLIPS)) due++
        if (2 * due > mesh.nodeCount) return runAll(progress)
        for (n in mesh.nodeCount - 1 downTo 0) {
            progress.pass()
            if (connectivity.outgoing[n] >= 0 && changes.take(n, Changes.FLIPS)) pushStar(n)
        }
        run(progress)
    }

    /** Adds the edges of the element of [h]. */
    private fun pushElement(h: Int) {
        val t = h - h % 3
        push(t)
        push(t + 1)
        push(t + 2)
    }

    /** Adds all edges of the elements around a node. */
    fun pushStar(node: Int) {
        val first = connectivity.outgoing[node]
        var h = first
        do {
            pushElement(h)
            h = mesh.twins[previous(h)]
        } while (h != first && h >= 0)
        if (h == first) return
        // At the boundary the fan goes on to the other side of where the turn began.
        h = mesh.twins[first]
        while (h >= 0) {
            pushElement(h)
            h = mesh.twins[next(h)]
        }
    }

    /** Works the list off. */
    fun run(progress: ImproveProgress) {
        while (height > 0) {
            progress.pass()
            val h = stack[--height]
            waiting[h] = 0
            if (!connectivity.isAlive(h) || mesh.twins[h] < 0) continue
            if (!isFlipGood(h)) continue
            val g = mesh.twins[h]
            connectivity.flip(h)
            changes.touch(mesh.elements[h])
            changes.touch(mesh.elements[g])
            changes.touch(mesh.elements[previous(h)])
            changes.touch(mesh.elements[previous(g)])
            push(h)
            push(previous(h))
            push(g)
            push(previous(g))
        }
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
        val gain = if (byQuality) 0.0 else ideal.flipGain(connectivity.valence, a, b, c, d)
        if (gain < -EQUAL) return false
        if (connectivity.isAtLeast(a) || connectivity.isAtLeast(b)) return false
        val before = Math.min(quality(a, b, c), quality(b, a, d))
        if (before > BEST_OF_BOTH && gain <= EQUAL) return false
        // The quadrilateral runs a, d, b, c.
        val after = Math.min(quality(a, d, c), quality(b, c, d))
        if (after < Star.SURELY_POSITIVE) return false
        val pays = if (gain > EQUAL) {
            QualityGuard.allows(before, after, LEAST_QUALITY, LEAST_SHARE)
        } else {
            after > before * (1 + EQUAL)
        }
        return pays && !mesh.isEmbedded(a, b)
    }

    private fun quality(a: Int, b: Int, c: Int): Double {
        val xy = mesh.xy
        return TriangleQuality.shape(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1])
    }

    private companion object {
        const val EQUAL = 1e-9

        /** Both ways to cut a quadrilateral can be as good as this in a square alone: sqrt(3) / 2. */
        const val BEST_OF_BOTH = 0.8661

        /** A flip for the valences' sake may lower the quality, but not below these. */
        const val LEAST_QUALITY = 0.35
        const val LEAST_SHARE = 0.6
    }
}
