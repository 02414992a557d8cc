package org.trigrid.spark

import org.apache.spark.sql.Dataset
import org.apache.spark.sql.Row
import org.apache.spark.sql.RowFactory
import org.apache.spark.sql.SparkSession
import org.apache.spark.sql.types.DataTypes
import org.apache.spark.sql.types.StructType
import java.nio.file.Path

/** Spark in this process, with two tasks at a time. */
internal object LocalSpark {
    fun session(): SparkSession = SparkSession.builder().master("local[2]").appName("test")
        .config("spark.ui.enabled", false)
        .config("spark.driver.bindAddress", "127.0.0.1")
        .config("spark.driver.host", "127.0.0.1")
        .getOrCreate()

    /** The file of the countries of the world, from the npm package world-atlas. */
    val world: Path = Path.of("..", "src-test-data", "world", "countries-110m.json")

    /** Outlines by their ids and texts. */
    fun outlines(vararg outlines: Pair<String, String?>): Dataset<Row> =
        session().createDataFrame(outlines.map { RowFactory.create(it.first, it.second) }, schema("id", "outline"))

    fun schema(vararg columns: String): StructType =
        DataTypes.createStructType(columns.map { DataTypes.createStructField(it, DataTypes.StringType, true) })
}
