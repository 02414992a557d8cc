package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.Domain

/**
 * Points of loops, one a line: x and y, divided by commas, semicolons or blanks, and passing over further columns. An empty line
 * begins another loop; headings and `#` comments do not count. With semicolons decimal commas are taken.
 */
internal class CsvPointsFormat : DomainFormat("points", "points, one a line", listOf(".csv", ".xy", ".dat")) {
    override fun read(input: DomainText): List<NamedDomain> {
        ReadingMemory.check(input.source, input.text.length, ReadingMemory.POLY * input.text.length)
        val loops = ArrayList<DoubleArray>()
        var points = ArrayList<Double>()
        input.text.lineSequence().forEachIndexed { i, line ->
            val content = line.substringBefore('#')
            if (content.isBlank()) {
                if (line.isBlank() && points.isNotEmpty()) {
                    loops.add(points.toDoubleArray())
                    points = ArrayList()
                }
            } else if (!addPoint(content, points) && (points.isNotEmpty() || isNumber(fields(content)[0]))) {
                throw FileFormatException(input.source, i + 1, 0, "a point must be two numbers, not '${content.trim()}'")
            }
        }
        if (points.isNotEmpty()) loops.add(points.toDoubleArray())
        if (loops.isEmpty()) throw FileFormatException(input.source, 1, 0, "there are no points in it")
        val builder = Domain.builder().regionName(input.baseName)
        for ((i, loop) in loops.withIndex()) builder.loop(RingPoints.withoutRepeatedEnd(loop), GeoJsonReader.ringTag(i))
        return input.single(builder.build())
    }

    private fun addPoint(line: String, points: MutableList<Double>): Boolean {
        val fields = fields(line)
        if (fields.size < 2) return false
        val x = RingPoints.decimal(fields[0])
        val y = RingPoints.decimal(fields[1])
        if (x.isNaN() || y.isNaN()) return false
        points.add(x)
        points.add(y)
        return true
    }

    private fun fields(line: String): List<String> {
        val fields = when {
            ';' in line -> line.split(';').map { it.replace(',', '.') }
            ',' in line -> line.split(',')
            else -> line.trim().split(BLANKS)
        }
        return fields.map { it.trim().removeSurrounding("\"") }
    }

    private fun isNumber(field: String) = !RingPoints.decimal(field).isNaN()

    private companion object {
        val BLANKS = Regex("\\s+")
    }
}
