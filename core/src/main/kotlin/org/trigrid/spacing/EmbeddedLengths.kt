package org.trigrid.spacing

import org.trigrid.domain.Domain

/** Lengths of a domain's embedded lines, each with all that hang together with it. */
internal class EmbeddedLengths(domain: Domain) {
    private val parent = IntArray(domain.nodeCount) { it }
    private val lengths = DoubleArray(domain.nodeCount)

    init {
        for (s in domain.boundaryCount until domain.segmentCount) {
            val a = rootOf(domain.segmentStart(s))
            val b = rootOf(domain.segmentEnd(s))
            parent[Math.max(a, b)] = Math.min(a, b)
        }
        for (s in domain.boundaryCount until domain.segmentCount) lengths[rootOf(domain.segmentStart(s))] += domain.segmentLength(s)
    }

    /** For a node of an embedded segment. */
    fun at(node: Int): Double = lengths[rootOf(node)]

    private fun rootOf(node: Int): Int {
        var root = node
        while (parent[root] != root) {
            parent[root] = parent[parent[root]]
            root = parent[root]
        }
        return root
    }
}
