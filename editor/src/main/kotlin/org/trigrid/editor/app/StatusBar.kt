package org.trigrid.editor.app

import javafx.scene.control.Button
import javafx.scene.control.Label
import javafx.scene.control.ProgressBar
import javafx.scene.control.TextField
import javafx.scene.control.Tooltip
import javafx.scene.input.KeyCode
import javafx.scene.input.KeyEvent
import javafx.scene.layout.HBox
import javafx.scene.layout.Priority
import javafx.scene.layout.Region
import org.trigrid.editor.meshing.MeshSummaryViewModel
import org.trigrid.editor.session.Change
import org.trigrid.editor.session.EditorSession
import org.trigrid.editor.tool.CoordinateEntry
import org.trigrid.editor.tool.Figures
import org.trigrid.geometry.Point2

/** The foot of the window: what to do next, where the mouse is, how the mesh stands; places are typed here. */
internal class StatusBar(private val session: EditorSession, private val showProblems: () -> Unit, private val toCanvas: () -> Unit) : HBox() {
    private val hint = Label()
    private val place = Label()
    private val measure = Label()
    private val figures = Label()
    private val problems = Button()
    private val progress = ProgressBar()
    private val progressWords = Label()
    private val cancel = Button()
    private var pointer: Point2? = null
    val entry = TextField()

    init {
        styleClass.add("status-bar")
        hint.styleClass.add("status-hint")
        hint.minWidth = 40.0
        place.styleClass.add("status-place")
        measure.id = "status-measure"
        problems.styleClass.addAll("status-problems", "flat")
        problems.isFocusTraversable = false
        problems.setOnAction { showProblems() }
        progress.prefWidth = PROGRESS_WIDTH
        cancel.graphic = Icons.CANCEL.node(12.0)
        cancel.styleClass.addAll("flat", "status-cancel")
        cancel.tooltip = Tooltip("Cancel meshing (Esc)")
        cancel.setOnAction { session.cancelMeshing() }
        entry.id = "coordinate-entry"
        entry.promptText = "3,4   @1,0   @2<30"
        entry.prefColumnCount = 13
        entry.minWidth = ENTRY_WIDTH
        entry.styleClass.add("coordinate-entry")
        entry.tooltip = Tooltip("Type a place at any moment, Tab goes to its second number: 3,4 as it stands, @1,0 from the last point, @2<30 by length and angle")
        entry.setOnAction { submit() }
        // A filter, since Tab would leave the field before its handler is asked.
        entry.addEventFilter(KeyEvent.KEY_PRESSED) {
            if (it.code == KeyCode.TAB && !it.isShiftDown && CoordinateEntry.awaitsSecond(entry.text)) {
                entry.text = CoordinateEntry.withSeparator(entry.text)
                entry.positionCaret(entry.text.length)
                it.consume()
            }
            if (it.code == KeyCode.ESCAPE) {
                entry.clear()
                toCanvas()
                it.consume()
            }
        }
        entry.textProperty().addListener { _, _, _ -> entry.styleClass.remove("entry-fault") }
        val spring = Region()
        setHgrow(spring, Priority.ALWAYS)
        for (fixed in listOf(place, problems, progressWords, cancel)) fixed.minWidth = Region.USE_PREF_SIZE
        // In a narrow window these give way, so that the rest is not pushed off.
        for (yielding in listOf(measure, figures)) yielding.minWidth = 0.0
        minWidth = 0.0
        children.addAll(hint, spring, progressWords, progress, cancel, problems, figures, measure, place, entry)
        session.listen(::changed)
        refreshAll()
    }

    /** Begins typing a place with [first]. */
    fun beginEntry(first: String) {
        entry.requestFocus()
        entry.text = first
        entry.positionCaret(first.length)
    }

    fun pointed(x: Double, y: Double, element: Int) {
        pointer = Point2(x, y)
        refreshPlace()
        val mesh = session.mesh
        if (element < 0 || mesh == null) return refreshFigures()
        figures.text = "element $element: quality ${Figures.plain(mesh.figures.quality(element), 3)}, " +
            "min angle ${Figures.angle(mesh.figures.minAngle(element))}, size ${Figures.plain(mesh.size(element), 3)}"
    }

    /** Where a click would go: the place that the mouse is drawn to, or its own. */
    private fun refreshPlace() {
        val preview = session.tool.preview
        measure.text = preview.measure
        measure.isVisible = preview.measure.isNotEmpty()
        measure.isManaged = measure.isVisible
        val at = preview.snap?.point ?: pointer ?: return
        place.text = "x ${Figures.plain(at.x, DIGITS)}   y ${Figures.plain(at.y, DIGITS)}"
    }

    private fun submit() {
        val point = CoordinateEntry.parse(entry.text, session.tool.lastPoint)
        if (point == null) {
            if (entry.text.isBlank()) return toCanvas()
            if ("entry-fault" !in entry.styleClass) entry.styleClass.add("entry-fault")
            session.say("“${entry.text}” is no place. Type 3,4 or @1,0 or @2<30", true)
            return
        }
        session.withTool { it.typed(point) }
        entry.clear()
        toCanvas()
    }

    private fun changed(change: Change) {
        when (change) {
            Change.PREVIEW, Change.TOOL -> {
                refreshHint()
                refreshPlace()
            }
            Change.MESSAGE, Change.SELECTION -> refreshHint()
            Change.MESH, Change.VIEW -> refreshFigures()
            Change.PROBLEMS, Change.DOCUMENT -> refreshProblems()
            Change.PROGRESS -> refreshProgress()
            Change.FILE, Change.PLAYBACK -> Unit
        }
    }

    private fun refreshAll() {
        refreshHint()
        refreshPlace()
        refreshFigures()
        refreshProblems()
        refreshProgress()
    }

    private fun refreshHint() {
        hint.text = session.message.ifEmpty { session.tool.label + ": " + session.tool.hint }
        hint.styleClass.removeAll("status-error")
        if (session.message.isNotEmpty() && session.isMessageError) hint.styleClass.add("status-error")
    }

    private fun refreshFigures() {
        val mesh = session.mesh
        if (mesh == null) {
            figures.text = ""
            return
        }
        val summary = MeshSummaryViewModel.of(mesh)
        val stale = if (session.isMeshCurrent) "" else " (before the last changes)"
        figures.text = "${summary.counts}, ${summary.worstAngle}$stale"
    }

    private fun refreshProblems() {
        val faults = session.problems.count { it.isFault }
        val warnings = session.problems.size - faults
        problems.styleClass.removeAll("status-error", "status-warning", "status-good")
        when {
            session.document.isEmpty -> problems.text = ""
            faults > 0 -> {
                problems.text = if (faults == 1) "1 fault" else "$faults faults"
                problems.styleClass.add("status-error")
            }
            warnings > 0 -> {
                problems.text = if (warnings == 1) "1 warning" else "$warnings warnings"
                problems.styleClass.add("status-warning")
            }
            else -> {
                problems.text = "no faults"
                problems.styleClass.add("status-good")
            }
        }
        problems.isManaged = problems.text.isNotEmpty()
        problems.isVisible = problems.isManaged
    }

    private fun refreshProgress() {
        val now = session.progress
        for (node in listOf(progress, progressWords, cancel)) {
            node.isVisible = now != null
            node.isManaged = now != null
        }
        if (now == null) return
        progress.progress = now.fraction
        progressWords.text = now.words
    }

    private companion object {
        const val PROGRESS_WIDTH = 120.0
        const val DIGITS = 5
        const val ENTRY_WIDTH = 110.0
    }
}
