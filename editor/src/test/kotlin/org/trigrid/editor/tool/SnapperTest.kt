package org.trigrid.editor.tool

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.trigrid.domain.Path
import org.trigrid.editor.document.EditorDocument
import org.trigrid.geometry.Point2
import org.trigrid.project.NodeLoop
import org.trigrid.project.Project
import org.trigrid.shape.Arc
import org.trigrid.shape.Circle
import org.trigrid.shape.Line
import org.trigrid.shape.Rectangle

class SnapperTest {
    private val path = Path.of(Line(0.0, 0.0, 3.0, 0.0, 1.0)).newLoop()
        .append(Line(1.5, -1.0, 1.75, 2.0, 9.0)).newLoop().append(Circle(10.0, 10.0, 2.0, 0.5))
    private val document = EditorDocument(Project.of(path))
    private val snapper = Snapper(document, SnapSettings())

    private fun at(x: Double, y: Double, shift: Boolean = false, alt: Boolean = false, anchor: Point2? = null) =
        snapper.snap(PointerInput(x, y, 0.01, shift, alt), anchor)

    @Test
    fun `nodes come first`() {
        val snap = at(1.03, 0.04)
        assertEquals(SnapKind.NODE, snap.kind)
        assertEquals(Point2(1.0, 0.0), snap.point)
        assertEquals(1, snap.node)
    }

    @Test
    fun `middles, centres and intersections`() {
        assertEquals(SnapKind.MIDDLE, at(1.47, 0.02).kind)
        assertEquals(Point2(1.5, 0.0), at(1.47, 0.02).point)
        assertEquals(SnapKind.CENTRE, at(10.03, 9.98).kind)
        val crossing = at(1.62, 0.02)
        assertEquals(SnapKind.INTERSECTION, crossing.kind)
        assertEquals(1.5 + 0.25 / 3, crossing.point.x, 1e-12)
        assertEquals(0.0, crossing.point.y, 1e-12)
    }

    @Test
    fun `sides of rectangles and loops have middles, arcs have centres`() {
        val path = Path.of(Rectangle(0.0, 0.0, 5.0, 3.0, 1.0)).newLoop().append(Arc.through(Point2(12.0, 0.0), Point2(10.0, 2.0), Point2(8.0, 0.0), 0.5))
        val loop = NodeLoop(doubleArrayOf(20.0, 0.0, 26.0, 0.0, 20.0, 6.0), "boundary")
        val snapper = Snapper(EditorDocument(Project.builder().path(path).loops(listOf(loop)).build()), SnapSettings())
        fun at(x: Double, y: Double) = snapper.snap(PointerInput(x, y, 0.01))
        for ((x, y) in listOf(5.0 to 1.5, 2.5 to 3.0, 0.0 to 1.5, 23.0 to 0.0, 23.0 to 3.0)) {
            assertEquals(SnapKind.MIDDLE, at(x + 0.02, y - 0.03).kind)
            assertEquals(Point2(x, y), at(x + 0.02, y - 0.03).point)
        }
        assertEquals(SnapKind.CENTRE, at(2.51, 1.51).kind)
        assertEquals(SnapKind.CENTRE, at(10.02, 0.03).kind)
        assertEquals(0.0, at(10.02, 0.03).point.distanceTo(Point2(10.0, 0.0)), 1e-12)
    }

    @Test
    fun `the grid comes last and its places are decimal`() {
        val snap = at(5.31, 7.09)
        assertEquals(SnapKind.GRID, snap.kind)
        assertEquals(Point2(5.4, 7.0), snap.point)
    }

    @Test
    fun `Alt suspends`() {
        assertEquals(Point2(1.03, 0.04), at(1.03, 0.04, alt = true).point)
    }

    @Test
    fun `Shift holds angles`() {
        val anchor = Point2(1.0, 1.0)
        assertEquals(Point2(5.0, 1.0), at(5.02, 1.1, shift = true, anchor = anchor).point)
        assertEquals(Point2(1.0, -3.0), at(1.1, -2.98, shift = true, anchor = anchor).point)
        val slanted = at(4.0, 4.1, shift = true, anchor = anchor).point
        assertEquals(slanted.x - 1, slanted.y - 1, 1e-12)
    }

    @Test
    fun `switched off, nothing draws the mouse`() {
        val off = Snapper(document, SnapSettings(false, false, false))
        assertEquals(Point2(1.03, 0.04), off.snap(PointerInput(1.03, 0.04, 0.01)).point)
    }

    @Test
    fun `grid steps are 1, 2 or 5`() {
        assertEquals(0.2, Grid.stepFor(0.01))
        assertEquals(20.0, Grid.stepFor(1.0))
        assertEquals(0.05, Grid.stepFor(0.003))
        assertEquals(0.3, Grid.nearest(0.2999, 0.1))
    }
}
