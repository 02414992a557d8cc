package org.trigrid.editor.canvas

import org.trigrid.editor.document.EditorDocument

/** How far each node is from its nearer neighbour, on the screen. */
internal class NodeRoom private constructor(private val lengths: FloatArray, private val scale: Double) {
    /** In pixels; large for a node by itself. */
    fun room(node: Int): Double = lengths[node] * scale

    companion object {
        private var last: Pair<EditorDocument, FloatArray>? = null

        fun of(document: EditorDocument, view: ViewTransform): NodeRoom {
            val known = last
            if (known != null && known.first === document) return NodeRoom(known.second, view.scale)
            val lengths = FloatArray(document.nodes.count) { Float.MAX_VALUE }
            val nodes = document.nodes
            for (outline in document.outlines) {
                for (step in 0 until outline.stepCount) {
                    val a = outline.nodes[step]
                    val b = outline.stepEnd(step)
                    val length = Math.hypot(nodes.x(a) - nodes.x(b), nodes.y(a) - nodes.y(b)).toFloat()
                    lengths[a] = Math.min(lengths[a], length)
                    lengths[b] = Math.min(lengths[b], length)
                }
            }
            last = document to lengths
            return NodeRoom(lengths, view.scale)
        }
    }
}
