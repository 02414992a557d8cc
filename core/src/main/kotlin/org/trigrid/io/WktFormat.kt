package org.trigrid.io

/** Well-known text: written as one geometry a line; names and tags have no place in it. */
internal class WktFormat : DomainFormat("wkt", "well-known text", listOf(".wkt"), canWrite = true) {
    override fun looksLike(first: String) = KEYWORDS.any { first.startsWith(it, ignoreCase = true) }

    override fun read(input: DomainText): List<NamedDomain> = WktReader.read(input.text, input.source, input.baseName)

    override fun write(domains: List<NamedDomain>, text: TextBuffer) {
        for (named in domains) {
            val polygons = DomainRings.polygons(named.domain)
            text.text(if (polygons.size == 1) "POLYGON " else "MULTIPOLYGON (")
            for ((i, polygon) in polygons.withIndex()) {
                if (i > 0) text.text(", ")
                writePolygon(polygon, text)
            }
            text.line(if (polygons.size == 1) "" else ")")
        }
    }

    private fun writePolygon(rings: List<DoubleArray>, text: TextBuffer) {
        for ((i, ring) in rings.withIndex()) {
            text.text(if (i == 0) "((" else ", (")
            for (k in 0..ring.size / 2) {
                val at = 2 * (k % (ring.size / 2))
                if (k > 0) text.text(", ")
                text.number(ring[at]).space().number(ring[at + 1])
            }
            text.text(")")
        }
        text.text(")")
    }

    private companion object {
        val KEYWORDS = listOf("POLYGON", "MULTIPOLYGON", "GEOMETRYCOLLECTION", "SRID=", "POINT", "LINESTRING", "MULTI")
    }
}
