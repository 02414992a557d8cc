package org.trigrid.editor.app

import java.nio.file.Path
import java.util.concurrent.ExecutorService
import javafx.application.Platform
import javafx.geometry.Insets
import javafx.geometry.Orientation
import javafx.geometry.Pos
import javafx.scene.Scene
import javafx.scene.control.Button
import javafx.scene.control.ScrollPane
import javafx.scene.control.Separator
import javafx.scene.control.Tab
import javafx.scene.control.TabPane
import javafx.scene.control.ToggleButton
import javafx.scene.control.ToolBar
import javafx.scene.control.Tooltip
import javafx.scene.input.TransferMode
import javafx.scene.layout.BorderPane
import javafx.scene.layout.Region
import javafx.scene.layout.StackPane
import javafx.scene.layout.VBox
import javafx.stage.FileChooser
import javafx.stage.Screen
import javafx.stage.Stage
import org.trigrid.editor.canvas.DrawingCanvas
import org.trigrid.editor.command.AddShapes
import org.trigrid.editor.files.Autosave
import org.trigrid.editor.files.DocumentFile
import org.trigrid.editor.files.Gallery
import org.trigrid.editor.files.OptionMemory
import org.trigrid.editor.files.Preferences
import org.trigrid.editor.inspector.FieldsView
import org.trigrid.editor.inspector.InspectorView
import org.trigrid.editor.inspector.OptionsViewModel
import org.trigrid.editor.session.Change
import org.trigrid.editor.session.EditorSession
import org.trigrid.editor.session.ViewSettings
import org.trigrid.editor.tool.SelectTool

