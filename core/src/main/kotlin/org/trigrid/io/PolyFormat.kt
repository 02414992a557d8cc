package org.trigrid.io

import org.trigrid.domain.Domain
import org.trigrid.domain.Region
import org.trigrid.domain.RegionPoints

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
        writeRegions(domain, text)
    }

    companion object {
        /** Triangle's area of an equilateral element of side h is this part of h squared. */
        const val AREA_OF_SQUARE = 0.4330127018922193

        /** With a point in each part; nothing for a domain of one region without a material and a largest size. */
        fun writeRegions(domain: Domain, text: TextBuffer) {
            val isPlain = domain.regions.size == 1 && domain.regions[0] == Region.of(domain.regions[0].name)
            if (isPlain) return
            val materials = Materials.of(domain.regions)
            val markers = RegionPoints.of(domain)
            for ((r, region) in domain.regions.withIndex()) text.text("# region ").number(materials[r]).text(": ").utf8(region.name).line()
            text.number(markers.size).line()
            for ((i, marker) in markers.withIndex()) {
                val size = marker.region.maxSize
                text.number(i + 1).space().number(marker.x).space().number(marker.y)
                text.space().number(materials[domain.regions.indexOf(marker.region)]).space()
                text.number(if (size == Double.POSITIVE_INFINITY) -1.0 else AREA_OF_SQUARE * size * size).line()
            }
        }

        /** @param holes x0, y0, … */
        fun writeHoles(holes: DoubleArray, text: TextBuffer) {
            text.number(holes.size / 2).line()
            for (i in 0 until holes.size / 2) {
                text.number(i + 1).space().number(holes[2 * i]).space().number(holes[2 * i + 1]).line()
            }
        }
    }
}
