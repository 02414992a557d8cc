package org.trigrid.io

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import org.trigrid.domain.Domain

/** TopoJSON: the polygons of all its objects. Arcs that several polygons share are the same nodes in each. */
internal class TopoJsonFormat : DomainFormat("topojson", "TopoJSON", listOf(".topojson")) {
    override fun read(input: DomainText): List<NamedDomain> =
        TopoJsonReader(JsonDocument(input.text, input.source, uniqueKeys = false), input.baseName).read()
}

/** Reads the polygons of a topology (the TopoJSON specification, Bostock and Metcalf). */
internal class TopoJsonReader(private val document: JsonDocument, private val baseName: String) {
    private val root = document.root as? JsonObject ?: document.fail(JsonPath.ROOT, "an object must stand here")
    private val domains = ArrayList<NamedDomain>()
    private val arcs: List<DoubleArray> by lazy { readArcs() }
    private val mostUses by lazy { MOST_USES * (1L + arcs.sumOf { it.size / 2 }) }
    private var uses = 0L

    fun read(): List<NamedDomain> {
        if ((root["type"] as? JsonPrimitive)?.content != "Topology") document.fail(JsonPath.ROOT, "the type must be \"Topology\"")
        val objects = root["objects"] as? JsonObject ?: document.fail(JsonPath.ROOT, "\"objects\" is missing")
        for ((name, geometry) in objects) readGeometry(geometry, JsonPath.ROOT["objects"][name], if (objects.size == 1) baseName else name)
        if (domains.isEmpty()) document.fail(JsonPath.ROOT, "there is no polygon in it")
        return domains
    }

    private fun readGeometry(element: JsonElement, at: JsonPath, name: String) {
        val geometry = element as? JsonObject ?: document.fail(at, "an object must stand here")
        val given = (geometry["properties"] as? JsonObject)?.get("name") as? JsonPrimitive
        val ownName = given?.takeIf { it.isString }?.content?.ifBlank { null } ?: name
        when (val type = (geometry["type"] as? JsonPrimitive)?.content) {
            "GeometryCollection" -> array(geometry["geometries"], at["geometries"]).forEachIndexed { i, inner ->
                readGeometry(inner, at["geometries"][i], ownName)
            }
            "Polygon" -> addPolygon(array(geometry["arcs"], at["arcs"]), at["arcs"], ownName)
            "MultiPolygon" -> {
                val polygons = array(geometry["arcs"], at["arcs"])
                polygons.forEachIndexed { i, polygon ->
                    addPolygon(array(polygon, at["arcs"][i]), at["arcs"][i], if (polygons.size == 1) ownName else "${ownName}_${i + 1}")
                }
            }
            "Point", "MultiPoint", "LineString", "MultiLineString" -> Unit
            null -> if (geometry["type"] !is JsonNull) document.fail(at, "a geometry must have a \"type\"")
            else -> if (geometry["type"] !is JsonNull) document.fail(at["type"], "unknown type \"$type\"")
        }
    }

    private fun addPolygon(rings: JsonArray, at: JsonPath, name: String) {
        if (rings.isEmpty()) return
        val builder = Domain.builder().regionName(name)
        for ((i, ring) in rings.withIndex()) {
            val xy = ring(array(ring, at[i]), at[i])
            if (i == 0) builder.outer(xy, GeoJsonReader.ringTag(i)) else builder.hole(xy, GeoJsonReader.ringTag(i))
        }
        domains.add(NamedDomain(name, builder.build()))
    }

    /** Arcs joined at their ends; the arc ~i is the arc i the other way. */
    private fun ring(numbers: JsonArray, at: JsonPath): DoubleArray {
        val xy = ArrayList<Double>()
        for ((i, element) in numbers.withIndex()) {
            val number = (element as? JsonPrimitive)?.takeIf { !it.isString }?.content?.toIntOrNull()
                ?: document.fail(at[i], "the number of an arc must stand here")
            val arc = arcs.getOrNull(if (number < 0) number.inv() else number) ?: document.fail(at[i], "there is no arc $number")
            val count = arc.size / 2
            for (k in (if (i == 0) 0 else 1) until count) {
                val from = if (number < 0) count - 1 - k else k
                xy.add(arc[2 * from])
                xy.add(arc[2 * from + 1])
            }
            uses += count
            if (uses > mostUses) document.fail(at[i], "the arcs are used more than $MOST_USES times in the mean")
        }
        if (xy.isEmpty()) document.fail(at, "a ring must have arcs")
        return RingPoints.withoutRepeatedEnd(xy.toDoubleArray())
    }

    private fun readArcs(): List<DoubleArray> {
        val at = JsonPath.ROOT["arcs"]
        val transform = root["transform"] as? JsonObject
        val scale = pair(transform?.get("scale"), 1.0, JsonPath.ROOT["transform"]["scale"])
        val translate = pair(transform?.get("translate"), 0.0, JsonPath.ROOT["transform"]["translate"])
        return array(root["arcs"], at).mapIndexed { i, arc ->
            val sums = DoubleArray(2)
            val positions = array(arc, at[i])
            val xy = DoubleArray(2 * positions.size)
            positions.forEachIndexed { k, position ->
                val values = array(position, at[i][k])
                for (axis in 0..1) {
                    val value = number(values.getOrNull(axis), at[i][k])
                    // Quantized positions are differences to the one before.
                    sums[axis] = if (transform == null) value else sums[axis] + value
                    xy[2 * k + axis] = if (transform == null) value else sums[axis] * scale[axis] + translate[axis]
                }
            }
            xy
        }
    }

    private fun pair(element: JsonElement?, standard: Double, at: JsonPath): DoubleArray {
        if (element == null) return doubleArrayOf(standard, standard)
        val values = array(element, at)
        return doubleArrayOf(number(values.getOrNull(0), at), number(values.getOrNull(1), at))
    }

    private fun number(element: JsonElement?, at: JsonPath): Double {
        val value = RingPoints.decimal((element as? JsonPrimitive)?.takeIf { !it.isString }?.content.orEmpty())
        if (value.isNaN()) document.fail(at, "two numbers must stand here")
        return value
    }

    private fun array(element: JsonElement?, at: JsonPath) = element as? JsonArray ?: document.fail(at, "an array must stand here")

    private companion object {
        /** Two polygons share an arc, and other objects may name it again; more would make much of a small file. */
        const val MOST_USES = 50
    }
}
