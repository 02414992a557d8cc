package org.trigrid.project

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import org.trigrid.domain.InnerParts
import org.trigrid.domain.Region
import org.trigrid.geometry.Point2

/** Makes the JSON of what lies inside a project's domain. */
internal object InnerWriter {
    /** Regions with their places; first the project's own, without one, if there is more to it than its name. */
    fun regions(project: Project): JsonArray {
        val inner = project.inner
        val own = project.region
        val entries = ArrayList<kotlinx.serialization.json.JsonObject>()
        val isToldWithPlaces = (0 until inner.markerCount).any { inner.markerRegion(it) == own }
        if (own != Region.of(own.name) && !isToldWithPlaces) entries.add(buildJsonObject { region(own) })
        for ((region, markers) in (0 until inner.markerCount).groupBy { inner.markerRegion(it) }) {
            entries.add(buildJsonObject {
                region(region)
                put("at", ProjectWriter.points(markers.map { Point2(inner.markerX(it), inner.markerY(it)) }))
            })
        }
        return JsonArray(entries)
    }

    fun lines(inner: InnerParts) = JsonArray(List(inner.lineCount) { line ->
        buildJsonObject {
            val xy = inner.lineNodes(line)
            put("name", inner.lineTag(line))
            if (inner.isClosed(line)) put("closed", true)
            put("nodes", ProjectWriter.points(List(xy.size / 2) { Point2(xy[2 * it], xy[2 * it + 1]) }))
        }
    })

    fun points(inner: InnerParts) = JsonArray(List(inner.pointCount) {
        buildJsonObject {
            put("name", inner.pointTag(it))
            put("at", ProjectWriter.point(Point2(inner.pointX(it), inner.pointY(it))))
        }
    })

    private fun JsonObjectBuilder.region(region: Region) {
        put("name", region.name)
        if (region.material > 0) put("material", region.material)
        if (region.maxSize != Double.POSITIVE_INFINITY) put("maxSize", ProjectWriter.number(region.maxSize))
    }
}
