package org.trigrid.editor.inspector

import java.util.Locale
import javafx.css.PseudoClass
import javafx.geometry.HPos
import javafx.scene.control.ChoiceBox
import javafx.scene.control.ColorPicker
import javafx.scene.control.Control
import javafx.scene.control.Label
import javafx.scene.control.TextField
import javafx.scene.control.Tooltip
import javafx.scene.input.KeyCode
import javafx.scene.layout.ColumnConstraints
import javafx.scene.layout.GridPane
import javafx.scene.layout.Priority
import javafx.scene.layout.VBox
import javafx.scene.paint.Color

/**
 * Shows sections of fields and hands on what is typed. No logic of its own.
 *
 * @param commit does what a text in a field asks for and returns what is wrong with it, or null.
 */
internal class FieldsView(private val commit: (InspectorField, String) -> String?) : VBox() {
    private class Row(var field: InspectorField, val control: Control, val fault: Label) {
        var colours: ColorPicker? = null
    }

    private var layout: List<String> = emptyList()
    private val rows = ArrayList<Row>()
    private var isUpdating = false

    init {
        styleClass.add("fields")
    }

    /** Shows [sections]; a field in which somebody types keeps its text. */
    fun show(sections: List<InspectorSection>) {
        val wanted = sections.flatMap { s -> listOf("#" + s.heading) + s.fields.map { "${it.label}|${it.unit}|${it.choices}|${it.isReadOnly}|${it.colour != null}" } }
        isUpdating = true
        if (wanted != layout) rebuild(sections) else sections.flatMap { it.fields }.forEachIndexed { i, field -> update(rows[i], field) }
        layout = wanted
        isUpdating = false
    }

    private fun rebuild(sections: List<InspectorSection>) {
        children.clear()
        rows.clear()
        for (section in sections) {
            val heading = Label(section.heading)
            heading.styleClass.add("section-heading")
            val grid = GridPane()
            grid.styleClass.add("field-grid")
            grid.columnConstraints.addAll(
                ColumnConstraints(LABEL_WIDTH).apply { halignment = HPos.LEFT },
                ColumnConstraints().apply { hgrow = Priority.ALWAYS; isFillWidth = true },
                ColumnConstraints(UNIT_WIDTH),
            )
            section.fields.forEachIndexed { i, field -> addRow(grid, i, field) }
            children.addAll(heading, grid)
        }
    }

    private fun addRow(grid: GridPane, index: Int, field: InspectorField) {
        val fault = Label()
        fault.styleClass.add("field-fault")
        fault.isWrapText = true
        fault.isManaged = false
        fault.isVisible = false
        val control = controlFor(field)
        val row = Row(field, control, fault)
        rows.add(row)
        update(row, field)
        val label = Label(field.label)
        label.styleClass.add("field-label")
        label.labelFor = control
        val unit = Label(field.unit)
        unit.styleClass.add("field-unit")
        if (field.help.isNotEmpty()) {
            val tip = Tooltip(field.help)
            control.tooltip = tip
            label.tooltip = tip
        }
        control.accessibleText = "${field.label} ${field.unit}"
        control.id = "field-" + field.label.lowercase().replace(' ', '-')
        grid.addRow(2 * index, label, control)
        val colours = if (field.colour == null) null else colourBox(row)
        row.colours = colours
        if (colours != null) {
            grid.add(colours, 2, 2 * index)
        } else if (field.unit.isEmpty()) {
            GridPane.setColumnSpan(control, 2)
        } else {
            grid.add(unit, 2, 2 * index)
        }
        grid.add(fault, 1, 2 * index + 1, 2, 1)
        listenTo(row)
    }

    private fun colourBox(row: Row): ColorPicker {
        val box = ColorPicker(Color.web(row.field.colour!!.value))
        box.styleClass.addAll("button", "colour-box")
        box.tooltip = Tooltip("Choose the colour of ${row.field.value}")
        box.accessibleText = "Colour of ${row.field.label} ${row.field.value}"
        box.id = "colour-" + row.field.value.lowercase().replace(' ', '-')
        box.setOnAction {
            val chosen = box.value
            val hex = String.format(
                Locale.ROOT, "#%02x%02x%02x",
                Math.round(255 * chosen.red).toInt(), Math.round(255 * chosen.green).toInt(), Math.round(255 * chosen.blue).toInt(),
            )
            val colour = row.field.colour
            if (!isUpdating && colour != null && hex != colour.value) commit(InspectorField(row.field.label, colour.value, change = colour.change), hex)
        }
        return box
    }

    private fun controlFor(field: InspectorField): Control = when {
        field.isReadOnly -> Label().apply { styleClass.add("field-value") }
        field.choices.isNotEmpty() -> ChoiceBox<String>().apply { maxWidth = Double.MAX_VALUE; items.addAll(field.choices) }
        else -> TextField().apply { prefColumnCount = 7 }
    }

    private fun listenTo(row: Row) {
        when (val control = row.control) {
            is TextField -> {
                control.setOnAction { submit(row, control.text) }
                control.focusedProperty().addListener { _, _, isFocused -> if (isFocused) showWhole(row, control) else leave(row, control) }
                control.setOnKeyPressed {
                    if (it.code == KeyCode.ESCAPE && control.text != row.field.value) {
                        control.text = row.field.value
                        tell(row, null)
                        it.consume()
                    }
                }
            }
            is ChoiceBox<*> -> control.valueProperty().addListener { _, _, value ->
                if (!isUpdating && value != null && value != row.field.value) submit(row, value.toString())
            }
            else -> Unit
        }
    }

    /** All digits, to be edited. */
    private fun showWhole(row: Row, control: TextField) {
        if (control.text == row.field.shown) control.text = row.field.value
    }

    private fun leave(row: Row, control: TextField) {
        submit(row, control.text)
        if (control.text == row.field.value) control.text = row.field.shown
    }

    private fun submit(row: Row, text: String) {
        if (!isUpdating && row in rows) tell(row, commit(row.field, text))
    }

    private fun tell(row: Row, fault: String?) {
        row.fault.text = fault.orEmpty()
        row.fault.isVisible = fault != null
        row.fault.isManaged = fault != null
        row.control.pseudoClassStateChanged(INVALID, fault != null)
    }

    private fun update(row: Row, field: InspectorField) {
        row.field = field
        field.colour?.let { row.colours?.value = Color.web(it.value) }
        when (val control = row.control) {
            is Label -> control.text = field.value
            is TextField -> {
                val text = if (control.isFocused) field.value else field.shown
                if (control.text != text && (!control.isFocused || !control.pseudoClassStates.contains(INVALID))) {
                    control.text = text
                    tell(row, null)
                }
            }
            is ChoiceBox<*> -> {
                @Suppress("UNCHECKED_CAST")
                (control as ChoiceBox<String>).value = field.value.ifEmpty { null }
            }
            else -> Unit
        }
    }

    private companion object {
        val INVALID: PseudoClass = PseudoClass.getPseudoClass("invalid")
        const val LABEL_WIDTH = 86.0
        const val UNIT_WIDTH = 76.0
    }
}
