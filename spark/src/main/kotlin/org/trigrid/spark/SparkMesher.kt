package org.trigrid.spark

import org.apache.spark.sql.Dataset
import org.apache.spark.sql.Row
import org.apache.spark.sql.types.StructType
import org.trigrid.MeshOptions
import org.trigrid.io.CurveDivision
import org.trigrid.io.MeshFormat

/**
 * Meshes outlines on the machines of a Spark cluster. Immutable; made by [builder].
 *
 * A dataset of outlines, one a row, becomes a dataset of meshes, one a row for each domain of an outline; [MeshColumns] names the
 * columns of both. An outline that cannot be read, and a domain that cannot be meshed, is a row too, with what is wrong and where.
 * The meshes are those of `MeshGenerator` and do not depend on the cluster, to the last bit.
 *
 * Outlines differ much in the work that they make. So [mesh] runs a first job that reads them and estimates their elements, and
 * deals them out to partitions of about equal work.
 */
public class SparkMesher private constructor(builder: Builder) {
    /** Default [MeshOptions.DEFAULT]. */
    @get:JvmName("options")
    public val options: MeshOptions = builder.options

    /** How the lines and curves of outlines are divided. Default: the points of the outlines are the boundary nodes. */
    @get:JvmName("division")
    public val division: CurveDivision = builder.division

    /** Nodes of an element: 1 for three, 2 for six. Default 1. */
    @get:JvmName("order")
    public val order: Int = builder.order

    /** Whether the meshes' arrays are columns of the result. Default true. */
    @get:JvmName("hasArrays")
    public val hasArrays: Boolean = builder.hasArrays

    /** In which format the bytes of a mesh's file are a column of the result; null for no such column, the default. */
    @get:JvmName("format")
    public val format: MeshFormat? = builder.format

    /**
     * About how many elements a partition of the result holds, unless one domain alone has more; 0 for outlines that stay in the
     * partitions that they are in. Default a million, some seconds of work.
     */
    @get:JvmName("elementsPerPartition")
    public val elementsPerPartition: Long = builder.elementsPerPartition

    /** Columns of the result. */
    public fun schema(): StructType = MeshColumns.schema(hasArrays, format != null)

    /**
     * The meshes of [outlines], which has the columns [MeshColumns.ID] and [MeshColumns.OUTLINE], both strings, and may have
     * [MeshColumns.NAME] and [MeshColumns.FORMAT]; others are left out.
     *
     * The meshes are made when the result is asked for; as with any dataset again each time, unless it is kept or written.
     *
     * @throws IllegalArgumentException if a column is missing or no string.
     */
    public fun mesh(outlines: Dataset<Row>): Dataset<Row> {
        val columns = OutlineColumns.of(outlines.schema())
        val asked = options
        val plan = MeshPlan({ asked }, division, false, order, elementsPerPartition)
        return MeshPipeline(outlines.sparkSession(), plan, ColumnsSink(hasArrays, format?.name))
            .mesh(outlines.toJavaRDD().map(columns))
    }

    /** Collects options; the same builder may build several times. */
    public class Builder internal constructor() {
        internal var options = MeshOptions.DEFAULT
        internal var division = CurveDivision.DEFAULT
        internal var order = 1
        internal var hasArrays = true
        internal var format: MeshFormat? = null
        internal var elementsPerPartition = 1_000_000L

        /** Sets [SparkMesher.options]; a size function must be serializable, see [TravellingSizeFunction]. */
        public fun options(value: MeshOptions): Builder = apply { options = value }

        /** Sets [SparkMesher.division]. */
        public fun division(value: CurveDivision): Builder = apply { division = value }

        /** @throws IllegalArgumentException unless 1 or 2. */
        public fun order(value: Int): Builder = apply {
            require(value in 1..2) { "order must be 1 or 2, not $value" }
            order = value
        }

        /** Sets [SparkMesher.hasArrays]. */
        public fun arrays(value: Boolean): Builder = apply { hasArrays = value }

        /** @throws IllegalArgumentException if a mesh of the format is several files. */
        public fun format(value: MeshFormat?): Builder = apply {
            require(value == null || value.isSingleFile && value.canWrite) { "a mesh of the format ${value?.name} is not one file" }
            format = value
        }

        /** @throws IllegalArgumentException unless >= 0. */
        public fun elementsPerPartition(value: Long): Builder = apply {
            require(value >= 0) { "elementsPerPartition must be at least 0, not $value" }
            elementsPerPartition = value
        }

        /** @throws IllegalArgumentException if [SparkMesher.format] has no elements of the [SparkMesher.order]. */
        public fun build(): SparkMesher {
            val highest = format?.highestOrder ?: order
            require(order <= highest) { "${format?.name} has no elements of six nodes" }
            return SparkMesher(this)
        }
    }

    public companion object {
        /** Starts from the defaults. */
        @JvmStatic
        public fun builder(): Builder = Builder()
    }
}
