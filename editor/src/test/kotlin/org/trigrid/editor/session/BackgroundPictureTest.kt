package org.trigrid.editor.session

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.editor.command.ProjectCommands
import org.trigrid.editor.files.Autosave
import org.trigrid.editor.files.DocumentFile
import org.trigrid.editor.inspector.InspectorViewModel
import org.trigrid.editor.tool.ShapeKind
import org.trigrid.geometry.Point2
import org.trigrid.project.Background
import java.nio.file.Files
import java.nio.file.Path

class BackgroundPictureTest {
    @TempDir
    lateinit var folder: Path

    private val session = newSession()

    private fun lay(isLocked: Boolean = false) {
        val file = folder.resolve("photos/hand.png").toString()
        session.execute(ProjectCommands.picture("set picture", Background(file, Point2(0.0, 0.0), 0.01, 0.0, 0.5, isLocked)))
        session.pictureSize = Point2(400.0, 300.0)
        session.selectTool()
    }

    private val corner: Point2 get() = session.document.picture!!.lowerLeft

    @Test
    fun `a free picture is dragged, in one step, a locked one is not`() {
        lay()
        session.dragFrom(1.0, 1.0, 3.0, 0.5)
        assertEquals(Point2(2.0, -0.5), corner)
        assertEquals("move picture", session.undoName)
        session.undo()
        assertEquals(Point2(0.0, 0.0), corner)
        session.dragFrom(5.0, 1.0, 6.0, 1.0)
        assertEquals(Point2(0.0, 0.0), corner)
        lay(isLocked = true)
        session.dragFrom(1.0, 1.0, 3.0, 0.5)
        assertEquals(Point2(0.0, 0.0), corner)
    }

    @Test
    fun `shapes over the picture come before it`() {
        session.drawWith(ShapeKind.RECTANGLE, 1.0, 1.0, 3.0, 3.0)
        lay()
        session.dragFrom(2.0, 1.0, 2.0, 0.6, alt = true)
        assertEquals("move node", session.undoName)
        assertEquals(Point2(0.0, 0.0), corner)
    }

    @Test
    fun `its fields are checked, and locked ones refused`() {
        lay()
        val model = InspectorViewModel(session)
        val field = { label: String -> model.sections.flatMap { it.fields }.first { it.label == label } }
        assertNull(model.commit(field("Rotation"), "30"))
        assertNull(model.commit(field("Pixel"), "0.02"))
        assertNull(model.commit(field("Opacity"), "80"))
        assertNotNull(model.commit(field("Opacity"), "101"))
        assertNotNull(model.commit(field("Pixel"), "0"))
        val picture = session.document.picture!!
        assertEquals(30.0, picture.rotationDegrees)
        assertEquals(0.02, picture.pixelSize)
        assertEquals(0.8, picture.opacity)
        assertNull(model.commit(field("Position"), "Locked"))
        assertTrue("locked" in model.commit(field("Corner x"), "1")!!)
        assertNull(model.commit(field("Opacity"), "50"))
    }

    @Test
    fun `the project names it relative to its own folder, so that both may be moved together`() {
        session.drawWith(ShapeKind.RECTANGLE, 0.0, 0.0, 4.0, 4.0)
        lay()
        val file = folder.resolve("a.trigrid.json")
        DocumentFile.write(file, session.document)
        assertTrue("\"photos/hand.png\"" in Files.readString(file))
        val elsewhere = Files.createDirectories(folder.resolve("moved/here")).resolve("a.trigrid.json")
        Files.copy(file, elsewhere)
        val read = DocumentFile.read(elsewhere).document
        assertEquals(elsewhere.resolveSibling("photos").resolve("hand.png").toString(), read.picture!!.file)
        val autosave = Autosave(folder.resolve("home"), 1L shl 40)
        autosave.write(null, session.document)
        assertEquals(session.document.picture!!.file, Autosave(folder.resolve("home")).adoptUntitled()!!.picture!!.file)
    }

    @Test
    fun `a mesh stays current when only picture and colours change`() {
        session.drawWith(ShapeKind.RECTANGLE, 0.0, 0.0, 4.0, 4.0)
        session.generate()
        lay()
        session.execute(ProjectCommands.colour("boundary", "#ff0000"))
        assertTrue(session.isMeshCurrent)
        session.execute(ProjectCommands.regionName("steel"))
        assertFalse(session.isMeshCurrent)
    }

    @Test
    fun `colours are kept, go along with their names and are undone`() {
        session.drawWith(ShapeKind.RECTANGLE, 0.0, 0.0, 4.0, 4.0)
        session.execute(ProjectCommands.colour("boundary", "#ff0000"))
        session.execute(ProjectCommands.colour("domain", "#00ff00"))
        session.execute(ProjectCommands.renameGroup("boundary", "edge"))
        session.execute(ProjectCommands.regionName("steel"))
        assertEquals(mapOf("edge" to "#ff0000", "steel" to "#00ff00"), session.document.project.colours)
        val file = folder.resolve("a.trigrid.json")
        DocumentFile.write(file, session.document)
        assertEquals(session.document.project.colours, DocumentFile.read(file).document.project.colours)
        repeat(4) { session.undo() }
        assertTrue(session.document.project.colours.isEmpty())
    }
}
