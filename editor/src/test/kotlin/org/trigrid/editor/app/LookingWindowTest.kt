package org.trigrid.editor.app

import java.nio.file.Files
import java.util.concurrent.Callable
import java.util.concurrent.TimeUnit
import javafx.scene.Node
import javafx.scene.control.ChoiceBox
import javafx.scene.control.ColorPicker
import javafx.scene.control.Hyperlink
import javafx.scene.control.TabPane
import javafx.scene.input.Clipboard
import javafx.scene.input.ClipboardContent
import javafx.scene.input.KeyCode
import javafx.scene.input.MouseButton
import javafx.scene.paint.Color
import javafx.stage.Stage
import javax.imageio.ImageIO
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.testfx.api.FxRobot
import org.testfx.framework.junit5.Start
import org.testfx.util.WaitForAsyncUtils
import org.trigrid.editor.canvas.Box
import org.trigrid.editor.files.Gallery
import org.trigrid.editor.meshing.Colouring
import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats

/** Picking, looking and exporting with a real mouse and real keys. */
internal class LookingWindowTest : WindowFixture() {
    @Start
    fun start(stage: Stage) = open(stage)

    @Test
    fun `nodes are inserted, picked by a lasso, found and pasted`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.type(KeyCode.R).clickOn(place(2.0, 2.0)).clickOn(place(6.0, 6.0))
        robot.type(KeyCode.V).doubleClickOn(place(2.5, 2.0))
        assertEquals("insert node", onFx { window.session.undoName })
        assertEquals(17, onFx { window.session.document.nodes.count })

        robot.push(KeyCode.SHIFT, KeyCode.V)
        robot.moveTo(place(5.5, 1.5)).press(MouseButton.PRIMARY)
        for ((x, y) in listOf(6.5 to 1.5, 6.5 to 4.5, 5.5 to 4.5, 5.5 to 1.6)) robot.moveTo(place(x, y))
        robot.release(MouseButton.PRIMARY)
        assertEquals(3, onFx { window.session.selection.nodes.size })
        robot.type(KeyCode.DELETE)
        assertEquals("delete 3 nodes", onFx { window.session.undoName })

