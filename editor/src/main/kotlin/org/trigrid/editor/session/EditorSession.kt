package org.trigrid.editor.session

import java.nio.file.Path
import java.util.concurrent.Executor
import org.trigrid.diagnostics.TriGridException
import org.trigrid.domain.Domain
import org.trigrid.editor.command.CommandHistory
import org.trigrid.editor.command.EditCommand
import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.document.EditorState
import org.trigrid.editor.document.Selection
import org.trigrid.editor.meshing.BackgroundMesher
import org.trigrid.editor.meshing.DomainInspection
import org.trigrid.editor.meshing.FrontPlayback
import org.trigrid.editor.meshing.MeshListener
import org.trigrid.editor.meshing.MeshProgress
import org.trigrid.editor.meshing.MeshView
import org.trigrid.editor.meshing.Problem
import org.trigrid.editor.tool.PointerInput
import org.trigrid.editor.tool.SelectTool
import org.trigrid.editor.tool.ShapeKind
import org.trigrid.editor.tool.ShapeTool
import org.trigrid.editor.tool.SnapSettings
import org.trigrid.editor.tool.Snapper
import org.trigrid.editor.tool.Tool
import org.trigrid.editor.tool.ToolHost
import org.trigrid.geometry.Point2

/**
 * All that a window shows and does, without the window: the history of the document, the tool at hand, what is picked,
 * the mesh. Used by one thread, that of [publisher].
 */
internal class EditorSession(worker: Executor, publisher: Executor) : ToolHost, MeshListener {
    private var history = CommandHistory(EditorState(EditorDocument.EMPTY))
    private val listeners = ArrayList<(Change) -> Unit>()
    val mesher = BackgroundMesher(worker, publisher, this)

    override val state: EditorState get() = history.state
    val document: EditorDocument get() = state.document
    val selection: Selection get() = state.selection
    val isModified: Boolean get() = history.isModified
    val undoName: String? get() = history.undoName
    val redoName: String? get() = history.redoName

    /** The project's file, or null before the first save. */
    var file: Path? = null
        private set

    /** What to call a drawing that has no file of its own yet: what it was imported from. */
    var title: String = UNTITLED
        private set

    var tool: Tool = SelectTool(this)
        private set

    var problems: List<Problem> = emptyList()
        private set

    /** The last mesh made; it may be older than the document. */
    var mesh: MeshView? = null
        private set

    /** The film of the front, or null while none is shown. */
    var playback: FrontPlayback? = null
        private set

    var progress: MeshProgress? = null
        private set

    /** The last thing to tell; empty for nothing. */
    var message: String = ""
        private set

    var isMessageError: Boolean = false
        private set

    /** Whether every change is meshed at once, in the background. */
    var isLive: Boolean = false
        set(value) {
            field = value
            if (value) meshIfSound() else mesher.cancel()
            tell(Change.VIEW)
        }

    var view: ViewSettings = ViewSettings()
        set(value) {
            field = value
            tell(Change.VIEW)
        }

    var snapping: SnapSettings = SnapSettings()
        set(value) {
            field = value
            snapperOf = null
            tell(Change.VIEW)
        }

    /** Pixels of the picture behind in width and height, once it is loaded. */
    override var pictureSize: Point2? = null

    private var inspection: DomainInspection? = null
    private var snapperOf: Pair<EditorDocument, Snapper>? = null

    override val snapper: Snapper
        get() {
            val known = snapperOf
            if (known != null && known.first === document) return known.second
            return Snapper(document, snapping).also { snapperOf = document to it }
        }

    /** The domain that is drawn, where it has no faults and is up to date; else null. */
    val domain: Domain? get() = inspection?.takeIf { it.document.isMeshedAs(document) }?.domain

    val isMeshCurrent: Boolean get() = mesh?.document?.isMeshedAs(document) == true

    fun listen(listener: (Change) -> Unit) {
        listeners.add(listener)
    }

    // Documents

    /** Shows another document; the one before must have been saved or given up. */
    fun open(document: EditorDocument, file: Path?, title: String = file?.fileName?.toString() ?: UNTITLED) {
        history = CommandHistory(EditorState(document))
        this.file = file
        this.title = title
        mesh = null
        problems = emptyList()
        mesher.cancel()
        selectTool()
        say("")
        tell(Change.MESH)
        tell(Change.FILE)
        documentChanged()
    }

    /** Shows what a crash left behind; it counts as changed. */
    fun recover(document: EditorDocument, file: Path?) {
        open(document, file)
        history.markUnsaved()
        tell(Change.FILE)
    }

