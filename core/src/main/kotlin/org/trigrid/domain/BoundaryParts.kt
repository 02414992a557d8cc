package org.trigrid.domain

/** The connected parts of a boundary, joined by shared places; each is closed or not as a whole. */
internal class BoundaryParts(private val checked: CheckedDomain) {
    private val parent = IntArray(checked.domain.nodeCount) { it }

    /** Per part's representative: whether some walk in it is open, so that it has no inside. */
    private val open = BooleanArray(checked.domain.nodeCount)

    /** Segments out minus segments in of each place, the untestable ones counted too. */
    private val balance = IntArray(checked.domain.nodeCount)

    init {
        for (t in 0 until checked.boundaryCount) {
            checked.checkpoint.pass()
            join(checked.start(t), checked.end(t))
        }
        val domain = checked.domain
        for (s in 0 until domain.segmentCount) {
            checked.checkpoint.pass()
            if (domain.isEmbedded(s)) continue
            balance[checked.place[domain.segmentStart(s)]]++
            balance[checked.place[domain.segmentEnd(s)]]--
        }
        for (node in balance.indices) if (balance[node] != 0) open[partOf(node)] = true
        for (s in 0 until domain.segmentCount) if (!domain.isEmbedded(s)) openIfNotFinite(s)
    }

    /** The part's representative node. */
    fun partOf(place: Int): Int {
        var root = place
        while (parent[root] != root) {
            parent[root] = parent[parent[root]]
            root = parent[root]
        }
        return root
    }

    fun isOpen(place: Int): Boolean = open[partOf(place)]

    /** Segments that leave the place less those that end in it. */
    fun balanceAt(place: Int): Int = balance[place]

    /** The lower number becomes the representative. */
    private fun join(a: Int, b: Int) {
        val rootA = partOf(a)
        val rootB = partOf(b)
        if (rootA < rootB) parent[rootB] = rootA else parent[rootA] = rootB
    }

    private fun openIfNotFinite(s: Int) {
        checked.checkpoint.pass()
        val a = checked.domain.segmentStart(s)
        val b = checked.domain.segmentEnd(s)
        if (checked.isFinite(a) && checked.isFinite(b)) return
        open[partOf(checked.place[a])] = true
        open[partOf(checked.place[b])] = true
    }
}
