package org.trigrid.editor.tool

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import org.trigrid.domain.Path
import org.trigrid.editor.session.PIXEL
import org.trigrid.editor.session.click
import org.trigrid.editor.session.drawWith
import org.trigrid.editor.session.newSession
import org.trigrid.geometry.Point2
import org.trigrid.project.ProjectFile
import org.trigrid.shape.Arc
import org.trigrid.shape.Circle
import org.trigrid.shape.Curve
import org.trigrid.shape.CurveEnds
import org.trigrid.shape.Ellipse
import org.trigrid.shape.Line
import org.trigrid.shape.Lines
import org.trigrid.shape.Polygon
import org.trigrid.shape.Rectangle

class ShapeToolTest {
    private val session = newSession()
    private val path: Path get() = session.document.path

    @Test
    fun `two clicks make a line, and the next begins at its end`() {
        session.drawWith(ShapeKind.LINE, 0.0, 0.0, 4.0, 0.0, 4.0, 3.0)
        assertEquals(listOf(Line(0.0, 0.0, 4.0, 0.0, 1.0), Line(4.0, 0.0, 4.0, 3.0, 1.0)), listOf(path.shape(0), path.shape(1)))
        assertEquals(2, path.shapeCount)
    }

    @Test
    fun `lines end where they began, and close the walk`() {
        session.drawWith(ShapeKind.LINES, 0.0, 0.0, 4.0, 0.0, 4.0, 3.0, 0.0, 0.0)
        assertEquals(1, path.shapeCount)
        assertTrue(path.shape(0).isClosed())
        assertTrue(session.problems.isEmpty())
    }

    @Test
    fun `Enter and a double click end lines`() {
        session.drawWith(ShapeKind.LINES, 0.0, 0.0, 4.0, 0.0, 4.0, 3.0)
        assertEquals(0, path.shapeCount)
        assertTrue(session.tool.enter())
        assertEquals(Lines.of(1.0, 0.0, 0.0, 4.0, 0.0, 4.0, 3.0), path.shape(0))
        session.click(2.0, 5.0)
        session.click(0.0, 5.0)
        session.click(0.0, 5.0, count = 2)
        assertEquals(Lines.of(1.0, 4.0, 3.0, 2.0, 5.0, 0.0, 5.0), path.shape(1))
    }

    @Test
    fun `Backspace takes the last vertex back, but not the end of the path`() {
        session.drawWith(ShapeKind.LINES, 0.0, 0.0, 4.0, 0.0, 4.0, 3.0)
        assertTrue(session.tool.backspace())
        session.click(4.0, 5.0)
        session.tool.enter()
        assertEquals(Lines.of(1.0, 0.0, 0.0, 4.0, 0.0, 4.0, 5.0), path.shape(0))
        assertFalse(session.tool.backspace())
    }

    @Test
    fun `Escape cancels the shape, then leaves the tool`() {
        session.drawWith(ShapeKind.LINES, 0.0, 0.0, 4.0, 0.0)
        assertTrue(session.tool.cancel())
        assertEquals(0, path.shapeCount)
        assertTrue(session.tool is ShapeTool)
        session.tool.cancel()
        assertTrue(session.tool is SelectTool)
    }

    @Test
    fun `a curve closed on its first point has no ends`() {
        session.drawWith(ShapeKind.CURVE, 0.0, 0.0, 4.0, 0.0, 4.0, 3.0, 0.0, 0.0)
        val curve = path.shape(0) as Curve
        assertEquals(CurveEnds.CLOSED, curve.ends)
        assertEquals(3, curve.vertices.size)
    }

    @Test
    fun `all closed shapes are drawn by their points`() {
        session.drawWith(ShapeKind.RECTANGLE, 0.0, 0.0, 20.0, 10.0)
        session.drawWith(ShapeKind.CIRCLE, 3.0, 3.0, 4.0, 3.0)
        session.drawWith(ShapeKind.ELLIPSE, 8.0, 3.0, 10.0, 4.0)
        session.drawWith(ShapeKind.REGULAR_POLYGON, 15.0, 5.0, 17.0, 5.0)
        session.drawWith(ShapeKind.POLYGON, 3.0, 6.0, 6.0, 6.0, 6.0, 8.0, 3.0, 6.0)
        assertEquals(Rectangle(0.0, 0.0, 20.0, 10.0, 1.0), path.shape(0))
        assertEquals(Circle(Point2(4.0, 3.0), Point2(3.0, 3.0), 1.0), path.shape(1))
        assertEquals(Ellipse(8.0, 3.0, 2.0, 1.0, 1.0), path.shape(2))
        assertEquals(Polygon(Point2(17.0, 5.0), Point2(15.0, 5.0), 6, 1.0), path.shape(3))
        assertEquals(Polygon.of(1.0, 3.0, 6.0, 6.0, 6.0, 6.0, 8.0), path.shape(4))
        assertEquals(emptyList<String>(), session.problems.filter { it.isFault }.map { it.message })
        assertEquals(5, session.document.project.toDomain().loopCount)
    }

