package org.trigrid.io

import java.io.StringReader

/**
 * SVG: the outlines of paths and basic shapes. Closed ones are loops, open ones lines kept inside; y is turned upwards. The id of
 * an element, or else of the group round it, is the tag of its segments.
 */
internal class SvgFormat : DomainFormat("svg", "SVG", listOf(".svg"), hasCurves = true) {
    override fun looksLike(first: String) = first.startsWith("<")

    override fun read(input: DomainText): List<NamedDomain> {
        ReadingMemory.check(input.source, input.text.length, ReadingMemory.DRAWING * input.text.length)
        return SvgReader(input).read()
    }
}

/** Goes through the elements with the transform and the tag that hold for each. */
internal class SvgReader(private val input: DomainText) {
    private val xml = XmlWalk(StringReader(input.text), input.source)
    private val outline = Outline(input, input.baseName)
    private val scopes = ArrayList<Scope>()

    private class Scope(val map: AffineMap, val tag: String, val isHidden: Boolean)

    fun read(): List<NamedDomain> {
        // SVG's y runs downwards.
        scopes.add(Scope(AffineMap(1.0, 0.0, 0.0, -1.0, 0.0, 0.0), DEFAULT_TAG, false))
        loop@ while (true) {
            when (xml.next()) {
                XmlWalk.Event.START -> startElement()
                XmlWalk.Event.END -> scopes.removeLast()
                XmlWalk.Event.DONE -> break@loop
                XmlWalk.Event.TEXT -> Unit
            }
        }
        if (outline.isEmpty) xml.fail("there is no closed outline in it")
        return input.single(outline.toDomain())
    }

    private fun startElement() {
        val name = xml.name
        if (xml.depth == 1 && name != "svg") xml.fail("this is no SVG: it begins with <$name>")
        val above = scopes.last()
        val hidden = above.isHidden || name in HIDING || xml.attribute("display") == "none"
        val ownMap = xml.attribute("transform")?.let { SvgTransform.parse(it, xml) }
        val tag = xml.attribute("id")?.trim()?.ifEmpty { null } ?: above.tag
        val scope = Scope(if (ownMap == null) above.map else above.map * ownMap, if (name == "svg") above.tag else tag, hidden)
        scopes.add(scope)
        if (!hidden) addShape(name, SvgContours(scope.map, scope.tag))
    }

    private fun addShape(name: String, contours: SvgContours) {
        when (name) {
            "path" -> SvgPath(xml.attribute("d").orEmpty(), contours, xml).read()
            "rect" -> contours.rectangle(number("x"), number("y"), number("width"), number("height"), radius("rx"), radius("ry"))
            "circle" -> contours.ellipse(number("cx"), number("cy"), number("r"), number("r"))
            "ellipse" -> contours.ellipse(number("cx"), number("cy"), number("rx"), number("ry"))
            "line" -> contours.polyline(doubleArrayOf(number("x1"), number("y1"), number("x2"), number("y2")), false)
            "polyline" -> contours.polyline(points(), false)
            "polygon" -> contours.polyline(points(), true)
            "use" -> xml.fail("<use> cannot be read: replace the copies by the shapes themselves")
        }
        for (contour in contours.finished()) if (contour.isClosed) outline.loop(contour.pieces) else outline.embed(contour.pieces)
    }

    private fun number(attribute: String): Double {
        val text = xml.attribute(attribute)?.trim() ?: return 0.0
        val value = RingPoints.decimal(text.removeSuffix("px"))
        if (value.isNaN()) xml.fail("$attribute must be a number in user units, not '$text'")
        return value
    }

    private fun radius(attribute: String): Double {
        val text = xml.attribute(attribute)
        return if (text == null || text == "auto") Double.NaN else number(attribute)
    }

    private fun points(): DoubleArray {
        val numbers = SvgNumbers(xml.attribute("points").orEmpty(), xml)
        val values = ArrayList<Double>()
        while (numbers.hasNumber()) values.add(numbers.number())
        if (!numbers.atEnd() || values.size % 2 != 0) xml.fail("points must be pairs of numbers")
        return values.toDoubleArray()
    }

