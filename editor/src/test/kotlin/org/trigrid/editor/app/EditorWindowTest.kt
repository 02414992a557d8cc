package org.trigrid.editor.app

import java.nio.file.Files
import java.util.concurrent.Callable
import java.util.concurrent.TimeUnit
import javafx.scene.Node
import javafx.scene.control.Labeled
import javafx.scene.control.TextField
import javafx.scene.input.KeyCode
import javafx.scene.input.MouseButton
import javafx.stage.Stage
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.testfx.api.FxRobot
import org.testfx.framework.junit5.Start
import org.testfx.util.NodeQueryUtils
import org.testfx.util.WaitForAsyncUtils
import org.trigrid.domain.Path
import org.trigrid.editor.canvas.Box
import org.trigrid.editor.files.Gallery
import org.trigrid.editor.files.Preferences
import org.trigrid.editor.tool.ShapeKind
import org.trigrid.geometry.Point2
import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import org.trigrid.project.Project
import org.trigrid.project.ProjectFile
import org.trigrid.shape.Circle
import org.trigrid.shape.Line
import org.trigrid.shape.Rectangle

/** The window with a real mouse and real keys. */
internal class EditorWindowTest : WindowFixture() {
    @Start
    fun start(stage: Stage) = open(stage)

    @Test
    fun `each shape is drawn with mouse and keys, undone and redone`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        for (kind in ShapeKind.entries) {
            val before = window.session.document.path.shapeCount
            robot.type(KeyCode.valueOf(kind.key))
            for ((x, y) in listOf(2.0 to 2.0, 6.0 to 3.0, 5.0 to 6.0)) robot.clickOn(place(x, y))
            robot.type(KeyCode.ENTER).type(KeyCode.ESCAPE).type(KeyCode.ESCAPE)
            assertTrue(window.session.document.path.shapeCount > before, kind.label)
            val drawn = text()
            robot.push(KeyCode.CONTROL, KeyCode.Z)
            while (window.session.document.path.shapeCount > 0) robot.push(KeyCode.CONTROL, KeyCode.Z)
            while (window.session.redoName != null) robot.push(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.Z)
            assertEquals(drawn, text(), kind.label)
            while (window.session.undoName != null) robot.push(KeyCode.CONTROL, KeyCode.Z)
        }
    }

    @Test
    fun `the saved project equals one made through the library, and the mesh is exported`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.type(KeyCode.R).clickOn(place(1.0, 1.0)).clickOn(place(11.0, 7.0))
        robot.type(KeyCode.O).clickOn(place(5.0, 4.0)).clickOn(place(6.0, 4.0))
        val file = folder.resolve("drawn.trigrid.json")
        assertTrue(onFx { window.files.write(file) })
        val expected = Path.of(Rectangle(1.0, 1.0, 11.0, 7.0, 1.0)).newLoop().append(Circle(Point2(6.0, 4.0), Point2(5.0, 4.0), 1.0))
        assertEquals(ProjectFile.format(Project.of(expected)), Files.readString(file))
        assertFalse(window.stage.title.startsWith("•"))

        robot.type(KeyCode.F5)
        val mesh = waitForMesh()
        assertTrue(mesh.mesh.elementCount > 50)
        MeshFormats.write(mesh.mesh, folder.resolve("drawn.msh"), MeshFormat.MSH_41)
        assertEquals(mesh.mesh.elementCount, MeshFormats.read(folder.resolve("drawn.msh")).elementCount)
    }

    @Test
    fun `places are typed`(robot: FxRobot) {
        robot.type(KeyCode.L)
        robot.write("1,1").type(KeyCode.ENTER)
        robot.write("@3,0").type(KeyCode.ENTER)
        robot.write("@2<90").type(KeyCode.ENTER)
        assertEquals(Line(1.0, 1.0, 4.0, 1.0, 1.0), window.session.document.path.shape(0))
        assertEquals(Line(4.0, 1.0, 4.0, 3.0, 1.0), window.session.document.path.shape(1))
        assertEquals("", robot.lookup("#coordinate-entry").queryAs(TextField::class.java).text)
    }

    @Test
    fun `nodes are dragged and merged`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.type(KeyCode.R).clickOn(place(2.0, 2.0)).clickOn(place(6.0, 6.0))
        robot.type(KeyCode.V)
        robot.drag(place(4.0, 2.0), MouseButton.PRIMARY).dropTo(place(4.0, 1.0))
        assertEquals(Point2(4.0, 1.0), window.session.document.nodes.point(2))
        assertEquals("move node", window.session.undoName)
        robot.drag(place(4.0, 1.0), MouseButton.PRIMARY).dropTo(place(5.0, 2.0))
        assertEquals(15, window.session.document.nodes.count)
        robot.push(KeyCode.CONTROL, KeyCode.Z).push(KeyCode.CONTROL, KeyCode.Z)
        assertEquals(16, window.session.document.nodes.count)
    }

    @Test
    fun `a field of the inspector changes the shape at once and refuses what is wrong`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.type(KeyCode.R).clickOn(place(2.0, 2.0)).clickOn(place(6.0, 6.0))
        robot.type(KeyCode.V).clickOn(place(2.5, 2.0))
        val spacing = robot.lookup("#field-spacing").queryAs(TextField::class.java)
        robot.clickOn(spacing).push(KeyCode.CONTROL, KeyCode.A).write("0.5").type(KeyCode.ENTER)
        assertEquals(32, window.session.document.nodes.count)
        robot.clickOn(spacing).push(KeyCode.CONTROL, KeyCode.A).write("-1").type(KeyCode.ENTER)
        assertEquals(32, window.session.document.nodes.count)
        val fault = robot.lookup(".field-fault").match<Node> { it.isVisible && (it as Labeled).text.isNotEmpty() }.tryQuery<Node>()
        assertTrue(fault.isPresent)
    }

    @Test
    fun `an opening is connected and the front is played by keys`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.type(KeyCode.R).clickOn(place(1.0, 1.0)).clickOn(place(11.0, 7.0))
        robot.type(KeyCode.O).clickOn(place(5.0, 4.0)).clickOn(place(6.0, 4.0))
        robot.type(KeyCode.V).clickOn(place(4.03, 4.2))
        robot.push(KeyCode.CONTROL, KeyCode.K)
        assertEquals("connect opening", window.session.undoName)
        assertEquals(1, window.session.document.path.walks().size)

        robot.push(KeyCode.SHIFT, KeyCode.F6)
        WaitForAsyncUtils.waitFor(20, TimeUnit.SECONDS, Callable { onFx { window.session.playback != null } })
        robot.type(KeyCode.RIGHT).type(KeyCode.RIGHT).type(KeyCode.LEFT)
        assertEquals(1, onFx { window.session.playback!!.position })
        robot.type(KeyCode.SPACE)
        WaitForAsyncUtils.waitFor(20, TimeUnit.SECONDS, Callable { onFx { window.session.playback!!.position > 3 } })
        robot.clickOn("#front-step")
        assertFalse(onFx { window.session.playback!!.isPlaying })
        robot.clickOn("#front-last")
        assertEquals(0, onFx { window.session.playback!!.front.size })
        robot.clickOn("#front-stop")
        assertNull(onFx { window.session.playback })
    }

    @Test
    fun `Alt held for the mouse suspends snapping and does not open the menu`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.type(KeyCode.L).moveTo(place(2.03, 2.04)).press(KeyCode.ALT).moveTo(place(2.031, 2.041)).clickOn(MouseButton.PRIMARY).release(KeyCode.ALT)
        robot.write("5").type(KeyCode.TAB).write("3").type(KeyCode.ENTER)
        val line = window.session.document.path.shape(0) as Line
        assertEquals(Point2(5.0, 3.0), line.lastPoint)
        assertTrue(line.firstPoint != Point2(2.0, 2.0) && line.firstPoint.distanceTo(Point2(2.0, 2.0)) < 0.1)
    }

    @Test
    fun `a picture laid behind is shown, dragged and locked`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        val file = folder.resolve("behind.png")
        val red = java.awt.image.BufferedImage(60, 40, java.awt.image.BufferedImage.TYPE_INT_RGB)
        for (x in 0 until 60) for (y in 0 until 40) red.setRGB(x, y, 0xFF0000)
        javax.imageio.ImageIO.write(red, "png", file.toFile())
        onFx { window.setPicture(file) }
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        WaitForAsyncUtils.waitFor(20, TimeUnit.SECONDS, Callable { onFx { window.session.pictureSize != null } })
        assertTrue(colourAt(6.13, 4.13).let { it.red > 0.9 && it.green < 0.7 })
        val before = window.session.document.picture!!.lowerLeft
        robot.drag(place(6.0, 4.0), MouseButton.PRIMARY).dropTo(place(7.0, 4.0))
        assertEquals(before.x + 1, window.session.document.picture!!.lowerLeft.x, 0.05)
        robot.push(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.L)
        assertEquals("lock picture", window.session.undoName)
        robot.drag(place(6.0, 4.0), MouseButton.PRIMARY).dropTo(place(5.0, 4.0))
        assertEquals("lock picture", window.session.undoName)
    }

    @Test
    fun `meshing in the background is cancelled`(robot: FxRobot) {
        onFx {
            window.openCase(Gallery.HAND)
            val fine = window.session.document.project.options.toBuilder().maxSize(0.012).build()
            window.session.execute(org.trigrid.editor.command.ProjectCommands.options("largest", fine))
        }
        robot.type(KeyCode.F5)
        WaitForAsyncUtils.waitFor(20, TimeUnit.SECONDS, Callable { onFx { window.session.progress != null } })
        robot.type(KeyCode.ESCAPE)
        WaitForAsyncUtils.waitFor(20, TimeUnit.SECONDS, Callable { onFx { window.session.progress == null } })
        assertNull(window.session.mesh)
        assertEquals("Meshing cancelled", window.session.message)
    }

    @Test
    fun `live meshes follow the drawing, in both themes`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.clickOn("#live")
        robot.type(KeyCode.R).clickOn(place(2.0, 2.0)).clickOn(place(6.0, 6.0))
        val first = waitForMesh()
        for (theme in Theme.entries) onFx { window.chooseTheme(theme) }
        assertEquals("DARK", Preferences(folder)["theme"])
        robot.type(KeyCode.O).clickOn(place(4.0, 4.0)).clickOn(place(5.0, 4.0))
        WaitForAsyncUtils.waitFor(20, TimeUnit.SECONDS, Callable { onFx { window.session.mesh !== first && window.session.isMeshCurrent } })
    }

    @Test
    fun `closing asks to save, and Cancel stays`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.type(KeyCode.R).clickOn(place(2.0, 2.0)).clickOn(place(6.0, 6.0))
        WaitForAsyncUtils.asyncFx { window.exit() }
        WaitForAsyncUtils.waitFor(10, TimeUnit.SECONDS, Callable { robot.lookup("Cancel").match(NodeQueryUtils.isVisible()).tryQuery<Node>().isPresent })
        robot.clickOn("Cancel")
        assertTrue(window.stage.isShowing)
        assertTrue(window.stage.title.startsWith("•"))
    }
}
