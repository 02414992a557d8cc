package org.trigrid.io

/** Triangle's `.poly`, with its points inline: of one domain, tags as markers from 1, which comments name. */
internal class PolyFormat : DomainFormat("poly", "Triangle .poly", listOf(".poly"), canWrite = true) {
    override fun looksLike(first: String) = first[0].isDigit()

    override fun read(input: DomainText): List<NamedDomain> = PolyReader.read(input.file, input.text)

    override fun write(domains: List<NamedDomain>, text: TextBuffer) {
        val domain = requireNotNull(domains.singleOrNull()) { "a .poly file holds one domain, not ${domains.size}" }.domain
        for ((i, tag) in domain.tags.withIndex()) text.text("# marker ").number(i + 1).text(": ").utf8(tag).line()
        text.number(domain.nodeCount).line(" 2 0 0")
        for (node in 0 until domain.nodeCount) {
            text.number(node + 1).space().number(domain.x(node)).space().number(domain.y(node)).line()
        }
        text.number(domain.segmentCount).line(" 1")
        for (s in 0 until domain.segmentCount) {
            text.number(s + 1).space().number(domain.segmentStart(s) + 1).space().number(domain.segmentEnd(s) + 1)
            text.space().number(domain.segmentTag(s) + 1).line()
        }
        writeHoles(HolePoints.of(domain), text)
    }

    companion object {
        /** @param holes x0, y0, … */
        fun writeHoles(holes: DoubleArray, text: TextBuffer) {
            text.number(holes.size / 2).line()
            for (i in 0 until holes.size / 2) {
                text.number(i + 1).space().number(holes[2 * i]).space().number(holes[2 * i + 1]).line()
            }
        }
    }
}
