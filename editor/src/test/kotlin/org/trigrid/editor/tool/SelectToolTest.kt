package org.trigrid.editor.tool

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.trigrid.editor.command.DeleteSelection
import org.trigrid.editor.command.SpreadNodes
import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.document.Selection
import org.trigrid.editor.session.PIXEL
import org.trigrid.editor.session.click
import org.trigrid.editor.session.dragFrom
import org.trigrid.editor.session.drawWith
import org.trigrid.editor.session.newSession
import org.trigrid.project.NodeLoop
import org.trigrid.project.Project
import org.trigrid.geometry.Point2
import org.trigrid.shape.Direction
import org.trigrid.shape.Rectangle

class SelectToolTest {
    private val session = newSession()

    @BeforeEach
    fun square() {
        session.drawWith(ShapeKind.RECTANGLE, 0.0, 0.0, 4.0, 4.0)
        session.selectTool()
    }

    @Test
    fun `a click picks the node, or the shape beside nodes`() {
        session.click(2.0, 0.02)
        assertEquals(setOf(2), session.selection.nodes)
        session.click(2.5, 0.02)
        assertEquals(setOf(0), session.selection.shapes)
        session.click(2.0, 2.0)
        assertTrue(session.selection.isEmpty)
    }

    @Test
    fun `Shift adds and takes away`() {
        session.click(1.0, 0.0)
        session.click(2.0, 0.0, shift = true)
        assertEquals(setOf(1, 2), session.selection.nodes)
        session.click(1.0, 0.0, shift = true)
        assertEquals(setOf(2), session.selection.nodes)
    }

    @Test
    fun `a node dragged goes with the mouse in one step`() {
        session.dragFrom(2.0, 0.0, 2.0, -1.0)
        assertEquals(Point2(2.0, -1.0), session.document.nodes.point(2))
        assertEquals("move node", session.undoName)
        session.undo()
        assertEquals("draw rectangle", session.undoName)
        assertEquals(Point2(2.0, 0.0), session.document.nodes.point(2))
    }

    @Test
    fun `a node dropped on another merges, the higher number goes`() {
        assertEquals(16, session.document.nodes.count)
        session.dragFrom(2.0, 0.0, 3.0, 0.0)
        assertEquals(15, session.document.nodes.count)
        assertEquals(Point2(3.0, 0.0), session.document.nodes.point(2))
        assertEquals(Point2(4.0, 0.0), session.document.nodes.point(3))
    }

    @Test
    fun `several nodes move together and do not merge with one another`() {
        session.dragFrom(0.5, -0.5, 3.5, 0.5)
        assertEquals(setOf(1, 2, 3), session.selection.nodes)
        session.dragFrom(2.0, 0.0, 2.0, 1.0)
        assertEquals(16, session.document.nodes.count)
        assertEquals(listOf(1.0, 1.0, 1.0), listOf(1, 2, 3).map { session.document.nodes.y(it) })
        session.dragFrom(2.0, 1.0, 3.0, 1.0)
        assertEquals(listOf(2.0, 3.0, 4.0), listOf(1, 2, 3).map { session.document.nodes.x(it) })
    }

    @Test
    fun `a lasso picks what it goes round`() {
        session.selectTool(isLasso = true)
        session.press(PointerInput(0.5, 0.5, PIXEL))
        for ((x, y) in listOf(2.5 to 0.5, 2.5 to -0.5, 0.5 to -0.5)) session.drag(PointerInput(x, y, PIXEL))
        session.release(PointerInput(0.5, 0.4, PIXEL))
        assertEquals(setOf(1, 2), session.selection.nodes)
    }

    @Test
    fun `a shape dragged moves whole`() {
        session.dragFrom(2.5, 0.0, 3.5, 1.0)
        assertEquals(Rectangle(1.0, 1.0, 5.0, 5.0, 1.0), session.document.path.shape(0))
    }

    @Test
    fun `a corner pulled changes the rectangle, which is exploded anew`() {
        session.click(2.5, 0.0)
        session.dragFrom(4.0, 4.0, 6.0, 5.0)
        assertEquals(Rectangle(0.0, 0.0, 6.0, 5.0, 1.0), session.document.path.shape(0))
        assertEquals(22, session.document.nodes.count)
    }

    @Test
    fun `one click on an arrow turns its shape round, and picks it`() {
        val arrow = session.document.arrows.single()
        session.click(arrow.place.x, arrow.place.y)
        assertEquals(Direction.CLOCKWISE, (session.document.path.shape(0) as Rectangle).direction)
        assertEquals("change direction", session.undoName)
        assertEquals(setOf(0), session.selection.shapes)
        session.undo()
        session.click(arrow.place.x, arrow.place.y, shift = true)
        assertEquals(Direction.ANTICLOCKWISE, (session.document.path.shape(0) as Rectangle).direction)
    }

    @Test
    fun `a double click on a segment inserts a node`() {
        session.click(2.5, 0.0, count = 2)
        assertEquals(17, session.document.nodes.count)
        assertEquals(setOf(3), session.selection.nodes)
        assertEquals(Point2(2.5, 0.0), session.document.nodes.point(3))
    }

    @Test
    fun `nodes picked are deleted, else the shape`() {
        session.dragFrom(0.5, -0.5, 3.5, 0.5)
        session.execute(DeleteSelection(session.selection))
        assertEquals(13, session.document.nodes.count)
        session.click(2.0, 0.0)
        assertEquals(setOf(0), session.selection.shapes)
        session.execute(DeleteSelection(session.selection))
        assertEquals(0, session.document.path.shapeCount)
    }

    @Test
    fun `nodes between two are spread anew`() {
        assertTrue(session.execute(SpreadNodes(0, 4, 0.5, 1.0)))
        assertEquals(20, session.document.nodes.count)
        assertEquals((0..8).map { it * 0.5 }, (0..8).map { session.document.nodes.x(it) })
        session.undo()
        session.execute(SpreadNodes(4, 0, 2.0, 1.0))
        assertEquals(14, session.document.nodes.count)
        assertEquals(emptyList<String>(), session.problems.filter { it.isFault }.map { it.message })
    }

    @Test
    fun `Alt lets the mouse go free of the grid`() {
        session.dragFrom(2.0, 0.0, 2.013, -1.017, alt = true)
        assertEquals(Point2(2.013, -1.017), session.document.nodes.point(2))
    }

    @Test
    fun `loops of plain nodes are edited alike`() {
        val loop = NodeLoop(doubleArrayOf(0.0, 0.0, 2.0, 0.0, 2.0, 2.0, 0.0, 2.0), "edge")
        session.open(EditorDocument(Project.builder().loops(listOf(loop)).build()), null)
        session.dragFrom(2.0, 2.0, 3.0, 3.0)
        assertEquals(Point2(3.0, 3.0), session.document.nodes.point(2))
        session.click(1.0, 0.0, count = 2)
        assertEquals(5, session.document.nodes.count)
        session.execute(DeleteSelection(Selection.ofNode(1)))
        assertEquals(4, session.document.nodes.count)
        session.click(0.0, 1.0)
        assertEquals(setOf(0), session.selection.loops)
        session.execute(DeleteSelection(session.selection))
        assertTrue(session.document.isEmpty)
    }
}
