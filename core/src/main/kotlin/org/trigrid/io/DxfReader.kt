package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException
import java.util.Locale

/**
 * Reads the entities that bound something, those of blocks where they are inserted; text, dimensions, hatches and points are passed
 * over, and so is what is hidden or on a sheet of paper; entities of space are refused.
 *
 * @param unit the unit wanted, or null for the file's own.
 */
internal class DxfReader(private val pairs: DxfPairs, private val unit: LengthUnit?) {
    private val blocks = HashMap<String, DxfBlock>()
    private val drawing = DxfBlock(0.0, 0.0)
    private var fileUnit: LengthUnit? = null

    /** Where entities go. */
    private var target = drawing

    /** The pieces of the drawing, in the unit wanted. */
    fun read(): List<OutlinePiece> {
        readSections()
        val map = if (unit == null || drawing.items.isEmpty()) AffineMap.IDENTITY else scaleOf(unit).let { AffineMap(it, 0.0, 0.0, it, 0.0, 0.0) }
        return DxfBlocks(blocks, pairs).pieces(drawing.items, map)
    }

    private fun readSections() {
        var section = ""
        var more = pairs.next()
        while (more) {
            if (pairs.code == 0 && pairs.value == "SECTION") {
                more = pairs.next()
                if (more && pairs.code == 2) section = pairs.value
                target = drawing
            } else if (section == "HEADER" && pairs.code == 9 && pairs.value == "\$INSUNITS") {
                if (pairs.next() && pairs.code == 70) fileUnit = LengthUnit.ofDxf(pairs.int())
            } else if (section == "ENTITIES" && pairs.code == 0 && pairs.value != "ENDSEC") {
                more = readEntity()
                continue
            } else if (section == "BLOCKS" && pairs.code == 0 && pairs.value != "ENDSEC") {
                more = readOfBlock()
                continue
            } else if (pairs.code == 0 && pairs.value == "ENDSEC") {
                section = ""
            }
            more = pairs.next()
        }
    }

    private fun scaleOf(wanted: LengthUnit): Double {
        val given = fileUnit ?: pairs.fail("the file does not say its unit (\$INSUNITS), so that it cannot be converted")
        return given.metres / wanted.metres
    }

    /** What cannot be read in a block is told where the block is used. */
    private fun readOfBlock(): Boolean = when (pairs.value) {
        "BLOCK" -> {
            val begin = DxfEntity(pairs)
            val more = begin.read()
            target = DxfBlock(begin[10], begin[20])
            blocks[begin.block.uppercase(Locale.ROOT)] = target
            more
        }
        "ENDBLK" -> {
            target = drawing
            DxfEntity(pairs).read()
        }
        else -> try {
            readEntity()
        } catch (error: FileFormatException) {
            target.items.add(DxfRefusal(error))
            // A mistake in the middle of an entity leaves the rest of it to be passed over.
            pairs.code == 0 && !pairs.isAtEnd || pairs.toNextEntity()
        }
    }

    /** Reads one entity, up to the next; false at the end of the file. */
    private fun readEntity(): Boolean {
        val type = pairs.value
        val entity = DxfEntity(pairs)
        var more = entity.read()
        if (entity.isHidden() && type != "POLYLINE") return more
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
            "INSERT" -> addInsert(entity)
            "3DFACE", "SOLID", "TRACE", "MLINE", "REGION", "3DSOLID", "BODY", "MESH" -> entity.fail("$type cannot be read")
        }
        return more
    }

    private fun add(entity: DxfEntity, curve: MappableCurve) {
        target.items.add(DxfCurve(curve, entity.layer))
    }

    /** Scaled, put in rows and columns, turned, moved, and last seen from the side that the entity is drawn on. */
    private fun addInsert(entity: DxfEntity) {
        val scaleX = entity.valueOr(41, 1.0)
        val scaleY = entity.valueOr(42, 1.0)
        if (scaleX == 0.0 || scaleY == 0.0) entity.fail("an INSERT cannot be scaled by 0")
        val columns = Math.max(1, entity[70].toInt())
        val rows = Math.max(1, entity[71].toInt())
        if (columns.toLong() * rows > MOST_INSERTS) entity.fail("an INSERT of $columns columns and $rows rows is too much")
        val seen = if (entity.isMirrored()) AffineMap(-1.0, 0.0, 0.0, 1.0, 0.0, 0.0) else AffineMap.IDENTITY
        val turned = seen * AffineMap.translation(entity[10], entity[20]) * AffineMap.rotation(entity[50])
        val scaled = AffineMap(scaleX, 0.0, 0.0, scaleY, 0.0, 0.0)
        val maps = List(columns * rows) { turned * AffineMap.translation(it % columns * entity[44], it / columns * entity[45]) * scaled }
        target.items.add(DxfInsert(entity.block.uppercase(Locale.ROOT), entity.layer, maps, entity.line))
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
        if (!entity.isHidden()) addPolyline(entity, vertices, flags and 1 != 0)
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
        const val MOST_INSERTS = 100_000L

        /** Files of eight digits do not have 2 pi exactly. */
        const val WHOLE_TURN = 1e-6
    }
}
