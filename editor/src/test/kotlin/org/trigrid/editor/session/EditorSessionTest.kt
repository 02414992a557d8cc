package org.trigrid.editor.session

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.editor.command.AddShapes
import org.trigrid.editor.command.ConnectOpenings
import org.trigrid.editor.command.ProjectCommands
import org.trigrid.editor.command.TransformSelection
import org.trigrid.editor.document.Selection
import org.trigrid.editor.meshing.MeshSummaryViewModel
import org.trigrid.editor.tool.ShapeKind
import org.trigrid.geometry.Point2
import org.trigrid.project.ProjectFile
import org.trigrid.shape.Similarity
import java.nio.file.Path

class EditorSessionTest {
    private val session = newSession()

    @Test
    fun `crossing lines are found and split where they cross`() {
        session.drawWith(ShapeKind.LINES, 0.0, 0.0, 8.0, 0.0, 2.0, 5.0, 8.0, 5.0, 0.0, 0.0)
        val crossing = session.problems.single { it.title == "Lines cross" }
        assertTrue(session.execute(crossing.fix!!))
        assertEquals("split at the crossing", session.undoName)
        assertFalse(session.problems.any { it.title == "Lines cross" })
    }

    @Test
    fun `faults are shown while the walk is open`() {
        session.drawWith(ShapeKind.LINES, 0.0, 0.0, 8.0, 0.0, 2.0, 5.0, 8.0, 5.0, 0.0, 0.4)
        session.tool.enter()
        assertEquals(setOf("Not closed", "Lines cross"), session.problems.map { it.title }.toSet())
        session.execute(session.problems.first { it.title == "Not closed" }.fix!!)
        assertFalse(session.problems.any { it.title == "Not closed" })
    }

    @Test
    fun `a mesh is made on demand and stays while the drawing goes on`() {
        session.generate()
        assertTrue("closed shape" in session.message)
        session.drawWith(ShapeKind.RECTANGLE, 0.0, 0.0, 6.0, 4.0)
        session.generate()
        val mesh = assertNotNull(session.mesh).let { session.mesh!! }
        assertTrue(session.isMeshCurrent)
        assertTrue("elements" in MeshSummaryViewModel.of(mesh).counts)
        session.drawWith(ShapeKind.CIRCLE, 3.0, 2.0, 4.0, 2.0)
        assertEquals(mesh, session.mesh)
        assertFalse(session.isMeshCurrent)
        session.undo()
        assertTrue(session.isMeshCurrent)
    }

    @Test
    fun `a faulty domain is told of and the last mesh stays`() {
        session.isLive = true
        session.drawWith(ShapeKind.RECTANGLE, 0.0, 0.0, 6.0, 4.0)
        val mesh = session.mesh
        assertNotNull(mesh)
        session.drawWith(ShapeKind.RECTANGLE, 3.0, 2.0, 9.0, 7.0)
        assertTrue(session.problems.any { it.isFault })
        assertEquals(mesh, session.mesh)
        session.generate()
        assertTrue(session.isMessageError)
    }

    @Test
    fun `options, defaults and names are steps like all others`() {
        session.drawWith(ShapeKind.RECTANGLE, 0.0, 0.0, 6.0, 4.0)
        val before = ProjectFile.format(session.document.project)
        session.execute(ProjectCommands.options("gradation", session.document.project.options.toBuilder().gradation(0.1).build()))
        session.execute(ProjectCommands.regionName("steel"))
        session.execute(ProjectCommands.renameGroup("boundary", "edge"))
        assertEquals(listOf("edge"), session.document.groups)
        assertEquals("rename group", session.undoName)
        repeat(3) { session.undo() }
        assertEquals(before, ProjectFile.format(session.document.project))
    }

    @Test
    fun `a copy pasted is a loop of its own`() {
        session.drawWith(ShapeKind.LINES, 0.0, 0.0, 2.0, 0.0, 2.0, 2.0, 0.0, 0.0)
        val clip = Clip.of(session.document, Selection.all(session.document))
        val pasted = Clip.parse(clip.toText())!!.moved(Similarity.translation(5.0, 0.0))
        session.execute(AddShapes(pasted.shapes, pasted.loops, "paste"))
        assertEquals(2, session.document.project.toDomain().loopCount)
        assertEquals(setOf(1), session.selection.shapes)
        assertNull(Clip.parse("no shapes"))
        assertEquals(1, Clip.parse("0 0\n1 0\n0 1")!!.loops.size)
    }

    @Test
    fun `a copy goes without connectors, so that it can be meshed`() {
        session.drawWith(ShapeKind.RECTANGLE, 0.0, 0.0, 6.0, 4.0)
        session.drawWith(ShapeKind.CIRCLE, 3.0, 2.0, 4.0, 2.0)
        session.execute(ConnectOpenings(ConnectOpenings.of(session.document, Selection.NONE)))
        val copy = Clip.of(session.document, Selection.all(session.document)).moved(Similarity.translation(9.0, 0.0))
        session.execute(AddShapes(copy.shapes, copy.loops, "paste"))
        assertEquals(emptyList<String>(), session.problems.filter { it.isFault }.map { it.message })
        assertEquals(4, session.document.project.toDomain().loopCount)
    }

    @Test
    fun `what hangs together is turned together`() {
        session.drawWith(ShapeKind.LINE, 0.0, 0.0, 4.0, 0.0, 4.0, 3.0, 0.0, 0.0)
        session.selectTool()
        session.select(Selection.all(session.document))
        session.execute(TransformSelection(Similarity.rotation(Point2(0.0, 0.0), 90.0), "rotate"))
        assertEquals(emptyList<String>(), session.problems.filter { it.isFault }.map { it.message })
        assertEquals(6.0, session.document.project.toDomain().area, 1e-12)
    }

    @Test
    fun `one shape moved takes the ends of its neighbours along`() {
        session.drawWith(ShapeKind.LINE, 0.0, 0.0, 4.0, 0.0, 4.0, 3.0, 0.0, 0.0)
        session.selectTool()
        session.select(Selection.ofShape(0))
        session.execute(TransformSelection(Similarity.translation(0.0, -1.0), "move"))
        assertEquals(emptyList<String>(), session.problems.filter { it.isFault }.map { it.message })
        assertEquals(8.0, session.document.project.toDomain().area, 1e-12)
    }

    @Test
    fun `what is saved is not modified until it is changed`() {
        session.drawWith(ShapeKind.CIRCLE, 0.0, 0.0, 2.0, 0.0)
        assertTrue(session.isModified)
        session.saved(session.document, Path.of("a.trigrid.json"))
        assertFalse(session.isModified)
        session.undo()
        assertTrue(session.isModified)
        session.redo()
        assertFalse(session.isModified)
    }
}
