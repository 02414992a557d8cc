package org.trigrid.editor.app

import java.util.concurrent.Callable
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import javafx.animation.AnimationTimer
import javafx.event.Event
import javafx.scene.image.ImageView
import javafx.scene.input.MouseButton
import javafx.scene.input.MouseEvent
import javafx.scene.input.ScrollEvent
import javafx.stage.Stage
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.testfx.framework.junit5.Start
import org.testfx.util.WaitForAsyncUtils
import org.trigrid.editor.command.ProjectCommands
import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.files.Gallery
import org.trigrid.editor.meshing.Colouring
import org.trigrid.project.Project

/**
 * A million elements on a sheet of 1280 by 800 pixels, panned and zoomed in the window itself. Counted are the frames of the
 * window and, the harder of the two, the pictures of the mesh that were drawn anew for where the sheet had come to. No test: it
 * prints what it measures, and its name keeps it out of every run that does not ask for it.
 */
@Tag("corpus")
internal class FrameRateBenchmark : WindowFixture() {
    @Start
    fun start(stage: Stage) = open(stage)

    @Test
    fun `pictures a second of a million elements, panned and zoomed`() {
        val spacing = System.getProperty("trigrid.frames.spacing")?.toDouble() ?: HAND_SPACING
        val hand = Gallery.HAND.document().project.toDomain().respaced(spacing, 1.0)
        onFx {
            window.stage.width = 1280 + window.stage.width - window.canvas.width
            window.stage.height = 800 + window.stage.height - window.canvas.height
            window.session.open(EditorDocument(Project.builder().loops(ProjectCommands.loopsOf(hand)).build()), null)
            window.session.generate()
        }
        WaitForAsyncUtils.waitFor(120, TimeUnit.SECONDS, Callable { onFx { window.session.mesh != null } })
        val count = onFx { window.session.mesh!!.mesh.elementCount }
        println("elements: $count, sheet ${onFx { window.canvas.width }} by ${onFx { window.canvas.height }}")
        assertTrue(count > 900_000, "$count elements")
        for (colouring in listOf(Colouring.NONE, Colouring.QUALITY)) {
            onFx { window.session.view = window.session.view.copy(colouring = colouring) }
            onFx { window.canvas.fit() }
            measure("$colouring warming up", 240) { zoom(it) }
            for (ease in listOf(1.0, 3.0, 10.0, 40.0, 150.0)) {
                onFx { window.canvas.fit() }
                onFx { window.canvas.zoom(ease) }
                measure("$colouring panning, $ease times the whole", 120) { pan(it) }
            }
            onFx { window.canvas.fit() }
            measure("$colouring zooming in and out by the wheel", 480) { zoom(it) }
        }
    }

    /** Prints the frames and pictures a second while [step] is taken in each frame, [steps] times. */
    private fun measure(what: String, steps: Int, step: (Int) -> Unit) {
        WaitForAsyncUtils.sleep(700, TimeUnit.MILLISECONDS)
        val done = CountDownLatch(1)
        var pictures = 0
        var begin = 0L
        var last = 0L
        var longest = 0L
        var end = 0L
        onFx {
            val node = window.canvas.childrenUnmodifiable.filterIsInstance<ImageView>().single()
            node.imageProperty().addListener { _, _, _ -> pictures++ }
            object : AnimationTimer() {
                var at = 0

                override fun handle(now: Long) {
                    val time = System.nanoTime()
                    if (at == 0) begin = time else longest = Math.max(longest, time - last)
                    last = time
                    if (at == steps) {
                        end = time
                        stop()
                        done.countDown()
                    } else {
                        step(at++)
                    }
                }
            }.start()
        }
        done.await(120, TimeUnit.SECONDS)
        val seconds = (end - begin) / 1e9
        val figures = "%5.1f frames/s, %5.1f pictures/s, longest frame %4.0f ms".format(steps / seconds, pictures / seconds, longest / 1e6)
        println("%-55s %s".format(what, figures))
    }

    /** The whole way in, to single elements, and out again, round a place that is not the middle. */
    private fun zoom(step: Int) {
        val wheel = if (step / 120 % 2 == 0) NOTCH else -NOTCH
        Event.fireEvent(
            window.canvas,
            ScrollEvent(ScrollEvent.SCROLL, 560.0, 470.0, 560.0, 470.0, false, false, false, false, false, false, 0.0, wheel, 0.0, wheel, ScrollEvent.HorizontalTextScrollUnits.NONE, 0.0, ScrollEvent.VerticalTextScrollUnits.NONE, 0.0, 0, null),
        )
    }

    private fun pan(step: Int) {
        // A mouse goes from pixel to pixel.
        val x = Math.rint(640 + 200 * Math.sin(step / 10.0))
        val y = Math.rint(400 + 150 * Math.cos(step / 10.0))
        if (step == 0) mouse(MouseEvent.MOUSE_PRESSED, x, y)
        mouse(if (step == 119) MouseEvent.MOUSE_RELEASED else MouseEvent.MOUSE_DRAGGED, x, y)
    }

    private fun mouse(type: javafx.event.EventType<MouseEvent>, x: Double, y: Double) = Event.fireEvent(
        window.canvas,
        MouseEvent(type, x, y, x, y, MouseButton.SECONDARY, 1, false, false, false, false, false, false, true, false, true, false, null),
    )

    private companion object {
        const val HAND_SPACING = 0.0106

        /** What a notch of a wheel turns. */
        const val NOTCH = 20.0
    }
}
