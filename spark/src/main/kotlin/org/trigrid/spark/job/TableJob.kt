package org.trigrid.spark.job

import org.apache.spark.sql.Dataset
import org.apache.spark.sql.Row
import org.apache.spark.sql.SaveMode
import org.apache.spark.sql.SparkSession
import org.apache.spark.sql.functions.col
import org.trigrid.io.MeshFormat
import org.trigrid.spark.ColumnsSink
import org.trigrid.spark.MeshColumns
import org.trigrid.spark.MeshPipeline
import org.trigrid.spark.MeshPlan
import org.trigrid.spark.OutlineColumns

/** Meshes the outlines of tables into one: for more outlines than a file system likes to have files. */
internal class TableJob(private val spark: SparkSession, private val plan: MeshPlan, private val table: TableArguments) {
    /**
     * Writes the meshes, with their arrays or with the bytes of their files in a [format], and their report without them.
     *
     * @return how many outlines there are.
     * @throws IllegalArgumentException if there are no such columns.
     */
    fun run(inputs: List<String>, format: MeshFormat?, meshes: String, report: String): Long {
        val outlines = outlines(inputs)
        val columns = OutlineColumns.of(outlines.schema())
        MeshPipeline(spark, plan, ColumnsSink(format == null, format?.name)).mesh(outlines.toJavaRDD().map(columns))
            .write().mode(SaveMode.Overwrite).parquet(meshes)
        val heavy = (MeshColumns.ARRAYS + MeshColumns.FILE_BYTES).map { it.name() }.toTypedArray()
        spark.read().parquet(meshes).drop(*heavy).write().mode(SaveMode.Overwrite).json(report)
        return outlines.count()
    }

    private fun outlines(inputs: List<String>): Dataset<Row> {
        val read = spark.read().format(requireNotNull(table.kind))
            // Of CSV: names in the first line, quotes doubled in quoted texts, which may have several lines. JSON would be one value then.
            .option("header", true).option("multiLine", table.kind.equals("csv", ignoreCase = true)).option("escape", "\"")
            .load(*inputs.toTypedArray())
        for (column in listOf(table.id, table.outline)) {
            require(column in read.columns()) { "the table has no column $column; it has ${read.columns().joinToString()}" }
        }
        return read.select(
            col(quoted(table.id)).cast("string").alias(MeshColumns.ID), col(quoted(table.outline)).cast("string").alias(MeshColumns.OUTLINE),
        )
    }

    private fun quoted(column: String) = "`" + column.replace("`", "``") + "`"
}
