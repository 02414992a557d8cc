package org.trigrid.regions

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.MeshGenerator
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import org.trigrid.domain.InnerParts
import org.trigrid.domain.Region
import org.trigrid.io.DomainFormats
import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import org.trigrid.io.NamedDomain
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.TriMesh
import org.trigrid.project.DomainInputs
import org.trigrid.project.InputOptions
import org.trigrid.project.Project
import org.trigrid.project.ProjectFile
import java.nio.file.Files
import java.nio.file.Path

class RegionFilesTest {
    @TempDir
    lateinit var directory: Path

    @Test
    fun `regions, interfaces and points come back from every format that is read`() {
        val domain = coil()
        val mesh = MeshGenerator.generate(domain).mesh
        for (format in MeshFormats.all().filter { it.canRead }) {
            val file = directory.resolve("coil-" + format.name + format.endings[0])
            MeshFormats.write(mesh, file, format)
            val back = MeshFormats.read(file)
            assertEquals(emptyList<Any>(), MeshCheck.check(back), format.name)
            val hasNames = format != MeshFormat.TRIANGLE && format != MeshFormat.MEDIT
            if (hasNames) {
                assertEquals(mesh.regions.map { it.name }.toSet(), back.regions.map { it.name }.toSet(), format.name)
                assertEquals(emptyList<Any>(), MeshCheck.check(back, domain), format.name)
            }
            for (region in mesh.regions.indices) {
                val twin = back.regions.indices.single { area(back, it) in area(mesh, region).let { a -> a - 1e-12..a + 1e-12 } }
                if (format != MeshFormat.VTU && mesh.regions[region].material > 0) {
                    assertEquals(mesh.regions[region].material, back.regions[twin].material, format.name)
                }
            }
            assertEquals(domain.segmentCount, back.taggedEdgeCount, format.name)
        }
    }

    private fun area(mesh: TriMesh, region: Int) = (0 until mesh.elementCount).filter { mesh.regionOf(it) == region }.sumOf { mesh.area(it) }

    @Test
    fun `ids of groups differ, and a material number is its region's own`() {
        val mesh = MeshGenerator.generate(coil()).mesh
        val file = directory.resolve("coil.msh")
        MeshFormats.write(mesh, file, MeshFormat.MSH_22)
        val names = Files.readAllLines(file).dropWhile { it != "\$PhysicalNames" }.drop(2).takeWhile { it != "\$EndPhysicalNames" }
        assertTrue("2 2 \"copper\"" in names) { "$names" }
        assertTrue(names.any { it.startsWith("0 ") && it.endsWith("\"probe\"") })
        val ids = names.map { it.split(' ')[1] }
        assertEquals(ids.size, ids.distinct().size)
    }

    @Test
    fun `a poly file has its regions by points, with attributes and areas`() {
        val domain = coil()
        val file = directory.resolve("coil.poly")
        DomainFormats.write(listOf(NamedDomain("coil", domain)), file, DomainFormats.named("poly")!!)
        val back = DomainFormats.read(file).single().domain
        assertEquals(emptyList<Any>(), DomainCheck.check(back))
        assertEquals(domain.segmentCount, back.segmentCount)
        assertEquals(1, back.pointCount)
        assertEquals(setOf("region_1", "region_2", "region_3"), back.regions.map { it.name }.toSet())
        val copper = back.regions.single { it.material == 2 }
        assertEquals(0.2, copper.maxSize, 1e-12)
        assertEquals((0 until domain.segmentCount).count { domain.isInterface(it) }, (0 until back.segmentCount).count { back.isInterface(it) })
    }

    @Test
    fun `a project keeps regions, lines and points, and tells an older program of them`() {
        val inner = InnerParts.NONE.withRegion(Region.of("copper").withMaterial(2).withMaxSize(0.125), 0.5, 0.5)
            .withRegion(Region.of("copper").withMaterial(2).withMaxSize(0.125), 0.1, 0.5).withPoint("probe", 0.25, 0.75)
            .withLine("cut", 0.0, 0.1, 0.2, 0.1).withLoop("ring", 0.4, 0.4, 0.6, 0.4, 0.5, 0.6)
        val project = Project.builder().region(Region.of("iron").withMaterial(7)).inner(inner).build()
        val text = ProjectFile.format(project)
        assertTrue("\"version\": 2" in text) { text }
        val back = ProjectFile.parse(text, "p")
        assertEquals(text, ProjectFile.format(back))
        assertEquals(Region.of("iron").withMaterial(7), back.region)
        assertEquals(2, back.inner.markerCount)
        assertEquals(inner.markerRegion(1), back.inner.markerRegion(1))
        assertArrayEquals(inner.lineNodes(1), back.inner.lineNodes(1))
        assertTrue(back.inner.isClosed(1))
        assertEquals("probe", back.inner.pointTag(0))
        assertTrue("\"version\": 1" in ProjectFile.format(Project.builder().build()))
        val quadratic = ProjectFile.format(Project.builder().order(2).build())
        assertTrue("\"version\": 2" in quadratic && ProjectFile.parse(quadratic, "q").order == 2) { quadratic }
        assertThrows(FileFormatException::class.java) { ProjectFile.parse(quadratic.replace("\"order\": 2", "\"order\": 3"), "q") }
    }

