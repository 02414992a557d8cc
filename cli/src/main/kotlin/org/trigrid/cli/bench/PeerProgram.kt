package org.trigrid.cli.bench

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.double
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.trigrid.domain.Domain
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.deleteIfExists
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** Runs the peers with [python], a Python 3 that may have their packages; one process a call. */
internal class PeerProgram(private val python: String, private val limitSeconds: Long) : AutoCloseable {
    private val folder: Path = Files.createTempDirectory("trigrid-peers")
    private val script: Path = folder.resolve("peers.py")
    private val domainFile: Path = folder.resolve("domain.json")

    /** Of those that are installed. */
    val versions: Map<Peer, String>

    init {
        val text = requireNotNull(javaClass.getResource("peers.py")) { "peers.py is not among the resources" }.readText()
        script.writeText(text)
        val found = call("list")
        versions = Peer.entries.filter { found != null && it.id in found }
            .associateWith { found!!.getValue(it.id).jsonPrimitive.content }
    }

    /** [runs] runs of [peer], or null if it fails or takes longer than the limit; [mesh], if given, receives the last mesh. */
    fun run(peer: Peer, domain: Domain, runs: Int, mesh: Path?): PeerRun? {
        domainFile.writeText(toJson(domain))
        val arguments = arrayOf(peer.id, domainFile.toString(), runs.toString()) +
            (if (mesh == null) emptyArray() else arrayOf(mesh.toString()))
        val answer = call(*arguments) ?: return null
        return PeerRun(
            answer.getValue("elements").jsonPrimitive.int,
            answer.getValue("seconds").jsonArray.map { it.jsonPrimitive.double },
            answer.getValue("segmentsMissing").jsonPrimitive.int == 0,
        )
    }

    override fun close() {
        domainFile.deleteIfExists()
        script.deleteIfExists()
        folder.deleteIfExists()
    }

    /** What the script prints last, or null if it does not come to its end. */
    private fun call(vararg arguments: String): JsonObject? {
        val output = folder.resolve("output.txt")
        try {
            val builder = ProcessBuilder(python, script.toString(), *arguments)
                .redirectOutput(output.toFile()).redirectError(ProcessBuilder.Redirect.DISCARD)
            // One thread, as ours.
            for (name in listOf("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS")) builder.environment()[name] = "1"
            val process = builder.start()
            if (!process.waitFor(limitSeconds, TimeUnit.SECONDS)) {
                process.destroyForcibly().waitFor()
                return null
            }
            if (process.exitValue() != 0) return null
            return Json.parseToJsonElement(output.readText().lines().last { it.isNotBlank() }).jsonObject
        } catch (_: IOException) {
            return null
        } finally {
            output.deleteIfExists()
        }
    }

    private fun toJson(domain: Domain): String = (0 until domain.loopCount).joinToString(",", """{"loops":[""", "]}") { loop ->
        domain.loopNodes(loop).joinToString(",", "[", "]") { "${domain.x(it)},${domain.y(it)}" }
    }
}

/** What a peer made and how long each of its runs took, in CPU seconds of the meshing call. */
internal class PeerRun(val elements: Int, val seconds: List<Double>, val keepsBoundary: Boolean)
