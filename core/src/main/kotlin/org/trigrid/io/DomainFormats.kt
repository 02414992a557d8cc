package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.charset.CharacterCodingException
import java.nio.charset.Charset
import java.nio.file.Files
import java.nio.file.Path

/**
 * Domains to and from files.
 *
 * The format is chosen by the ending of the file's name, else by how its text begins. Every number becomes the double
 * nearest to its decimals; a ring's last point is dropped if it repeats the first, and nothing else is changed: a faulty
 * domain is read as it is, for `DomainCheck` to tell.
 */
public object DomainFormats {
    private val ALL: List<DomainFormat> = java.util.List.of(
        DomainFormat.GEOJSON, DomainFormat.WKT, DomainFormat.POLY, DomainFormat.TOPOJSON, DomainFormat.SVG, DomainFormat.DXF,
        DomainFormat.GEO, DomainFormat.POINTS,
    )

    /** All formats; of those that share an ending, the usual one first. */
    @JvmStatic
    public fun all(): List<DomainFormat> = ALL

    /** The format of a short name, such as `geojson`, in any case; null if there is none. */
    @JvmStatic
    public fun named(name: String): DomainFormat? = ALL.firstOrNull { it.name.equals(name, ignoreCase = true) }

    /** The format of a file of this name, by its ending; null if that says nothing. */
    @JvmStatic
    public fun forFile(file: Path): DomainFormat? = ALL.firstOrNull { it.fits(file) }

    /**
     * All domains of a file, in its order; at least one. The points of polygons are the boundary nodes; curves are divided
     * so that no part bends by more than ten degrees.
     *
     * @throws FileFormatException if the text is none of the formats, or breaks the rules of its own; with line and column
     *   as far as they are known.
     * @throws IOException if the file cannot be read.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun read(file: Path): List<NamedDomain> = read(file, CurveDivision.DEFAULT)

    /**
     * As the other, with lines and curves divided as [division] says.
     *
     * @throws org.trigrid.diagnostics.InvalidShapeException if something cannot be divided like that.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun read(file: Path, division: CurveDivision): List<NamedDomain> {
        val named = forFile(file)
        val text = textOf(file, named?.isOfAnyCharset == true)
        val format = named ?: formatOf(text) ?: throw unknown(file.toString())
        return divided(format, DomainText(file, text, division))
    }

    /**
     * All domains of a text that is not in a file, such as a column of a table; otherwise as [read].
     *
     * @param name names the text in errors, and domains that have no name of their own.
     * @param format of the text, or null to tell it by how the text begins.
     * @throws FileFormatException as [read] does.
     * @throws org.trigrid.diagnostics.InvalidShapeException as [read] does.
     * @throws IOException if the text asks for a file beside it, as `.poly` may, which a text does not have.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun parse(text: String, name: String, format: DomainFormat?, division: CurveDivision): List<NamedDomain> {
        val known = format ?: formatOf(text) ?: throw unknown(name)
        return divided(known, DomainText(Path.of("text" + known.endings[0]), text.removePrefix(BYTE_ORDER_MARK), division, name, name))
    }

    /** As the other, of the bytes of a file that is not at hand as one, such as one of an archive or of a cluster. */
    @JvmStatic
    @Throws(IOException::class)
    public fun parse(bytes: ByteArray, name: String, format: DomainFormat?, division: CurveDivision): List<NamedDomain> =
        parse(decoded(name, format?.isOfAnyCharset == true) { decode(bytes, it) }, name, format, division)

    private fun divided(format: DomainFormat, input: DomainText): List<NamedDomain> {
        val domains = format.read(input)
        if (format.hasCurves || input.spacing.isNaN()) return domains
        return domains.map { NamedDomain(it.name, it.domain.respaced(input.spacing, input.ratio)) }
    }

    private fun unknown(source: String) = FileFormatException(source, 0, 0, "this is none of the formats that are known")

    /**
     * Writes domains to one file; it is written beside its place and moved over it.
     *
     * @throws IllegalArgumentException if the format cannot be written, or cannot hold these domains.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(domains: List<NamedDomain>, file: Path, format: DomainFormat) {
        AtomicFile.write(file) { out ->
            val text = TextBuffer(out)
            format.write(domains, text)
            text.flush()
        }
    }

    /** UTF-8, without the byte order mark that some editors put first. */
    @Throws(IOException::class)
    internal fun textOf(file: Path): String = textOf(file, false)

    @Throws(IOException::class)
    private fun textOf(file: Path, isOfAnyCharset: Boolean): String {
        ReadingMemory.check(file, ReadingMemory.TEXT)
        return decoded(file.toString(), isOfAnyCharset) { Files.readString(file, it) }.removePrefix(BYTE_ORDER_MARK)
    }

    private fun decoded(source: String, isOfAnyCharset: Boolean, read: (Charset) -> String): String = try {
        read(Charsets.UTF_8)
    } catch (e: CharacterCodingException) {
        if (isOfAnyCharset) read(Charsets.ISO_8859_1) else throw FileFormatException(source, 0, 0, "not a text file in UTF-8", e)
    }

    /** Refuses what is no text of the [charset]. */
    private fun decode(bytes: ByteArray, charset: Charset): String = charset.newDecoder().decode(ByteBuffer.wrap(bytes)).toString()

    /** The file's name up to its first dot. */
    internal fun baseName(file: Path): String = file.fileName.toString().substringBefore('.').ifEmpty { "domain" }

    private fun formatOf(text: String): DomainFormat? {
        val line = text.lineSequence().map { it.trim() }.firstOrNull { it.isNotEmpty() && !it.startsWith("#") } ?: return null
        return ALL.firstOrNull { it.looksLike(line) }
    }

    private const val BYTE_ORDER_MARK = "\uFEFF"
}