/** The window: menus, tools, the sheet, what is picked, what is wrong, how the mesh stands. */
internal class EditorWindow(
    val stage: Stage,
    private val preferences: Preferences,
    private val worker: ExecutorService,
) : WindowActions {
    val session = EditorSession(worker, Platform::runLater)
    val canvas = DrawingCanvas(session)
    private val dialogs = Dialogs { stage }
    private val meshOptions = OptionMemory(preferences)
    val files = FileActions(session, preferences, Autosave(Preferences.folder()), meshOptions, dialogs, worker) { stage }
    private val edit = EditActions(session, canvas, dialogs)
    private val picture = PictureActions(session, canvas, dialogs)
    val export = ExportActions(session, files, canvas) { stage }
    private val menus = Menus(session, preferences, files, edit, picture, SourceActions(session, dialogs), export, this)
    private val inspector = InspectorView(session)
    private val options = OptionsViewModel(session)
    private val optionFields = FieldsView { field, text -> field.change?.let { commitOption(it, field.value, text) } }
    private val meshPanel = MeshPanel(session, canvas)
    private val status = StatusBar(session, ::toggleProblems) { canvas.requestFocus() }
    private val problems = ProblemsView(session, canvas, ::toggleProblems)
    private val tabs = TabPane()
    private val root = BorderPane()
    private val live = ToggleButton()
    private var theme = Theme.LIGHT
    private val welcome = WelcomeView(
        preferences, worker, Platform::runLater, { theme }, files::open, ::openCase, files::open, ::startDrawing,
    )
    private val film = FrontBar(session) { canvas.requestFocus() }
    private val centre = StackPane(canvas, film, welcome)

    init {
        root.top = VBox(menus.bar(), toolBar())
        root.left = ToolPalette(session)
        // Whatever lies on the sheet must not make the window's parts wider than the window.
        centre.setMinSize(0.0, 0.0)
        root.center = BorderPane(centre)
        root.right = side()
        root.bottom = status
        StackPane.setAlignment(welcome, Pos.CENTER)
        StackPane.setAlignment(film, Pos.BOTTOM_CENTER)
        StackPane.setMargin(film, Insets(0.0, 0.0, FILM_MARGIN, 0.0))
        welcome.managedProperty().bind(welcome.visibleProperty())
        val screen = Screen.getPrimary().visualBounds
        val scene = Scene(
            root, Math.min(preferences.number("width") ?: WIDTH, screen.width), Math.min(preferences.number("height") ?: HEIGHT, screen.height),
        )
        scene.stylesheets.add(stylesheet)
        stage.scene = scene
        stage.minWidth = Math.min(LEAST_WIDTH, screen.width)
        stage.minHeight = Math.min(LEAST_HEIGHT, screen.height)
        KeyInput(session, canvas, edit, status::beginEntry).listenTo(scene)
        acceptDrops(scene)
        canvas.pointed = status::pointed
        files.opened = ::opened
        session.listen(::changed)
        stage.setOnCloseRequest {
            it.consume()
            exit()
        }
        restore()
        titleChanged()
        menus.update()
    }

    private fun toolBar(): ToolBar {
        val mesh = Button("Mesh", Icons.MESH.node())
        mesh.id = "mesh"
        mesh.styleClass.add("accent")
        mesh.isFocusTraversable = false
        mesh.tooltip = Tooltip("Mesh the domain  (F5)")
        mesh.setOnAction { session.generate() }
        live.graphic = Icons.LIVE.node()
        live.id = "live"
        live.styleClass.add("tool-button")
        live.isFocusTraversable = false
        live.tooltip = Tooltip("Mesh while editing  (Shift+F5)")
        live.accessibleText = "Mesh while editing"
        live.setOnAction { session.isLive = live.isSelected }
        val bar = { Separator(Orientation.VERTICAL) }
        return ToolBar(
            menus.new.button(), menus.open.button(), menus.save.button(), bar(),
            menus.undo.button(), menus.redo.button(), bar(),
            menus.zoomIn.button(), menus.zoomOut.button(), menus.fit.button(), bar(),
            menus.closeLoop.button(), menus.reverse.button(), menus.connect.button(), bar(), mesh, live,
        )
    }

    private fun side(): Region {
        val optionsBox = VBox(optionFields)
        optionsBox.styleClass.add("options")
        tabs.tabs.addAll(tab("Shape", inspector), tab("Options", optionsBox), tab("Mesh", meshPanel))
        tabs.tabClosingPolicy = TabPane.TabClosingPolicy.UNAVAILABLE
        val side = BorderPane(tabs)
        side.styleClass.add("side")
        return side
    }

    private fun tab(name: String, content: Region): Tab {
        val scroll = ScrollPane(content)
        scroll.isFitToWidth = true
        scroll.hbarPolicy = ScrollPane.ScrollBarPolicy.NEVER
        return Tab(name, scroll)
    }

    private fun commitOption(change: (String) -> org.trigrid.editor.command.EditCommand, old: String, text: String): String? {
        if (text == old) return null
        val command = try {
            change(text)
        } catch (error: IllegalArgumentException) {
            return error.message
        }
        if (!session.execute(command)) return session.message
        meshOptions.remember(session.document.project.options)
        return null
    }

    private fun changed(change: Change) {
        when (change) {
            Change.DOCUMENT -> {
                optionFields.show(options.sections)
                if (!session.document.isEmpty) welcome.isVisible = false
                titleChanged()
                menus.update()
            }
            Change.FILE -> {
                titleChanged()
                menus.updateRecent()
            }
            Change.SELECTION, Change.MESH -> menus.update()
            Change.VIEW -> {
                live.isSelected = session.isLive
                remember()
            }
            Change.TOOL -> {
                if (session.tool !is SelectTool) welcome.isVisible = false
                canvas.requestFocus()
            }
            Change.PLAYBACK -> if (session.playback?.position == 0) canvas.requestFocus()
            Change.PREVIEW, Change.PROBLEMS, Change.PROGRESS, Change.MESSAGE -> Unit
        }
    }

    private fun titleChanged() {
        stage.title = (if (session.isModified) "• " else "") + session.title + " – TriGrid"
    }

    private fun opened() {
        welcome.isVisible = session.document.isEmpty && session.file == null && welcome.isVisible
        canvas.fit()
        optionFields.show(options.sections)
        canvas.requestFocus()
    }

    fun startDrawing() {
        welcome.isVisible = false
        session.draw(org.trigrid.editor.tool.ShapeKind.LINES)
        canvas.requestFocus()
    }

    private fun acceptDrops(scene: Scene) {
        scene.setOnDragOver { if (it.dragboard.hasFiles()) it.acceptTransferModes(TransferMode.COPY) }
        scene.setOnDragDropped { event ->
            val dropped = event.dragboard.files.firstOrNull()?.toPath()
            if (dropped != null) Platform.runLater { drop(dropped) }
            event.isDropCompleted = dropped != null
        }
    }

    fun drop(file: Path) {
        val name = file.fileName.toString().lowercase()
        if (PICTURES.any { name.endsWith(it) }) setPicture(file) else files.open(file)
    }

    fun setPicture(file: Path) {
        val image = javafx.scene.image.Image(file.toUri().toString())
        if (image.isError) return dialogs.tell("$file cannot be shown", "It is no PNG or JPEG picture.")
        welcome.isVisible = false
        picture.set(file, image.width)
    }

    // What menus and buttons ask for

    override fun fit() = canvas.fit()

    override fun fitSelection() = canvas.fitSelection()

    override fun zoom(factor: Double) = canvas.zoom(factor)

    override fun showMatrix() {
        val mesh = session.mesh ?: return session.say("Make a mesh first", true)
        session.mesher.unnumbered(mesh) { MatrixWindow(stage, mesh, it).stage.show() }
    }

    override fun toggleProblems() {
        val middle = root.center as BorderPane
        middle.bottom = if (middle.bottom == null) problems else null
        if (middle.bottom != null) problems.takeFocus() else canvas.requestFocus()
    }

    override fun chooseTheme(theme: Theme?) {
        preferences["theme"] = theme?.name
        if (theme != null) return use(theme)
        worker.execute {
            val found = Theme.ofSystem()
            Platform.runLater { if (preferences["theme"] == null && found != this.theme) use(found) }
        }
    }

    fun use(theme: Theme) {
        this.theme = theme
        preferences["theme.last"] = theme.name
        theme.apply()
        canvas.colours = theme.colours
        inspector.ink = theme.colours.text
        meshPanel.ink = theme.colours.text
        options.palette = theme.colours.palette
        optionFields.show(options.sections)
        welcome.refresh()
    }

    override fun choosePicture() {
        val chooser = files.chooser("Choose a picture to trace over")
        chooser.extensionFilters.add(FileChooser.ExtensionFilter("Pictures", PICTURES.map { "*$it" }))
        chooser.showOpenDialog(stage)?.let { setPicture(it.toPath()) }
    }

    override fun importFile() {
        val chooser = files.chooser("Import into the drawing")
        chooser.extensionFilters.add(FileChooser.ExtensionFilter("Domains", DocumentFile.patterns))
        chooser.showOpenDialog(stage)?.let { importInto(it.toPath()) }
    }

    override fun importInto(file: Path) {
        files.attempt("$file cannot be imported") {
            val read = DocumentFile.read(file).document
            val shapes = (0 until read.path.shapeCount).map { read.path.shape(it) }
            session.execute(AddShapes(shapes, read.loops, "import ${file.fileName}"))
            canvas.fit()
        }
    }

    override fun openCase(case: Gallery) {
        if (!files.mayLeave()) return
        session.open(case.document(), null, case.label)
        opened()
    }

    override fun showKeys() = KeySheet(stage, menus.shortcuts()).show()

    override fun showAbout() = dialogs.inform(
        "TriGrid", "Triangular meshes of irregular domains by an advancing front, after H. Naji. Apache-2.0.",
    )

    override fun exit() {
        if (!files.mayLeave()) return
        remember()
        canvas.close()
        stage.close()
        worker.shutdownNow()
    }

    // What is remembered

    private fun remember() {
        if (!stage.isMaximized && stage.isShowing) {
            preferences["width"] = stage.scene.width.toString()
            preferences["height"] = stage.scene.height.toString()
            preferences["x"] = stage.x.toString()
            preferences["y"] = stage.y.toString()
        }
        preferences["maximized"] = stage.isMaximized.toString()
        preferences["live"] = session.isLive.toString()
        val view = session.view
        preferences["view.mesh"] = view.showMesh.toString()
        preferences["view.nodes"] = view.showNodes.toString()
        preferences["view.numbers"] = view.showNumbers.toString()
        preferences["view.directions"] = view.showDirections.toString()
        preferences["view.grid"] = view.showGrid.toString()
        preferences["view.colouring"] = view.colouring.name
        preferences["snap.grid"] = session.snapping.toGrid.toString()
        preferences["snap.nodes"] = session.snapping.toNodes.toString()
        preferences["snap.shapes"] = session.snapping.toShapes.toString()
    }

    /** Where the window was, if it can be seen there. */
    private fun restorePlace() {
        val x = preferences.number("x") ?: return
        val y = preferences.number("y") ?: return
        if (Screen.getScreensForRectangle(x, y, SEEN, SEEN).isEmpty()) return
        stage.x = x
        stage.y = y
    }

    private fun restore() {
        session.view = ViewSettings(
            preferences.flag("view.mesh", true), preferences.flag("view.nodes", true), preferences.flag("view.numbers", true),
            preferences.flag("view.directions", true), preferences.flag("view.grid", true),
            org.trigrid.editor.meshing.Colouring.entries.firstOrNull { it.name == preferences["view.colouring"] }
                ?: org.trigrid.editor.meshing.Colouring.NONE,
        )
        session.snapping = session.snapping.withGrid(preferences.flag("snap.grid", true))
            .withNodes(preferences.flag("snap.nodes", true)).withShapes(preferences.flag("snap.shapes", true))
        session.open(files.empty(), null)
        restorePlace()
        session.isLive = preferences.flag("live", false)
        stage.isMaximized = preferences.flag("maximized", false)
        val chosen = Theme.of(preferences["theme"].orEmpty())
        use(chosen ?: Theme.of(preferences["theme.last"].orEmpty()) ?: Theme.LIGHT)
        if (chosen == null) chooseTheme(null)
        optionFields.show(options.sections)
    }

    companion object {
        private const val WIDTH = 1280.0
        private const val HEIGHT = 820.0
        private const val LEAST_WIDTH = 900.0
        private const val LEAST_HEIGHT = 560.0
        private const val FILM_MARGIN = 14.0

        /** Pixels of the window's corner that must be on a screen. */
        private const val SEEN = 60.0
        private val PICTURES = listOf(".png", ".jpg", ".jpeg", ".gif", ".bmp")

        val stylesheet: String = EditorWindow::class.java.getResource("editor.css")!!.toExternalForm()
    }
}
