package org.trigrid.io

import org.trigrid.domain.Region

/** Reads the statements of a `.geo` script. */
internal class GeoReader(private val tokens: GeoTokens) {
    private val model = GeoModel().also { it.complaint = tokens }
    private val expressions = GeoExpressions(tokens) { model.newNumber(it)?.toDouble() }
    private val flow = GeoFlow(tokens, expressions)
    private val variables = GeoVariables(tokens, expressions)

    fun read(): GeoModel {
        while (tokens.kind != GeoTokens.Kind.END) if (!tokens.takeIf(";")) statement()
        flow.checkEnd()
        return model
    }

    private fun statement() {
        val place = tokens.start
        if (tokens.kind != GeoTokens.Kind.NAME) tokens.fail("expected a statement, found ${tokens.shown()}")
        val word = tokens.word
        tokens.next()
        if (flow.obey(word, place)) return
        when (word) {
            "Point" -> if (tokens.word == "{") readInner(place, model.innerPoints) else readPoint()
            "Line", "Curve" ->
                if (tokens.takeIf("Loop")) readLoop() else if (tokens.word == "{") readInner(place, model.inner) else readCurve("Line", place)
            "Circle", "Ellipse", "Spline", "BSpline", "Bezier" -> readCurve(word, place)
            "Plane" -> {
                tokens.expect("Surface")
                readSurface(place)
            }
            "Physical" -> readPhysical()
            "Transfinite" -> if (tokens.takeIf("Surface")) skipSurfaces() else readTransfinite()
            "Recombine" -> {
                tokens.expect("Surface")
                skipSurfaces()
            }
            "MeshSize" -> readSizes()
            "Characteristic" -> {
                tokens.expect("Length")
                readSizes()
            }
            "DefineConstant" -> variables.readConstants()
            "Printf", "Save" -> skipToEnd()
            "SetFactory" -> {
                tokens.expect("(")
                tokens.next()
                tokens.expect(")")
            }
            "Mesh", "Coherence" -> if (tokens.takeIf(".")) skipOption() else if (tokens.word != ";") expressions.number()
            else -> otherStatement(word, place)
        }
        tokens.expect(";")
    }

    /** A variable, or an option of Gmsh's own, such as `General.Terminal = 1`, which is passed over. */
    private fun otherStatement(word: String, place: Int) {
        if (tokens.takeIf(".")) return skipOption()
        if (!variables.readAssignment(word)) tokens.failAt(place, "the statement $word cannot be read")
    }

    private fun skipToEnd() {
        while (tokens.kind != GeoTokens.Kind.END && tokens.word != ";") tokens.next()
    }

    /** How other meshers are to fill surfaces. */
    private fun skipSurfaces() {
        expressions.list()
        if (tokens.word != ";") skipToEnd()
    }

    /** `{points} = size`, of all points where the list is `:`. */
    private fun readSizes() {
        val place = tokens.start
        val points = if (tokens.takeSigns("{:}")) model.points.numbers else whole(expressions.list(), place)
        tokens.expect("=")
        val size = expressions.number()
        if (!(size > 0)) tokens.failAt(place, "the size at a point must be above 0, not $size")
        for (number in points) (model.points[number] ?: tokens.failAt(place, "there is no point $number")).size = size
    }

    /** `{curves or points} In Surface {surfaces}` */
    private fun readInner(place: Int, target: HashMap<Int, ArrayList<Int>>) {
        val members = whole(expressions.list(), place)
        tokens.expect("In")
        tokens.expect("Surface")
        for (surface in whole(expressions.list(), place)) {
            if (model.surfaces.none { it.number == surface }) tokens.failAt(place, "there is no surface $surface")
            target.getOrPut(surface) { ArrayList() }.addAll(members.map { Math.abs(it) })
        }
    }

    private fun skipOption() {
        while (tokens.word != "=" && tokens.word != ";" && tokens.kind != GeoTokens.Kind.END) tokens.next()
        tokens.expect("=")
        if (tokens.kind == GeoTokens.Kind.STRING) tokens.next() else expressions.number()
    }

    /** `(number) = ` */
    private fun number(what: String): Int {
        tokens.expect("(")
        val number = expressions.whole("the number of a $what")
        tokens.expect(")")
        tokens.expect("=")
        return number
    }

    private fun readPoint() {
        val number = number("point")
        val place = tokens.start
        val values = expressions.list()
        if (values.size !in 3..4) tokens.failAt(place, "a point has three coordinates and perhaps a size, not ${values.size} numbers")
        if (values[2] != 0.0) tokens.failAt(place, "z = ${values[2]}: only points in the plane z = 0 can be read")
        val size = values.getOrElse(3) { Double.NaN }
        if (size <= 0) tokens.failAt(place, "the size at a point must be above 0, not $size")
        model.points[number] = GeoModel.Point(values[0], values[1], size)
    }

