package org.trigrid.project

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.Test
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import java.nio.file.Files
import java.nio.file.Path

/** The files of `src-test-data/paper`. `-Dtrigrid.rewrite=true` writes them anew from [PaperProjects]. */
class PaperProjectsTest {
    @Test
    fun `the files are what the library builds`() {
        for ((name, project) in PaperProjects.all()) {
            val file = directory.resolve("$name.trigrid.json")
            assertEquals(ProjectFile.format(project), Files.readString(file), name)
        }
        Files.list(directory).use { files ->
            val names = files.map { it.fileName.toString() }.filter { it.endsWith(".trigrid.json") }.sorted().toList()
            assertEquals(PaperProjects.all().keys.map { "$it.trigrid.json" }.sorted(), names)
        }
    }

    @Test
    fun `every file makes a valid domain`() {
        for (name in PaperProjects.all().keys) {
            val domain = domain(name)
            val faults = DomainCheck.check(domain)
            assertTrue(faults.isEmpty(), "$name: $faults")
        }
    }

    @Test
    fun `boundary nodes are as many as the paper's meshes have`() {
        // Nb = 2 N - 2 + 2 holes - T from the paper's numbers of nodes N and elements T.
        assertEquals(16, domain("small-grid").nodeCount)
        assertEquals(162, domain("machine-part").nodeCount)
        assertEquals(307, domain("machine-part-dense").nodeCount)
        assertEquals(294, domain("machine-part-thinner").nodeCount)
        // "A total of 307 nodes were used to describe the front": the nodes of the connectors are among them.
        assertEquals(307, read("machine-part-thinner").path.nodeCount)
    }

    @Test
    fun `the ellipse hangs on a neck and comes off when edited`() {
        val whole = domain("general")
        assertEquals(5, whole.loopCount)
        assertEquals(1, read("general").path.walks().size)
        val edited = domain("general-edited")
        assertEquals(6, edited.loopCount)
        assertEquals(2, read("general-edited").path.walks().size)
        assertEquals(4, (0 until edited.loopCount).count { edited.isHole(it) })
    }

    @Test
    fun `openings lie where the paper has them`() {
        assertEquals(2, holes("machine-part"))
        assertEquals(2, holes("owen"))
        assertEquals(1, holes("bastian"))
        assertEquals(0, holes("hand"))
    }

    private companion object {
        val directory: Path = Path.of("..", "src-test-data", "paper")

        @BeforeAll
        @JvmStatic
        fun rewriteIfAsked() {
            if (System.getProperty("trigrid.rewrite") != "true") return
            for ((name, project) in PaperProjects.all()) ProjectFile.write(directory.resolve("$name.trigrid.json"), project)
        }
    }

    private fun holes(name: String): Int = domain(name).let { d -> (0 until d.loopCount).count { d.isHole(it) } }

    private fun read(name: String): Project = ProjectFile.read(directory.resolve("$name.trigrid.json"))

    private fun domain(name: String): Domain = read(name).toDomain()
}
