package org.trigrid.editor.app

import javafx.scene.control.Button
import javafx.scene.control.Label
import javafx.scene.control.ListCell
import javafx.scene.control.ListView
import javafx.scene.control.Tooltip
import javafx.scene.input.KeyCode
import javafx.scene.layout.BorderPane
import javafx.scene.layout.HBox
import javafx.scene.layout.Priority
import javafx.scene.layout.Region
import javafx.scene.shape.Circle
import org.trigrid.editor.canvas.DrawingCanvas
import org.trigrid.editor.meshing.Problem
import org.trigrid.editor.session.Change
import org.trigrid.editor.session.EditorSession

/** All that is wrong with the domain; a click goes there, a button mends it. */
internal class ProblemsView(private val session: EditorSession, private val canvas: DrawingCanvas, close: () -> Unit) : BorderPane() {
    private val list = ListView<Problem>()
    private val heading = Label()
    private val empty = Label()

    init {
        styleClass.add("problems")
        list.id = "problem-list"
        list.placeholder = empty
        list.setCellFactory { ProblemCell() }
        list.setOnMouseClicked { go() }
        list.setOnKeyPressed { if (it.code == KeyCode.ENTER) go() else if (it.code == KeyCode.SPACE) mend() }
        list.prefHeight = HEIGHT
        heading.styleClass.add("section-heading")
        val shut = Button()
        shut.graphic = Icons.CANCEL.node(12.0)
        shut.styleClass.add("flat")
        shut.accessibleText = "Close the problem list"
        shut.setOnAction { close() }
        val spring = Region()
        HBox.setHgrow(spring, Priority.ALWAYS)
        top = HBox(heading, spring, shut).apply { styleClass.add("panel-head") }
        center = list
        session.listen { if (it == Change.PROBLEMS) refresh() }
        refresh()
    }

    private fun refresh() {
        val at = list.selectionModel.selectedIndex
        list.items.setAll(session.problems)
        if (at >= 0 && list.items.isNotEmpty()) list.selectionModel.select(Math.min(at, list.items.size - 1))
        empty.text = if (session.document.isEmpty) "Nothing is drawn yet." else "No faults: the domain can be meshed."
        heading.text = "Problems (${session.problems.size})"
    }

    /** Brings the keys to the list: Up and Down choose, Enter goes there, Space mends. */
    fun takeFocus() {
        if (list.selectionModel.isEmpty) list.selectionModel.selectFirst()
        list.requestFocus()
    }

    private fun mend() {
        list.selectionModel.selectedItem?.fix?.let { session.execute(it) }
    }

    private fun go() {
        val problem = list.selectionModel.selectedItem ?: return
        canvas.emphasised = problem
        canvas.lookAt(problem.x, problem.y)
    }

    private inner class ProblemCell : ListCell<Problem>() {
        private val dot = Circle(4.5)
        private val title = Label()
        private val words = Label()
        private val fix = Button()
        private val box = HBox(dot, title, words, Region().also { HBox.setHgrow(it, Priority.ALWAYS) }, fix)

        init {
            box.styleClass.add("problem")
            title.styleClass.add("problem-title")
            title.minWidth = Region.USE_PREF_SIZE
            words.styleClass.add("problem-words")
            words.minWidth = 0.0
            fix.styleClass.addAll("small")
            fix.minWidth = Region.USE_PREF_SIZE
            box.maxWidth = Double.MAX_VALUE
            prefWidth = 0.0
        }

        override fun updateItem(item: Problem?, empty: Boolean) {
            super.updateItem(item, empty)
            text = null
            if (empty || item == null) {
                graphic = null
                return
            }
            dot.styleClass.setAll(if (item.isFault) "dot-fault" else "dot-warning")
            title.text = item.title
            words.text = item.message
            val command = item.fix
            fix.isVisible = command != null
            fix.isManaged = command != null
            fix.tooltip = command?.let { Tooltip("Mends it, as a step that can be undone  (Space)") }
            fix.text = command?.name?.replaceFirstChar { it.uppercase() }.orEmpty()
            fix.setOnAction { if (command != null) session.execute(command) }
            graphic = box
        }
    }

    private companion object {
        const val HEIGHT = 150.0
    }
}
