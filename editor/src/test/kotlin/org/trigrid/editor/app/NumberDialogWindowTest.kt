package org.trigrid.editor.app

import java.util.concurrent.Callable
import java.util.concurrent.TimeUnit
import javafx.css.PseudoClass
import javafx.scene.Node
import javafx.scene.control.Labeled
import javafx.scene.control.TextField
import javafx.scene.input.Clipboard
import javafx.scene.input.ClipboardContent
import javafx.scene.input.KeyCode
import javafx.stage.Stage
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.testfx.api.FxRobot
import org.testfx.framework.junit5.Start
import org.testfx.util.WaitForAsyncUtils
import org.trigrid.editor.canvas.Box
import org.trigrid.editor.document.Selection
import org.trigrid.geometry.Point2
import org.trigrid.project.Background
import org.trigrid.shape.Rectangle

/** Numbers asked for by dialogs, answered with real keys and nothing else: what stands there at first is typed over. */
internal class NumberDialogWindowTest : WindowFixture() {
    @Start
    fun start(stage: Stage) = open(stage)

    @Test
    fun `a node is found by its number, and a number that is none keeps the dialog`(robot: FxRobot) {
        drawRectangle(robot)
        robot.push(KeyCode.CONTROL, KeyCode.F)
        val field = field("number")
        robot.write("9").type(KeyCode.ENTER)
        assertEquals(setOf(9), onFx { window.session.selection.nodes })
        assertTrue(isGone(field))

        robot.push(KeyCode.CONTROL, KeyCode.F)
        val again = field("number")
        assertEquals("9", again.text)
        for (wrong in listOf("16", "-1", "1.5", "x", "")) {
            robot.push(KeyCode.CONTROL, KeyCode.A).type(KeyCode.DELETE).write(wrong).type(KeyCode.ENTER)
            assertTrue(isMarked(again), wrong)
            assertTrue(robot.lookup(".field-fault").queryAll<Labeled>().any { it.isVisible && it.text.contains("from 0 to 15") }, wrong)
        }
        robot.write("3")
        WaitForAsyncUtils.waitForFxEvents()
        assertTrue(!isMarked(again))
        robot.type(KeyCode.ENTER)
        assertEquals(setOf(3), onFx { window.session.selection.nodes })
    }

    @Test
    fun `Esc gives up without a change`(robot: FxRobot) {
        drawRectangle(robot)
        choose("Rotate…")
        val field = field("angle-degrees")
        robot.write("45").type(KeyCode.ESCAPE)
        assertTrue(isGone(field))
        assertEquals("draw rectangle", onFx { window.session.undoName })
    }

    @Test
    fun `what is picked is turned about its very middle`(robot: FxRobot) {
        drawRectangle(robot)
        val before = nodes()
        choose("Rotate…")
        field("angle-degrees")
        robot.write("90").type(KeyCode.ENTER)
        assertEquals("rotate", onFx { window.session.undoName })
        assertEquals(before.map { Point2(4 - (it.y - 4), 4 + (it.x - 4)) }.toSet(), nodes().toSet())

        choose("Rotate…")
        field("angle-degrees")
        robot.write("180").type(KeyCode.TAB).write("0").type(KeyCode.TAB).write("0").type(KeyCode.ENTER)
        WaitForAsyncUtils.waitForFxEvents()
        assertTrue(nodes().all { it.x in -6.0..-2.0 && it.y in -6.0..-2.0 })
    }

    @Test
    fun `what is picked is scaled, by no factor below 0`(robot: FxRobot) {
        drawRectangle(robot)
        choose("Scale…")
        val factor = field("factor")
        robot.write("0").type(KeyCode.ENTER)
        assertTrue(isMarked(factor))
        robot.write("0,5").type(KeyCode.ENTER)
        assertEquals("scale", onFx { window.session.undoName })
        assertEquals(Rectangle(3.0, 3.0, 5.0, 5.0, 0.5), onFx { window.session.document.path.shape(0) })
    }

    @Test
    fun `what is picked is repeated in rows and columns`(robot: FxRobot) {
        drawRectangle(robot)
        choose("Repeat in rows and columns…")
        field("columns")
        robot.write("2").type(KeyCode.TAB).write("3").type(KeyCode.TAB).write("5").type(KeyCode.TAB).write("-6").type(KeyCode.ENTER)
        assertEquals(6, onFx { window.session.document.path.shapeCount })
        assertEquals(Rectangle(7.0, -10.0, 11.0, -6.0, 1.0), onFx { window.session.document.path.shape(5) })
        robot.push(KeyCode.CONTROL, KeyCode.Z)
        assertEquals(1, onFx { window.session.document.path.shapeCount })
    }

    @Test
    fun `what is picked is mirrored at a typed line`(robot: FxRobot) {
        drawRectangle(robot)
        robot.push(KeyCode.CONTROL, KeyCode.M)
        robot.write("7,0").type(KeyCode.ENTER).write("@0,1").type(KeyCode.ENTER)
        assertEquals("mirror", onFx { window.session.undoName })
        assertTrue(nodes().all { it.x in 8.0..12.0 })
    }

    @Test
    fun `nodes between two are spread anew by typed numbers`(robot: FxRobot) {
        drawRectangle(robot)
        onFx { window.session.select(Selection(nodes = setOf(0, 4))) }
        WaitForAsyncUtils.waitForFxEvents()
        robot.clickOn("#field-new-spacing").write("0.5").type(KeyCode.ENTER)
        assertEquals("spread nodes", onFx { window.session.undoName })
        assertEquals(20, onFx { window.session.document.nodes.count })
    }

