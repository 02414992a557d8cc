package org.trigrid.cli

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

class InfoCommandTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun `a mesh of ours is described and found valid`() {
        val file = folder.resolve("lake.msh")
        Outcome.of("mesh", Samples.lake, "-o", file)
        val outcome = Outcome.of("info", file)
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        assertEquals("", outcome.err)
        val values = outcome.out.trimEnd().lines().associate { it.substringBefore(':') to it.substringAfter(':').trim() }
        assertEquals("229", values["boundary edges"])
        assertEquals("lake", values["region"])
        assertEquals("outer, hole_1, hole_2, hole_3, hole_4", values["tags"])
        assertTrue(values.getValue("nodes").toInt() > 1000)
    }

    @Test
    fun `violations are told with their places`() {
        val folded = Samples.file(
            folder, "folded.msh",
            "\$MeshFormat\n2.2 0 8\n\$EndMeshFormat\n\$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 1 0\n5 0.5 2 0\n\$EndNodes\n" +
                "\$Elements\n3\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 2 4\n3 2 2 1 1 1 2 5\n\$EndElements\n",
        )
        val outcome = Outcome.of("info", folded)
        assertEquals(ExitCodes.INVALID_DOMAIN, outcome.code, outcome.out)
        assertTrue(outcome.errorLines.isNotEmpty())
        for (line in outcome.errorLines) assertTrue(Regex(""".*folded\.msh: [A-Z_]+ at \(\S+, \S+\): .+""").matches(line), line)
    }

    @Test
    fun `what is no mesh is file trouble`() {
        val outcome = Outcome.of("info", Samples.plate(folder))
        assertEquals(ExitCodes.FILE_TROUBLE, outcome.code)
        assertTrue(outcome.errorLines.single().startsWith(folder.resolve("plate.wkt").toString()), outcome.err)
    }
}
