package org.trigrid.editor.app

import javafx.scene.control.Button
import javafx.scene.control.MenuItem
import javafx.scene.control.Tooltip
import javafx.scene.input.KeyCombination

/** Something to do, once in a menu, once more on a button; with its keys. */
internal class EditorAction(
    val label: String,
    val keys: String = "",
    val icon: Icons? = null,
    private val name: () -> String = { label },
    private val isPossible: () -> Boolean = { true },
    val run: () -> Unit,
) {
    fun menuItem(): MenuItem {
        val item = MenuItem(label)
        if (keys.isNotEmpty()) item.accelerator = KeyCombination.valueOf(keys)
        item.setOnAction { run() }
        updates.add {
            item.text = name()
            item.isDisable = !isPossible()
        }
        return item
    }

    fun button(): Button {
        val button = Button()
        if (icon != null) button.graphic = icon.node() else button.text = label
        button.styleClass.add("tool-button")
        button.isFocusTraversable = false
        button.accessibleText = label
        button.setOnAction { run() }
        updates.add {
            button.tooltip = Tooltip(name() + shortcut())
            button.isDisable = !isPossible()
        }
        return button
    }

    /** Brings names and what is greyed out up to date. */
    fun update() {
        for (update in updates) update()
    }

    private val updates = ArrayList<() -> Unit>()

    private fun shortcut(): String = if (keys.isEmpty()) "" else "  (${KeyCombination.valueOf(keys).displayText})"
}
