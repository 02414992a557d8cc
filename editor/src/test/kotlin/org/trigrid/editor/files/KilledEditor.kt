package org.trigrid.editor.files

import org.trigrid.editor.session.drawWith
import org.trigrid.editor.session.newSession
import org.trigrid.editor.tool.ShapeKind
import java.nio.file.Path

/** Draws, keeps its copy, and then waits to be killed. */
internal class KilledEditor {
    companion object {
        @JvmStatic
        fun main(arguments: Array<String>) {
            val file = Path.of(arguments[0])
            val session = newSession()
            session.drawWith(ShapeKind.CIRCLE, 0.0, 0.0, 2.0, 0.0)
            Autosave(file.parent).write(file, session.document)
            println("copied")
            Thread.sleep(60_000)
        }
    }
}
