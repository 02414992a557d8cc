package org.trigrid.cli

import java.nio.file.Path
import kotlin.io.path.writeText

/** Small input files for the tests. */
internal object Samples {
    /** The example of the README. */
    val lake: Path = Path.of("..", "src-test-data", "domains", "lake.geojson")

    fun plate(folder: Path): Path =
        file(folder, "plate.wkt", "POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0), (0.5 0.4, 0.5 0.6, 0.7 0.6, 0.7 0.4, 0.5 0.4))\n")

    fun twoSquares(folder: Path): Path =
        file(folder, "two.wkt", "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((3 0, 4 0, 4 1, 3 1, 3 0)))\n")

    /** Its edges (0,0)-(2,2) and (2,0)-(0,2) cross in (1,1). */
    fun bowTie(folder: Path): Path = file(folder, "bowtie.wkt", "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))\n")

    fun file(folder: Path, name: String, text: String): Path = folder.resolve(name).also { it.writeText(text) }
}
