package org.trigrid.io

/** Reads the statements of a `.geo` script. */
internal class GeoReader(private val tokens: GeoTokens) {
    private val model = GeoModel().also { it.complaint = tokens }
    private val expressions = GeoExpressions(tokens) { model.newNumber(it)?.toDouble() }

    fun read(): GeoModel {
        while (tokens.kind != GeoTokens.Kind.END) if (!tokens.takeIf(";")) statement()
        return model
    }

    private fun statement() {
        val place = tokens.start
        if (tokens.kind != GeoTokens.Kind.NAME) tokens.fail("expected a statement, found ${tokens.shown()}")
        val word = tokens.word
        tokens.next()
        when (word) {
            "Point" -> readPoint()
            "Line", "Curve" -> if (tokens.takeIf("Loop")) readLoop() else readCurve("Line", place)
            "Circle", "Ellipse", "Spline", "BSpline", "Bezier" -> readCurve(word, place)
            "Plane" -> {
                tokens.expect("Surface")
                readSurface(place)
            }
            "Physical" -> readPhysical()
            "Transfinite" -> readTransfinite()
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
        val change = tokens.word.takeIf { it in "+-*/" && it.isNotEmpty() }
        if (change != null) tokens.next()
        if (!tokens.takeIf("=")) tokens.failAt(place, "the statement $word cannot be read")
        if (tokens.kind == GeoTokens.Kind.STRING || tokens.word == "{" || tokens.word == "DefineNumber") {
            tokens.fail("only numbers can be the value of a variable")
        }
        val value = expressions.number()
        val old = if (change == null) 0.0 else expressions.valueOf(word) ?: tokens.failAt(place, "there is no variable $word")
        expressions.define(
            word,
            when (change) {
                "+" -> old + value
                "-" -> old - value
                "*" -> old * value
                "/" -> old / value
                else -> value
            },
        )
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
        val points = whole(expressions.list(), listPlace).map {
            model.points[it] ?: tokens.failAt(listPlace, "there is no point $it")
        }
        val least = if (kind == "Circle") 3 else if (kind == "Ellipse") 4 else 2
        val most = if (kind == "Line") 2 else if (least > 2) least else Int.MAX_VALUE
        if (points.size !in least..most) tokens.failAt(listPlace, "$kind of ${points.size} points cannot be read")
        val curve = GeoCurves.of(kind, points) ?: tokens.failAt(place, "$kind: these points make no such curve")
        model.curves[number] = GeoModel.Curve(curve, points.first(), points.last())
    }

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
        var name: String? = null
        if (tokens.kind == GeoTokens.Kind.STRING) {
            name = tokens.word
            tokens.next()
            if (tokens.takeIf(",")) expressions.number()
        } else {
            val number = expressions.whole("a physical group")
            name = (if (kind == "Surface") "surface " else "curve ") + number
        }
        tokens.expect(")")
        tokens.takeIf("+")
        tokens.expect("=")
        val place = tokens.start
        for (member in whole(expressions.list(), place)) {
            if (kind == "Surface") model.surfaceNames[Math.abs(member)] = name
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
}
