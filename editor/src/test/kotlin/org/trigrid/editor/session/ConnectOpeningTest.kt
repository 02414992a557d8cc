package org.trigrid.editor.session

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.editor.command.ConnectOpenings
import org.trigrid.editor.document.Selection
import org.trigrid.editor.document.ShapeHandles
import org.trigrid.editor.document.ShapeRole
import org.trigrid.editor.tool.ShapeKind
import org.trigrid.project.ProjectFile

class ConnectOpeningTest {
    private val session = newSession()

    private fun plate() {
        session.drawWith(ShapeKind.RECTANGLE, 0.0, 0.0, 12.0, 8.0)
        session.drawWith(ShapeKind.CIRCLE, 3.0, 4.0, 4.0, 4.0)
        session.drawWith(ShapeKind.CIRCLE, 8.0, 4.0, 9.0, 4.0)
        session.selectTool()
    }

    @Test
    fun `the opening picked is connected in one step`() {
        plate()
        val before = ProjectFile.format(session.document.project)
        val area = session.document.project.toDomain().area
        session.select(Selection.ofShape(2))
        val openings = ConnectOpenings.of(session.document, session.selection)
        assertEquals(listOf(2), openings)
        assertTrue(session.execute(ConnectOpenings(openings)))
        assertEquals("connect opening", session.undoName)
        assertEquals(2, session.document.path.walks().size)
        assertEquals(setOf(3), session.selection.shapes)
        assertEquals(area, session.document.project.toDomain().area, 1e-9)
        assertFalse(session.problems.any { it.isFault })
        assertTrue(ConnectOpenings.of(session.document, Selection.ofShape(2)).isEmpty())
        session.undo()
        assertEquals(before, ProjectFile.format(session.document.project))
    }

    @Test
    fun `all openings are connected where nothing is picked`() {
        plate()
        session.execute(ConnectOpenings(ConnectOpenings.of(session.document, Selection.NONE)))
        assertEquals("connect 2 openings", session.undoName)
        assertEquals(1, session.document.path.walks().size)
        session.generate()
        assertTrue(session.isMeshCurrent)
    }

    @Test
    fun `a connector between walks is not pulled, it goes where its nodes go`() {
        plate()
        session.execute(ConnectOpenings(listOf(1)))
        assertTrue(ShapeHandles.of(session.document.path, 3).isEmpty())
        val before = session.document.path.shape(3).lastPoint
        val node = session.document.nodes.at(before.x, before.y)
        session.select(Selection.ofNode(node))
        session.dragFrom(before.x, before.y, before.x - 0.4, before.y, alt = true)
        assertFalse(session.problems.any { it.isFault })
    }

    @Test
    fun `roles are told in words`() {
        plate()
        val role = { shape: Int -> ShapeRole.of(session.document, shape) }
        assertEquals("Bounds the domain", role(0))
        assertEquals("Opening: left out", role(1))
        session.execute(ConnectOpenings(listOf(1, 2)))
        assertEquals("Opening: left out", role(1))
        assertEquals("Connector, there and back", role(3))
        session.drawWith(ShapeKind.LINE, 20.0, 0.0, 22.0, 0.0)
        assertEquals("Part of an open line", role(5))
    }

    @Test
    fun `loops split at a crossing are mended to the end`() {
        session.drawWith(ShapeKind.LINES, 0.0, 0.0, 8.0, 0.0, 2.0, 5.0, 8.0, 5.0, 0.0, 0.0)
        session.execute(session.problems.single { it.title == "Lines cross" }.fix!!)
        session.execute(session.problems.single { it.title == "Hole outside" }.fix!!)
        assertEquals("turn the loop round", session.undoName)
        assertFalse(session.problems.any { it.isFault })
        session.generate()
        assertTrue(session.isMeshCurrent)
    }

    @Test
    fun `ends that nearly meet are snapped together`() {
        session.drawWith(ShapeKind.LINES, 0.0, 0.0, 8.0, 0.0, 8.0, 5.0, 0.0, 0.4)
        session.tool.enter()
        session.execute(session.problems.single { it.title == "Not closed" }.fix!!)
        assertEquals("snap the ends together", session.undoName)
        assertFalse(session.problems.any { it.isFault })
        assertEquals(20.0, session.document.project.toDomain().area, 1e-9)
    }
}
