package org.trigrid.domain

/** The segments at each node, in compressed rows; within a node in ascending order. */
internal class NodeSegments private constructor(private val first: IntArray, private val list: IntArray) {
    fun countAt(node: Int): Int = first[node + 1] - first[node]

    inline fun forEachAt(node: Int, action: (Int) -> Unit) {
        for (i in first(node) until first(node + 1)) action(get(i))
    }

    fun first(node: Int): Int = first[node]

    fun get(position: Int): Int = list[position]

    companion object {
        /** The segments that start in each node. */
        fun leaving(nodeCount: Int, segments: IntArray): NodeSegments = build(nodeCount, segments, 0)

        /** The segments that end in each node. */
        fun arriving(nodeCount: Int, segments: IntArray): NodeSegments = build(nodeCount, segments, 1)

        private fun build(nodeCount: Int, segments: IntArray, end: Int): NodeSegments {
            val first = IntArray(nodeCount + 1)
            for (i in end until segments.size step 2) first[segments[i] + 1]++
            for (node in 0 until nodeCount) first[node + 1] += first[node]
            val next = first.copyOf()
            val list = IntArray(segments.size / 2)
            for (s in list.indices) list[next[segments[2 * s + end]]++] = s
            return NodeSegments(first, list)
        }
    }
}
