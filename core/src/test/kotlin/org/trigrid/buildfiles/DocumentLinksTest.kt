package org.trigrid.buildfiles

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.extension
import kotlin.io.path.name
import kotlin.io.path.readText

/** Links between the documents lead somewhere. */
class DocumentLinksTest {
    private val root = Path.of("..")

    @Test
    fun `relative links and pictures exist`() {
        val documents = documents()
        assertTrue(documents.any { it.name == "README.md" } && documents.any { it.name == "cli.md" })
        val broken = documents.flatMap { document ->
            links(document)
                .filterNot { it.startsWith("http") || it.startsWith("#") }
                .filterNot { document.resolveSibling(it.substringBefore('#')).exists() }
                .map { "$document: $it" }
        }
        assertEquals(emptyList<String>(), broken)
    }

    private fun links(document: Path): List<String> =
        Regex("""]\(([^)\s]+)[^)]*\)""").findAll(withoutCode(document.readText())).map { it.groupValues[1] }.toList()

    private fun withoutCode(text: String): String = text.replace(Regex("(?s)```.*?```"), "").replace(Regex("`[^`\n]*`"), "")

    private fun documents(): List<Path> = listOf(root, root.resolve("docs"), root.resolve("src-test-data")).flatMap { folder ->
        Files.walk(folder, if (folder == root) 1 else MAX_DEPTH).use { files ->
            files.filter { it.extension == "md" }.sorted().toList()
        }
    }

    private companion object {
        const val MAX_DEPTH = 4
    }
}
