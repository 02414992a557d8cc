package org.trigrid.domain

import org.trigrid.diagnostics.Fault

/** Which region lies on each side of a domain's segments. */
internal class DomainRegions(
    val list: List<Region>,
    /** 2 per segment: the region on its left and on its right, -1 outside. Empty for a single region. Not modified. */
    private val sides: IntArray,
    /** What is wrong with the points that told the regions. */
    val faults: List<Fault>,
    /** False where segments cross or touch, so that nobody can say what is inside of what; all of them are embedded then. */
    val isPlanar: Boolean = true,
) {
    val isSingle: Boolean get() = list.size == 1

    fun left(segment: Int): Int = if (sides.isEmpty()) 0 else sides[2 * segment]

    fun right(segment: Int, isEmbedded: Boolean): Int = if (sides.isNotEmpty()) sides[2 * segment + 1] else if (isEmbedded) 0 else -1

    /** The same for segments that are parts of these: [origin] tells of which. */
    fun ofParts(origin: IntArray): DomainRegions =
        if (sides.isEmpty()) this else DomainRegions(list, IntArray(2 * origin.size) { sides[2 * origin[it / 2] + it % 2] }, faults, isPlanar)

    /** The same for segments in another order, the sides of some of them swapped; [origin] tells of which segment each is made. */
    fun laid(origin: IntArray, isSwapped: (Int) -> Boolean): DomainRegions {
        if (sides.isEmpty()) return this
        val laid = IntArray(2 * origin.size) { sides[2 * origin[it / 2] + (if (isSwapped(it / 2)) 1 - it % 2 else it % 2)] }
        return DomainRegions(list, laid, faults, isPlanar)
    }

    /**
     * With [added] embedded segments more after [count], of whose sides nobody knows yet: the assembly of regions takes them from
     * the faces.
     */
    fun withLines(count: Int, added: Int): DomainRegions = when {
        sides.isEmpty() -> this
        else -> DomainRegions(list, sides.copyOf(2 * count) + IntArray(2 * added) { UNKNOWN }, faults, isPlanar)
    }

    companion object {
        /** The region of a side before the assembly. */
        const val UNKNOWN = -1

        fun single(region: Region): DomainRegions = DomainRegions(java.util.List.of(region), IntArray(0), emptyList())
    }
}

/** Points that are kept as nodes of the mesh. */
internal class DomainPoints(
    /** Node numbers. Not modified. */
    val nodes: IntArray,
    /** Per point: index into the domain's tags. Not modified. */
    val tags: IntArray,
) {
    companion object {
        val NONE = DomainPoints(IntArray(0), IntArray(0))
    }
}
