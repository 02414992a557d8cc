package org.trigrid.spark

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledOnOs
import org.junit.jupiter.api.condition.OS
import org.junit.jupiter.api.io.TempDir
import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import java.nio.file.Files
import java.nio.file.Path

/** The Kotlin program of docs/spark.md. */
class KotlinProgramTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisabledOnOs(OS.WINDOWS)
    fun `from a table of parcels to Parquet`() {
        val spark = LocalSpark.session()
        val parcels = folder.resolve("parcels").toString()
        val output = folder.resolve("meshes").toString()
        LocalSpark.outlines("a" to "POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))", "b" to "POLYGON ((0 0, 1 0, 0 1, 0 0))")
            .selectExpr("id AS parcel", "outline AS wkt").write().parquet(parcels)
        // docs/spark.md
        val outlines = spark.read().parquet(parcels).selectExpr("parcel AS id", "wkt AS outline")
        val mesher = SparkMesher.builder().arrays(false).format(MeshFormat.MSH_41_BINARY).build()
        mesher.mesh(outlines).write().parquet(output)
        // end
        val rows = spark.read().parquet(output).orderBy("id").collectAsList()
        assertEquals(2, rows.size)
        for (row in rows) {
            val file = Files.write(folder.resolve("mesh.msh"), row.getAs<ByteArray>("file"))
            assertEquals(row.getAs<Int>("elements"), MeshFormats.read(file).elementCount)
        }
    }
}
