package org.trigrid.editor.files

/**
 * Loops as people paste them: two numbers a line, an empty line between loops, a line of words before each. Numbers may
 * have a decimal comma where another character stands between them.
 */
internal object PointList {
    private val SEPARATOR = Regex("""[\s,;]+""")
    private val BESIDE_COMMAS = Regex("""\s*[;\t]\s*|\s+""")
    private val DECIMAL_COMMAS = Regex("""[-+]?\d*,\d+\s+[-+]?\d*,\d+""")

    /** Coordinates of each loop, x0, y0, x1, y1, …; null if [text] is no such list, or a loop has fewer than three points. */
    fun parse(text: String): List<DoubleArray>? {
        val loops = ArrayList<DoubleArray>()
        var current = ArrayList<Double>()
        for (line in text.lines() + "") {
            if (line.isBlank()) {
                if (current.isNotEmpty()) loops.add(loop(current) ?: return null)
                current = ArrayList()
                continue
            }
            val isHeading = current.isEmpty() && line.none { it.isDigit() }
            if (isHeading) continue
            val numbers = numbers(line.trim()) ?: return null
            current.add(numbers[0])
            current.add(numbers[1])
        }
        return loops.takeIf { it.isNotEmpty() }
    }

    /** At least two numbers, or null. */
    private fun numbers(line: String): List<Double>? {
        val hasCommas = ';' in line || '\t' in line || DECIMAL_COMMAS.matches(line)
        val words = if (hasCommas) line.split(BESIDE_COMMAS).map { it.replace(',', '.') } else line.split(SEPARATOR)
        val numbers = words.filter { it.isNotEmpty() }.map { it.toDoubleOrNull()?.takeIf(Double::isFinite) ?: return null }
        return numbers.takeIf { it.size >= 2 }
    }

    /** Without a last point that repeats the first. */
    private fun loop(xy: List<Double>): DoubleArray? {
        val n = xy.size
        val repeats = n >= 4 && xy[0] == xy[n - 2] && xy[1] == xy[n - 1]
        val kept = if (repeats) xy.subList(0, n - 2) else xy
        return if (kept.size < 6) null else kept.toDoubleArray()
    }
}