    private fun readCurve(kind: String, place: Int) {
        val number = number("curve")
        val listPlace = tokens.start
        val values = expressions.list()
        if (kind == "Circle" && values.size in 4..6) return readCircle(number, values, place)
        val points = whole(values, listPlace).map {
            model.points[it] ?: tokens.failAt(listPlace, "there is no point $it")
        }
        val least = if (kind == "Circle") 3 else if (kind == "Ellipse") 4 else 2
        val most = if (kind == "Line") 2 else if (least > 2) least else Int.MAX_VALUE
        if (points.size !in least..most) tokens.failAt(listPlace, "$kind of ${points.size} points cannot be read")
        val curve = GeoCurves.of(kind, points) ?: tokens.failAt(place, "$kind: these points make no such curve")
        model.curves[number] = GeoModel.Curve(curve, points.first(), points.last())
    }

    /** Of OpenCASCADE: the centre, the radius, and the angles at the ends of an arc. */
    private fun readCircle(number: Int, values: List<Double>, place: Int) {
        if (values[2] != 0.0) tokens.failAt(place, "z = ${values[2]}: only circles in the plane z = 0 can be read")
        if (!(values[3] > 0)) tokens.failAt(place, "the radius must be above 0, not ${values[3]}")
        val from = values.getOrElse(4) { 0.0 } / (2 * Math.PI)
        val to = values.getOrElse(5) { (from + 1) * 2 * Math.PI } / (2 * Math.PI)
        val isWhole = Math.abs(to - from - 1) < WHOLE_TURN
        if (!(to > from) || !isWhole && to - from > 1) tokens.failAt(place, "the angles of an arc must rise, by up to a turn")
        val curve = EllipseArc.circle(values[0], values[1], values[3], from, if (isWhole) from + 1 else to)
        val begin = GeoModel.Point(curve.beginX, curve.beginY, Double.NaN)
        model.points[newPoint()] = begin
        val end = if (isWhole) begin else GeoModel.Point(curve.endX, curve.endY, Double.NaN).also { model.points[newPoint()] = it }
        model.curves[number] = GeoModel.Curve(curve, begin, end)
    }

    private fun newPoint(): Int = requireNotNull(model.newNumber("newp"))

    private fun readLoop() {
        val place = tokens.start
        val number = number("loop")
        model.loops[number] = GeoModel.Loop(whole(expressions.list(), place), place)
    }

    private fun readSurface(place: Int) {
        val number = number("surface")
        val loops = whole(expressions.list(), place)
        if (loops.isEmpty()) tokens.failAt(place, "a surface needs a loop")
        model.surfaces.add(GeoModel.Surface(number, loops, place))
    }

    private fun readPhysical() {
        val kind = tokens.word
        if (kind !in setOf("Point", "Line", "Curve", "Surface")) tokens.fail("Physical ${tokens.word} cannot be read")
        tokens.next()
        tokens.expect("(")
        val name: String
        var number = 0
        if (tokens.kind == GeoTokens.Kind.STRING) {
            name = tokens.word
            tokens.next()
            if (tokens.takeIf(",")) number = expressions.whole("a physical group")
        } else {
            number = expressions.whole("a physical group")
            name = (if (kind == "Surface") "surface " else if (kind == "Point") "point " else "curve ") + number
        }
        val region = Region.of(name).withMaterial(Math.max(number, 0))
        tokens.expect(")")
        tokens.takeIf("+")
        tokens.expect("=")
        val place = tokens.start
        for (member in whole(expressions.list(), place)) {
            if (kind == "Surface") model.regions[Math.abs(member)] = region
            if (kind == "Point") model.pointTags[Math.abs(member)] = name
            if (kind == "Line" || kind == "Curve") model.curveTags[Math.abs(member)] = name
        }
    }

    private fun readTransfinite() {
        if (!tokens.takeIf("Curve") && !tokens.takeIf("Line")) tokens.fail("Transfinite ${tokens.word} cannot be read")
        val place = tokens.start
        val curves = whole(expressions.list(), place)
        tokens.expect("=")
        val nodes = expressions.whole("the number of nodes")
        if (nodes !in 2..1_000_000) tokens.failAt(place, "a curve cannot have $nodes nodes")
        var ratio = 1.0
        if (tokens.takeIf("Using")) {
            if (!tokens.takeIf("Progression")) tokens.fail("only Using Progression can be read, not ${tokens.shown()}")
            val progression = expressions.number()
            if (!(progression > 0)) tokens.failAt(place, "the progression must be above 0, not $progression")
            ratio = StrictMath.pow(progression, nodes - 2.0)
            if (!(ratio > 0 && ratio < Double.POSITIVE_INFINITY)) tokens.failAt(place, "the progression $progression is out of range")
        }
        for (curve in curves) {
            val division = OutlineDivision(nodes - 1, ratio)
            model.divisions[Math.abs(curve)] = if (curve < 0) division.reversed() else division
        }
    }

    private fun whole(values: List<Double>, place: Int): List<Int> = values.map {
        if (it.toInt().toDouble() != it) tokens.failAt(place, "$it is no number of an entity")
        it.toInt()
    }

    private companion object {
        const val WHOLE_TURN = 1e-9
    }
}
