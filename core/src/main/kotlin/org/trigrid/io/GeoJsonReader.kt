package org.trigrid.io

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import org.trigrid.domain.Domain

/**
 * Reads the polygons of GeoJSON (RFC 7946) as domains: of a bare geometry, a feature, or a collection of either.
 *
 * Ring 0 is the outer boundary (tag "outer"), the others are holes ("hole_1", …), in either direction. Third coordinates
 * are left out, and so are points and lines. Also read: `{"name": …, "loops": [[[x, y], …], …]}`, loops of any role.
 */
internal class GeoJsonReader private constructor(
    private val document: JsonDocument,
    private val baseName: String,
) {
    private val domains = ArrayList<NamedDomain>()

    private fun read(): List<NamedDomain> {
        val root = JsonPath.ROOT
        val tree = objectOf(document.root, root)
        if ((tree["type"] as? JsonPrimitive)?.content == "Topology") return TopoJsonReader(document, baseName).read()
        if ("loops" in tree) readLoops(tree, root) else readAny(tree, root, baseName)
        if (domains.isEmpty()) fail(root, "there is no polygon in it")
        return domains
    }

    private fun readLoops(tree: JsonObject, at: JsonPath) {
        val name = (tree["name"] as? JsonPrimitive)?.content ?: baseName
        val loops = arrayOf(tree, "loops", at)
        if (loops.isEmpty()) fail(at["loops"], "there is no loop in it")
        val builder = Domain.builder().regionName(name)
        for ((i, loop) in loops.withIndex()) builder.loop(ring(loop, at["loops"][i]), ringTag(i))
        domains.add(NamedDomain(name, builder.build()))
    }

    private fun readAny(tree: JsonObject, at: JsonPath, name: String) {
        when (val type = (tree["type"] as? JsonPrimitive)?.content) {
            "FeatureCollection" -> arrayOf(tree, "features", at).forEachIndexed { i, feature ->
                val place = at["features"][i]
                readAny(objectOf(feature, place), place, name)
            }
            "Feature" -> readFeature(tree, at, name)
            "GeometryCollection" -> arrayOf(tree, "geometries", at).forEachIndexed { i, geometry ->
                val place = at["geometries"][i]
                readAny(objectOf(geometry, place), place, name)
            }
            "Polygon" -> addPolygon(arrayOf(tree, "coordinates", at), at["coordinates"], name)
            "MultiPolygon" -> readMultiPolygon(arrayOf(tree, "coordinates", at), at["coordinates"], name)
            "Point", "MultiPoint", "LineString", "MultiLineString" -> Unit
            null -> fail(at, "a GeoJSON object must have a \"type\"")
            else -> fail(at["type"], "unknown type \"$type\"")
        }
    }

    private fun readFeature(tree: JsonObject, at: JsonPath, name: String) {
        val geometry = tree["geometry"] ?: fail(at, "a feature must have a \"geometry\"")
        if (geometry is JsonNull) return
        val ownName = ((tree["properties"] as? JsonObject)?.get("name") as? JsonPrimitive)?.takeIf { it.isString }?.content
        readAny(objectOf(geometry, at["geometry"]), at["geometry"], ownName?.ifBlank { null } ?: name)
    }

    private fun readMultiPolygon(polygons: JsonArray, at: JsonPath, name: String) {
        for ((i, polygon) in polygons.withIndex()) {
            addPolygon(arrayOf(polygon, at[i]), at[i], if (polygons.size == 1) name else "${name}_${i + 1}")
        }
    }

    private fun addPolygon(rings: JsonArray, at: JsonPath, name: String) {
        if (rings.isEmpty()) return
        val builder = Domain.builder().regionName(name)
        for ((i, ring) in rings.withIndex()) {
            val xy = ring(ring, at[i])
            if (i == 0) builder.outer(xy, ringTag(i)) else builder.hole(xy, ringTag(i))
        }
        domains.add(NamedDomain(name, builder.build()))
    }

    private fun ring(element: JsonElement, at: JsonPath): DoubleArray {
        val positions = arrayOf(element, at)
        val xy = DoubleArray(2 * positions.size)
        for (i in positions.indices) {
            val position = positions[i] as? JsonArray
            if (position == null || position.size < 2) fail(at[i], "a position must be an array of two numbers or more")
            xy[2 * i] = number(position[0], at, i, 0)
            xy[2 * i + 1] = number(position[1], at, i, 1)
        }
        if (xy.isEmpty()) fail(at, "a ring must have positions")
        return RingPoints.withoutRepeatedEnd(xy)
    }

    private fun number(element: JsonElement, ring: JsonPath, position: Int, axis: Int): Double {
        val content = (element as? JsonPrimitive)?.takeIf { !it.isString }?.content
        val value = RingPoints.decimal(content.orEmpty())
        if (value.isNaN()) fail(ring[position][axis], "a coordinate must be a number")
        return value
    }

    private fun arrayOf(tree: JsonObject, member: String, at: JsonPath): JsonArray {
        val element = tree[member] ?: fail(at, "\"$member\" is missing")
        return arrayOf(element, at[member])
    }

    private fun arrayOf(element: JsonElement, at: JsonPath) = element as? JsonArray ?: fail(at, "an array must stand here")

    private fun objectOf(element: JsonElement, at: JsonPath) = element as? JsonObject ?: fail(at, "an object must stand here")

    private fun fail(at: JsonPath, reason: String): Nothing = document.fail(at, reason)

    companion object {
        /**
         * @param source names the text in errors.
         * @param baseName names domains that have no name of their own.
         */
        fun read(text: String, source: String, baseName: String): List<NamedDomain> =
            GeoJsonReader(JsonDocument(text, source, uniqueKeys = false), baseName).read()

        /** "outer" for the first ring, "hole_1" and so on for the others. */
        fun ringTag(ring: Int): String = if (ring == 0) "outer" else "hole_$ring"
    }
}
