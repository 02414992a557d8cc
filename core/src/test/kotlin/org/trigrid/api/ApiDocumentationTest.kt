package org.trigrid.api

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.readLines

/** Every public declaration of the library says what it is, unless its name alone does. */
class ApiDocumentationTest {
    @Test
    fun `public declarations are documented`() {
        val files = Files.walk(sources).use { paths -> paths.filter { it.extension == "kt" }.sorted().toList() }
        val bare = files.flatMap { file ->
            val lines = file.readLines()
            lines.indices.filter { isPublic(lines[it]) && !isDocumented(lines, it) }
                .map { "${sources.relativize(file)}:${it + 1}: ${lines[it].trim()}" }
        }
        assertEquals(emptyList<String>(), bare)
    }

    private fun isPublic(line: String): Boolean =
        line.trimStart().startsWith("public ") && "override " !in line && OBVIOUS.none { it.containsMatchIn(line) }

    private fun isDocumented(lines: List<String>, declaration: Int): Boolean {
        val above = lines.subList(0, declaration).lastOrNull { !it.trimStart().startsWith("@") } ?: return false
        return above.endsWith("*/")
    }

    private companion object {
        val sources: Path = Path.of("src", "main", "kotlin", "org", "trigrid")
        val OBVIOUS = listOf(
            Regex("companion object"),
            Regex("val (size|nodeCount|edgeCount|elementCount)\\b"),
            Regex("fun [xy]\\(node: Int\\)"),
        )
    }
}
