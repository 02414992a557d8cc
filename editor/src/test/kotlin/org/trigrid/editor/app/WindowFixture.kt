package org.trigrid.editor.app

import javafx.stage.Stage
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.extension.ExtendWith
import org.testfx.api.FxRobot
import org.testfx.framework.junit5.ApplicationExtension
import org.testfx.util.WaitForAsyncUtils
import org.trigrid.editor.canvas.Box
import org.trigrid.editor.files.Preferences
import org.trigrid.project.ProjectFile
import java.nio.file.Files
import java.util.concurrent.Callable
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit

/** A window with a folder of its own, and what tests of it need. */
@ExtendWith(NeedsDisplay::class, ApplicationExtension::class)
internal abstract class WindowFixture {
    protected val folder = Files.createTempDirectory("trigrid-window")
    protected lateinit var window: EditorWindow

    /** For the test's own start method, since TestFX asks for one in the very class. */
    protected fun open(stage: Stage) {
        System.setProperty("trigrid.home", folder.toString())
        val preferences = Preferences(folder)
        preferences["theme"] = "LIGHT"
        Theme.LIGHT.apply()
        window = EditorWindow(stage, preferences, Executors.newCachedThreadPool { Thread(it).apply { isDaemon = true } })
        stage.show()
        window.startDrawing()
        window.canvas.layout()
        window.session.selectTool()
    }

    @AfterEach
    fun close() {
        WaitForAsyncUtils.asyncFx { window.canvas.close() }.get()
        Files.walk(folder).sorted(Comparator.reverseOrder()).forEach { Files.delete(it) }
    }

    protected fun show(robot: FxRobot, box: Box) {
        WaitForAsyncUtils.waitForFxEvents()
        onFx { window.canvas.fit(box) }
        robot.interact { window.canvas.requestFocus() }
    }

    protected fun colourAt(x: Double, y: Double): javafx.scene.paint.Color {
        WaitForAsyncUtils.waitForFxEvents()
        return onFx {
            val t = window.canvas.transform
            window.canvas.snapshot(null, null).pixelReader.getColor(t.screenX(x).toInt(), t.screenY(y).toInt())
        }
    }

    protected fun place(x: Double, y: Double): javafx.geometry.Point2D {
        WaitForAsyncUtils.waitForFxEvents()
        return onFx {
            val t = window.canvas.transform
            window.canvas.localToScreen(t.screenX(x), t.screenY(y))
        }
    }

    protected fun waitForMesh(): org.trigrid.editor.meshing.MeshView {
        WaitForAsyncUtils.waitFor(20, TimeUnit.SECONDS, Callable { onFx { window.session.mesh != null } })
        return assertNotNull(window.session.mesh).let { window.session.mesh!! }
    }

    protected fun text(): String {
        WaitForAsyncUtils.waitForFxEvents()
        return ProjectFile.format(window.session.document.project)
    }

    protected fun <T> onFx(action: () -> T): T = WaitForAsyncUtils.asyncFx(Callable { action() }).get()
}
