package org.trigrid.cli

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.io.MeshFormats
import org.trigrid.mesh.MeshCheck
import java.nio.file.Path
import kotlin.io.path.writeText

class RegionOptionsTest {
    @TempDir
    lateinit var folder: Path

    private val output: Path get() = folder.resolve("out.msh")

    @Test
    fun `regions, points and lines given on the command line are in the mesh`() {
        val plate = folder.resolve("plate.wkt")
        plate.writeText("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))")
        val outcome = Outcome.of(
            "mesh", plate, "-o", output, "--spacing", "0.1", "--region", "fill=9,0.05@1.5,1.5", "--point", "probe@3,3,3.2,3.3",
            "--line", "cut,0.25@2.5,1,2.5,3",
        )
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        val mesh = MeshFormats.read(output)
        assertEquals(emptyList<Any>(), MeshCheck.check(mesh))
        assertEquals(setOf("plate", "fill"), mesh.regions.map { it.name }.toSet())
        assertEquals(9, mesh.regions.single { it.name == "fill" }.material)
        assertEquals(1.0, mesh.elementsIn("fill").sumOf { mesh.area(it) }, 1e-9)
        assertTrue(mesh.elementsIn("fill").size > 350) { "${mesh.elementsIn("fill").size}" }
        assertEquals(2, mesh.nodesOn("probe").size)
        assertEquals(8, mesh.edgesOn("cut").size)
        val info = Outcome.of("info", output).out
        assertTrue("fill (material 9), " in info && "points:         2" in info) { info }
    }

    @Test
    fun `polygons of a file become one domain, and a file keeps its regions as a project`() {
        val land = folder.resolve("land.wkt")
        land.writeText("GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0)), POLYGON ((1 0, 2 0, 2 1, 1 1, 1 0)))")
        val project = folder.resolve("land.trigrid.json")
        assertEquals(ExitCodes.DONE, Outcome.of("convert", land, project, "--join-domains").code)
        assertEquals(ExitCodes.DONE, Outcome.of("mesh", project, "-o", output).code)
        val mesh = MeshFormats.read(output)
        assertEquals(2, mesh.regions.size)
        for (region in mesh.regions) assertEquals(1.0, mesh.elementsIn(region.name).sumOf { mesh.area(it) }, 1e-12)
    }

    @Test
    fun `a region outside of everything is told with its place`() {
        val outcome = Outcome.of("mesh", Samples.lake, "-o", output, "--region", "far@1e6,1e6")
        assertEquals(ExitCodes.INVALID_DOMAIN, outcome.code)
        assertTrue("far" in outcome.err && "1000000.0" in outcome.err) { outcome.err }
    }

    @Test
    fun `a project says the order of its elements, and the command line may say another`() {
        val project = folder.resolve("disc.trigrid.json")
        project.writeText(
            """{"format": "trigrid", "version": 2, "order": 2, "path": [{"type": "circle", "firstPoint": [1, 0], "centre": [0, 0], "spacing": 0.3}]}""",
        )
        assertEquals(ExitCodes.DONE, Outcome.of("mesh", project, "-o", output).code)
        assertEquals(2, MeshFormats.readEither(output).order)
        assertEquals(ExitCodes.DONE, Outcome.of("mesh", project, "-o", output, "--order", "1").code)
        assertEquals(1, MeshFormats.readEither(output).order)
        val refused = Outcome.of("mesh", project, "-o", folder.resolve("disc.su2"))
        assertEquals(ExitCodes.FILE_TROUBLE, refused.code)
        assertTrue("su2" in refused.err) { refused.err }
    }
}
