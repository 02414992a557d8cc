package org.trigrid.editor.tool

import org.trigrid.editor.document.EditorDocument
import org.trigrid.geometry.Point2
import org.trigrid.shape.Similarity

/** The segments that change while nodes are dragged. */
internal object DragLines {
    fun of(document: EditorDocument, nodes: Set<Int>, similarity: Similarity): List<DoubleArray> {
        val lines = ArrayList<DoubleArray>()
        for (outline in document.outlines) {
            for (step in 0 until outline.stepCount) {
                val a = outline.nodes[step]
                val b = outline.stepEnd(step)
                if (a !in nodes && b !in nodes) continue
                val from = place(document, a, nodes, similarity)
                val to = place(document, b, nodes, similarity)
                lines.add(doubleArrayOf(from.x, from.y, to.x, to.y))
            }
        }
        return lines
    }

    private fun place(document: EditorDocument, node: Int, nodes: Set<Int>, similarity: Similarity): Point2 =
        document.nodes.point(node).let { if (node in nodes) similarity.apply(it) else it }
}
