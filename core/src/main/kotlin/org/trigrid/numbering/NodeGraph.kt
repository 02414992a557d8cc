package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.mesh.MeshTopology
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh

/**
 * Which nodes of a mesh share an element: the coefficient matrix' structure without its diagonal, in compressed rows.
 *
 * The neighbours of a node come in the order of their degree, ties by number: the order in which Cuthill and McKee
 * number them. Immutable.
 */
public class NodeGraph private constructor(
    /** Per node, where its neighbours start in [targets]; one entry more than nodes. */
    internal val starts: IntArray,
    internal val targets: IntArray,
) {
    @get:JvmName("nodeCount")
    public val nodeCount: Int get() = starts.size - 1

    @get:JvmName("edgeCount")
    public val edgeCount: Int get() = targets.size / 2

    /** Number of neighbours of [node]. */
    public fun degree(node: Int): Int = starts[node + 1] - starts[node]

    /** The neighbours of [node], lowest degree first. A new array. */
    public fun neighbours(node: Int): IntArray = targets.copyOfRange(starts[node], starts[node + 1])

    /** The connected part of this graph that has the nodes of [order], the node at `order[i]` numbered i. */
    internal fun relabelled(order: IntArray, newNumbers: IntArray, checkpoint: Checkpoint): NodeGraph {
        val newStarts = IntArray(order.size + 1)
        for (i in order.indices) newStarts[i + 1] = newStarts[i] + degree(order[i])
        checkpoint.ask()
        val newTargets = IntArray(newStarts[order.size])
        var at = 0
        for (old in order) {
            checkpoint.pass()
            for (k in starts[old] until starts[old + 1]) newTargets[at++] = newNumbers[targets[k]]
        }
        return NodeGraph(newStarts, sortedByDegree(newStarts, newTargets, checkpoint))
    }

    /** The graph of groups of nodes: two are neighbours if nodes of theirs are. [groups] has a group for each node. */
    internal fun quotient(groups: IntArray, groupCount: Int, checkpoint: Checkpoint): NodeGraph {
        val firsts = IntArray(groupCount + 1)
        for (g in groups) firsts[g + 1]++
        checkpoint.ask()
        for (g in 1..groupCount) firsts[g] += firsts[g - 1]
        val members = IntArray(nodeCount)
        val at = firsts.copyOf()
        for (node in 0 until nodeCount) members[at[groups[node]]++] = node
        checkpoint.ask()
        val newStarts = IntArray(groupCount + 1)
        var newTargets = IntArray(8 * groupCount + 8)
        val seenBy = IntArray(groupCount) { -1 }
        var size = 0
        for (g in 0 until groupCount) {
            checkpoint.pass()
            seenBy[g] = g
            for (i in firsts[g] until firsts[g + 1]) {
                for (k in starts[members[i]] until starts[members[i] + 1]) {
                    val other = groups[targets[k]]
                    if (seenBy[other] == g) continue
                    seenBy[other] = g
                    if (size == newTargets.size) newTargets = newTargets.copyOf(2 * size)
                    newTargets[size++] = other
                }
            }
            newStarts[g + 1] = size
        }
        return NodeGraph(newStarts, sortedByDegree(newStarts, newTargets.copyOf(size), checkpoint))
    }

    public companion object {
        /** The graph of the nodes of [mesh], two being neighbours if an element has both. */
        @JvmStatic
        public fun of(mesh: TriMesh): NodeGraph = of(mesh, Checkpoint.unheard())

        /** The graph of the nodes of [mesh], two of the six nodes of an element being neighbours. */
        @JvmStatic
        public fun of(mesh: QuadraticMesh): NodeGraph = ofEdges(mesh.nodeCount, QuadraticPairs.of(mesh))

        internal fun of(mesh: TriMesh, checkpoint: Checkpoint): NodeGraph {
            val elements = mesh.elements
            val neighbours = mesh.neighbours
            val starts = IntArray(mesh.nodeCount + 1)
            // Inside, each of the two half-edges of an edge tells its start of its end.
            for (half in elements.indices) {
                checkpoint.pass()
                starts[elements[half] + 1]++
                if (neighbours[half] < 0) starts[elements[MeshTopology.nextCorner(half)] + 1]++
            }
            for (n in 1 until starts.size) starts[n] += starts[n - 1]
            checkpoint.ask()
            val targets = IntArray(starts[mesh.nodeCount])
            val at = starts.copyOf()
            for (half in elements.indices) {
                checkpoint.pass()
                val a = elements[half]
                val b = elements[MeshTopology.nextCorner(half)]
                targets[at[a]++] = b
                if (neighbours[half] < 0) targets[at[b]++] = a
            }
            return NodeGraph(starts, sortedByDegree(starts, targets, checkpoint))
        }

        /**
         * The graph with the given edges.
         *
         * @param pairs two different nodes an edge, each edge once; not modified.
         * @throws IllegalArgumentException if a node is out of range or an edge leads back to its node.
         */
        @JvmStatic
        public fun ofEdges(nodeCount: Int, pairs: IntArray): NodeGraph {
            require(pairs.size % 2 == 0) { "edges come as two nodes each, not ${pairs.size} numbers" }
            val starts = IntArray(nodeCount + 1)
            for (i in pairs.indices) {
                require(pairs[i] in 0 until nodeCount && pairs[i] != pairs[i xor 1]) { "edge ${i / 2} has node ${pairs[i]}" }
                starts[pairs[i] + 1]++
            }
            for (n in 1..nodeCount) starts[n] += starts[n - 1]
            val targets = IntArray(pairs.size)
            val at = starts.copyOf()
            for (i in pairs.indices step 2) {
                targets[at[pairs[i]]++] = pairs[i + 1]
                targets[at[pairs[i + 1]]++] = pairs[i]
            }
            return NodeGraph(starts, sortedByDegree(starts, targets, Checkpoint.unheard()))
        }

        /** Sorts all rows at once: nodes taken by degree are appended to the rows of their neighbours. */
        private fun sortedByDegree(starts: IntArray, targets: IntArray, checkpoint: Checkpoint): IntArray {
            checkpoint.ask()
            val sorted = IntArray(targets.size)
            checkpoint.ask()
            val at = starts.copyOf()
            for (node in nodesByDegree(starts, checkpoint)) {
                checkpoint.pass()
                for (k in starts[node] until starts[node + 1]) {
                    sorted[at[targets[k]]++] = node
                }
            }
            return sorted
        }

        /** Nodes by degree, ties by number; a counting sort. */
        internal fun nodesByDegree(starts: IntArray, checkpoint: Checkpoint = Checkpoint.unheard()): IntArray {
            val count = starts.size - 1
            var highest = 0
            for (n in 0 until count) highest = maxOf(highest, starts[n + 1] - starts[n])
            checkpoint.ask()
            val place = IntArray(highest + 2)
            for (n in 0 until count) place[starts[n + 1] - starts[n] + 1]++
            checkpoint.ask()
            for (d in 1 until place.size) place[d] += place[d - 1]
            val nodes = IntArray(count)
            for (n in 0 until count) nodes[place[starts[n + 1] - starts[n]]++] = n
            checkpoint.ask()
            return nodes
        }
    }
}
