package org.trigrid.editor.files

/** Loops as people paste them: two numbers a line, an empty line between loops. */
internal object PointList {
    private val SEPARATOR = Regex("""[\s,;]+""")

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
            val numbers = line.trim().split(SEPARATOR).map { it.toDoubleOrNull() ?: return null }
            if (numbers.size < 2 || numbers.any { !it.isFinite() }) return null
            current.add(numbers[0])
            current.add(numbers[1])
        }
        return loops.takeIf { it.isNotEmpty() }
    }

    /** Without a last point that repeats the first. */
    private fun loop(xy: List<Double>): DoubleArray? {
        val n = xy.size
        val repeats = n >= 4 && xy[0] == xy[n - 2] && xy[1] == xy[n - 1]
        val kept = if (repeats) xy.subList(0, n - 2) else xy
        return if (kept.size < 6) null else kept.toDoubleArray()
    }
}
