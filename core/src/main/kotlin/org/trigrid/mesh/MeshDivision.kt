package org.trigrid.mesh

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.geometry.HalfEdges
import org.trigrid.geometry.IntList

/**
 * A mesh cut along edges into parts that can be changed each by itself, and put together again.
 *
 * Where parts meet, nodes and edges are fixed in all of them, as those of the boundary are; that keeps parts fitting.
 */
internal class MeshDivision(
    private val whole: MutableMesh,
    /** Per element its part; no element may be dead. Not modified. */
    private val partOf: IntArray,
    private val partCount: Int,
    checkpoint: Checkpoint,
) {
    /** Per part its first place in [elementsByPart], and all elements' count at the end. */
    private val starts = IntArray(partCount + 1)
    private val elementsByPart = IntArray(whole.elementCount)

    /** Per element its number in its part. */
    private val numberInPart = IntArray(whole.elementCount)

    /** Per node the part that has it alone, or [SHARED]. */
    private val ownerOf = IntArray(whole.nodeCount)

    /** Per free node that is not shared its number in its part, less the part's fixed nodes. */
    private val numberOf = IntArray(whole.nodeCount)

    init {
        for (t in 0 until whole.elementCount) {
            checkpoint.pass()
            starts[partOf[t] + 1]++
        }
        for (p in 0 until partCount) starts[p + 1] += starts[p]
        val filled = starts.copyOf()
        ownerOf.fill(NOBODY)
        numberOf.fill(NOBODY)
        for (t in 0 until whole.elementCount) {
            checkpoint.pass()
            val part = partOf[t]
            numberInPart[t] = filled[part] - starts[part]
            elementsByPart[filled[part]++] = t
            for (i in 3 * t..3 * t + 2) {
                val node = whole.elements[i]
                if (ownerOf[node] != part) ownerOf[node] = if (ownerOf[node] == NOBODY) part else SHARED
            }
        }
    }

    private fun isShared(node: Int): Boolean = ownerOf[node] == SHARED

    /** Copies a part out of the whole; several threads may do so for different parts. */
    fun part(part: Int, checkpoint: Checkpoint): MeshPiece {
        val fixed = IntList()
        val free = IntList()
        for (at in starts[part] until starts[part + 1]) {
            checkpoint.pass()
            for (i in 3 * elementsByPart[at]..3 * elementsByPart[at] + 2) {
                val node = whole.elements[i]
                if (ownerOf[node] == SHARED || whole.isFixed(node)) {
                    fixed.add(node)
                } else if (numberOf[node] == NOBODY) {
                    numberOf[node] = free.size
                    free.add(node)
                }
            }
        }
        val fixedNodes = fixed.toArray().apply { sort() }.distinct().toIntArray()
        checkpoint.ask()
        val wholeNodes = IntArray(fixedNodes.size + free.size) { if (it < fixedNodes.size) fixedNodes[it] else free[it - fixedNodes.size] }
        val mesh = emptyMesh(part, wholeNodes, embeddedIn(part, fixedNodes), fixedNodes.size)
        for (at in starts[part] until starts[part + 1]) {
            checkpoint.pass()
            val t = 3 * elementsByPart[at]
            val own = 3 * mesh.addElement(
                numberIn(part, whole.elements[t], fixedNodes),
                numberIn(part, whole.elements[t + 1], fixedNodes),
                numberIn(part, whole.elements[t + 2], fixedNodes),
            )
            for (k in 0..2) {
                val twin = whole.twins[t + k]
                if (twin >= 0 && partOf[twin / 3] == part) mesh.twins[own + k] = 3 * numberInPart[twin / 3] + twin % 3
            }
        }
        return MeshPiece(mesh, wholeNodes)
    }

    private fun emptyMesh(part: Int, wholeNodes: IntArray, embedded: EdgeSet, fixedCount: Int): MutableMesh {
        val spare = wholeNodes.size / 16 + 16
        val xy = DoubleArray(2 * (wholeNodes.size + spare))
        val sizes = DoubleArray(wholeNodes.size + spare)
        for (i in wholeNodes.indices) {
            xy[2 * i] = whole.xy[2 * wholeNodes[i]]
            xy[2 * i + 1] = whole.xy[2 * wholeNodes[i] + 1]
            sizes[i] = whole.sizes[wholeNodes[i]]
        }
        val elements = starts[part + 1] - starts[part]
        val mesh = MutableMesh(xy, fixedCount, sizes, elements + elements / 16 + 16, embedded)
        mesh.nodeCount = wholeNodes.size
        return mesh
    }

    /** The embedded edges of a part in its numbers. */
    private fun embeddedIn(part: Int, fixedNodes: IntArray): EdgeSet {
        if (whole.embedded.isEmpty) return EdgeSet.EMPTY
        val pairs = IntList()
        for (at in starts[part] until starts[part + 1]) {
            for (h in 3 * elementsByPart[at]..3 * elementsByPart[at] + 2) {
                val a = whole.elements[h]
                val b = whole.elements[HalfEdges.next(h)]
                if (a > b || !whole.isEmbedded(a, b)) continue
                pairs.add(fixedNodes.binarySearch(a))
                pairs.add(fixedNodes.binarySearch(b))
            }
        }
        return EdgeSet(pairs.toArray())
    }

    private fun numberIn(part: Int, node: Int, fixedNodes: IntArray): Int =
        if (ownerOf[node] == part && !whole.isFixed(node)) fixedNodes.size + numberOf[node] else fixedNodes.binarySearch(node)

    /**
     * Puts all parts back into the whole, without dead elements or nodes: first the nodes that are fixed in the whole, with
     * their numbers, then the shared ones, then those of the parts one after the other. The division is of no use afterwards.
     *
     * @param parts in their order, compacted.
     * @return the nodes where parts meet, in their new numbers.
     */
    fun join(parts: List<MeshPiece>, checkpoint: Checkpoint): IntArray {
        val meeting = IntList()
        for (node in 0 until whole.nodeCount) if (ownerOf[node] == SHARED) meeting.add(node)
        var free = whole.fixedNodeCount
        for (i in 0 until meeting.size) numberOf[meeting[i]] = if (whole.isFixed(meeting[i])) meeting[i] else free++
        val nodes = free + parts.sumOf { it.mesh.nodeCount - it.mesh.fixedNodeCount }
        // The parts have copies: what is a third of the memory at this moment can go.
        whole.elements = IntArray(0)
        whole.twins = IntArray(0)
        val joined = JoinedMesh(whole, nodes, parts.sumOf { it.mesh.elementCount })
        for (i in 0 until meeting.size) joined.place(numberOf[meeting[i]], whole.xy, whole.sizes, meeting[i])
        for (part in parts) {
            val mesh = part.mesh
            checkpoint.ask()
            val newNumber = IntArray(mesh.nodeCount) {
                if (!mesh.isFixed(it)) free++ else if (isShared(part.wholeNodes[it])) numberOf[part.wholeNodes[it]] else part.wholeNodes[it]
            }
            checkpoint.ask()
            for (n in mesh.fixedNodeCount until mesh.nodeCount) joined.place(newNumber[n], mesh.xy, mesh.sizes, n)
            checkpoint.ask()
            joined.append(mesh, newNumber) { it < mesh.fixedNodeCount && isShared(part.wholeNodes[it]) }
        }
        joined.takeOver()
        return IntArray(meeting.size) { numberOf[meeting[it]] }
    }

    /** Puts one part back into the whole in the place of its elements; some elements and nodes may be dead then. */
    fun replace(part: Int, by: MeshPiece, checkpoint: Checkpoint) {
        val mesh = by.mesh
        var node = whole.fixedNodeCount
        val newNumber = IntArray(mesh.nodeCount) {
            checkpoint.pass()
            if (mesh.isFixed(it)) return@IntArray by.wholeNodes[it]
            while (node < ownerOf.size && ownerOf[node] != part) node++
            if (node < ownerOf.size) node++ else whole.addNode(0.0, 0.0, 0.0)
        }
        while (node < ownerOf.size) {
            if (ownerOf[node] == part) whole.sizes[node] = Double.NaN
            node++
        }
        for (n in mesh.fixedNodeCount until mesh.nodeCount) {
            whole.xy[2 * newNumber[n]] = mesh.xy[2 * n]
            whole.xy[2 * newNumber[n] + 1] = mesh.xy[2 * n + 1]
            whole.sizes[newNumber[n]] = mesh.sizes[n]
        }
        val seams = outerSides(part, checkpoint)
        val old = starts[part + 1] - starts[part]
        val slots = IntArray(mesh.elementCount) { if (it < old) elementsByPart[starts[part] + it] else whole.addElement(0, 0, 0) }
        for (h in 0 until 3 * mesh.elementCount) {
            checkpoint.pass()
            val own = 3 * slots[h / 3] + h % 3
            val twin = mesh.twins[h]
            whole.elements[own] = newNumber[mesh.elements[h]]
            whole.twins[own] = if (twin < 0) -1 else 3 * slots[twin / 3] + twin % 3
            if (twin < 0) seams.add(newNumber[mesh.elements[h]], newNumber[mesh.elements[HalfEdges.next(h)]], own)
        }
        for (i in mesh.elementCount until old) whole.elements[3 * elementsByPart[starts[part] + i]] = -1
        seams.link(whole.twins)
    }

    /** The half-edges of other parts along a part. */
    private fun outerSides(part: Int, checkpoint: Checkpoint): MeshSeams {
        val seams = MeshSeams()
        for (at in starts[part] until starts[part + 1]) {
            checkpoint.pass()
            for (h in 3 * elementsByPart[at]..3 * elementsByPart[at] + 2) {
                val twin = whole.twins[h]
                if (twin < 0 || partOf[twin / 3] == part) continue
                seams.add(whole.elements[twin], whole.elements[HalfEdges.next(twin)], twin)
            }
        }
        return seams
    }

    private companion object {
        const val NOBODY = -1
        const val SHARED = -2
    }
}
