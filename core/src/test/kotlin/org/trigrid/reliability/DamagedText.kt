package org.trigrid.reliability

import java.util.Random

/** Ways in which a text file may be broken. */
internal object DamagedText {
    private val NUMBER = Regex("-?[0-9]+(\\.[0-9]+)?([eE][+-]?[0-9]+)?")

    private val BAD_NUMBERS = listOf(
        "2000000000", "2147483648", "99999999999", "1e9999999999", "1e999", "-1e999", "1e-999", "NaN", "Infinity", "-1", "-0", "0",
        "1.5", "0x1p3", "1f", "1e9", "1e300", "-1e300", "1e-300", "4.9e-324", "", "+", "-", "1e", "00012", "9".repeat(4000),
    )

    private val PIECES = listOf(
        "\u0000", "\uFEFF", "\r", "\n\n", "\"", "'", "{", "}", "[", "]", "(", ")", ",", ":", ";", "#", "\\", "\\u12", "$", "null", "true",
        "é", "\uD83D\uDE00", "\uD800", "EMPTY", "SRID=4;", "/*", "//",
    )

    fun damaged(text: String, r: Random): String {
        var result = text
        repeat(1 + r.nextInt(3)) { result = damagedOnce(result, r) }
        return result
    }

    private fun damagedOnce(text: String, r: Random): String {
        if (text.isEmpty()) return noise(r, 20)
        val at = r.nextInt(text.length)
        val to = Math.min(text.length, at + 1 + r.nextInt(30))
        return when (r.nextInt(7)) {
            0, 1, 2 -> withBadNumber(text, r)
            3 -> text.removeRange(at, to)
            4 -> text.substring(0, to) + text.substring(at)
            5 -> text.substring(0, at) + PIECES[r.nextInt(PIECES.size)] + text.substring(at)
            else -> text.substring(0, at) + noise(r, 1 + r.nextInt(5)) + text.substring(to)
        }
    }

    private fun withBadNumber(text: String, r: Random): String {
        val places = NUMBER.findAll(text).toList()
        if (places.isEmpty()) return text + BAD_NUMBERS[r.nextInt(BAD_NUMBERS.size)]
        return text.replaceRange(places[r.nextInt(places.size)].range, BAD_NUMBERS[r.nextInt(BAD_NUMBERS.size)])
    }

    fun noise(r: Random, length: Int): String = String(CharArray(length) { (if (r.nextInt(4) > 0) r.nextInt(128) else r.nextInt(65536)).toChar() })

    /** Large, deep and long beyond all measure; [sample] gives the form of some. */
    fun extremes(sample: String): List<String> {
        val depths = listOf("[", "{\"a\":", "(", "GEOMETRYCOLLECTION(", "{\"type\":\"GeometryCollection\",\"geometries\":[")
        val long = listOf("1", " ", "a", "\n", "0 ", "\"", "\\", "1,", "(", ")", "EMPTY ", "SRID=", "#", "[],", "{\"a\":", "1.", ";")
        return depths.flatMap { piece -> listOf(65, 2000, 100_000).map { piece.repeat(it) } } +
            long.map { it.repeat(300_000 / it.length) } +
            long.map { sample + it.repeat(300_000 / it.length) } +
            long.map { sample.take(sample.length / 2) + it.repeat(300_000 / it.length) + sample.drop(sample.length / 2) } +
            listOf(NUMBER.replaceFirst(sample, "9".repeat(300_000)), NUMBER.replace(sample, "2147483647"), NUMBER.replace(sample, "1e308"))
    }
}