    @Test
    fun `pasted points are a loop, pasted words are refused`(robot: FxRobot) {
        drawRectangle(robot)
        clip("x;y\n8;2\n10;2\n9;5")
        robot.push(KeyCode.CONTROL, KeyCode.V)
        assertEquals(1, onFx { window.session.document.loops.size })
        clip("not a point in sight")
        robot.push(KeyCode.CONTROL, KeyCode.V)
        assertEquals(1, onFx { window.session.document.loops.size })
        assertTrue(onFx { window.session.isMessageError })
    }

    @Test
    fun `the picture behind is scaled and turned by two points`(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        val file = folder.resolve("behind.png")
        javax.imageio.ImageIO.write(java.awt.image.BufferedImage(60, 40, java.awt.image.BufferedImage.TYPE_INT_RGB), "png", file.toFile())
        onFx { window.setPicture(file) }
        val before: Background = onFx { window.session.document.picture!! }
        choose("Scale by two points")
        robot.clickOn(place(2.0, 2.0)).clickOn(place(6.0, 2.0))
        field("distance")
        robot.write("8").type(KeyCode.ENTER)
        assertEquals(2 * before.pixelSize, onFx { window.session.document.picture!!.pixelSize }, 1e-12)
        choose("Rotate by two points")
        robot.clickOn(place(2.0, 2.0)).clickOn(place(6.0, 2.0))
        field("angle-degrees")
        robot.write("30").type(KeyCode.ENTER)
        assertEquals(30.0, onFx { window.session.document.picture!!.rotationDegrees }, 1e-12)
        while (onFx { window.session.undoName } != null) robot.push(KeyCode.CONTROL, KeyCode.Z)
        assertNull(onFx { window.session.document.picture })
    }

    @Test
    fun `sizes asked for at a point and along a line make small elements there`(robot: FxRobot) {
        drawRectangle(robot)
        robot.push(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.A).clickOn(place(4.0, 4.0))
        val size = field("edge-length")
        assertEquals("0.25", size.text)
        robot.write("0").type(KeyCode.ENTER)
        assertTrue(isMarked(size))
        robot.write("0.1").type(KeyCode.ENTER)
        assertEquals("add size at a point", onFx { window.session.undoName })
        robot.type(KeyCode.ESCAPE).push(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.D)
        robot.write("3,3").type(KeyCode.ENTER).write("5,3").type(KeyCode.ENTER)
        field("edge-length")
        robot.write("0.2").type(KeyCode.ENTER)
        robot.type(KeyCode.ESCAPE).type(KeyCode.F5)
        val mesh = waitForMesh()
        val at = (0 until mesh.mesh.elementCount).minByOrNull { element ->
            Math.hypot((0..2).sumOf { mesh.mesh.x(mesh.mesh.nodeOf(element, it)) } / 3 - 4, (0..2).sumOf { mesh.mesh.y(mesh.mesh.nodeOf(element, it)) } / 3 - 4)
        }!!
        // A boundary whose segments are 1 long at a distance of 2 keeps it from less than 1 - 0.25 * 2.
        assertTrue(mesh.size(at) < 0.7, "${mesh.size(at)}")
        val saved = text()
        assertEquals(2, org.trigrid.project.ProjectFile.parse(saved, "saved").options.sizeSources.count)
        onFx { (window.stage.scene.lookup(".tab-pane") as javafx.scene.control.TabPane).selectionModel.select(1) }
        WaitForAsyncUtils.waitForFxEvents()
        robot.clickOn("#field-point-1").push(KeyCode.CONTROL, KeyCode.A).type(KeyCode.DELETE).type(KeyCode.ENTER)
        assertEquals("remove size source", onFx { window.session.undoName })
        robot.clickOn(place(9.0, 7.5))
        repeat(3) { robot.push(KeyCode.CONTROL, KeyCode.Z) }
        assertEquals(0, onFx { window.session.document.project.options.sizeSources.count })
    }

    private fun drawRectangle(robot: FxRobot) {
        show(robot, Box(0.0, 0.0, 12.0, 8.0))
        robot.type(KeyCode.R).clickOn(place(2.0, 2.0)).clickOn(place(6.0, 6.0))
        robot.type(KeyCode.V).clickOn(place(2.5, 2.0))
        assertEquals(setOf(0), onFx { window.session.selection.shapes })
        robot.moveTo(place(9.0, 7.0))
    }

    /** What a click on the menu's item would do; it must not be waited for, since the dialog stops it. */
    private fun choose(item: String) {
        WaitForAsyncUtils.asyncFx {
            val bar = window.stage.scene.lookup(".menu-bar") as javafx.scene.control.MenuBar
            bar.menus.flatMap { it.items }.first { it.text == item }.fire()
        }
        WaitForAsyncUtils.waitForFxEvents()
    }

    /** The field for a number, once it has the focus, so that keys go there. */
    private fun field(name: String): TextField {
        WaitForAsyncUtils.waitFor(10, TimeUnit.SECONDS, Callable { onFx { focused()?.id == "number-$name" } })
        return onFx { focused()!! }
    }

    private fun focused(): TextField? =
        javafx.stage.Window.getWindows().filter { it.isFocused }.firstNotNullOfOrNull { it.scene?.focusOwner as? TextField }

    private fun isMarked(field: TextField): Boolean = onFx { PseudoClass.getPseudoClass("invalid") in field.pseudoClassStates }

    private fun isGone(node: Node): Boolean = onFx { node.scene?.window?.isShowing != true }

    private fun nodes(): List<Point2> = onFx { window.session.document.nodes.let { all -> (0 until all.count).map { all.point(it) } } }

    private fun clip(words: String) = onFx { Clipboard.getSystemClipboard().setContent(ClipboardContent().apply { putString(words) }) }
}
