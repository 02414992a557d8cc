package org.trigrid.documents

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.domain.DomainCheck
import org.trigrid.domain.Path as Outline
import org.trigrid.io.DomainFormats
import org.trigrid.io.MeshFormats
import org.trigrid.mesh.MeshCheck
import org.trigrid.shape.Circle
import org.trigrid.spacing.Sizes
import java.nio.file.Path
import kotlin.math.hypot
import kotlin.math.ln

/** The Kotlin programs of the documents, run; [DocumentProgramsTest] holds the two together. */
class KotlinProgramsTest {
    @Test
    fun `the program of the README`(@TempDir folder: Path) {
        val file = Path.of("../src-test-data/domains/lake.geojson")
        val output = folder.resolve("lake.vtu")
        // README.md
        val lake = DomainFormats.read(file).single().domain            // GeoJSON, WKT, SVG, DXF, .poly, …
        val faults = DomainCheck.check(lake)                           // all of them, each with its place
        check(faults.isEmpty()) { faults.joinToString("\n") }
        val options = MeshOptions.builder()
            .sizes(Sizes.GRADE).gradation(0.3)                         // grow away from the shore
            .sizeFunction { x, y -> 20 + 0.1 * hypot(x - 500, y - 400) }
            .build()
        val mesh = MeshGenerator.generate(lake, options).mesh
        println("${mesh.nodeCount} nodes, ${mesh.elementCount} elements")
        MeshFormats.write(mesh, output)                                // the ending says: .msh, .vtu, .inp, …
        // end
        assertTrue(MeshCheck.check(mesh, lake).isEmpty())
        assertEquals(mesh.elementCount, MeshFormats.read(output).elementCount)
    }

    /** A ring instead of the plate, since its solution is known: ln(r / R) / ln(a / R). */
    @Test
    fun `the solver of the quick start finds a known solution`() {
        val plate = Outline.of(
            Circle(0.0, 0.0, 3.0, 0.4).withName("edge"), Circle(0.0, 0.0, 1.0, 0.2).withName("hole"),
        )
        // docs/quick-start.md
        val mesh = MeshGenerator.generate(plate.toDomain()).mesh
        val u = DoubleArray(mesh.nodeCount)
        val held = BooleanArray(mesh.nodeCount)
        for (node in mesh.nodesOn("edge")) held[node] = true
        for (node in mesh.nodesOn("hole")) {
            held[node] = true
            u[node] = 1.0
        }
        val stiffness = Array(mesh.nodeCount) { sortedMapOf<Int, Double>() }
        for (e in 0 until mesh.elementCount) {
            val nodes = IntArray(3) { mesh.nodeOf(e, it) }
            val b = DoubleArray(3) { mesh.y(nodes[(it + 1) % 3]) - mesh.y(nodes[(it + 2) % 3]) }
            val c = DoubleArray(3) { mesh.x(nodes[(it + 2) % 3]) - mesh.x(nodes[(it + 1) % 3]) }
            for (i in 0..2) for (k in 0..2) {
                stiffness[nodes[i]].merge(nodes[k], (b[i] * b[k] + c[i] * c[k]) / (4 * mesh.area(e)), Double::plus)
            }
        }
        repeat(500) {
            for ((i, row) in stiffness.withIndex()) {
                if (!held[i]) u[i] = -row.entries.sumOf { (k, a) -> if (k == i) 0.0 else a * u[k] } / row.getValue(i)
            }
        }
        // end
        for (node in u.indices) {
            val expected = 1 - ln(hypot(mesh.x(node), mesh.y(node))) / ln(3.0)
            assertEquals(expected, u[node], 0.01, "node $node")
        }
    }
}
