package org.trigrid.editor.inspector

import org.trigrid.editor.command.EditCommand
import org.trigrid.editor.tool.Figures

/** A property as people see and change it. Immutable. */
internal class InspectorField(
    val label: String,
    val value: String,
    /** Behind the field; empty for none. */
    val unit: String = "",
    /** What can be chosen; empty for what is typed. */
    val choices: List<String> = emptyList(),
    val help: String = "",
    /** A colour that goes with it, `#rrggbb`, in a box to choose another one; null for none. */
    val colour: InspectorColour? = null,
    /** The command that a text asks for; throws [IllegalArgumentException] with the reason where it asks for nothing. Null: cannot be changed. */
    val change: ((String) -> EditCommand)? = null,
) {
    val isReadOnly: Boolean get() = change == null

    /** [value] with no more digits than there is room for, while nobody edits it. */
    val shown: String
        get() {
            val number = if (unit.isEmpty() || value.length <= MOST_CHARACTERS) null else value.toDoubleOrNull()
            return if (number == null) value else Figures.plain(number, DIGITS)
        }

    private companion object {
        const val MOST_CHARACTERS = 9
        const val DIGITS = 7
    }
}

/** A colour, `#rrggbb`, and the command that another one asks for. Immutable. */
internal class InspectorColour(val value: String, val change: (String) -> EditCommand)

/** Fields under one heading. */
internal class InspectorSection(val heading: String, val fields: List<InspectorField>)
