package org.trigrid.editor.inspector

import javafx.scene.canvas.Canvas
import javafx.scene.control.Label
import javafx.scene.layout.VBox
import javafx.scene.paint.Color
import org.trigrid.editor.session.Change
import org.trigrid.editor.session.EditorSession

/** The properties of what is picked, or of the shapes to come. */
internal class InspectorView(session: EditorSession) : VBox() {
    private val model = InspectorViewModel(session)
    private val title = Label()
    private val note = Label()
    private val preview = Canvas(PREVIEW_WIDTH, PREVIEW_HEIGHT)
    private val fields = FieldsView(model::commit)

    /** Colour of the small picture of the spacing. */
    var ink: Color = Color.BLACK
        set(value) {
            field = value
            drawPreview()
        }

    init {
        styleClass.add("inspector")
        title.styleClass.add("inspector-title")
        note.styleClass.add("inspector-note")
        note.isWrapText = true
        children.addAll(title, note, preview, fields)
        session.listen { if (it == Change.SELECTION || it == Change.DOCUMENT) refresh() }
        refresh()
    }

    private fun refresh() {
        title.text = model.title
        note.text = model.note
        note.isVisible = note.text.isNotEmpty()
        note.isManaged = note.isVisible
        val sections = model.sections
        fields.show(sections)
        preview.isVisible = sections.any { it.heading == "Spacing" }
        preview.isManaged = preview.isVisible
        drawPreview()
    }

    private fun drawPreview() {
        val g = preview.graphicsContext2D
        g.clearRect(0.0, 0.0, PREVIEW_WIDTH, PREVIEW_HEIGHT)
        g.stroke = ink
        g.fill = ink
        g.lineWidth = 1.0
        val y = PREVIEW_HEIGHT / 2 - 0.5
        val width = PREVIEW_WIDTH - 2 * DOT
        g.strokeLine(DOT, y, DOT + width, y)
        for (at in model.distributionPreview) g.fillOval(at * width, y - DOT, 2 * DOT, 2 * DOT)
    }

    private companion object {
        const val PREVIEW_WIDTH = 250.0
        const val PREVIEW_HEIGHT = 16.0
        const val DOT = 3.0
    }
}