    @Test
    fun `an arc runs through its third point`() {
        session.drawWith(ShapeKind.ARC, 0.0, 0.0, 4.0, 0.0, 2.0, 2.0)
        assertEquals(-180.0, (path.shape(0) as Arc).angleDegrees, 1e-9)
    }

    @Test
    fun `Up and Down change the number of sides`() {
        session.draw(ShapeKind.REGULAR_POLYGON)
        session.tool.count(-2)
        session.click(0.0, 0.0)
        session.click(2.0, 0.0)
        assertEquals(4, (path.shape(0) as Polygon).vertices.size)
    }

    @Test
    fun `an opening drawn while the walk is open hangs on a connector and is left out`() {
        session.drawWith(ShapeKind.LINES, 0.0, 0.0, 10.0, 0.0, 10.0, 10.0)
        session.tool.enter()
        session.drawWith(ShapeKind.CIRCLE, 6.0, 3.0, 7.0, 3.0)
        session.drawWith(ShapeKind.LINES, 0.0, 10.0, 0.0, 0.0)
        assertTrue(path.isConnector(1))
        assertEquals(emptyList<String>(), session.problems.filter { it.isFault }.map { it.message })
        val domain = session.document.project.toDomain()
        assertEquals(2, domain.loopCount)
        assertTrue(domain.area < 100 && domain.area > 95)
    }

    @Test
    fun `a connector drawn by hand goes back by itself after its opening`() {
        session.drawWith(ShapeKind.RECTANGLE, 0.0, 0.0, 10.0, 10.0)
        session.drawWith(ShapeKind.CONNECTOR, 3.0, 3.0)
        session.drawWith(ShapeKind.CIRCLE, 4.0, 3.0, 3.0, 3.0)
        assertEquals(2, session.document.project.toDomain().loopCount)
        assertEquals(emptyList<String>(), session.problems.filter { it.isFault }.map { it.message })
    }

    @Test
    fun `typed places count like clicks`() {
        session.draw(ShapeKind.LINE)
        session.tool.typed(CoordinateEntry.parse("1,1", session.tool.lastPoint)!!)
        session.tool.typed(CoordinateEntry.parse("@3<90", session.tool.lastPoint)!!)
        assertEquals(Line(1.0, 1.0, 1.0, 4.0, 1.0), path.shape(0))
    }

    @Test
    fun `the preview shows the nodes that will be made`() {
        session.draw(ShapeKind.LINE)
        session.click(0.0, 0.0)
        session.move(PointerInput(4.0, 0.0, PIXEL))
        assertEquals(5, session.tool.preview.nodes.size / 2)
        assertTrue("length 4" in session.tool.preview.measure)
        session.click(4.0, 0.0)
        assertEquals(5, path.nodeCount)
    }

    @Test
    fun `what makes no shape is refused with a reason and drawing goes on`() {
        session.draw(ShapeKind.RECTANGLE)
        session.click(0.0, 0.0)
        session.click(3.0, 0.0)
        assertTrue("height" in session.tool.hint)
        session.click(3.0, 2.0)
        assertEquals(1, path.shapeCount)
    }

    @TestFactory
    fun `undo takes back the whole shape and redo brings it again`(): List<DynamicTest> =
        ShapeKind.entries.map { DynamicTest.dynamicTest(it.label) { drawUndoRedo(it) } }

    private fun drawUndoRedo(kind: ShapeKind) {
        val session = newSession()
        session.drawWith(kind, 0.0, 0.0, 4.0, 1.0, 2.0, 3.0)
        session.tool.enter()
        val drawn = ProjectFile.format(session.document.project)
        assertTrue(session.document.path.shapeCount > 0)
        while (session.undoName != null) session.undo()
        assertEquals(0, session.document.path.shapeCount)
        while (session.redoName != null) session.redo()
        assertEquals(drawn, ProjectFile.format(session.document.project))
    }
}
