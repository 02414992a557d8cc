package org.trigrid.editor.files

import org.trigrid.editor.document.EditorDocument
import org.trigrid.project.ProjectFile

/** The paper's cases, which come with the editor. */
internal enum class Gallery(val label: String, private val file: String) {
    GENERAL("All shapes (Fig. 8)", "general"),
    MACHINE_PART("Machine part (Fig. 9)", "machine-part"),
    OWEN("Square and circle (Fig. 10)", "owen"),
    BASTIAN("Ellipse with a hole (Fig. 11)", "bastian"),
    HAND("Hand (Fig. 12)", "hand"),
    SMALL_GRID("Small grid (Fig. 7)", "small-grid"),
    ;

    /** @throws IllegalStateException if the editor was packed without it. */
    fun document(): EditorDocument {
        val name = "/org/trigrid/editor/gallery/$file.trigrid.json"
        val stream = checkNotNull(Gallery::class.java.getResourceAsStream(name)) { "the editor was packed without $name" }
        val text = stream.use { it.readAllBytes().toString(Charsets.UTF_8) }
        return EditorDocument(ProjectFile.parse(text, "$file.trigrid.json"))
    }
}
