package org.trigrid.project

import org.trigrid.domain.InnerParts
import org.trigrid.domain.Path
import org.trigrid.domain.Region

/** Makes what lies inside a project's domain of its JSON. */
internal object InnerReader {
    /** Sets the project's region and what is inside, from the keys "regions", "lines" and "points". */
    fun read(fields: JsonFields, builder: Project.Builder) {
        var inner = InnerParts.NONE
        if (fields.has("regions")) {
            val names = HashSet<String>()
            for (item in fields.items("regions")) inner = region(JsonFields(item, "a region"), names, inner, builder)
        }
        if (fields.has("lines")) {
            for (item in fields.items("lines")) inner = line(JsonFields(item, "a line"), inner)
        }
        if (fields.has("points")) {
            for (item in fields.items("points")) {
                val point = JsonFields(item, "a point")
                val at = point.point("at")
                inner = inner.withPoint(point.string("name", "point"), at.x, at.y)
                point.end()
            }
        }
        builder.inner(inner)
    }

    private fun region(fields: JsonFields, names: MutableSet<String>, inner: InnerParts, builder: Project.Builder): InnerParts = checked(fields) {
        var region = Region.of(fields.string("name"))
        require(names.add(region.name)) { "there is another region called \"${region.name}\"" }
        if (fields.has("material")) region = region.withMaterial(fields.whole("material"))
        if (fields.has("maxSize")) region = region.withMaxSize(fields.number("maxSize"))
        val places = if (fields.has("at")) fields.points("at") else emptyList()
        fields.end()
        if (region.name == builder.region.name) builder.region(region)
        require(places.isNotEmpty() || region.name == builder.region.name) {
            "region \"${region.name}\" has no place \"at\" which it could be found"
        }
        places.fold(inner) { all, at -> all.withRegion(region, at.x, at.y) }
    }

    private fun line(fields: JsonFields, inner: InnerParts): InnerParts = checked(fields) {
        val xy = fields.points("nodes").flatMap { listOf(it.x, it.y) }.toDoubleArray()
        val name = fields.string("name", Path.UNNAMED_TAG)
        val isClosed = fields.boolean("closed", false)
        fields.end()
        if (isClosed) inner.withLoop(name, *xy) else inner.withLine(name, *xy)
    }

    private fun <T> checked(fields: JsonFields, make: () -> T): T = try {
        make()
    } catch (e: IllegalArgumentException) {
        fields.refuse(e.message ?: "a value is not allowed", e)
    }
}
