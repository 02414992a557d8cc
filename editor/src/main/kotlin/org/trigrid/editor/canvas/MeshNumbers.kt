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
    fun draw(index: MeshRaster, settings: ViewSettings) {
        val mesh = index.view
        if (!settings.showNumbers || mesh.sizes[1] * view.scale < ELEMENT_ROOM) return
        g.font = Font.font(10.0)
        g.textAlign = TextAlignment.CENTER
        g.textBaseline = VPos.CENTER
        val elements = ArrayList<Int>()
        index.forEachVisible(view, width, height) { if (mesh.size(it) * view.scale >= ELEMENT_ROOM) elements.add(it) }
        var left = MOST
        for (element in elements) {
            val x = view.screenX(corners(mesh, element) { mesh.mesh.x(it) })
            val y = view.screenY(corners(mesh, element) { mesh.mesh.y(it) })
            if (x < 0 || y < 0 || x > width || y > height) continue
            if (left-- == 0) break
            NumberText.draw(g, element.toString(), x, y, colours.text, colours.sheet)
        }
        nodes(mesh, elements)
        g.textAlign = TextAlignment.LEFT
        g.textBaseline = VPos.BASELINE
    }

    /** Numbers of the mesh's nodes, below them; those of the drawing stand above. */
    private fun nodes(mesh: MeshView, elements: List<Int>) {
        if (mesh.sizes[1] * view.scale < NODE_ROOM) return
        val nodes = LinkedHashSet<Int>()
        for (element in elements) for (corner in 0..2) nodes.add(mesh.mesh.nodeOf(element, corner))
        var left = MOST
        for (node in nodes) {
            val x = view.screenX(mesh.mesh.x(node))
            val y = view.screenY(mesh.mesh.y(node))
            if (x < 0 || y < 0 || x > width || y > height) continue
            if (mesh.room(node) * view.scale < NODE_ROOM) continue
            if (left-- == 0) break
            NumberText.draw(g, node.toString(), x, y + NODE_SHIFT, colours.accent, colours.sheet)
        }
    }

    /** The mean of what the corners of an element have. */
    private inline fun corners(mesh: MeshView, element: Int, of: (Int) -> Double): Double =
        (of(mesh.mesh.nodeOf(element, 0)) + of(mesh.mesh.nodeOf(element, 1)) + of(mesh.mesh.nodeOf(element, 2))) / 3

    private companion object {
        /** Longest edge, in pixels, of an element that has room for its number. */
        const val ELEMENT_ROOM = 64.0
        const val MOST = 1500

        /** Longest edge, in pixels, of the elements about a node that has room for its number. */
        const val NODE_ROOM = 96.0
        const val NODE_SHIFT = 11.0
    }
}
