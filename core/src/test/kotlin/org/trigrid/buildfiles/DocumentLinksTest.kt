package org.trigrid.buildfiles

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.file.FileVisitResult
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.SimpleFileVisitor
import java.nio.file.attribute.BasicFileAttributes
import java.util.Locale
import kotlin.io.path.exists
import kotlin.io.path.extension
import kotlin.io.path.isDirectory
import kotlin.io.path.name
import kotlin.io.path.readText

/** Links between the documents lead somewhere: to a file that is there, and to a heading of it. */
class DocumentLinksTest {
    private val root = Path.of("..")
    private val documents = documents()
    private val anchors = HashMap<Path, Set<String>>()

    @Test
    fun `relative links and pictures exist`() {
        assertTrue(documents.any { it.name == "README.md" } && documents.any { it.name == "cli.md" })
        assertTrue(documents.any { ".github" in it.toString() })
        val broken = documents.flatMap { document ->
            links(document).filterNot { target(document, it).exists() }.map { "$document: $it" }
        }
        assertEquals(emptyList<String>(), broken)
    }

    @Test
    fun `anchors are headings`() {
        val withAnchor = documents.flatMap { document -> links(document).filter { '#' in it }.map { document to it } }
        assertTrue(withAnchor.size > 10)
        val broken = withAnchor.filter { (document, link) ->
            val target = target(document, link)
            target.extension == "md" && link.substringAfter('#') !in anchors.getOrPut(target) { anchorsOf(target) }
        }
        assertEquals(emptyList<Pair<Path, String>>(), broken)
    }

    @Test
    fun `anchors are made as GitHub makes them`() {
        assertEquals("completion-and-manual-page", anchor("Completion and manual page"))
        assertEquals("1-the-walk-its-loops", anchor("1. The walk, `its` loops"))
        assertEquals("tables--csv", anchor("Tables / [CSV](tables.md)"))
    }

    private fun target(document: Path, link: String): Path {
        val file = link.substringBefore('#')
        return (if (file.isEmpty()) document else document.resolveSibling(file)).normalize()
    }

    private fun links(document: Path): List<String> {
        val text = withoutCode(document.readText())
        return (Regex("""]\(([^)\s]+)[^)]*\)""").findAll(text) + Regex("""\bsrc="([^"]+)"""").findAll(text))
            .map { it.groupValues[1] }.filterNot { Regex("^[a-z]+:").containsMatchIn(it) }.toList()
    }

    /** Of equal headings the later ones get a number. */
    private fun anchorsOf(document: Path): Set<String> {
        val found = LinkedHashSet<String>()
        for (heading in Regex("(?m)^#+ +(.+)$").findAll(document.readText().replace(Regex("(?s)```.*?```"), ""))) {
            val plain = anchor(heading.groupValues[1])
            found.add(generateSequence(0) { it + 1 }.map { if (it == 0) plain else "$plain-$it" }.first { it !in found })
        }
        return found
    }

    private fun anchor(heading: String): String = heading.trim().replace(Regex("""\[([^]]*)]\([^)]*\)"""), "$1")
        .lowercase(Locale.ROOT).replace(Regex("""[^\p{L}\p{N} _-]"""), "").replace(' ', '-')

    private fun withoutCode(text: String): String = text.replace(Regex("(?s)```.*?```"), "").replace(Regex("`[^`\n]*`"), "")

    private fun documents(): List<Path> {
        val found = ArrayList<Path>()
        Files.walkFileTree(root, object : SimpleFileVisitor<Path>() {
            override fun preVisitDirectory(folder: Path, attributes: BasicFileAttributes): FileVisitResult {
                val isPassed = folder.name in PASSED || folder != root && folder.resolve(".git").isDirectory()
                return if (isPassed) FileVisitResult.SKIP_SUBTREE else FileVisitResult.CONTINUE
            }

            override fun visitFile(file: Path, attributes: BasicFileAttributes): FileVisitResult {
                if (file.extension == "md") found.add(file)
                return FileVisitResult.CONTINUE
            }
        })
        return found.sorted()
    }

    private companion object {
        val PASSED = setOf(".git", ".gradle", ".kotlin", ".venv", "build", "node_modules", "out", "target")
    }
}
