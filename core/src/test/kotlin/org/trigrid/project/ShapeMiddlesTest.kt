package org.trigrid.project

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.MeshRework
import org.trigrid.domain.Path
import org.trigrid.geometry.Point2
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.TriMesh
import org.trigrid.shape.Arc
import org.trigrid.shape.Circle
import org.trigrid.shape.Ellipse
import org.trigrid.shape.Line

class ShapeMiddlesTest {
    private fun area(mesh: TriMesh) = (0 until mesh.elementCount).sumOf { mesh.area(it) }

    @Test
    fun `refined boundaries stay on circles, ellipses and arcs`() {
        val path = Path.of(Circle(Point2(2.0, 0.0), Point2(0.0, 0.0), 0.5).withRatio(2.0).withName("rim"))
            .newLoop().append(Ellipse(0.0, 0.0, 1.0, 0.5, 0.3).withName("bore"))
        val project = Project.of(path)
        var mesh = MeshGenerator.generate(project.toDomain()).mesh
        val middles = ShapeMiddles(path)
        val before = area(mesh)
        repeat(3) { mesh = MeshRework.refine(mesh, middles) }
        assertEquals(emptyList<Any>(), MeshCheck.check(mesh))
        for (node in mesh.nodesOn("rim")) assertEquals(2.0, Math.hypot(mesh.x(node), mesh.y(node)), 1e-12)
        for (node in mesh.nodesOn("bore")) assertEquals(1.0, Math.hypot(mesh.x(node), 2 * mesh.y(node)), 1e-12)
        val exact = 3.5 * Math.PI
        assertTrue(Math.abs(area(mesh) - exact) < Math.abs(before - exact) / 30, "${area(mesh)}, before $before, exact $exact")
        // Halves of an edge differ by little.
        val lengths = mesh.nodesOn("rim").size
        assertEquals(8 * project.toDomain().loopNodes(0).size, lengths)
    }

    @Test
    fun `straight shapes and edited ones have straight middles`() {
        val path = Path.of(Line(0.0, 0.0, 4.0, 0.0, 1.0)).append(Arc(Point2(4.0, 0.0), Point2(0.0, 0.0), 180.0, 1.0))
        val mesh = MeshGenerator.generate(Project.of(path).toDomain()).mesh
        val fine = MeshRework.refine(mesh, ShapeMiddles(path))
        val onArc = (0 until fine.nodeCount).filter { fine.kindOf(it).name == "BOUNDARY" && fine.y(it) > 0 }
        for (node in onArc) assertEquals(2.0, Math.hypot(fine.x(node) - 2, fine.y(node)), 1e-12)
        assertTrue((0 until fine.nodeCount).any { fine.x(it) == 0.5 && fine.y(it) == 0.0 })
        val edited = path.moveNode(6, path.x(6), path.y(6) + 0.1)
        val straight = MeshRework.refine(MeshGenerator.generate(Project.of(edited).toDomain()).mesh, ShapeMiddles(edited))
        assertEquals(area(MeshGenerator.generate(Project.of(edited).toDomain()).mesh), area(straight), 1e-12)
    }

    @Test
    fun `with six nodes an element the area of curved domains is right to the fourth order`() {
        for (ratio in doubleArrayOf(1.0, 2.5)) {
            val errors = doubleArrayOf(0.4, 0.2, 0.1).map { spacing ->
                val path = Path.of(Circle(0.0, 0.0, 1.0, spacing).withRatio(ratio)).newLoop().append(Ellipse(0.0, 0.0, 0.5, 0.3, spacing / 2))
                val mesh = MeshGenerator.generate(Project.of(path).toDomain()).mesh
                val quadratic = MeshRework.secondOrder(mesh, ShapeMiddles(path))
                assertEquals(0, quadratic.straightenedEdgeCount)
                Math.abs((0 until quadratic.elementCount).sumOf { quadratic.area(it) } - 0.85 * Math.PI)
            }
            // Half the spacing twice: 16 * 16 times less, or nearly so.
            assertTrue(errors[2] < errors[0] / 150 && errors[2] < 1e-5, "ratio $ratio: $errors")
        }
    }

    @Test
    fun `middles lie halfway along the shape, also across the end of a closed one`() {
        val path = Path.of(Circle(0.0, 0.0, 1.0, 0.6).withRatio(4.0))
        val mesh = MeshGenerator.generate(Project.of(path).toDomain()).mesh
        val middles = ShapeMiddles(path)
        for (e in 0 until mesh.taggedEdgeCount) {
            val middle = middles.middleOf(mesh, e)
            val toStart = Math.hypot(middle[0] - mesh.x(mesh.edgeStart(e)), middle[1] - mesh.y(mesh.edgeStart(e)))
            val toEnd = Math.hypot(middle[0] - mesh.x(mesh.edgeEnd(e)), middle[1] - mesh.y(mesh.edgeEnd(e)))
            assertEquals(toStart, toEnd, 1e-12)
            assertEquals(1.0, Math.hypot(middle[0], middle[1]), 1e-12)
        }
    }
}
