package org.trigrid.editor.document

import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.diagnostics.TriGridException
import org.trigrid.shape.Polygon

/** What a shape does for the domain, in words. */
internal object ShapeRole {
    /** Empty where it has none yet. */
    fun of(document: EditorDocument, shape: Int): String {
        val path = document.path
        if (path.isConnector(shape)) return "Connector, there and back"
        val walks = path.walks()
        val at = walks.indexOfFirst { walk -> (0 until walk.stepCount).any { walk.shape(it) == shape } }
        if (at < 0) return ""
        val walk = walks[at]
        if (!walk.isClosed) return "Part of an open line"
        val openings = try {
            document.project.openings()
        } catch (_: TriGridException) {
            return ""
        }
        if (at in openings) return "Opening: left out"
        val hasConnector = (0 until walk.stepCount).any { walk.shape(it) >= 0 && path.isConnector(walk.shape(it)) }
        if (!hasConnector || !path.shape(shape).isClosed()) return "Bounds the domain"
        return try {
            val whole = Polygon(walk.nodes().map { path.node(it) }, 1.0).direction
            val own = Polygon(path.nodesOf(shape).map { path.node(it) }, 1.0).direction
            if (own == whole) "Included in the domain" else "Opening: left out"
        } catch (_: InvalidShapeException) {
            ""
        }
    }
}
