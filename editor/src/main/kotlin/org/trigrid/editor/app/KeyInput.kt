package org.trigrid.editor.app

import javafx.scene.Scene
import javafx.scene.control.TextInputControl
import javafx.scene.input.KeyCode
import javafx.scene.input.KeyEvent
import javafx.scene.input.MouseEvent
import org.trigrid.editor.canvas.DrawingCanvas
import org.trigrid.editor.command.TransformSelection
import org.trigrid.editor.session.EditorSession
import org.trigrid.editor.tool.Grid
import org.trigrid.editor.tool.ShapeKind
import org.trigrid.shape.Similarity

/** Keys pressed while nobody types into a field: tools by their letters, places by their digits, the tool's own keys. */
internal class KeyInput(
    private val session: EditorSession,
    private val canvas: DrawingCanvas,
    private val edit: EditActions,
    private val beginEntry: (String) -> Unit,
) {
    /** Whether Alt is held for the mouse, to suspend snapping, and so must not open the menu when it is let go. */
    private var isAltForMouse = false

    fun listenTo(scene: Scene) {
        scene.addEventFilter(KeyEvent.KEY_PRESSED) { event ->
            if (isForDrawing(scene, event.code) && pressed(event)) event.consume()
        }
        scene.addEventFilter(KeyEvent.KEY_RELEASED) { event ->
            if (event.code == KeyCode.SPACE) canvas.isPanning = false
            if (event.code == KeyCode.ALT && isAltForMouse) {
                isAltForMouse = false
                event.consume()
            }
        }
        scene.addEventFilter(KeyEvent.KEY_PRESSED) { if (it.code != KeyCode.ALT) isAltForMouse = false }
        scene.addEventFilter(MouseEvent.ANY) { isAltForMouse = it.isAltDown || isAltForMouse && it.eventType == MouseEvent.MOUSE_EXITED_TARGET }
        scene.addEventFilter(KeyEvent.KEY_TYPED) { event ->
            val first = event.character
            val begins = first.length == 1 && (first[0].isDigit() || first[0] in "@.-+")
            if (begins && scene.focusOwner !is TextInputControl && !event.isShortcutDown && !event.isAltDown) {
                beginEntry(first)
                event.consume()
            }
        }
    }

    /** Fields keep all keys; lists, buttons and tabs those that they know. */
    private fun isForDrawing(scene: Scene, code: KeyCode): Boolean = when (scene.focusOwner) {
        null, canvas -> true
        is TextInputControl -> false
        else -> !code.isNavigationKey && code != KeyCode.ENTER && code != KeyCode.SPACE
    }

    private fun pressed(event: KeyEvent): Boolean {
        if (event.isShortcutDown || event.isMetaDown) return false
        if (session.playback != null && played(event.code)) return true
        return when (event.code) {
            KeyCode.ENTER -> told { it.enter() }
            KeyCode.BACK_SPACE -> told { it.backspace() } || deleted()
            KeyCode.DELETE -> deleted()
            KeyCode.ESCAPE -> if (session.progress != null) true.also { session.cancelMeshing() } else told { it.cancel() }
            KeyCode.SPACE -> true.also { canvas.isPanning = true }
            KeyCode.UP -> told { it.count(1) } || nudged(0, 1)
            KeyCode.DOWN -> told { it.count(-1) } || nudged(0, -1)
            KeyCode.LEFT -> nudged(-1, 0)
            KeyCode.RIGHT -> nudged(1, 0)
            KeyCode.V -> true.also { session.selectTool(event.isShiftDown) }
            else -> drawn(event)
        }
    }

    /** The keys of the film of the front. */
    private fun played(code: KeyCode): Boolean {
        when (code) {
            KeyCode.SPACE -> session.withPlayback { it.toggle() }
            KeyCode.RIGHT -> session.withPlayback { it.step(1) }
            KeyCode.LEFT -> session.withPlayback { it.step(-1) }
            KeyCode.HOME -> session.withPlayback { it.goTo(0) }
            KeyCode.END -> session.withPlayback { it.goTo(it.length) }
            KeyCode.ESCAPE -> session.stopPlayback()
            else -> return false
        }
        return true
    }

    private fun told(tell: (org.trigrid.editor.tool.Tool) -> Boolean): Boolean {
        var meant = false
        session.withTool { meant = tell(it) }
        return meant
    }

    private fun deleted(): Boolean {
        edit.delete()
        return true
    }

    /** Arrow keys move what is picked by one step of the grid; presses in a row are one step of the history. */
    private fun nudged(x: Int, y: Int): Boolean {
        if (session.selection.isEmpty) return false
        val step = Grid.stepFor(canvas.transform.pixel)
        session.execute(TransformSelection(Similarity.translation(x * step, y * step), "move", "nudge"))
        return true
    }

    private fun drawn(event: KeyEvent): Boolean {
        if (event.isShiftDown || event.isAltDown) return false
        val kind = ShapeKind.entries.firstOrNull { it.key == event.code.getName() } ?: return false
        session.draw(kind)
        return true
    }
}
