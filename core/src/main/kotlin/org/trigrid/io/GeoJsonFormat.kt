package org.trigrid.io

import kotlinx.serialization.json.JsonPrimitive

/** GeoJSON (RFC 7946): written as a collection of features, one a domain, with its name; segments keep no tags. */
internal class GeoJsonFormat : DomainFormat("geojson", "GeoJSON", listOf(".geojson", ".json"), canWrite = true) {
    override fun looksLike(first: String) = first.startsWith("{")

    override fun read(input: DomainText): List<NamedDomain> = GeoJsonReader.read(input.text, input.source, input.baseName)

    override fun write(domains: List<NamedDomain>, text: TextBuffer) {
        text.line("{\"type\": \"FeatureCollection\", \"features\": [")
        for ((i, named) in domains.withIndex()) {
            val polygons = DomainRings.polygons(named.domain)
            text.text("{\"type\": \"Feature\", \"properties\": {\"name\": ").utf8(JsonPrimitive(named.name).toString())
            text.text("}, \"geometry\": {\"type\": ").text(if (polygons.size == 1) "\"Polygon\"" else "\"MultiPolygon\"")
            text.text(", \"coordinates\": ")
            if (polygons.size == 1) writePolygon(polygons[0], text) else writeAll(polygons, text)
            text.line(if (i + 1 < domains.size) "}}," else "}}")
        }
        text.line("]}")
    }

    private fun writeAll(polygons: List<List<DoubleArray>>, text: TextBuffer) {
        text.text("[")
        for ((i, polygon) in polygons.withIndex()) {
            if (i > 0) text.text(",\n")
            writePolygon(polygon, text)
        }
        text.text("]")
    }

    private fun writePolygon(rings: List<DoubleArray>, text: TextBuffer) {
        text.text("[")
        for ((i, ring) in rings.withIndex()) {
            text.text(if (i == 0) "[" else ",\n[")
            for (k in 0..ring.size / 2) {
                val at = 2 * (k % (ring.size / 2))
                text.text(if (k == 0) "[" else ", [").number(ring[at]).text(", ").number(ring[at + 1]).text("]")
            }
            text.text("]")
        }
        text.text("]")
    }
}
