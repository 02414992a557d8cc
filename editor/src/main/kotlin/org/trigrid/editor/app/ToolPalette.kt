package org.trigrid.editor.app

import javafx.geometry.Orientation
import javafx.scene.control.Separator
import javafx.scene.control.ToggleButton
import javafx.scene.control.Tooltip
import javafx.scene.layout.FlowPane
import org.trigrid.editor.session.Change
import org.trigrid.editor.session.EditorSession
import org.trigrid.editor.tool.SelectTool
import org.trigrid.editor.tool.ShapeKind
import org.trigrid.editor.tool.ShapeTool

/** The tools down the left side of the window, in a second column where it is low. */
internal class ToolPalette(private val session: EditorSession) : FlowPane(Orientation.VERTICAL) {
    private val kinds = LinkedHashMap<ShapeKind, ToggleButton>()
    private val select = toggle("Select and move", "V", Icons.SELECT) { session.selectTool() }
    private val lasso = toggle("Pick nodes with a lasso", "Shift+V", Icons.LASSO) { session.selectTool(true) }

    init {
        styleClass.add("tool-palette")
        children.addAll(select, lasso, rule())
        for (kind in ShapeKind.entries) {
            val button = toggle(kind.label, kind.key, iconOf(kind)) { session.draw(kind) }
            button.id = "tool-" + kind.name.lowercase().replace('_', '-')
            kinds[kind] = button
            if (kind == ShapeKind.RECTANGLE || kind == ShapeKind.CONNECTOR) children.add(rule())
            children.add(button)
        }
        session.listen { if (it == Change.TOOL) refresh() }
        refresh()
    }

    private fun rule() = Separator().apply { prefWidth = RULE }

    private fun toggle(label: String, key: String, icon: Icons, run: () -> Unit): ToggleButton {
        val button = ToggleButton()
        button.graphic = icon.node(20.0)
        button.tooltip = Tooltip("$label  ($key)")
        button.accessibleText = label
        button.styleClass.add("palette-button")
        button.isFocusTraversable = false
        button.setOnAction {
            run()
            refresh()
        }
        return button
    }

    private fun refresh() {
        val tool = session.tool
        select.isSelected = tool is SelectTool && tool.label == "Select"
        lasso.isSelected = tool is SelectTool && tool.label == "Lasso"
        for ((kind, button) in kinds) button.isSelected = tool is ShapeTool && tool.kind == kind
    }

    private fun iconOf(kind: ShapeKind): Icons = when (kind) {
        ShapeKind.LINE -> Icons.LINE
        ShapeKind.LINES -> Icons.LINES
        ShapeKind.CURVE -> Icons.CURVE
        ShapeKind.ARC -> Icons.ARC
        ShapeKind.RECTANGLE -> Icons.RECTANGLE
        ShapeKind.POLYGON -> Icons.POLYGON
        ShapeKind.REGULAR_POLYGON -> Icons.REGULAR
        ShapeKind.CIRCLE -> Icons.CIRCLE
        ShapeKind.ELLIPSE -> Icons.ELLIPSE
        ShapeKind.CONNECTOR -> Icons.CONNECTOR
    }

    private companion object {
        const val RULE = 38.0
    }
}