        onFx { Clipboard.getSystemClipboard().setContent(ClipboardContent().apply { putString("8 2\n10 2\n9 5") }) }
        robot.push(KeyCode.CONTROL, KeyCode.V)
        assertEquals(1, onFx { window.session.document.loops.size })
        robot.push(KeyCode.CONTROL, KeyCode.D)
        assertEquals("duplicate", onFx { window.session.undoName })
        robot.push(KeyCode.CONTROL, KeyCode.Z).push(KeyCode.CONTROL, KeyCode.Z)
        assertEquals(0, onFx { window.session.document.loops.size })
    }

    @Test
    fun `one click on an arrow turns the shape round`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.type(KeyCode.O).clickOn(place(5.0, 4.0)).clickOn(place(8.0, 4.0)).type(KeyCode.V)
        val arrow = onFx { window.session.document.arrows.single().place }
        robot.clickOn(place(arrow.x, arrow.y))
        assertEquals("change direction", onFx { window.session.undoName })
    }

    @Test
    fun `elements are coloured, pointed at, and the worst are gone to`(robot: FxRobot) {
        onFx { window.openCase(Gallery.OWEN) }
        robot.type(KeyCode.F5)
        val mesh = waitForMesh()
        onFx { (window.stage.scene.lookup(".tab-pane") as TabPane).selectionModel.select(2) }
        val colouring = robot.lookup("#colouring").queryAs(ChoiceBox::class.java)
        for (kind in Colouring.entries) {
            @Suppress("UNCHECKED_CAST")
            onFx { (colouring as ChoiceBox<String>).value = kind.label }
            assertEquals(kind, onFx { window.session.view.colouring })
        }
        val before = onFx { window.canvas.transform.scale }
        robot.clickOn(robot.lookup(".hyperlink").queryAll<Hyperlink>().first { it.text.startsWith("Element") })
        assertNotEquals(before, onFx { window.canvas.transform.scale })
        assertEquals(1, onFx { window.canvas.markedElements.size })
        val element = onFx { window.canvas.markedElements.single() }
        val x = (0..2).sumOf { mesh.mesh.x(mesh.mesh.nodeOf(element, it)) } / 3
        val y = (0..2).sumOf { mesh.mesh.y(mesh.mesh.nodeOf(element, it)) } / 3
        WaitForAsyncUtils.sleep(300, TimeUnit.MILLISECONDS)
        robot.moveTo(place(x, y))
        WaitForAsyncUtils.waitFor(10, TimeUnit.SECONDS, Callable { robot.lookup("element $element: quality", ).tryQuery<Node>().isPresent || hover(robot, element) })
    }

    private fun hover(robot: FxRobot, element: Int): Boolean =
        robot.lookup(".label").queryAll<javafx.scene.control.Label>().any { it.text.startsWith("element $element:") }

    @Test
    fun `faults are listed and mended by their buttons`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.type(KeyCode.P)
        for ((x, y) in listOf(1.0 to 1.0, 9.0 to 1.0, 3.0 to 6.0, 9.0 to 6.0, 1.0 to 1.0)) robot.clickOn(place(x, y))
        robot.type(KeyCode.F4)
        robot.clickOn("Split at the crossing")
        WaitForAsyncUtils.waitFor(10, TimeUnit.SECONDS, Callable { robot.lookup("Turn the loop round").tryQuery<Node>().isPresent })
        robot.clickOn("Turn the loop round")
        WaitForAsyncUtils.waitFor(10, TimeUnit.SECONDS, Callable { onFx { window.session.problems.none { it.isFault } } })
    }

    @Test
    fun `what is exported is what is named and shown`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.type(KeyCode.R).clickOn(place(2.0, 2.0)).clickOn(place(6.0, 6.0))
        onFx {
            window.session.execute(org.trigrid.editor.command.ProjectCommands.renameGroup("boundary", "rim"))
            window.session.execute(org.trigrid.editor.command.ProjectCommands.regionName("steel"))
        }
        robot.type(KeyCode.F5)
        waitForMesh()
        assertTrue(onFx { window.export.writeMesh(folder.resolve("a.msh"), MeshFormat.MSH_22) })
        val text = Files.readString(folder.resolve("a.msh"))
        assertTrue("\"rim\"" in text && "\"steel\"" in text)
        assertEquals(onFx { window.session.mesh!!.mesh.elementCount }, MeshFormats.read(folder.resolve("a.msh")).elementCount)
        assertTrue(onFx { window.export.writeMesh(folder.resolve("six.msh"), MeshFormat.MSH_22, 2) })
        assertTrue(Files.readAllLines(folder.resolve("six.msh")).any { Regex("\\d+ 9 2 .*").matches(it) })
        assertTrue(onFx { window.export.writeSvg(folder.resolve("a.svg")) })
        assertTrue(Files.readString(folder.resolve("a.svg")).contains("<svg"))
        assertTrue(onFx { window.export.writePng(folder.resolve("a.png")) })
        val image = ImageIO.read(folder.resolve("a.png").toFile())
        assertEquals(onFx { 2 * window.canvas.width.toInt() }, image.width)
        assertFalse(onFx { window.export.writeMesh(folder.resolve("no/such/folder/a.msh"), MeshFormat.MSH_22) })
        WaitForAsyncUtils.waitForFxEvents()
        robot.type(KeyCode.ESCAPE)
    }

    @Test
    fun `groups are given colours`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.type(KeyCode.R).clickOn(place(2.0, 2.0)).clickOn(place(6.0, 6.0))
        onFx { (window.stage.scene.lookup(".tab-pane") as TabPane).selectionModel.select(1) }
        WaitForAsyncUtils.waitForFxEvents()
        onFx {
            val box = window.stage.scene.lookup("#colour-boundary") as ColorPicker
            box.value = Color.web("#ff0000")
            box.fireEvent(javafx.event.ActionEvent())
        }
        assertEquals(mapOf("boundary" to "#ff0000"), onFx { window.session.document.project.colours })
        assertEquals("colour of boundary", onFx { window.session.undoName })
        WaitForAsyncUtils.sleep(300, TimeUnit.MILLISECONDS)
        val ink = colourAt(2.6, 2.0)
        assertTrue(ink.red > 0.8 && ink.green < 0.5, ink.toString())
    }

    @Test
    fun `a file dropped is opened, a picture is laid behind, the sheet of keys is shown`(robot: FxRobot) {
        onFx { window.drop(java.nio.file.Path.of("..", "src-test-data", "domains", "lake.geojson").toAbsolutePath().normalize()) }
        WaitForAsyncUtils.waitForFxEvents()
        assertTrue(onFx { window.session.document.loops.size } > 1)
        robot.type(KeyCode.F1)
        WaitForAsyncUtils.waitFor(10, TimeUnit.SECONDS, Callable { robot.lookup(".key-cap").queryAll<Node>().size > 40 })
        robot.clickOn("Close")
    }

    @Test
    fun `faults are mended and bars chosen with keys alone`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.type(KeyCode.P)
        for ((x, y) in listOf(1.0 to 1.0, 9.0 to 1.0, 2.0 to 6.0, 9.0 to 6.0, 1.0 to 1.0)) robot.clickOn(place(x, y))
        robot.type(KeyCode.V).moveTo(place(11.0, 7.0))
        WaitForAsyncUtils.waitFor(10, TimeUnit.SECONDS, Callable { onFx { window.session.problems.any { it.fix != null } } })
        robot.type(KeyCode.F4)
        val row = onFx { window.session.problems.indexOfFirst { it.fix != null } }
        repeat(row) { robot.type(KeyCode.DOWN) }
        robot.type(KeyCode.SPACE)
        assertEquals("split at the crossing", onFx { window.session.undoName })
        robot.type(KeyCode.F4)
        assertTrue(onFx { window.canvas.isFocused })

        onFx { window.session.open(Gallery.OWEN.document(), null) }
        robot.type(KeyCode.F5)
        waitForMesh()
        onFx { (window.stage.scene.lookup(".tab-pane") as TabPane).selectionModel.select(2) }
        WaitForAsyncUtils.waitForFxEvents()
        onFx { window.stage.scene.lookup("#histogram").requestFocus() }
        robot.type(KeyCode.RIGHT)
        val best = onFx { window.canvas.markedElements.size }
        robot.type(KeyCode.LEFT)
        assertTrue(onFx { window.canvas.markedElements.size } in 1 until best)
    }
}
