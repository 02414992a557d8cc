package org.trigrid.cli

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonObject
import org.trigrid.diagnostics.Stage
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.numbering.Numbering
import org.trigrid.quality.QualityReport
import java.nio.file.Path

/** The report of `trigrid mesh`; its keys are documented in `docs/cli.md`. */
internal object ReportJson {
    private val json = Json { prettyPrint = true }

    /** One object for one mesh, an array of objects for several. */
    fun text(figures: List<MeshFigures>): String {
        val root = figures.singleOrNull()?.let { of(it) } ?: JsonArray(figures.map { of(it) })
        return json.encodeToString(JsonElement.serializer(), root) + "\n"
    }

    /**
     * One object on one line, for a mesh of a batch.
     *
     * @param fingerprint of all that it is made of.
     * @param written when its file was, in milliseconds since 1970.
     */
    fun line(input: Path, output: Path, fingerprint: String, written: Long, figures: MeshFigures): String {
        val head = buildJsonObject {
            put("file", input.toString())
            put("status", "done")
            put("output", output.toString())
            put("fingerprint", fingerprint)
            put("written", written)
        }
        return JsonObject(head + of(figures)).toString()
    }

    /** One object on one line, for a file or a domain of a batch that has no mesh. */
    fun failure(input: Path, name: String?, code: Int, error: String): String = buildJsonObject {
        put("file", input.toString())
        put("status", "failed")
        if (name != null) put("name", name)
        put("code", code)
        put("error", error)
    }.toString()

    private fun of(figures: MeshFigures): JsonObject = buildJsonObject {
        val report = figures.report
        put("name", figures.name)
        put("nodes", report.nodeCount)
        put("elements", report.elementCount)
        put("boundaryNodes", report.boundaryNodeCount)
        put("loops", report.loopCount)
        put("expectedElements", figure(report.expectedElements))
        put("fallbacks", report.fallbacks)
        put("quality", quality(report.quality))
        put("degree6", figure(report.quality.degree6))
        putJsonObject("bandwidth") {
            put("before", report.numberingBefore.bandwidth)
            put("after", report.numberingAfter.bandwidth)
        }
        putJsonObject("profile") {
            put("before", report.numberingBefore.profile)
            put("after", report.numberingAfter.profile)
        }
        figures.quadratic?.let { put("secondOrder", secondOrder(it)) }
        put("seconds", seconds(figures))
    }

    private fun secondOrder(mesh: QuadraticMesh): JsonObject = buildJsonObject {
        val numbering = Numbering.metrics(mesh)
        put("nodes", mesh.nodeCount)
        put("bandwidth", numbering.bandwidth)
        put("profile", numbering.profile)
        put("straightenedEdges", mesh.straightenedEdgeCount)
    }

    private fun quality(quality: QualityReport): JsonObject = buildJsonObject {
        put("min", figure(quality.minQuality))
        put("mean", figure(quality.meanQuality))
        put("p05", figure(quality.quality05))
        put("minAngle", figure(quality.minAngle))
        put("meanMinAngle", figure(quality.meanMinAngle))
        put("maxAngle", figure(quality.maxAngle))
        put("histogram", JsonArray(quality.qualityHistogram().map { JsonPrimitive(it) }))
    }

    private fun seconds(figures: MeshFigures): JsonObject = buildJsonObject {
        val report = figures.report
        put("read", figures.clock.readSeconds)
        put("check", report.seconds(Stage.CHECK))
        put("sizes", report.seconds(Stage.SIZES))
        put("front", report.seconds(Stage.FRONT))
        put("improve", report.seconds(Stage.IMPROVE))
        put("renumber", report.seconds(Stage.RENUMBER))
        if (figures.quadratic != null) put("secondOrder", figures.clock.orderSeconds)
        put("write", figures.clock.writeSeconds)
        put("total", figures.clock.totalSeconds)
    }

    /** JSON knows no NaN; a figure that a mesh does not have is null. */
    private fun figure(value: Double): JsonPrimitive = if (value.isFinite()) JsonPrimitive(value) else JsonNull
}
