@file:JvmName("Main")

package org.trigrid.editor

import javafx.application.Application
import org.trigrid.editor.app.EditorApp

/** Opens the editor, with the file named first where there is one. */
fun main(arguments: Array<String>) {
    Application.launch(EditorApp::class.java, *arguments)
}
