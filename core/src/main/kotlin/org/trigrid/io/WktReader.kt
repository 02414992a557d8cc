package org.trigrid.io

import org.locationtech.jts.geom.Geometry
import org.locationtech.jts.geom.GeometryCollection
import org.locationtech.jts.geom.Polygon
import org.locationtech.jts.io.ParseException
import org.locationtech.jts.io.WKTReader
import org.locationtech.jts.util.AssertionFailedException
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.interop.JtsDomains

/**
 * Reads the polygons of well-known text (OGC 06-103r4) as domains: one geometry, over any number of lines, or several.
 *
 * A leading `SRID=n;` is skipped, and so are lines that begin with `#`, points and lines. Tags are "outer", "hole_1", ….
 */
internal class WktReader private constructor(private val text: String, private val source: String) {
    private val polygons = ArrayList<Polygon>()

    private fun read(baseName: String): List<NamedDomain> {
        ReadingMemory.check(source, text.length, ReadingMemory.WKT * text.length)
        var from = 0
        while (true) {
            from = skipBetween(from)
            if (from == text.length) break
            val end = endOfGeometry(from)
            collect(parse(from, end))
            from = end
        }
        if (polygons.isEmpty()) throw FileFormatException(source, 0, 0, "there is no polygon in it")
        return polygons.mapIndexed { i, polygon ->
            val name = if (polygons.size == 1) baseName else "${baseName}_${i + 1}"
            NamedDomain(name, JtsDomains.fromPolygon(polygon, name))
        }
    }

    private fun collect(geometry: Geometry) {
        if (geometry is Polygon && !geometry.isEmpty) polygons.add(geometry)
        if (geometry is GeometryCollection) for (i in 0 until geometry.numGeometries) collect(geometry.getGeometryN(i))
    }

    private fun parse(from: Int, end: Int): Geometry = try {
        WKTReader().read(text.substring(from, end))
    } catch (e: ParseException) {
        throw failure(from, e)
    } catch (e: IllegalArgumentException) {
        throw failure(from, e)
    } catch (e: AssertionFailedException) {
        throw failure(from, e)
    }

    /** JTS counts lines from where it began to read. */
    private fun failure(from: Int, e: Exception): FileFormatException {
        val message = e.message.orEmpty()
        val first = (0 until from).count { text[it] == '\n' } + 1
        val line = LINE.find(message)?.groupValues?.get(1)?.toIntOrNull() ?: 1
        return FileFormatException(source, first + line - 1, 0, message.replace(LINE, "").ifEmpty { "not a WKT geometry" }, e)
    }

    private fun skipBetween(from: Int): Int {
        var at = from
        while (at < text.length) {
            val c = text[at]
            if (c == '#') {
                while (at < text.length && text[at] != '\n') at++
            } else if (text.startsWith("SRID=", at, ignoreCase = true) && text.indexOf(';', at) > 0) {
                at = text.indexOf(';', at) + 1
            } else if (c.isWhitespace() || c == ';') {
                at++
            } else {
                break
            }
        }
        return at
    }

    /** After the bracket that closes the first one, or after EMPTY, or else at the end of the text. */
    private fun endOfGeometry(from: Int): Int {
        var depth = 0
        for (i in from until text.length) {
            when (text[i]) {
                '(' -> if (++depth > MAX_DEPTH) throw TextPlace.exception(source, text, i, "more than $MAX_DEPTH brackets in one another")
                ')' -> if (--depth <= 0) return i + 1
                'Y', 'y' -> if (depth == 0 && text.regionMatches(i - 4, "EMPTY", 0, 5, ignoreCase = true)) return i + 1
            }
        }
        return text.length
    }

    companion object {
        /** The parser goes as deep into its stack as brackets are nested. */
        private const val MAX_DEPTH = 64
        private val LINE = Regex(" *\\(line (\\d+)\\)")

        /**
         * @param source names the text in errors.
         * @param baseName names the domains.
         */
        fun read(text: String, source: String, baseName: String): List<NamedDomain> = WktReader(text, source).read(baseName)
    }
}
