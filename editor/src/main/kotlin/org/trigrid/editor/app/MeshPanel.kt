package org.trigrid.editor.app

import javafx.scene.canvas.Canvas
import javafx.scene.control.ChoiceBox
import javafx.scene.control.Hyperlink
import javafx.scene.control.Label
import javafx.scene.input.KeyCode
import javafx.scene.layout.GridPane
import javafx.scene.layout.HBox
import javafx.scene.layout.VBox
import javafx.scene.paint.Color
import org.trigrid.editor.canvas.ColourScale
import org.trigrid.editor.canvas.DrawingCanvas
import org.trigrid.editor.meshing.Colouring
import org.trigrid.editor.meshing.MeshSummaryViewModel
import org.trigrid.editor.meshing.MeshView
import org.trigrid.editor.session.Change
import org.trigrid.editor.session.EditorSession
import org.trigrid.editor.tool.Figures

/** The figures of the mesh: its colours, counts, the histogram of its quality, the ten worst elements. */
internal class MeshPanel(private val session: EditorSession, private val canvas: DrawingCanvas) : VBox() {
    private val colouring = ChoiceBox<String>()
    private val figures = GridPane()
    private val histogram = Canvas(HISTOGRAM_WIDTH, HISTOGRAM_HEIGHT)
    private val worst = VBox()
    private val empty = Label("No mesh yet. Draw a closed shape, then press Mesh (F5).")
    private val content = VBox()

    /** The bar whose elements are outlined, or -1. */
    private var chosen = -1

    /** Colour of the histogram's words. */
    var ink: Color = Color.BLACK
        set(value) {
            field = value
            refresh()
        }

    init {
        styleClass.add("mesh-panel")
        colouring.id = "colouring"
        colouring.items.addAll(Colouring.entries.map { it.label })
        colouring.value = session.view.colouring.label
        colouring.maxWidth = Double.MAX_VALUE
        colouring.valueProperty().addListener { _, _, label ->
            val chosen = Colouring.entries.first { it.label == label }
            if (chosen != session.view.colouring) session.view = session.view.copy(colouring = chosen)
        }
        histogram.id = "histogram"
        histogram.accessibleText = "Elements by quality; Left and Right choose a bar"
        histogram.isFocusTraversable = true
        histogram.focusedProperty().addListener { _, _, _ -> refresh() }
        histogram.setOnMouseClicked {
            histogram.requestFocus()
            markClass((it.x / HISTOGRAM_WIDTH * CLASSES).toInt().coerceIn(0, CLASSES - 1))
        }
        histogram.setOnKeyPressed {
            val by = if (it.code == KeyCode.LEFT) -1 else if (it.code == KeyCode.RIGHT) 1 else return@setOnKeyPressed
            markClass(((if (chosen < 0) CLASSES - 1 - by else chosen) + by).coerceIn(0, CLASSES - 1))
            it.consume()
        }
        empty.isWrapText = true
        empty.styleClass.add("inspector-note")
        figures.styleClass.add("figures")
        worst.styleClass.add("worst")
        content.children.addAll(
            heading("Colour by"), colouring, heading("Figures"), figures,
            heading("Quality of the elements"), histogram, heading("Ten worst elements"), worst,
        )
        content.styleClass.add("mesh-panel-content")
        children.addAll(empty, content)
        session.listen {
            if (it == Change.MESH) {
                chosen = -1
                refresh()
            }
            if (it == Change.VIEW) colouring.value = session.view.colouring.label
        }
        refresh()
    }

    private fun heading(words: String) = Label(words).apply { styleClass.add("section-heading") }

    private fun refresh() {
        val mesh = session.mesh
        empty.isVisible = mesh == null
        empty.isManaged = mesh == null
        content.isVisible = mesh != null
        content.isManaged = mesh != null
        if (mesh == null) return
        val summary = MeshSummaryViewModel.of(mesh)
        figures.children.clear()
        summary.rows.forEachIndexed { i, (name, value) ->
            figures.add(Label(name).apply { styleClass.add("field-label") }, 0, i)
            figures.add(Label(value).apply { styleClass.add("figure") }, 1, i)
        }
        drawHistogram(summary.histogram)
        worst.children.clear()
        for (element in summary.worst) {
            val words = "quality ${Figures.plain(element.quality, 3)}, ${Figures.angle(element.minAngle)}"
            val link = Hyperlink("Element ${element.element}")
            link.setOnAction {
                canvas.markedElements = listOf(element.element)
                canvas.lookAt(element.x, element.y, REACH * mesh.size(element.element))
            }
            worst.children.add(HBox(link, Label(words).apply { styleClass.add("field-unit") }).apply { styleClass.add("worst-row") })
        }
    }

    private fun drawHistogram(counts: IntArray) {
        val g = histogram.graphicsContext2D
        g.clearRect(0.0, 0.0, HISTOGRAM_WIDTH, HISTOGRAM_HEIGHT)
        val most = (counts.maxOrNull() ?: 0).coerceAtLeast(1)
        val cell = HISTOGRAM_WIDTH / CLASSES
        val room = HISTOGRAM_HEIGHT - FOOT - HEAD
        g.font = javafx.scene.text.Font.font(10.0)
        g.textAlign = javafx.scene.text.TextAlignment.CENTER
        for ((i, count) in counts.withIndex()) {
            val colour = ColourScale.of(Colouring.QUALITY).colour((i + HALF) / CLASSES)
            // Few bad elements must show, so a bar that is not empty is never flat.
            val height = if (count == 0) 0.0 else Math.max(2.0, room * count / most)
            g.fill = Color.rgb(colour shr 16 and 255, colour shr 8 and 255, colour and 255)
            g.fillRect(i * cell + 1, HEAD + room - height, cell - 2, height)
            if (i == chosen) {
                g.stroke = ink
                g.lineWidth = if (histogram.isFocused) 2.0 else 1.0
                g.strokeRect(i * cell + 1, HEAD, cell - 2, room)
            }
            g.fill = ink
            if (count > 0) g.fillText(short(count), (i + HALF) * cell, HEAD + room - height - 3)
            if (i % 2 == 0) g.fillText(Figures.plain(i / CLASSES.toDouble(), 2), i * cell + (if (i == 0) 4 else 0), HISTOGRAM_HEIGHT - 4)
        }
        g.fillText("1", HISTOGRAM_WIDTH - 4, HISTOGRAM_HEIGHT - 4)
    }

    private fun short(count: Int): String = when {
        count >= 1_000_000 -> Figures.plain(count / 1e6, 2) + "M"
        count >= 1000 -> Figures.plain(count / 1e3, 2) + "k"
        else -> count.toString()
    }

    /** Outlines the elements of one class of quality. */
    private fun markClass(index: Int) {
        val mesh: MeshView = session.mesh ?: return
        val found = ArrayList<Int>()
        for (element in 0 until mesh.mesh.elementCount) {
            if ((mesh.figures.quality(element) * CLASSES).toInt().coerceIn(0, CLASSES - 1) == index) found.add(element)
            if (found.size == MOST_MARKED) break
        }
        canvas.markedElements = found
        chosen = index
        refresh()
        session.say("${Figures.count(found.size)} elements with a quality from ${index / 10.0} to ${(index + 1) / 10.0}")
    }

    private companion object {
        const val HISTOGRAM_WIDTH = 260.0
        const val HISTOGRAM_HEIGHT = 110.0
        const val FOOT = 16.0
        const val HEAD = 14.0
        const val CLASSES = 10
        const val HALF = 0.5
        const val REACH = 4.0
        const val MOST_MARKED = 20_000
    }
}
