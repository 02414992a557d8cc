package org.trigrid.editor.app

import javafx.scene.control.CheckMenuItem
import javafx.scene.control.Menu
import javafx.scene.control.MenuBar
import javafx.scene.control.MenuItem
import javafx.scene.control.SeparatorMenuItem
import javafx.scene.input.KeyCombination
import org.trigrid.editor.command.ShapeCommands
import org.trigrid.editor.files.Gallery
import org.trigrid.editor.files.Preferences
import org.trigrid.editor.session.EditorSession
import org.trigrid.editor.tool.ShapeKind
import java.nio.file.Path

/** The actions of the window, and its menus. */
internal class Menus(
    private val session: EditorSession,
    private val preferences: Preferences,
    private val files: FileActions,
    private val edit: EditActions,
    private val picture: PictureActions,
    private val sources: SourceActions,
    private val export: ExportActions,
    private val window: WindowActions,
) {
    val new = EditorAction("New", "Shortcut+N", Icons.NEW) { files.new() }
    val open = EditorAction("Open…", "Shortcut+O", Icons.OPEN) { files.open() }
    val save = EditorAction("Save", "Shortcut+S", Icons.SAVE) { files.save() }
    private val saveAs = EditorAction("Save as…", "Shortcut+Shift+S") { files.saveAs() }
    val undo = EditorAction(
        "Undo", "Shortcut+Z", Icons.UNDO, { "Undo" + (session.undoName?.let { " $it" } ?: "") }, { session.undoName != null },
    ) { session.undo() }
    val redo = EditorAction(
        "Redo", "Shortcut+Shift+Z", Icons.REDO, { "Redo" + (session.redoName?.let { " $it" } ?: "") }, { session.redoName != null },
    ) { session.redo() }
    val fit = EditorAction("Zoom to fit", "Shortcut+0", Icons.FIT) { window.fit() }
    private val fitSelection = EditorAction("Zoom to selection", "Shortcut+Shift+0") { window.fitSelection() }
    val zoomIn = EditorAction("Zoom in", "Shortcut+Plus", Icons.ZOOM_IN) { window.zoom(ZOOM) }
    val zoomOut = EditorAction("Zoom out", "Shortcut+Minus", Icons.ZOOM_OUT) { window.zoom(1 / ZOOM) }
    val mesh = EditorAction("Mesh", "F5", Icons.MESH) { session.generate() }
    val closeLoop = EditorAction("Close loop", "Shortcut+L", Icons.CLOSE_LOOP) { session.execute(ShapeCommands.closeLoop()) }
    val reverse = EditorAction("Reverse direction", "Shortcut+R", Icons.REVERSE, isPossible = { session.selection.shapes.isNotEmpty() }) {
        session.execute(ShapeCommands.reverse(session.selection.shapes))
    }
    val connect = EditorAction("Connect opening", "Shortcut+K", Icons.CONNECT) { edit.connectOpenings() }
    private val exportMesh = EditorAction("Export mesh…", "Shortcut+E", isPossible = { session.mesh != null }) { export.mesh() }
    private val exportCurved = EditorAction("Export mesh of second order…", "Shortcut+Shift+E", isPossible = { session.mesh != null }) { export.mesh(2) }
    private val matrix = EditorAction("Matrix before and after renumbering", "F6", isPossible = { session.mesh != null }) { window.showMatrix() }
    private val all = ArrayList<EditorAction>()
    private val keyed = LinkedHashMap<String, String>()
    private val recent = Menu("Open recent")
    private val checks = ArrayList<() -> Unit>()

    fun bar(): MenuBar {
        val bar = MenuBar(fileMenu(), editMenu(), drawMenu(), pictureMenu(), viewMenu(), meshMenu(), helpMenu())
        bar.isUseSystemMenuBar = true
        return bar
    }

    /** Brings names and marks up to date. */
    fun update() {
        all.forEach { it.update() }
        listOf(new, open, save, undo, redo, fit, zoomIn, zoomOut, mesh, closeLoop, reverse, connect).forEach { it.update() }
        checks.forEach { it() }
    }

    /** Keys and what they do, in the order of the menus. */
    fun shortcuts(): List<Pair<String, String>> = keyed.map { (keys, label) -> KeyCombination.valueOf(keys).displayText to label.removeSuffix("…") }

    fun updateRecent() {
        val items = preferences.recent.map { file -> MenuItem(file.toString()).apply { setOnAction { files.open(file) } } }
        recent.items.setAll(items)
        recent.isDisable = items.isEmpty()
    }

    private fun fileMenu(): Menu {
        updateRecent()
        val gallery = Menu("Gallery")
        gallery.items.setAll(Gallery.entries.map { case -> MenuItem(case.label).apply { setOnAction { window.openCase(case) } } })
        return menu(
            "_File", item(new), item(open), recent, gallery, null, item(save), item(saveAs), null,
            item("Import into drawing…", "Shortcut+I") { window.importFile() },
            item(exportMesh), item(exportCurved), item("Export SVG…") { export.svg() }, item("Export PNG of what is shown…") { export.png() }, null,
            item("Exit", "Shortcut+Q") { window.exit() },
        )
    }

    private fun editMenu(): Menu = menu(
        "_Edit", item(undo), item(redo), null,
        item("Cut", "Shortcut+X") { edit.cut() }, item("Copy", "Shortcut+C") { edit.copy() },
        item("Paste", "Shortcut+V") { edit.paste() }, item("Duplicate", "Shortcut+D") { edit.duplicate() },
        item("Delete") { edit.delete() }, item("Select all", "Shortcut+A") { edit.selectAll() },
        item("Find node…", "Shortcut+F") { edit.findNode() }, null,
        item("Mirror…", "Shortcut+M") { edit.mirror() }, item("Rotate…") { edit.rotate() }, item("Scale…") { edit.scale() },
        item("Repeat in rows and columns…") { edit.array() }, item(reverse),
        item("Explode anew") { session.execute(ShapeCommands.rebuild(session.selection.shapes)) }, null,
        check("Snap to grid", "Shortcut+Shift+G", { session.snapping.toGrid }) { session.snapping = session.snapping.withGrid(it) },
        check("Snap to nodes", "", { session.snapping.toNodes }) { session.snapping = session.snapping.withNodes(it) },
        check("Snap to middles, centres, intersections", "", { session.snapping.toShapes }) { session.snapping = session.snapping.withShapes(it) },
    )

    private fun drawMenu(): Menu {
        val kinds = ShapeKind.entries.map { kind -> MenuItem("${kind.label}    ${kind.key}").apply { setOnAction { session.draw(kind) } } }
        val menu = menu(
            "_Draw", null, item(closeLoop), item(connect),
            item("Go back along connector", "Shortcut+B") { session.execute(ShapeCommands.goBack()) },
            item("Begin new loop", "Shortcut+Shift+N") { session.execute(ShapeCommands.beginLoop()) },
            item("Size at a point", "Shortcut+Shift+A") { sources.point() },
            item("Size along a line", "Shortcut+Shift+D") { sources.line() },
            item("Measure", "Shortcut+Shift+M") { edit.measure() },
        )
        menu.items.addAll(0, kinds)
        return menu
    }

    private fun pictureMenu(): Menu {
        val onPicture = { label: String, keys: String, run: () -> Unit -> item(EditorAction(label, keys, isPossible = { picture.isThere }, run = run)) }
        return menu(
            "_Picture", item("Choose a picture to trace…", "Shortcut+Shift+P") { window.choosePicture() }, null,
            onPicture("Scale by two points", "") { picture.scale() }, onPicture("Move", "") { picture.move() },
            onPicture("Rotate by two points", "") { picture.rotate() }, null,
            onPicture("Stronger", "Shortcut+Shift+Up") { picture.fade(FADE) }, onPicture("Weaker", "Shortcut+Shift+Down") { picture.fade(-FADE) },
            check("Locked", "Shortcut+Shift+L", { picture.isLocked }) { picture.lock(it) }, null,
            onPicture("Remove", "") { picture.remove() },
        )
    }

    private fun viewMenu(): Menu {
        val view = { session.view }
        val theme = Menu("Theme")
        theme.items.setAll(
            (listOf<Theme?>(null) + Theme.entries).map { choice ->
                MenuItem(choice?.label ?: "As the system").apply { setOnAction { window.chooseTheme(choice) } }
            },
        )
        return menu(
            "_View", item(fit), item(fitSelection), item(zoomIn), item(zoomOut), null,
            check("Show mesh", "F7", { view().showMesh }) { session.view = view().copy(showMesh = it) },
            check("Show nodes", "F8", { view().showNodes }) { session.view = view().copy(showNodes = it) },
            check("Show numbers", "F9", { view().showNumbers }) { session.view = view().copy(showNumbers = it) },
            check("Show directions", "", { view().showDirections }) { session.view = view().copy(showDirections = it) },
            check("Show grid", "Shortcut+G", { view().showGrid }) { session.view = view().copy(showGrid = it) }, null,
            item("Problems", "F4") { window.toggleProblems() }, theme,
        )
    }

    private fun meshMenu(): Menu = menu(
        "_Mesh", item(mesh), check("Mesh while editing", "Shift+F5", { session.isLive }) { session.isLive = it },
        item("Cancel") { session.cancelMeshing() }, item("Clear mesh") { session.clearMesh() }, null,
        item("Play the front", "Shift+F6") { session.playFront() }, item(matrix), null, item(exportMesh), item(exportCurved),
    )

    private fun helpMenu(): Menu = menu("_Help", item("Keys and mouse", "F1") { window.showKeys() }, item("About TriGrid") { window.showAbout() })

    private fun menu(name: String, vararg items: MenuItem?): Menu {
        val menu = Menu(name)
        menu.items.addAll(items.map { it ?: SeparatorMenuItem() })
        menu.setOnShowing { update() }
        return menu
    }

    private fun item(action: EditorAction): MenuItem {
        all.add(action)
        if (action.keys.isNotEmpty()) keyed[action.keys] = action.label
        return action.menuItem()
    }

    private fun item(label: String, keys: String = "", run: () -> Unit): MenuItem = item(EditorAction(label, keys, run = run))

    private fun check(label: String, keys: String, isOn: () -> Boolean, set: (Boolean) -> Unit): MenuItem {
        val item = CheckMenuItem(label)
        if (keys.isNotEmpty()) {
            item.accelerator = KeyCombination.valueOf(keys)
            keyed[keys] = label
        }
        item.setOnAction { set(item.isSelected) }
        checks.add { item.isSelected = isOn() }
        return item
    }

    private companion object {
        const val ZOOM = 1.4
        const val FADE = 0.15
    }
}

/** What only the window can do. */
internal interface WindowActions {
    fun fit()

    fun fitSelection()

    fun zoom(factor: Double)

    fun showMatrix()

    fun toggleProblems()

    fun chooseTheme(theme: Theme?)

    fun choosePicture()

    fun importFile()

    fun importInto(file: Path)

    fun openCase(case: Gallery)

    fun showKeys()

    fun showAbout()

    fun exit()
}