    /** [saved] is now what [file] holds. */
    fun saved(saved: EditorDocument, file: Path) {
        history.markSaved(saved)
        this.file = file
        title = file.fileName.toString()
        tell(Change.FILE)
    }

    // Commands

    override fun execute(command: EditCommand): Boolean {
        val before = document
        try {
            history.execute(command)
        } catch (error: TriGridException) {
            say(error.message.orEmpty(), true)
            return false
        } catch (error: IllegalArgumentException) {
            say(error.message.orEmpty(), true)
            return false
        }
        if (document !== before) {
            say("")
            documentChanged()
        } else {
            tell(Change.SELECTION)
        }
        return true
    }

    /** Whatever comes next is a step of its own. */
    fun endStep() = history.endMerging()

    /** Takes the last step back, or the last point of a shape that is being drawn. */
    fun undo() {
        if (tool.backspace()) return tell(Change.PREVIEW)
        val name = history.undoName ?: return
        history.undo()
        afterTravel("Undone: $name")
    }

    fun redo() {
        val name = history.redoName ?: return
        history.redo()
        afterTravel("Redone: $name")
    }

    private fun afterTravel(words: String) {
        documentChanged()
        tool.documentChanged()
        say(words)
    }

    override fun select(selection: Selection) {
        if (selection == state.selection) return
        history.select(state.withSelection(selection))
        tell(Change.SELECTION)
    }

    private fun documentChanged() {
        stopPlayback()
        tell(Change.DOCUMENT)
        tell(Change.SELECTION)
        tell(Change.PREVIEW)
        mesher.inspect(document)
        if (document.isEmpty && mesh != null) {
            mesh = null
            tell(Change.MESH)
        }
    }

    // Tools

    fun draw(kind: ShapeKind) = use(ShapeTool(this, kind))

    fun selectTool(isLasso: Boolean = false) = use(SelectTool(this, isLasso))

    fun use(tool: Tool) {
        this.tool = tool
        history.endMerging()
        if (message.isNotEmpty()) say("")
        tell(Change.TOOL)
        tell(Change.PREVIEW)
    }

    override fun leaveTool() = selectTool()

    fun press(input: PointerInput) {
        if (message.isNotEmpty()) say("")
        withTool { it.press(input) }
    }

    fun drag(input: PointerInput) = withTool { it.drag(input) }

    fun release(input: PointerInput) = withTool { it.release(input) }

    fun move(input: PointerInput) = withTool { it.move(input) }

    /** Does [action] with the tool at hand and tells that its preview may be another. */
    fun withTool(action: (Tool) -> Unit) {
        action(tool)
        tell(Change.PREVIEW)
    }

    // Mesh

    fun generate() {
        if (document.isEmpty) return say("Draw a closed shape first, then mesh it")
        mesher.mesh(document)
    }

    fun cancelMeshing() {
        mesher.cancel()
        say("Meshing cancelled")
    }

    /** Meshes and shows, element by element, how the front advances. */
    fun playFront() {
        if (document.isEmpty) return say("Draw a closed shape first, then play its front")
        mesher.trace(document) {
            playback = FrontPlayback(it)
            say("")
            tell(Change.PLAYBACK)
        }
    }

    /** Does [action] with the film that is shown. */
    fun withPlayback(action: (FrontPlayback) -> Unit) {
        val shown = playback ?: return
        action(shown)
        tell(Change.PLAYBACK)
    }

    fun stopPlayback() {
        if (playback == null) return
        playback = null
        tell(Change.PLAYBACK)
    }

    fun clearMesh() {
        mesh = null
        tell(Change.MESH)
    }

    private fun meshIfSound() {
        val known = inspection
        if (known != null && known.document === document && known.domain != null) mesher.mesh(document)
    }

    override fun inspected(inspection: DomainInspection) {
        this.inspection = inspection
        problems = inspection.problems
        tell(Change.PROBLEMS)
        if (isLive && mesh?.document?.isMeshedAs(inspection.document) != true) meshIfSound()
    }

    override fun progressed(progress: MeshProgress?) {
        this.progress = progress
        tell(Change.PROGRESS)
    }

    override fun meshed(view: MeshView) {
        mesh = view
        if (message.isNotEmpty()) say("")
        tell(Change.MESH)
    }

    override fun failed(message: String?) {
        if (message == null) say("Meshing cancelled") else say(message, true)
    }

    fun say(words: String, isError: Boolean = false) {
        message = words
        isMessageError = isError
        tell(Change.MESSAGE)
    }

    private fun tell(change: Change) {
        for (listener in listeners) listener(change)
    }

    companion object {
        const val UNTITLED = "Untitled"
    }
}
