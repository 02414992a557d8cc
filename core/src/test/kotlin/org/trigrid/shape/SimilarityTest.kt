package org.trigrid.shape

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.trigrid.domain.Path
import org.trigrid.geometry.Point2
import org.trigrid.project.Project
import org.trigrid.project.ProjectFile

class SimilarityTest {
    private val shapes = listOf(
        Line(0.0, 0.0, 4.0, 1.0, 0.5).withRatio(2.0),
        Lines.of(0.5, 0.0, 0.0, 2.0, 0.0, 2.0, 3.0),
        Curve.of(0.5, 0.0, 0.0, 2.0, 1.0, 4.0, 0.0).clamped(Point2(1.0, 1.0), Point2(0.0, -1.0)),
        Curve.of(0.5, 0.0, 0.0, 2.0, 1.0, 4.0, 0.0).closed(),
        Rectangle(1.0, 1.0, 4.0, 3.0, 0.5).withDirection(Direction.CLOCKWISE),
        Polygon.of(0.5, 0.0, 0.0, 3.0, 0.0, 1.0, 2.0),
        Polygon(Point2(2.0, 0.0), Point2(0.0, 0.0), 5, 0.4),
        Circle(1.0, 2.0, 1.5, 0.4),
        Ellipse(1.0, 2.0, 3.0, 1.0, 0.4).withRotationDegrees(20.0),
        Arc(Point2(0.0, 0.0), Point2(2.0, 0.0), 120.0, 0.3),
    )
    private val similarities = listOf(
        Similarity.translation(3.0, -2.0),
        Similarity.rotation(Point2(1.0, 1.0), 90.0),
        Similarity.rotation(Point2(-1.0, 2.0), 33.0),
        Similarity.scaling(Point2(1.0, 0.0), 2.5),
        Similarity.reflection(Point2(0.0, 1.0), Point2(3.0, 2.0)),
        Similarity.reflection(Point2(0.0, 1.0), Point2(3.0, 2.0)).then(Similarity.rotation(Point2(0.0, 3.0), 71.0)),
    )

    @Test
    fun `moved shapes are written to projects and read back`() {
        for (shape in shapes) {
            for (similarity in similarities) {
                val text = ProjectFile.format(Project.of(Path.of(similarity.apply(shape))))
                assertEquals(text, ProjectFile.format(ProjectFile.parse(text, "moved")), "$shape")
            }
        }
    }

    @Test
    fun `the nodes of the moved shape are the moved nodes of the shape`() {
        for (shape in shapes) {
            for (similarity in similarities) {
                val before = shape.explode()
                val after = similarity.apply(shape).explode()
                assertEquals(before.size, after.size, "$shape")
                for (k in 0 until before.size / 2) {
                    val wanted = similarity.apply(Point2(before[2 * k], before[2 * k + 1]))
                    assertEquals(0.0, wanted.distanceTo(Point2(after[2 * k], after[2 * k + 1])), 1e-9, "$shape node $k")
                }
            }
        }
    }

    @Test
    fun `a rectangle stays one as long as its sides are along the axes`() {
        val rectangle = Rectangle(1.0, 1.0, 4.0, 3.0, 0.5)
        assertTrue(Similarity.rotation(Point2(2.0, 2.0), 270.0).apply(rectangle) is Rectangle)
        assertTrue(Similarity.rotation(Point2(2.0, 2.0), 10.0).apply(rectangle) is Lines)
    }

    @Test
    fun `one after the other is the same as both at once`() {
        val point = Point2(0.3, -1.7)
        for (first in similarities) {
            for (second in similarities) {
                val wanted = second.apply(first.apply(point))
                assertEquals(0.0, wanted.distanceTo(first.then(second).apply(point)), 1e-12)
                assertEquals(first.isReflection != second.isReflection, first.then(second).isReflection)
                assertEquals(first.scale * second.scale, first.then(second).scale, 1e-12)
            }
        }
    }

    @Test
    fun `what has no sense is refused`() {
        assertThrows(IllegalArgumentException::class.java) { Similarity.scaling(Point2(0.0, 0.0), 0.0) }
        assertThrows(IllegalArgumentException::class.java) { Similarity.reflection(Point2(1.0, 1.0), Point2(1.0, 1.0)) }
    }
}
