package org.trigrid.domain

/** The embedded segments of a domain as lines, each of segments that follow one another with the same tag. */
internal class InnerChains(private val domain: Domain) {
    fun lines(): List<InnerLine> {
        val lines = ArrayList<InnerLine>()
        var s = domain.boundaryCount
        while (s < domain.segmentCount) {
            var end = s + 1
            while (end < domain.segmentCount && goesOn(s, end)) end++
            lines.add(line(s, end))
            s = end
        }
        return lines
    }

    /** Whether segment [next] follows the one before it; a line that has come back to its first node ends there. */
    private fun goesOn(first: Int, next: Int): Boolean =
        domain.segmentEnd(next - 1) == domain.segmentStart(next) && domain.segmentTag(next - 1) == domain.segmentTag(next) &&
            domain.segmentEnd(next - 1) != domain.segmentStart(first)

    private fun line(from: Int, to: Int): InnerLine {
        val isClosed = to - from >= 3 && domain.segmentEnd(to - 1) == domain.segmentStart(from)
        val nodes = IntArray(to - from + if (isClosed) 0 else 1) {
            if (it < to - from) domain.segmentStart(from + it) else domain.segmentEnd(to - 1)
        }
        val xy = DoubleArray(2 * nodes.size) { if (it % 2 == 0) domain.x(nodes[it / 2]) else domain.y(nodes[it / 2]) }
        return InnerLine(xy, domain.tags[domain.segmentTag(from)], isClosed)
    }
}
