package org.trigrid.io

/**
 * Gmsh's geometry script, in part: points with sizes, lines, arcs, splines, loops, plane and physical surfaces, curves inside of
 * surfaces, transfinite curves, variables and lists, arithmetic, `For` and `If`. Each plane surface is a domain; what is not known is an error with its place.
 */
internal class GeoFormat : DomainFormat("geo", "Gmsh .geo, in part", listOf(".geo"), hasCurves = true) {
    override fun read(input: DomainText): List<NamedDomain> {
        ReadingMemory.check(input.source, input.text.length, ReadingMemory.DRAWING * input.text.length)
        val model = GeoReader(GeoTokens(input.text, input.source)).read()
        return GeoDomains(model, input).domains()
    }
}

/** The words of a script with their places; `//` and `/* */` comments do not count. */
internal class GeoTokens(private val text: String, private val source: String) : Complaint {
    enum class Kind { NAME, NUMBER, STRING, SIGN, END }

    private var at = 0

    /** Of the token at hand. */
    var start = 0
        private set
    var kind = Kind.END
        private set
    /** What the token at hand says, a string without its quotes. */
    val word: String get() = text.substring(wordStart, wordEnd)

    private var wordStart = 0
    private var wordEnd = 0

    init {
        next()
    }

    fun next() {
        skip()
        start = at
        val c = text.getOrNull(at)
        when {
            c == null -> take(Kind.END, 0)
            c.isLetter() || c == '_' -> take(Kind.NAME, length { it.isLetterOrDigit() || it == '_' })
            c in '0'..'9' || c == '.' && text.getOrNull(at + 1).let { it != null && it in '0'..'9' } -> take(Kind.NUMBER, numberLength())
            c == '"' -> {
                val end = text.indexOf('"', at + 1)
                if (end < 0) fail("the string is not closed")
                take(Kind.STRING, end + 1 - at)
                wordStart++
                wordEnd--
            }
            else -> take(Kind.SIGN, 1)
        }
    }

    /** Takes the sign or name [expected], if it is at hand. */
    fun takeIf(expected: String): Boolean {
        if (kind == Kind.STRING || wordEnd - wordStart != expected.length || !text.startsWith(expected, wordStart)) return false
        next()
        return true
    }

    /** Takes several signs in a row, such as `==`. */
    fun takeSigns(expected: String): Boolean {
        if (kind != Kind.SIGN || !text.startsWith(expected, start)) return false
        repeat(expected.length) { next() }
        return true
    }

    /** Goes back to the token that began at [place]. */
    fun goTo(place: Int) {
        at = place
        next()
    }

    fun expect(expected: String) {
        if (!takeIf(expected)) fail("expected '$expected', found ${shown()}")
    }

    fun shown(): String = if (kind == Kind.END) "the end of the file" else "'$word'"

    /** About the token at hand. */
    override fun fail(reason: String): Nothing = failAt(start, reason)

    fun failAt(place: Int, reason: String): Nothing = throw TextPlace.exception(source, text, place, reason)

    private fun take(kind: Kind, length: Int) {
        this.kind = kind
        wordStart = at
        at += length
        wordEnd = at
    }

    /** The value of a number of few digits alone, or -1. */
    fun smallNumber(): Int {
        var value = 0
        if (wordEnd - wordStart > SMALL_DIGITS) return -1
        for (i in wordStart until wordEnd) value = if (text[i] in '0'..'9') 10 * value + (text[i] - '0') else return -1
        return value
    }

    private fun length(accepts: (Char) -> Boolean): Int {
        var end = at
        while (end < text.length && accepts(text[end])) end++
        return end - at
    }

    private fun numberLength(): Int {
        var end = at
        while (end < text.length && (text[end] in '0'..'9' || text[end] == '.')) end++
        if (end < text.length && text[end] in "eE") {
            val digits = if (text.getOrNull(end + 1).let { it == '+' || it == '-' }) end + 2 else end + 1
            if (text.getOrNull(digits).let { it != null && it in '0'..'9' }) {
                end = digits
                while (end < text.length && text[end] in '0'..'9') end++
            }
        }
        return end - at
    }

    private fun skip() {
        while (at < text.length) {
            if (text[at].isWhitespace()) {
                at++
            } else if (text.startsWith("//", at)) {
                while (at < text.length && text[at] != '\n') at++
            } else if (text.startsWith("/*", at)) {
                val end = text.indexOf("*/", at + 2)
                if (end < 0) throw TextPlace.exception(source, text, at, "the comment is not closed")
                at = end + 2
            } else {
                return
            }
        }
    }

    private companion object {
        const val SMALL_DIGITS = 9
    }
}
