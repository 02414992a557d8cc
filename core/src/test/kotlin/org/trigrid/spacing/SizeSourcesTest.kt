package org.trigrid.spacing

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.diagnostics.InvalidSizeException
import org.trigrid.domain.Path
import org.trigrid.geometry.Pose
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.TriMesh
import org.trigrid.project.Project
import org.trigrid.shape.Rectangle

class SizeSourcesTest {
    private val square = Project.of(Path.of(Rectangle(0.0, 0.0, 1.0, 1.0, 0.05))).toDomain()

    private fun mesh(sources: SizeSources, gradation: Double = 0.25): TriMesh {
        val mesh = MeshGenerator.generate(square, MeshOptions.builder().sizeSources(sources).gradation(gradation).build()).mesh
        assertEquals(emptyList<Any>(), MeshCheck.check(mesh, square))
        return mesh
    }

    /** Mean length of the edges whose middle is less than [reach] from (x, y). */
    private fun sizeNear(mesh: TriMesh, x: Double, y: Double, reach: Double): Double {
        val lengths = ArrayList<Double>()
        val edges = mesh.edgeNodes()
        for (e in 0 until edges.size / 2) {
            val a = edges[2 * e]
            val b = edges[2 * e + 1]
            if (Math.hypot((mesh.x(a) + mesh.x(b)) / 2 - x, (mesh.y(a) + mesh.y(b)) / 2 - y) > reach) continue
            lengths.add(Math.hypot(mesh.x(b) - mesh.x(a), mesh.y(b) - mesh.y(a)))
        }
        return lengths.average()
    }

    @Test
    fun `elements have the size of a point, and grow by the gradation`() {
        for (gradation in doubleArrayOf(0.15, 0.3)) {
            val mesh = mesh(SizeSources.NONE.withPoint(0.002, 0.4137, 0.5519), gradation)
            assertEquals(0.002, sizeNear(mesh, 0.4137, 0.5519, 0.003), 0.0008)
            assertEquals(0.002 + gradation * 0.1, sizeNear(mesh, 0.5137, 0.5519, 0.03), 0.25 * (0.002 + gradation * 0.1))
            assertEquals(0.05, sizeNear(mesh, 0.95, 0.05, 0.08), 0.015)
        }
    }

    @Test
    fun `elements along a line are small at its ends, its bends and between`() {
        val expected = 0.01 + 0.25 * 0.0075  // half of the reach away
        val mesh = mesh(SizeSources.NONE.withLine(0.01, 0.3, 0.3, 0.7, 0.3, 0.7, 0.7))
        for ((x, y) in listOf(0.3 to 0.3, 0.5 to 0.3, 0.7 to 0.3, 0.7 to 0.51, 0.7 to 0.7)) {
            assertEquals(expected, sizeNear(mesh, x, y, 0.015), 0.003)
        }
        assertTrue(sizeNear(mesh, 0.3, 0.7, 0.05) > 0.035)
    }

    @Test
    fun `of many sources the smallest rules`() {
        var sources = SizeSources.NONE.withLine(0.3, 0.0, 0.0, 1.0, 0.0)
        val random = java.util.Random(3)
        repeat(200) { sources = sources.withPoint(0.01 + random.nextDouble(), random.nextDouble(), random.nextDouble()) }
        val sizes = sources.graded(0.2, Pose.AS_GIVEN)!!
        repeat(100) {
            val x = 2 * random.nextDouble() - 0.5
            val y = 2 * random.nextDouble() - 0.5
            var expected = 0.3 + 0.2 * Math.hypot(x - x.coerceIn(0.0, 1.0), y)
            for (i in 1 until sources.count) {
                val place = sources.placeOf(i)
                expected = minOf(expected, sources.sizeOf(i) + 0.2 * Math.hypot(x - place[0], y - place[1]))
            }
            assertEquals(expected, sizes.sizeAt(x, y), 1e-12)
        }
    }

    @Test
    fun `what cannot be a source is refused`() {
        assertThrows(IllegalArgumentException::class.java) { SizeSources.NONE.withPoint(0.0, 0.0, 0.0) }
        assertThrows(IllegalArgumentException::class.java) { SizeSources.NONE.withPoint(1.0, Double.NaN, 0.0) }
        assertThrows(IllegalArgumentException::class.java) { SizeSources.NONE.withLine(1.0, 0.0, 0.0) }
        assertThrows(IllegalArgumentException::class.java) { SizeSources.NONE.withLine(1.0, 0.0, 0.0, 1.0) }
        val options = MeshOptions.builder().sizeSources(SizeSources.NONE.withPoint(0.1, 0.5, 0.5)).sizeFunction { _, _ -> -1.0 }.build()
        assertThrows(InvalidSizeException::class.java) { MeshGenerator.generate(square, options) }
        assertEquals(0, SizeSources.NONE.count)
        assertArrayEquals(doubleArrayOf(1.0, 2.0), SizeSources.NONE.withPoint(0.5, 1.0, 2.0).placeOf(0))
    }
}
