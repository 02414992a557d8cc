package org.trigrid.cli.batch

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.longOrNull
import org.trigrid.io.MeshFormat
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.isRegularFile

/** The meshes that earlier runs have made, as their report tells. */
internal class MadeMeshes private constructor(private val lines: Map<Path, Made>) {
    private class Made(val fingerprint: String, val written: Long)

    /** Whether the mesh [output] is there as it was made, of what [fingerprint] says. */
    fun has(output: Path, format: MeshFormat, fingerprint: String): Boolean {
        val made = lines[place(output)] ?: return false
        return made.fingerprint == fingerprint && made.written == writtenAt(output, format)
    }

    companion object {
        val NONE = MadeMeshes(emptyMap())

        /** What the report [file] tells, its last line of a mesh before those above; lines that are damaged tell nothing. */
        @Throws(IOException::class)
        fun of(file: Path): MadeMeshes {
            if (!file.isRegularFile()) return NONE
            val lines = HashMap<Path, Made>()
            Files.newBufferedReader(file).useLines { all -> for (line in all) read(line)?.let { (output, made) -> lines[output] = made } }
            return MadeMeshes(lines)
        }

        private fun read(line: String): Pair<Path, Made>? {
            val json = runCatching { Json.parseToJsonElement(line) as? JsonObject }.getOrNull() ?: return null
            val output = text(json, "output") ?: return null
            val fingerprint = text(json, "fingerprint") ?: return null
            val written = (json["written"] as? JsonPrimitive)?.longOrNull ?: return null
            return place(Path.of(output)) to Made(fingerprint, written)
        }

        private fun text(json: JsonObject, key: String) = (json[key] as? JsonPrimitive)?.takeIf { it.isString }?.content

        private fun place(output: Path): Path = output.toAbsolutePath().normalize()

        /** When the last of a mesh's files was changed, in milliseconds since 1970; -1 if one is missing. */
        fun writtenAt(output: Path, format: MeshFormat): Long {
            val files = format.filesOf(output)
            if (files.any { !it.isRegularFile() }) return -1
            return files.maxOf { Files.getLastModifiedTime(it).toMillis() }
        }
    }
}
