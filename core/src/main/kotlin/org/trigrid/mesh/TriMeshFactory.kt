package org.trigrid.mesh

import java.util.BitSet

/** Makes a [TriMesh] of coordinates, elements and named lines, as a file or a user's arrays give them. */
internal object TriMeshFactory {
    /** Group of boundary edges that no line of the input names. */
    const val UNNAMED: String = "boundary"

    /** Group of edges between two regions that no line of the input names. */
    const val INTERFACE: String = "interface"

    /** As the other, with one region and no points. */
    fun of(
        xy: DoubleArray, elements: IntArray, lines: IntArray, lineTags: IntArray, tags: List<String>, regionName: String,
    ): TriMesh = of(xy, elements, lines, lineTags, tags, MeshParts.single(regionName))

    /**
     * @param xy x0, y0, x1, y1, …; taken over, not copied.
     * @param elements three nodes an element; taken over, clockwise ones are turned.
     * @param lines two nodes a line, in either direction.
     * @param lineTags per line an index into [tags].
     * @param parts regions of the elements, and points.
     * @throws IllegalArgumentException if a node number is out of range, a coordinate is not finite or a line is no edge of an element.
     */
    fun of(
        xy: DoubleArray,
        elements: IntArray,
        lines: IntArray,
        lineTags: IntArray,
        tags: List<String>,
        parts: MeshParts,
    ): TriMesh {
        require(xy.size % 2 == 0) { "coordinates come in pairs, not ${xy.size} numbers" }
        require(elements.size % 3 == 0) { "elements come as three nodes each, not ${elements.size} numbers" }
        val nodeCount = xy.size / 2
        for (i in elements.indices) {
            require(elements[i] in 0 until nodeCount) { "element ${i / 3} has node ${elements[i]}, nodes are 0 to ${nodeCount - 1}" }
        }
        for (i in xy.indices) require(xy[i].isFinite()) { "node ${i / 2} has a coordinate that is not a finite number: ${xy[i]}" }
        MeshTopology.turnAnticlockwise(xy, elements)
        val neighbours = MeshTopology.neighbours(nodeCount, elements)
        val boundary = MeshTopology.boundaryEdges(elements, neighbours)
        val named = NamedLines(lines, lineTags)
        val boundaryTags = IntArray(boundary.size / 2) { named.take(boundary[2 * it], boundary[2 * it + 1]) }
        val embedded = named.rest()
        requireEdges(elements, lines, embedded)
        val between = if (parts.regions.size == 1) emptyList() else interfaces(elements, neighbours, parts)
        val bare = between.filter { !named.has(elements[it], elements[MeshTopology.nextCorner(it)]) }
        val allTags = ArrayList(tags)
        if (boundaryTags.any { it < 0 } && UNNAMED !in allTags) allTags.add(UNNAMED)
        if (bare.isNotEmpty() && INTERFACE !in allTags) allTags.add(INTERFACE)
        val fallback = allTags.indexOf(UNNAMED)
        for (i in boundaryTags.indices) if (boundaryTags[i] < 0) boundaryTags[i] = fallback
        val inner = IntArray(2 * embedded.size) { lines[2 * embedded[it / 2] + it % 2] } +
            IntArray(2 * bare.size) { if (it % 2 == 0) elements[bare[it / 2]] else elements[MeshTopology.nextCorner(bare[it / 2])] }
        val innerTags = IntArray(embedded.size + bare.size) {
            if (it < embedded.size) lineTags[embedded[it]] else allTags.indexOf(INTERFACE)
        }
        val edges = boundary + inner
        val kinds = kinds(nodeCount, edges, boundaryTags.size, parts.points)
        return TriMesh(
            xy, elements, neighbours, kinds, edges, boundaryTags + innerTags, boundaryTags.size, java.util.List.copyOf(allTags), parts,
        )
    }

    /** One half-edge of each edge between elements of different regions. */
    private fun interfaces(elements: IntArray, neighbours: IntArray, parts: MeshParts): List<Int> = elements.indices.filter {
        val across = neighbours[it]
        across > it / 3 && parts.regionOf(across) != parts.regionOf(it / 3)
    }

    /** Kind of each node by the tagged edges it lies on, and whether it is a point. */
    fun kinds(nodeCount: Int, edges: IntArray, boundaryEdgeCount: Int, points: IntArray): ByteArray {
        val kinds = ByteArray(nodeCount) { NodeKind.INTERIOR.code }
        for (node in points) kinds[node] = NodeKind.EMBEDDED.code
        for (i in 2 * boundaryEdgeCount until edges.size) kinds[edges[i]] = NodeKind.EMBEDDED.code
        for (i in 0 until 2 * boundaryEdgeCount) kinds[edges[i]] = NodeKind.BOUNDARY.code
        return kinds
    }

    private fun requireEdges(elements: IntArray, lines: IntArray, chosen: IntArray) {
        if (chosen.isEmpty()) return
        val onLine = BitSet()
        for (line in chosen) {
            onLine.set(lines[2 * line])
            onLine.set(lines[2 * line + 1])
        }
        var pairs = IntArray(64)
        var count = 0
        for (half in elements.indices) {
            val a = elements[half]
            val b = elements[MeshTopology.nextCorner(half)]
            if (!onLine.get(a) || !onLine.get(b)) continue
            if (count == pairs.size) pairs = pairs.copyOf(2 * count)
            pairs[count++] = a
            pairs[count++] = b
        }
        val edges = EdgeSet(pairs.copyOf(count))
        for (line in chosen) {
            val a = lines[2 * line]
            val b = lines[2 * line + 1]
            require(edges.contains(a, b)) { "the line from node $a to node $b is no edge of an element" }
        }
    }

    /** Looks lines up by their two nodes and remembers which were asked for. */
    private class NamedLines(private val lines: IntArray, private val tags: IntArray) {
        private val order: IntArray
        private val keys: LongArray
        private val taken = BooleanArray(tags.size)

        init {
            val sorted = (0 until tags.size).sortedBy { key(lines[2 * it], lines[2 * it + 1]) }
            order = sorted.toIntArray()
            keys = LongArray(order.size) { key(lines[2 * order[it]], lines[2 * order[it] + 1]) }
        }

        fun has(a: Int, b: Int): Boolean = keys.binarySearch(key(a, b)) >= 0

        fun take(a: Int, b: Int): Int {
            val key = key(a, b)
            var at = keys.binarySearch(key)
            if (at < 0) return -1
            while (at > 0 && keys[at - 1] == key) at--
            val tag = tags[order[at]]
            // A line written twice is one edge; it counts once.
            while (at < keys.size && keys[at] == key) taken[order[at++]] = true
            return tag
        }

        fun rest(): IntArray {
            val result = ArrayList<Int>()
            for (line in tags.indices) {
                if (taken[line]) continue
                take(lines[2 * line], lines[2 * line + 1])
                result.add(line)
            }
            return result.toIntArray()
        }

        private fun key(a: Int, b: Int): Long = (minOf(a, b).toLong() shl 32) or maxOf(a, b).toLong()
    }
}
