package org.trigrid.io

import org.trigrid.domain.Domain
import java.io.IOException
import java.nio.file.Path

/** A format of files with domains. */
public abstract class DomainFormat internal constructor(
    name: String,
    title: String,
    endings: List<String>,
    canWrite: Boolean = false,
    /** Whether files hold curves, which a spacing divides; the nodes of other formats are the boundary nodes as they are. */
    @get:JvmName("hasCurves") public val hasCurves: Boolean = false,
) : FileFormat(name, title, endings, canRead = true, canWrite = canWrite) {
    /** Whether a text that begins with the line [first] looks like this format; asked where the file's name says nothing. */
    internal open fun looksLike(first: String): Boolean = false

    /** Whether texts that are no UTF-8 are read as ISO 8859-1, which older programs write. */
    internal open val isOfAnyCharset: Boolean get() = false

    /** @throws org.trigrid.diagnostics.FileFormatException with the place of what is wrong. */
    @Throws(IOException::class)
    internal abstract fun read(input: DomainText): List<NamedDomain>

    /** The text of a file that holds [domains]. */
    internal open fun write(domains: List<NamedDomain>, text: TextBuffer): Unit = throw IllegalArgumentException("$name cannot be written")

    public companion object {
        /** GeoJSON (RFC 7946). */
        @JvmField
        public val GEOJSON: DomainFormat = GeoJsonFormat()

        /** Well-known text of polygons. */
        @JvmField
        public val WKT: DomainFormat = WktFormat()

        /** Triangle's planar straight line graph. */
        @JvmField
        public val POLY: DomainFormat = PolyFormat()

        /** TopoJSON. */
        @JvmField
        public val TOPOJSON: DomainFormat = TopoJsonFormat()

        /** Paths and basic shapes of SVG. */
        @JvmField
        public val SVG: DomainFormat = SvgFormat()

        /** Lines, arcs and splines of AutoCAD's drawing exchange format. */
        @JvmField
        public val DXF: DomainFormat = DxfFormat()

        /** Gmsh's geometry script, in part. */
        @JvmField
        public val GEO: DomainFormat = GeoFormat()

        /** Points of loops, one a line. */
        @JvmField
        public val POINTS: DomainFormat = CsvPointsFormat()
    }
}

/** A text to be read as domains, and how its lines and curves are to be divided. */
internal class DomainText(
    val file: Path,
    val text: String,
    private val division: CurveDivision = CurveDivision.DEFAULT,
    /** Names the text in errors. */
    val source: String = file.toString(),
    /** Names domains that have no name of their own: the file's name up to its first dot. */
    val baseName: String = DomainFormats.baseName(file),
) {
    /** Wanted distance of neighbouring nodes on curves and lines; NaN to keep lines and to divide curves by their bend. */
    val spacing: Double get() = division.spacing

    /** Last spacing / first spacing of each piece; means nothing without [spacing]. */
    val ratio: Double get() = division.ratio

    /** Ends that are no farther from each other are one; NaN for the format's standard. */
    val join: Double get() = division.join

    /** The unit of coordinates wanted, or null for the file's own. */
    val unit: LengthUnit? get() = division.unit

    fun single(domain: Domain): List<NamedDomain> = listOf(NamedDomain(baseName, domain))
}
