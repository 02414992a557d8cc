package org.trigrid.io

/**
 * Reads the entities that bound something; text, dimensions, hatches and points are passed over, blocks and entities of space refused.
 *
 * @param unit the unit wanted, or null for the file's own.
 */
internal class DxfReader(private val pairs: DxfPairs, private val unit: LengthUnit?) {
    val pieces = ArrayList<OutlinePiece>()
    private var scale = 1.0

    fun read() {
        var section = ""
        var fileUnit: LengthUnit? = null
        var more = pairs.next()
        while (more) {
            if (pairs.code == 0 && pairs.value == "SECTION") {
                more = pairs.next()
                if (more && pairs.code == 2) section = pairs.value
            } else if (section == "HEADER" && pairs.code == 9 && pairs.value == "\$INSUNITS") {
                if (pairs.next() && pairs.code == 70) fileUnit = LengthUnit.ofDxf(pairs.int())
            } else if (section == "ENTITIES" && pairs.code == 0 && pairs.value != "ENDSEC") {
                if (pieces.isEmpty()) scale = scaleOf(fileUnit)
                more = readEntity()
                continue
            } else if (pairs.code == 0 && pairs.value == "ENDSEC") {
                section = ""
            }
            more = pairs.next()
        }
    }

    private fun scaleOf(fileUnit: LengthUnit?): Double {
        if (unit == null) return 1.0
        if (fileUnit == null) pairs.fail("the file does not say its unit (\$INSUNITS), so that it cannot be converted")
        return fileUnit.metres / unit.metres
    }

    /** Reads one entity, up to the next; false at the end of the file. */
    private fun readEntity(): Boolean {
        val type = pairs.value
        val entity = DxfEntity(pairs)
        var more = entity.read()
        when (type) {
            "LINE" -> add(entity, StraightLine(entity[10], entity[20], entity[11], entity[21]))
            "CIRCLE" -> addCircle(entity, 0.0, 1.0)
            "ARC" -> {
                val from = entity[50] / 360
                var turns = entity[51] / 360 - from
                turns -= Math.floor(turns)
                addCircle(entity, from, from + (if (turns == 0.0) 1.0 else turns))
            }
            "ELLIPSE" -> addEllipse(entity)
            "LWPOLYLINE" -> addPolyline(entity, entity.vertices, entity.flags() and 1 != 0)
            "POLYLINE" -> more = readPolyline(entity)
            "SPLINE" -> addSpline(entity)
            "INSERT" -> entity.fail("INSERT cannot be read: explode the blocks first")
            "3DFACE", "SOLID", "TRACE", "MLINE", "REGION", "3DSOLID", "BODY", "MESH" -> entity.fail("$type cannot be read")
        }
        return more
    }

    private fun add(entity: DxfEntity, curve: PlaneCurve) {
        val scaled = when {
            scale == 1.0 -> curve
            curve is StraightLine -> curve.scaled(scale)
            else -> ScaledCurve(curve, scale)
        }
        pieces.add(OutlinePiece(scaled, entity.layer))
    }

    private fun addCircle(entity: DxfEntity, from: Double, to: Double) {
        val radius = entity[40]
        if (!(radius > 0)) entity.fail("the radius must be above 0, not $radius")
        val sign = if (entity.isMirrored()) -1.0 else 1.0
        add(entity, EllipseArc(sign * entity[10], entity[20], sign * radius, 0.0, 0.0, radius, from, to))
    }

    /** The small half axis is the large one turned by a quarter and shortened. */
    private fun addEllipse(entity: DxfEntity) {
        val sign = if (entity.isMirrored()) -1.0 else 1.0
        val share = entity[40]
        if (!(share > 0) || entity[11] == 0.0 && entity[21] == 0.0) entity.fail("the ellipse has no area")
        val from = entity[41] / (2 * Math.PI)
        val end = entity.valueOr(42, 2 * Math.PI) / (2 * Math.PI)
        var turns = end - from
        if (turns <= 0) turns -= Math.floor(turns)
        if (turns == 0.0 || Math.abs(turns - 1) < WHOLE_TURN) turns = 1.0
        val bx = -sign * share * entity[21]
        val by = sign * share * entity[11]
        add(entity, EllipseArc(entity[10], entity[20], entity[11], entity[21], bx, by, from, from + turns))
    }

    private fun readPolyline(entity: DxfEntity): Boolean {
        val flags = entity.flags()
        if (flags and (16 or 64) != 0) entity.fail("meshes of POLYLINE cannot be read")
        val vertices = ArrayList<DoubleArray>()
        while (pairs.code == 0 && pairs.value == "VERTEX") {
            val vertex = DxfEntity(pairs)
            val more = vertex.read()
            // Control points of a curve that was fitted are no points of it.
            if (vertex.flags() and 16 == 0) vertices.add(doubleArrayOf(vertex[10], vertex[20], vertex[42]))
            if (!more) return false
        }
        addPolyline(entity, vertices, flags and 1 != 0)
        return if (pairs.value == "SEQEND") DxfEntity(pairs).read() else true
    }

