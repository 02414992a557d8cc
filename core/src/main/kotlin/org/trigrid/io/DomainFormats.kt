package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path

/**
 * Reads domains whose points are the boundary nodes: GeoJSON, WKT and Triangle's .poly.
 *
 * The reader is chosen by the file's extension (.geojson, .json, .wkt, .poly), else by how its text begins. Every number
 * becomes the double nearest to its decimals; a ring's last point is dropped if it repeats the first, and nothing else is
 * changed: a faulty domain is read as it is, for `DomainCheck` to tell.
 */
public object DomainFormats {
    /**
     * All domains of a file, in its order; at least one.
     *
     * @throws FileFormatException if the text is none of the formats, or breaks the rules of its own; with line and column
     *   as far as they are known.
     * @throws IOException if the file cannot be read.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun read(file: Path): List<NamedDomain> {
        val text = textOf(file)
        return when (formatOf(file, text)) {
            Format.GEOJSON -> GeoJsonReader.read(text, file.toString(), baseName(file))
            Format.WKT -> WktReader.read(text, file.toString(), baseName(file))
            Format.POLY -> PolyReader.read(file, text)
            null -> throw FileFormatException(file.toString(), 0, 0, "neither GeoJSON nor WKT nor a .poly file")
        }
    }

    /** UTF-8, without the byte order mark that some editors put first. */
    @Throws(IOException::class)
    internal fun textOf(file: Path): String = try {
        ReadingMemory.check(file, ReadingMemory.TEXT)
        Files.readString(file).removePrefix("\uFEFF")
    } catch (e: CharacterCodingException) {
        throw FileFormatException(file.toString(), 0, 0, "not a text file in UTF-8", e)
    }

    /** The file's name up to its first dot. */
    internal fun baseName(file: Path): String = file.fileName.toString().substringBefore('.').ifEmpty { "domain" }

    private enum class Format { GEOJSON, WKT, POLY }

    private fun formatOf(file: Path, text: String): Format? {
        val extension = file.fileName.toString().substringAfterLast('.', "").lowercase()
        return when (extension) {
            "geojson", "json" -> Format.GEOJSON
            "wkt" -> Format.WKT
            "poly" -> Format.POLY
            else -> formatOf(text)
        }
    }

    private fun formatOf(text: String): Format? {
        val line = text.lineSequence().map { it.trim() }.firstOrNull { it.isNotEmpty() && !it.startsWith("#") } ?: return null
        return when {
            line.startsWith("{") -> Format.GEOJSON
            line[0].isLetter() -> Format.WKT
            line[0].isDigit() -> Format.POLY
            else -> null
        }
    }
}
