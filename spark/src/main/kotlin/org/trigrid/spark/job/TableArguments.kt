package org.trigrid.spark.job

import picocli.CommandLine.Option

/** The options that say where outlines are in a table. */
internal class TableArguments {
    @Option(
        names = ["--table"], paramLabel = "KIND",
        description = [
            "IN are tables with an outline a row, of a kind that Spark reads: csv, parquet, orc or json (a row a line). The meshes go to the " +
                "Parquet table OUT/meshes: as arrays, or with --format as the bytes of files.",
        ],
    )
    var kind: String? = null

    @Option(names = ["--id-column"], paramLabel = "NAME", description = ["With --table: the column of ids. Default: id."])
    var id: String = "id"

    @Option(names = ["--outline-column"], paramLabel = "NAME", description = ["With --table: the column of WKT or GeoJSON. Default: outline."])
    var outline: String = "outline"
}
