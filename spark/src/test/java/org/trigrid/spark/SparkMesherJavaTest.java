package org.trigrid.spark;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.apache.spark.sql.Dataset;
import org.apache.spark.sql.Encoders;
import org.apache.spark.sql.Row;
import org.apache.spark.sql.SparkSession;
import org.junit.jupiter.api.Test;
import org.trigrid.MeshOptions;
import org.trigrid.io.CurveDivision;
import org.trigrid.io.MeshFormat;

/** The program of docs/spark.md. */
class SparkMesherJavaTest {
    @Test
    void meshesOutlines() {
        SparkSession spark = LocalSpark.INSTANCE.session();
        Dataset<Row> outlines = spark.createDataset(List.of("POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))", "POLYGON ((0 0, 1 0, 0 1"), Encoders.STRING())
            .selectExpr("concat('plot ', monotonically_increasing_id()) AS id", "value AS outline");

        TravellingSizeFunction sizes = (x, y) -> 0.05 + 0.1 * x;
        SparkMesher mesher = SparkMesher.builder()
            .options(MeshOptions.builder().sizeFunction(sizes).build())
            .division(CurveDivision.DEFAULT.withSpacing(0.1, 1))
            .format(MeshFormat.VTU)
            .build();
        Dataset<Row> meshes = mesher.mesh(outlines).cache();
        Dataset<Row> failed = meshes.filter("error IS NOT NULL").select("id", "error", "line", "column");
        Row total = meshes.selectExpr("sum(elements)", "min(minAngle)").first();

        assertEquals(1, failed.count());
        assertTrue(total.getLong(0) > 100);
        assertTrue(total.getDouble(1) > 20);
        meshes.unpersist();
    }
}
