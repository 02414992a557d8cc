package org.trigrid.editor.app

import javafx.geometry.VPos
import javafx.scene.control.ButtonType
import javafx.scene.control.Dialog
import javafx.scene.control.Label
import javafx.scene.control.ScrollPane
import javafx.scene.layout.GridPane
import javafx.scene.layout.HBox
import javafx.scene.layout.Region
import javafx.scene.layout.VBox
import javafx.stage.Window
import org.trigrid.editor.tool.ShapeKind

/** All keys on one sheet: those of the tools, of the mouse, and of the menus as they are. */
internal class KeySheet(owner: Window?, menus: List<Pair<String, String>>) {
    private class Section(val title: String, val rows: List<Pair<String, String>>)

    private val dialog = Dialog<ButtonType>()

    init {
        dialog.initOwner(owner)
        dialog.title = "Keys and mouse"
        dialog.headerText = null
        dialog.dialogPane.buttonTypes.setAll(ButtonType.CLOSE)
        val half = (menus.size + 1) / 2
        val columns = listOf(
            listOf(Section("Tools", tools()), Section("While the front is played", FILM)),
            listOf(Section("While drawing", DRAWING), Section("Mouse", MOUSE)),
            listOf(Section("Menus", menus.take(half))),
            listOf(Section("", menus.drop(half))),
        )
        val sheet = HBox()
        sheet.styleClass.add("key-sheet")
        for (column in columns) sheet.children.add(VBox(*column.map { view(it) }.toTypedArray()).apply { styleClass.add("key-column") })
        val scroll = ScrollPane(sheet)
        scroll.isFitToWidth = true
        scroll.isFitToHeight = true
        dialog.dialogPane.content = scroll
        dialog.dialogPane.styleClass.add("key-pane")
        dialog.dialogPane.stylesheets.add(EditorWindow.stylesheet)
        dialog.isResizable = true
    }

    fun show() = dialog.show()

    private fun view(section: Section): VBox {
        val grid = GridPane()
        grid.styleClass.add("key-grid")
        section.rows.forEachIndexed { i, (keys, meaning) ->
            val cap = Label(keys).apply { styleClass.add("key-cap"); minWidth = Region.USE_PREF_SIZE }
            val words = Label(meaning).apply { styleClass.add("key-words"); minWidth = Region.USE_PREF_SIZE }
            GridPane.setValignment(cap, VPos.TOP)
            grid.addRow(i, cap, words)
        }
        return VBox(Label(section.title.ifEmpty { " " }).apply { styleClass.add("section-heading") }, grid)
    }

    private fun tools(): List<Pair<String, String>> =
        listOf("V" to "Select", "Shift+V" to "Lasso") + ShapeKind.entries.map { it.key to it.label }

    private companion object {
        val DRAWING = listOf(
            "Enter" to "ends the shape", "Backspace" to "takes the last point back", "Esc" to "cancels", "Shift" to "holds angles",
            "Alt" to "suspends snapping", "3,4" to "a place as it stands", "@1,0" to "from the last point", "@2<30" to "by length and angle",
            "Tab" to "on to the second number", "Arrows" to "move what is picked", "Up, Down" to "sides of a polygon",
        )
        val MOUSE = listOf(
            "Wheel" to "zooms at the mouse", "Right drag" to "moves the sheet", "Space+drag" to "moves the sheet",
            "Double click" to "inserts a node", "Drop on node" to "merges the two", "Click arrow" to "turns the shape round",
        )
        val FILM = listOf(
            "Space" to "plays, pauses", "Left, Right" to "step", "Home, End" to "first, last", "Esc" to "ends",
        )
    }
}
