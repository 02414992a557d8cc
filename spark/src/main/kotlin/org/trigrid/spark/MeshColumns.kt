package org.trigrid.spark

import org.apache.spark.sql.types.DataType
import org.apache.spark.sql.types.DataTypes
import org.apache.spark.sql.types.StructField
import org.apache.spark.sql.types.StructType

/**
 * The columns of outlines and of meshes. A mesh's row has either its figures or an error; the columns of the other are null.
 * `docs/spark.md` tells each with its unit.
 */
public object MeshColumns {
    /** Of an outline, a string that is the caller's own; stands in the rows of its meshes too. */
    public const val ID: String = "id"

    /** Of an outline: its text, GeoJSON, WKT or another of `DomainFormats`. */
    public const val OUTLINE: String = "outline"

    /** Of an outline: the name of domains that the text gives none, default the id; of a mesh: its domain's name. */
    public const val NAME: String = "name"

    /** Of an outline: short name of its format, such as `wkt`; null to tell it by the text. */
    public const val FORMAT: String = "format"

    /** Which domain of its outline, from 0; -1 if the outline cannot be read. */
    public const val DOMAIN: String = "domain"

    /** How many domains the outline has; 0 if it cannot be read. */
    public const val DOMAINS: String = "domains"

    /** What is wrong, in a line or more; null for a mesh. */
    public const val ERROR: String = "error"

    /** Name of an [OutlineError]; null for a mesh. */
    public const val ERROR_KIND: String = "errorKind"

    /** 1-based line of the error in the outline's text, null where it is not known. */
    public const val LINE: String = "line"

    /** 1-based column of the error in the outline's text, null where it is not known. */
    public const val COLUMN: String = "column"

    /** All faults of a domain: an array of `kind`, `message`, `x`, `y` and the array `nodes`. */
    public const val FAULTS: String = "faults"

    /** Of the mesh, those in the middles of edges counted. */
    public const val NODES: String = "nodes"

    /** Of the mesh. */
    public const val ELEMENTS: String = "elements"

    /** x0, y0, x1, y1, …: an array of doubles. */
    public const val COORDINATES: String = "coordinates"

    /** Three nodes an element, six at order 2, anticlockwise, from 0: an array of ints. */
    public const val ELEMENT_NODES: String = "elementNodes"

    /** Two nodes a tagged edge, at order 2 its middle as the third; those of the boundary, with the domain on the left, first. */
    public const val EDGE_NODES: String = "edgeNodes"

    /** For each tagged edge its place in [TAGS]: an array of ints. */
    public const val EDGE_TAGS: String = "edgeTags"

    /** How many of the tagged edges are on the boundary; those after them are inside. */
    public const val BOUNDARY_EDGES: String = "boundaryEdges"

    /** Names of the groups of edges and points: an array of strings. */
    public const val TAGS: String = "tags"

    /** For each element its place in [REGIONS]: an array of ints. */
    public const val ELEMENT_REGIONS: String = "elementRegions"

    /** Names of the regions: an array of strings. */
    public const val REGIONS: String = "regions"

    /** Numbers of the regions' materials, 0 for none: an array of ints. */
    public const val MATERIALS: String = "materials"

    /** The nodes at points that were given to be nodes: an array of ints. */
    public const val POINT_NODES: String = "pointNodes"

    /** For each of these points its place in [TAGS]: an array of ints. */
    public const val POINT_TAGS: String = "pointTags"

    /** The bytes of the mesh's file. */
    public const val FILE: String = "file"

    internal const val BOUNDARY_NODES = "boundaryNodes"
    internal const val LOOPS = "loops"
    internal const val EXPECTED_ELEMENTS = "expectedElements"
    internal const val FALLBACKS = "fallbacks"
    internal const val MIN_QUALITY = "minQuality"
    internal const val MEAN_QUALITY = "meanQuality"
    internal const val MIN_ANGLE = "minAngle"
    internal const val MEAN_MIN_ANGLE = "meanMinAngle"
    internal const val MAX_ANGLE = "maxAngle"
    internal const val DEGREE_6 = "degree6"
    internal const val BANDWIDTH = "bandwidth"
    internal const val PROFILE = "profile"
    internal const val STRAIGHTENED_EDGES = "straightenedEdges"
    internal const val SECONDS = "seconds"

    /** Columns of every dataset of meshes. */
    internal val FIGURES: List<StructField> = listOf(
        field(ID, DataTypes.StringType), field(DOMAIN, DataTypes.IntegerType), field(DOMAINS, DataTypes.IntegerType),
        field(NAME, DataTypes.StringType), field(ERROR, DataTypes.StringType), field(ERROR_KIND, DataTypes.StringType),
        field(LINE, DataTypes.IntegerType), field(COLUMN, DataTypes.IntegerType), field(FAULTS, arrayOf(FaultRows.TYPE)),
        field(NODES, DataTypes.IntegerType), field(ELEMENTS, DataTypes.IntegerType), field(BOUNDARY_NODES, DataTypes.IntegerType),
        field(LOOPS, DataTypes.IntegerType), field(EXPECTED_ELEMENTS, DataTypes.DoubleType), field(FALLBACKS, DataTypes.IntegerType),
        field(MIN_QUALITY, DataTypes.DoubleType), field(MEAN_QUALITY, DataTypes.DoubleType), field(MIN_ANGLE, DataTypes.DoubleType),
        field(MEAN_MIN_ANGLE, DataTypes.DoubleType), field(MAX_ANGLE, DataTypes.DoubleType), field(DEGREE_6, DataTypes.DoubleType),
        field(BANDWIDTH, DataTypes.IntegerType), field(PROFILE, DataTypes.LongType), field(STRAIGHTENED_EDGES, DataTypes.IntegerType),
        field(SECONDS, DataTypes.DoubleType),
    )

    internal val ARRAYS: List<StructField> = listOf(
        field(COORDINATES, arrayOf(DataTypes.DoubleType)), field(ELEMENT_NODES, arrayOf(DataTypes.IntegerType)),
        field(EDGE_NODES, arrayOf(DataTypes.IntegerType)), field(EDGE_TAGS, arrayOf(DataTypes.IntegerType)),
        field(BOUNDARY_EDGES, DataTypes.IntegerType), field(TAGS, arrayOf(DataTypes.StringType)),
        field(ELEMENT_REGIONS, arrayOf(DataTypes.IntegerType)), field(REGIONS, arrayOf(DataTypes.StringType)),
        field(MATERIALS, arrayOf(DataTypes.IntegerType)), field(POINT_NODES, arrayOf(DataTypes.IntegerType)),
        field(POINT_TAGS, arrayOf(DataTypes.IntegerType)),
    )

    internal val FILE_BYTES: StructField = field(FILE, DataTypes.BinaryType)

    /** Of a dataset of meshes, with the meshes' arrays and the bytes of their files or without. */
    @JvmStatic
    public fun schema(hasArrays: Boolean, hasFile: Boolean): StructType =
        DataTypes.createStructType(FIGURES + ColumnsSink.columns(hasArrays, hasFile))

    internal fun field(name: String, type: DataType): StructField = DataTypes.createStructField(name, type, true)

    private fun arrayOf(type: DataType) = DataTypes.createArrayType(type, false)
}
