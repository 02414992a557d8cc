package org.trigrid.domain

import org.trigrid.diagnostics.Fault
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.InvalidDomainException

/** Makes a [Domain] of a path's nodes and walks. */
internal class PathDomain(val xy: DoubleArray, val walks: List<PathWalk>) {
    private val nodes = walks.map { it.nodes() }

    fun make(keepConnectors: Boolean, regionName: String): Domain {
        requireClosed()
        val numbers = LinkedHashMap<String, Int>()
        val stepTags = walks.map { walk ->
            IntArray(walk.stepCount) { numbers.getOrPut(walk.tag(it)) { numbers.size } }
        }
        val turned = turnedGroups()
        val directed = walks.indices.map { if (walks[it].group in turned) nodes[it].reversedArray() else nodes[it] }
        val directedTags = walks.indices.map { if (walks[it].group in turned) turnedTags(stepTags[it]) else stepTags[it] }
        return Domain.fromWalks(xy, directed, directedTags, numbers.keys.toList(), regionName, keepConnectors)
    }

    /** Walks that are not closed, and faults of the lines as they are, whatever they will bound. */
    fun faults(keepConnectors: Boolean): List<Fault> {
        val open = openWalks()
        if (open.isEmpty()) return DomainCheck.check(make(keepConnectors, ""))
        val loops = walks.filter { it.isClosed || it.stepCount > 1 }.map { if (it.isClosed) it else closed(it) }
        if (loops.isEmpty()) return open
        val domain = PathDomain(xy, loops).make(keepConnectors, "")
        val ends = open.map { it.nodes().map { node -> place(node) } }
        return open + DomainCheck.check(domain).filter { fault ->
            val places = fault.nodes().map { "(${domain.x(it)}, ${domain.y(it)})" }
            fault.kind in OF_LINES && ends.none { places.containsAll(it) }
        }
    }

    private fun closed(walk: PathWalk): PathWalk {
        val steps = 0 until walk.stepCount
        val tags = steps.map { walk.tag(it) }
        return PathWalk(walk.nodes(), tags + tags.last(), IntArray(walk.stepCount + 1) { if (it in steps) walk.shape(it) else -1 }, true, walk.group)
    }

    private fun openWalks(): List<Fault> = walks.indices.filter { !walks[it].isClosed }.map { openWalk(nodes[it]) }

    private fun requireClosed() {
        val faults = openWalks()
        if (faults.isNotEmpty()) throw InvalidDomainException(faults)
    }

    private fun openWalk(nodes: IntArray): Fault {
        val first = nodes.first()
        val last = nodes.last()
        val message = "the walk from node $first at ${place(first)} ends at node $last at ${place(last)}"
        return Fault(FaultKind.OPEN_WALK, message, xy[2 * last], xy[2 * last + 1], intArrayOf(first, last))
    }

    private fun place(node: Int): String = "(${xy[2 * node]}, ${xy[2 * node + 1]})"

    /**
     * Loops that are to be travelled the other way. Loops not joined to one another may run in any direction: each is
     * taken anticlockwise, or clockwise where it lies inside an odd number of others. Walks that came off one walk keep
     * their directions to each other, which say what is in and what is out.
     */
    fun turnedGroups(): Set<Int> {
        val groups = walks.indices.groupBy { walks[it].group }
        val nesting = LoopNesting(xy, nodes)
        val turned = HashSet<Int>()
        for ((group, members) in groups) {
            val main = nesting.fromLargest().first { it in members }
            val wanted = if (depth(nesting, main, members) % 2 == 0) 1 else -1
            if (nesting.areaSign(main) == -wanted) turned.add(group)
        }
        return turned
    }

    private fun depth(nesting: LoopNesting, walk: Int, group: List<Int>): Int {
        var depth = 0
        var parent = nesting.parentOf(walk)
        while (parent >= 0) {
            if (parent !in group) depth++
            parent = nesting.parentOf(parent)
        }
        return depth
    }

    /** Tags of the reversed walk's steps: its step i runs back along step n - 2 - i. */
    private fun turnedTags(tags: IntArray): IntArray {
        val n = tags.size
        return IntArray(n) { tags[(2 * n - 2 - it) % n] }
    }

    private companion object {
        /** Faults that do not depend on what is closed by which segment. */
        val OF_LINES = setOf(
            FaultKind.NOT_A_NUMBER, FaultKind.CROSSING, FaultKind.TOUCHING, FaultKind.DUPLICATE_NODE, FaultKind.ZERO_LENGTH,
            FaultKind.SPIKE, FaultKind.OVERLAP,
        )
    }
}
