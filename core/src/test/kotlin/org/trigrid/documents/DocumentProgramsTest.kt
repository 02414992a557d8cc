package org.trigrid.documents

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.extension
import kotlin.io.path.readLines
import kotlin.io.path.readText

/** Every Java and Kotlin program in the documents stands, line by line, in a source that is compiled and run by a test. */
class DocumentProgramsTest {
    private val root = Path.of("..")

    @Test
    fun `every program in the documents is compiled and run`() {
        val programs = documents().flatMap { programs(it) }
        assertTrue(programs.any { it.language == "java" } && programs.any { it.language == "kotlin" })
        val sources = listOf("core/src/test", "samples", "spark/src/test").map { root.resolve(it) }.filter { it.exists() }.flatMap { files(it, "java", "kt") }
        val lines = sources.associateWith { it.readLines() }
        val strangers = programs.filter { program ->
            lines.none { (file, text) -> (file.extension == "java") == (program.language == "java") && program.isIn(text) }
        }
        assertEquals(emptyList<String>(), strangers.map { "${it.document}:\n${it.lines.joinToString("\n")}" })
    }

    private class Program(val document: Path, val language: String, val lines: List<String>) {
        /** Whether the lines stand in [source] one after the other, all indented by as much more. */
        fun isIn(source: List<String>): Boolean = (0..source.size - lines.size).any { at ->
            source[at].endsWith(lines[0]) && source[at].removeSuffix(lines[0]).let { indent ->
                indent.isBlank() && lines.indices.all { source[at + it] == if (lines[it].isEmpty()) "" else indent + lines[it] }
            }
        }
    }

    private fun programs(document: Path): List<Program> =
        Regex("""(?s)```(java|kotlin)\n(.*?)\n```""").findAll(document.readText())
            .map { Program(document, it.groupValues[1], it.groupValues[2].lines()) }.toList()

    private fun documents(): List<Path> = listOf(root.resolve("README.md")) + files(root.resolve("docs"), "md")

    private fun files(folder: Path, vararg extensions: String): List<Path> =
        Files.walk(folder).use { found -> found.filter { it.extension in extensions }.sorted().toList() }
}
