package org.trigrid.editor.canvas

import javafx.geometry.VPos
import javafx.scene.canvas.GraphicsContext
import javafx.scene.text.Font
import javafx.scene.text.TextAlignment
import org.trigrid.editor.meshing.MeshView
import org.trigrid.editor.session.ViewSettings

/** Numbers of nodes and elements of the mesh, where there is room for them. */
internal class MeshNumbers(
    private val g: GraphicsContext,
    private val view: ViewTransform,
    private val width: Double,
    private val height: Double,
    private val colours: CanvasColours,
) {
    fun draw(mesh: MeshView, settings: ViewSettings) {
        if (!settings.showNumbers || mesh.sizes[1] * view.scale < ELEMENT_ROOM) return
        g.font = Font.font(10.0)
        g.textAlign = TextAlignment.CENTER
        g.textBaseline = VPos.CENTER
        var left = MOST
        for (element in 0 until mesh.mesh.elementCount) {
            val x = view.screenX((0..2).sumOf { mesh.mesh.x(mesh.mesh.nodeOf(element, it)) } / 3)
            val y = view.screenY((0..2).sumOf { mesh.mesh.y(mesh.mesh.nodeOf(element, it)) } / 3)
            if (x < 0 || y < 0 || x > width || y > height) continue
            if (mesh.size(element) * view.scale < ELEMENT_ROOM) continue
            if (left-- == 0) break
            NumberText.draw(g, element.toString(), x, y, colours.text, colours.sheet)
        }
        nodes(mesh)
        g.textAlign = TextAlignment.LEFT
        g.textBaseline = VPos.BASELINE
    }

    /** Numbers of the mesh's nodes, below them; those of the drawing stand above. */
    private fun nodes(mesh: MeshView) {
        if (mesh.sizes[1] * view.scale < NODE_ROOM) return
        var left = MOST
        for (node in 0 until mesh.mesh.nodeCount) {
            val x = view.screenX(mesh.mesh.x(node))
            val y = view.screenY(mesh.mesh.y(node))
            if (x < 0 || y < 0 || x > width || y > height) continue
            if (mesh.room(node) * view.scale < NODE_ROOM) continue
            if (left-- == 0) break
            NumberText.draw(g, node.toString(), x, y + NODE_SHIFT, colours.accent, colours.sheet)
        }
    }

    private companion object {
        /** Longest edge, in pixels, of an element that has room for its number. */
        const val ELEMENT_ROOM = 64.0
        const val MOST = 1500

        /** Longest edge, in pixels, of the elements about a node that has room for its number. */
        const val NODE_ROOM = 96.0
        const val NODE_SHIFT = 11.0
    }
}
