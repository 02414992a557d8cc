package org.trigrid.spark.job

import org.apache.spark.api.java.JavaRDD
import org.apache.spark.api.java.JavaSparkContext
import org.apache.spark.sql.SaveMode
import org.apache.spark.sql.SparkSession
import org.apache.spark.sql.functions
import org.apache.spark.util.SerializableConfiguration
import org.trigrid.MeshOptions
import org.trigrid.cli.ExitCodes
import org.trigrid.cli.ExplodingArguments
import org.trigrid.cli.MeshOutput
import org.trigrid.cli.MeshingArguments
import org.trigrid.cli.OrderArguments
import org.trigrid.io.MeshFormat
import org.trigrid.spark.MeshColumns
import org.trigrid.spark.MeshPipeline
import org.trigrid.spark.MeshPlan
import org.trigrid.spark.Outline
import org.trigrid.spark.OutlineError
import picocli.CommandLine
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Spec
import java.io.IOException
import java.io.PrintStream
import java.io.PrintWriter
import java.util.concurrent.Callable

/** Meshes files of outlines on a cluster, as `trigrid mesh --out-dir` does on one machine. */
@Command(
    name = "trigrid-spark-job.jar",
    description = ["Mesh the files of folders on a Spark cluster, one file a mesh, with a report."],
    mixinStandardHelpOptions = true,
    sortOptions = false,
    footer = [
        "",
        "Examples:",
        "  spark-submit --master yarn trigrid-spark-job.jar --in hdfs:///outlines --out hdfs:///meshes --format vtu",
        "  spark-submit trigrid-spark-job.jar --in parcels.parquet --table parquet --outline-column wkt --out meshes",
        "",
        "Files are named as by 'trigrid mesh --out-dir' and hold the same bytes. OUT/report has one JSON object a line for each mesh",
        "and each failure. The exit code is 0 when the job has run, whatever it met; with --strict that of the command line.",
    ],
)
internal class JobCommand private constructor(private val out: PrintStream, private val session: () -> SparkSession) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Option(
        names = ["--in"], paramLabel = "IN", required = true, arity = "1..*",
        description = ["Files, folders and patterns, on any file system of Hadoop: GeoJSON, WKT, TopoJSON, points as CSV, SVG, DXF, projects, ..."],
    )
    lateinit var inputs: List<String>

    @Option(names = ["--out"], paramLabel = "OUT", required = true, description = ["The folder of the meshes and of the report."])
    lateinit var output: String

    @Option(names = ["--format"], paramLabel = "NAME", description = ["Of the meshes, one of those of 'trigrid convert --list'. Default: msh22."])
    var format: String? = null

    @Option(
        names = ["--elements-per-task"], paramLabel = "N",
        description = ["Elements that one task of Spark makes, about, > 0. Default: 1000000."],
    )
    var elementsPerTask: Long = 1_000_000

    @Option(names = ["--strict"], description = ["Exit with 1, 3 or 4 if an outline could not be meshed."])
    var isStrict: Boolean = false

    @Mixin
    lateinit var table: TableArguments

    @Mixin
    lateinit var exploding: ExplodingArguments

    @Mixin
    lateinit var ordering: OrderArguments

    @Mixin
    lateinit var meshing: MeshingArguments

    override fun call(): Int {
        val inputOptions = exploding.toOptions(spec.commandLine())
        meshing.over(MeshOptions.DEFAULT, spec.commandLine())
        val meshFormat = meshFormat()
        if (elementsPerTask <= 0) throw ParameterException(spec.commandLine(), "--elements-per-task must be above 0, not $elementsPerTask")
        val arguments = meshing
        val plan = MeshPlan(
            { arguments.over(it) }, inputOptions.division, inputOptions.keepConnectors, ordering.order, elementsPerTask,
        )
        val spark = session()
        return try {
            run(spark, plan, meshFormat)
        } finally {
            spark.stop()
        }
    }

    private fun meshFormat(): MeshFormat {
        val found = MeshOutput.format(format, null, spec.commandLine())
        if (!found.isSingleFile || !found.canWrite) {
            throw ParameterException(spec.commandLine(), "--format ${found.name} is several files; choose one that is a single file")
        }
        ordering.check(found, spec.commandLine())
        return found
    }

    private fun run(spark: SparkSession, plan: MeshPlan, meshFormat: MeshFormat): Int {
        val root = output.trimEnd('/')
        val report = "$root/$REPORT"
        val count = try {
            if (table.kind == null) meshFiles(spark, plan, meshFormat, report)
            else TableJob(spark, plan, table).run(inputs, meshFormat.takeIf { format != null }, "$root/$MESHES", report)
        } catch (error: IllegalArgumentException) {
            throw ParameterException(spec.commandLine(), error.message)
        }
        return summary(spark, report, "$count " + if (table.kind == null) "files" else "outlines")
    }

    /** @return how many files there are. */
    private fun meshFiles(spark: SparkSession, plan: MeshPlan, format: MeshFormat, report: String): Int {
        val context = JavaSparkContext.fromSparkContext(spark.sparkContext())
        val files = JobFiles(context.hadoopConfiguration()).of(inputs)
        val configuration = context.broadcast(SerializableConfiguration(context.hadoopConfiguration()))
        val outlines: JavaRDD<Outline> = context.parallelize(files, slices(files, context.defaultParallelism())).map(FileReading(configuration))
        MeshPipeline(spark, plan, FilesSink(output, format.name, configuration)).mesh(outlines)
            .write().mode(SaveMode.Overwrite).json(report)
        return files.size
    }

    /** Small files many a task, large ones few. */
    private fun slices(files: List<JobFile>, cores: Int): Int {
        val bySize = files.sumOf { it.size + FILE_COST } / BYTES_PER_SLICE
        return bySize.coerceAtLeast(SLICES_PER_CORE * cores.toLong()).coerceAtMost(files.size.toLong()).coerceAtLeast(1).toInt()
    }

    private fun summary(spark: SparkSession, report: String, inputs: String): Int {
        val rows = spark.read().schema(REPORT_SCHEMA).json(report)
        val meshed = rows.filter(functions.col(MeshColumns.ERROR).isNull)
            .agg(functions.count("*"), functions.coalesce(functions.sum(MeshColumns.ELEMENTS), functions.lit(0L))).first()
        val failures = rows.filter(functions.col(MeshColumns.ERROR).isNotNull).groupBy(MeshColumns.ERROR_KIND).count().collectAsList()
        val failed = failures.sumOf { it.getLong(1) }
        out.println("$output: ${meshed.getLong(0)} meshes of $inputs, ${meshed.getLong(1)} elements, $failed failed")
        val codes = failures.map { codeOf(OutlineError.valueOf(it.getString(0))) }
        return if (isStrict) SEVERITY.firstOrNull { it in codes } ?: ExitCodes.DONE else ExitCodes.DONE
    }

    private fun codeOf(error: OutlineError): Int = when (error) {
        OutlineError.FILE, OutlineError.FORMAT -> ExitCodes.FILE_TROUBLE
        OutlineError.DOMAIN, OutlineError.SHAPE, OutlineError.TOO_LARGE -> ExitCodes.INVALID_DOMAIN
        OutlineError.SIZE, OutlineError.DEFECT -> ExitCodes.DEFECT
    }

    companion object {
        private const val REPORT = "report"
        private const val MESHES = "meshes"
        private const val FILE_COST = 1L shl 20
        private const val BYTES_PER_SLICE = 1L shl 26
        private const val SLICES_PER_CORE = 3
        private val SEVERITY = listOf(ExitCodes.DEFECT, ExitCodes.FILE_TROUBLE, ExitCodes.INVALID_DOMAIN)
        private const val REPORT_SCHEMA = "${MeshColumns.ERROR} STRING, ${MeshColumns.ERROR_KIND} STRING, ${MeshColumns.ELEMENTS} INT"

        fun commandLine(out: PrintStream, err: PrintStream, session: () -> SparkSession): CommandLine =
            CommandLine(JobCommand(out, session))
                .setCaseInsensitiveEnumValuesAllowed(true)
                .setOut(PrintWriter(out, true))
                .setErr(PrintWriter(err, true))
                .setColorScheme(CommandLine.Help.defaultColorScheme(CommandLine.Help.Ansi.OFF))
                .setParameterExceptionHandler { error, _ -> usage(error, err) }
                .setExecutionExceptionHandler { error, _, _ ->
                    when (error) {
                        is ParameterException -> usage(error, err)
                        is IOException -> ExitCodes.FILE_TROUBLE.also { err.println(error.message ?: error.toString()) }
                        else -> ExitCodes.DEFECT.also { error.printStackTrace(err) }
                    }
                }

        private fun usage(error: ParameterException, err: PrintStream): Int {
            err.println("trigrid-spark-job: ${error.message}")
            err.println("Try --help.")
            return ExitCodes.USAGE
        }
    }
}
