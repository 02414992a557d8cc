package org.trigrid.editor.meshing

import org.trigrid.editor.command.EditCommand

/** Something wrong with the domain, where it is, and what would mend it. */
internal class Problem(
    /** In a few words. */
    val title: String,
    val message: String,
    val x: Double,
    val y: Double,
    /** Whether it keeps the domain from being meshed. */
    val isFault: Boolean,
    val fix: EditCommand? = null,
)