    private fun addPolyline(entity: DxfEntity, vertices: List<DoubleArray>, isClosed: Boolean) {
        val sign = if (entity.isMirrored()) -1.0 else 1.0
        for (i in vertices.indices) {
            val a = vertices[i]
            val b = if (i + 1 < vertices.size) vertices[i + 1] else if (isClosed) vertices[0] else break
            if (a[0] == b[0] && a[1] == b[1]) continue
            add(entity, EllipseArc.ofBulge(sign * a[0], a[1], sign * b[0], b[1], sign * a[2]))
        }
    }

    private fun addSpline(entity: DxfEntity) {
        val degree = entity.valueOr(71, 3.0).toInt()
        val points = entity.vertices
        val knots = entity.knots.toDoubleArray()
        val weights = DoubleArray(points.size) { entity.weights.getOrElse(it) { 1.0 } }
        if (points.isEmpty()) entity.fail("a SPLINE must have control points; those with fit points alone cannot be read")
        if (degree !in 1..25 || knots.size != points.size + degree + 1 || points.size <= degree) {
            entity.fail("a SPLINE of degree $degree with ${points.size} control points cannot have ${knots.size} knots")
        }
        val rises = (1 until knots.size).all { knots[it] >= knots[it - 1] } && knots[degree] < knots[points.size]
        if (!rises) entity.fail("the knots of a SPLINE must not fall")
        if (weights.any { !(it > 0) }) entity.fail("weights of a SPLINE must be above 0")
        add(entity, SplineCurve(degree, knots, DoubleArray(2 * points.size) { points[it / 2][it % 2] }, weights))
    }

    private companion object {
        /** Files of eight digits do not have 2 pi exactly. */
        const val WHOLE_TURN = 1e-6
    }
}

/** The values of one entity by their group codes. */
private class DxfEntity(private val pairs: DxfPairs) {
    private val values = HashMap<Int, Double>()
    private val line = pairs.lineNumber

    /** x, y, bulge of LWPOLYLINE; x, y of SPLINE. */
    val vertices = ArrayList<DoubleArray>()
    val knots = ArrayList<Double>()
    val weights = ArrayList<Double>()
    var layer = "0"
        private set
    private val type = pairs.value

    /** Reads up to the next entity; false at the end of the file. */
    fun read(): Boolean {
        while (pairs.next()) {
            when (pairs.code) {
                0 -> return true
                8 -> layer = pairs.value.ifEmpty { "0" }
                in 10..59, in 140..149, in 210..239 -> putNumber()
                in 70..79 -> values[pairs.code] = pairs.int().toDouble()
            }
        }
        return false
    }

    private fun putNumber() {
        val value = pairs.number()
        val isList = type == "LWPOLYLINE" || type == "SPLINE"
        when {
            isList && pairs.code == 10 -> vertices.add(doubleArrayOf(value, 0.0, 0.0))
            isList && pairs.code == 20 -> vertices.lastOrNull()?.set(1, value)
            type == "LWPOLYLINE" && pairs.code == 42 -> vertices.lastOrNull()?.set(2, value)
            type == "SPLINE" && pairs.code == 40 -> knots.add(value)
            type == "SPLINE" && pairs.code == 41 -> weights.add(value)
            else -> values[pairs.code] = value
        }
    }

    operator fun get(code: Int): Double = values[code] ?: 0.0

    fun valueOr(code: Int, standard: Double): Double = values[code] ?: standard

    fun flags(): Int = get(70).toInt()

    /** Seen from below, where x runs the other way; other planes are none of the drawing. */
    fun isMirrored(): Boolean {
        if (get(210) != 0.0 || get(220) != 0.0) fail("the entity is not in the plane of the drawing")
        return get(230) < 0
    }

    fun fail(reason: String): Nothing = pairs.failAtLine(line, reason)
}

/** The same curve, larger. */
private class ScaledCurve(private val curve: PlaneCurve, private val scale: Double) : PlaneCurve {
    override val knots: DoubleArray get() = curve.knots

    override fun x(u: Double) = scale * curve.x(u)

    override fun y(u: Double) = scale * curve.y(u)

    override fun speed(u: Double) = scale * curve.speed(u)

    override val beginX: Double get() = scale * curve.beginX
    override val beginY: Double get() = scale * curve.beginY
    override val endX: Double get() = scale * curve.endX
    override val endY: Double get() = scale * curve.endY
}