    @Test
    fun `the stator slot has its four materials, and its domain is the same from loops and inner parts`() {
        val project = ProjectFile.read(Path.of("../src-test-data/regions/stator-slot.trigrid.json"))
        val domain = project.toDomain()
        assertEquals(listOf("iron", "insulation", "copper", "steel"), domain.regions.map { it.name })
        assertEquals(emptyList<Any>(), project.faults())
        val mesh = MeshGenerator.generate(domain, project.options).mesh
        assertEquals(emptyList<Any>(), MeshCheck.check(mesh, domain))
        assertEquals(280.0, mesh.elementsIn("copper").sumOf { mesh.area(it) }, 1e-9)
        assertEquals(2, mesh.nodesOn("sensor").size)

        val loops = Domain.builder()
        for (loop in 0 until domain.loopCount) {
            val nodes = domain.loopNodes(loop)
            loops.loop(DoubleArray(2 * nodes.size) { if (it % 2 == 0) domain.x(nodes[it / 2]) else domain.y(nodes[it / 2]) })
        }
        val again = loops.baseRegion(domain.regions[0]).build().with(InnerParts.of(domain))
        assertEquals(emptyList<Any>(), DomainCheck.check(again))
        assertEquals(domain.regions.toSet(), again.regions.toSet())
        assertEquals((0 until domain.segmentCount).count { domain.isInterface(it) }, (0 until again.segmentCount).count { again.isInterface(it) })
    }

    @Test
    fun `features of a GeoJSON file become regions that share their sides`() {
        val file = directory.resolve("land.geojson")
        fun feature(name: String, rings: String) =
            "{\"type\": \"Feature\", \"properties\": {\"name\": \"$name\"}, \"geometry\": {\"type\": \"Polygon\", \"coordinates\": [$rings]}}"
        val west = feature("west", "[[0,0],[1,0],[1,1],[0,1],[0,0]],[[0.4,0.4],[0.6,0.4],[0.6,0.6],[0.4,0.6],[0.4,0.4]]")
        val east = feature("east", "[[1,0],[2,0],[2,1],[1,1],[1,0]]")
        val lake = feature("lake", "[[0.4,0.4],[0.6,0.4],[0.6,0.6],[0.4,0.6],[0.4,0.4]]")
        Files.writeString(file, "{\"type\": \"FeatureCollection\", \"features\": [$west, $east, $lake]}")
        assertEquals(3, DomainInputs.read(file).size)
        val options = InputOptions.DEFAULT.withJoin(true).withInner(InnerParts.NONE.withPoint("p", 0.2, 0.2))
        val domain = DomainInputs.read(file, options).single().domain
        assertEquals(emptyList<Any>(), DomainCheck.check(domain))
        assertEquals(listOf("west", "east", "lake"), domain.regions.map { it.name })
        assertEquals(5, (0 until domain.segmentCount).count { domain.isInterface(it) })
        assertEquals(1, domain.loopCount)
        assertEquals(2.0, domain.area)
        assertEquals(1, domain.pointCount)
        assertEquals(emptyList<Any>(), MeshCheck.check(MeshGenerator.generate(domain).mesh, domain))
    }

    @Test
    fun `lines and points go into a domain of regions that is there, and one more region`() {
        val domain = coil().with(InnerParts.NONE.withLine("cut", 0.0, 0.0, 0.3, 0.4).withLoop("pin", 3.2, 3.2, 3.6, 3.2, 3.4, 3.6).withPoint("p", 0.2, 3.0))
        assertEquals(emptyList<Any>(), DomainCheck.check(domain))
        assertEquals(2, domain.pointCount)
        assertEquals(listOf("iron", "copper", "air"), domain.regions.map { it.name })
        val more = domain.with(InnerParts.NONE.withRegion(Region.of("pin"), 3.4, 3.3))
        assertEquals(listOf("iron", "copper", "air", "pin"), more.regions.map { it.name })
        assertEquals(emptyList<Any>(), MeshCheck.check(MeshGenerator.generate(more).mesh, more))
    }

    /** Iron with a copper square in it, in that a hole filled with air, and a probe. */
    private fun coil(): Domain = Domain.builder().regionName("iron").outer(square(0.0, 4.0), "rim").hole(square(1.0, 2.0), "copper-iron")
        .outer(square(1.5, 1.0), "air-copper").embedPoint(0.5, 0.5, "probe")
        .region(1.2, 1.2, Region.of("copper").withMaterial(2).withMaxSize(0.2)).region(2.0, 2.0, Region.of("air").withMaterial(3)).build()

    private fun square(at: Double, side: Double) = doubleArrayOf(at, at, at + side, at, at + side, at + side, at, at + side)
}
