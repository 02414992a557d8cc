package org.trigrid.editor.app

import javafx.application.Platform
import javafx.css.PseudoClass
import javafx.event.ActionEvent
import javafx.scene.control.ButtonType
import javafx.scene.control.Dialog
import javafx.scene.control.Label
import javafx.scene.control.TextField
import javafx.scene.layout.GridPane
import javafx.stage.Window
import org.trigrid.editor.inspector.NumberQuestion

/**
 * Asks for numbers. The first field is ready to be typed over, Enter accepts; a field that holds no answer is marked,
 * says what to type and keeps the dialog open.
 */
internal class NumberDialog(owner: Window?, title: String, questions: List<NumberQuestion>) {
    private class Row(val question: NumberQuestion) {
        val input = TextField(question.text)
        val fault = Label()

        /** The number that is typed, or null if it is none, which the row then tells. */
        fun answer(): Double? = try {
            question.answer(input.text).also { tell(null) }
        } catch (error: IllegalArgumentException) {
            tell(error.message)
            null
        }

        fun tell(words: String?) {
            fault.text = words.orEmpty()
            fault.isVisible = words != null
            fault.isManaged = words != null
            input.pseudoClassStateChanged(INVALID, words != null)
        }
    }

    private val dialog = Dialog<List<Double>>()
    private val rows = questions.map { Row(it) }

    init {
        dialog.title = title
        dialog.headerText = title
        dialog.graphic = null
        dialog.initOwner(owner)
        dialog.dialogPane.buttonTypes.setAll(ButtonType.OK, ButtonType.CANCEL)
        dialog.dialogPane.stylesheets.add(EditorWindow.stylesheet)
        dialog.dialogPane.content = fields()
        dialog.dialogPane.lookupButton(ButtonType.OK).addEventFilter(ActionEvent.ACTION) { if (!check()) it.consume() }
        dialog.setResultConverter { button -> if (button == ButtonType.OK) rows.map { it.answer()!! } else null }
        // Only after the window has given the focus to its first button.
        dialog.setOnShown { Platform.runLater { focus(rows.first()) } }
    }

    /** The numbers, or null if the dialog is cancelled. */
    fun ask(): List<Double>? = dialog.showAndWait().orElse(null)

    private fun fields(): GridPane {
        val grid = GridPane()
        grid.styleClass.add("number-grid")
        rows.forEachIndexed { i, row ->
            row.tell(null)
            row.input.id = "number-" + row.question.label.lowercase().replace(Regex("[^a-z0-9]+"), "-")
            row.input.accessibleText = row.question.label
            row.input.textProperty().addListener { _, _, _ -> if (row.fault.isVisible) row.answer() }
            row.fault.styleClass.add("field-fault")
            row.fault.isWrapText = true
            val label = Label(row.question.label)
            label.labelFor = row.input
            grid.addRow(2 * i, label, row.input)
            grid.add(row.fault, 1, 2 * i + 1)
        }
        // A fault that is told makes the dialog higher.
        grid.heightProperty().addListener { _, old, new -> if (old.toDouble() > 0 && new != old) dialog.dialogPane.scene?.window?.sizeToScene() }
        return grid
    }

    private fun check(): Boolean {
        val wrong = rows.filter { it.answer() == null }
        wrong.firstOrNull()?.let { focus(it) }
        if (wrong.isNotEmpty()) dialog.dialogPane.scene?.window?.sizeToScene()
        return wrong.isEmpty()
    }

    private fun focus(row: Row) {
        row.input.requestFocus()
        row.input.selectAll()
    }

    private companion object {
        val INVALID: PseudoClass = PseudoClass.getPseudoClass("invalid")
    }
}