    private companion object {
        const val DEFAULT_TAG = "boundary"

        /** What is in these is not drawn where it stands. */
        val HIDING = setOf("defs", "symbol", "clipPath", "mask", "marker", "pattern", "metadata", "title", "desc")
    }
}

/** Numbers and words of an attribute, separated by blanks and commas or by nothing where that is clear. */
internal class SvgNumbers(private val text: String, private val complaint: Complaint) {
    private var at = 0

    fun atEnd(): Boolean {
        skip()
        return at >= text.length
    }

    fun hasNumber(): Boolean {
        skip()
        return at < text.length && (text[at] in '0'..'9' || text[at] in "+-.")
    }

    /** The next character, which is taken. */
    fun letter(): Char {
        skip()
        return text[at++]
    }

    fun word(): String {
        skip()
        val from = at
        while (at < text.length && text[at].isLetter()) at++
        return text.substring(from, at)
    }

    fun flag(): Boolean {
        skip()
        val c = text.getOrNull(at++)
        if (c != '0' && c != '1') complaint.fail("a flag of an arc must be 0 or 1, not '${c ?: ""}'")
        return c == '1'
    }

    fun number(): Double {
        skip()
        val from = at
        if (at < text.length && text[at] in "+-") at++
        digits()
        if (at < text.length && text[at] == '.') {
            at++
            digits()
        }
        if (at < text.length && text[at] in "eE" && text.getOrNull(at + 1).let { it != null && (it in '0'..'9' || it in "+-") }) {
            at += 2
            digits()
        }
        val value = RingPoints.decimal(text.substring(from, at))
        if (value.isNaN()) complaint.fail("expected a number, found '${text.drop(from).take(SHOWN)}'")
        return value
    }

    private fun digits() {
        while (at < text.length && text[at] in '0'..'9') at++
    }

    private fun skip() {
        while (at < text.length && (text[at].isWhitespace() || text[at] == ',')) at++
    }

    private companion object {
        const val SHOWN = 20
    }
}

/** The attribute `transform`. */
internal object SvgTransform {
    fun parse(text: String, complaint: Complaint): AffineMap {
        val numbers = SvgNumbers(text, complaint)
        var map = AffineMap.IDENTITY
        while (!numbers.atEnd()) {
            val name = numbers.word()
            if (name.isEmpty() || numbers.atEnd() || numbers.letter() != '(') complaint.fail("a transform must be like translate(1, 2)")
            val values = ArrayList<Double>()
            while (numbers.hasNumber()) values.add(numbers.number())
            if (numbers.atEnd() || numbers.letter() != ')') complaint.fail("the brackets of the transform $name are not closed")
            map *= one(name, values) ?: complaint.fail("the transform $name with ${values.size} numbers is unknown")
        }
        return map
    }

    private fun one(name: String, v: List<Double>): AffineMap? = when (name to v.size) {
        "matrix" to 6 -> AffineMap(v[0], v[1], v[2], v[3], v[4], v[5])
        "translate" to 1 -> AffineMap.translation(v[0], 0.0)
        "translate" to 2 -> AffineMap.translation(v[0], v[1])
        "scale" to 1 -> AffineMap(v[0], 0.0, 0.0, v[0], 0.0, 0.0)
        "scale" to 2 -> AffineMap(v[0], 0.0, 0.0, v[1], 0.0, 0.0)
        "rotate" to 1 -> AffineMap.rotation(v[0])
        "rotate" to 3 -> AffineMap.translation(v[1], v[2]) * AffineMap.rotation(v[0]) * AffineMap.translation(-v[1], -v[2])
        "skewX" to 1 -> AffineMap(1.0, 0.0, StrictMath.tan(Math.toRadians(v[0])), 1.0, 0.0, 0.0)
        "skewY" to 1 -> AffineMap(1.0, StrictMath.tan(Math.toRadians(v[0])), 0.0, 1.0, 0.0, 0.0)
        else -> null
    }
}
