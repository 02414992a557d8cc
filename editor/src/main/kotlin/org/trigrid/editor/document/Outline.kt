package org.trigrid.editor.document

import org.trigrid.project.Project

/**
 * A run of nodes from one to the next, as it is drawn: a walk of the path or a loop. Immutable.
 *
 * @param nodes numbers in the document; not repeated at the end of a closed run.
 * @param shapes per step the shape it came from, or -1.
 * @param tags per step the boundary group.
 * @param loop number of the loop, or -1 for a walk.
 */
internal class Outline(
    val nodes: IntArray,
    val shapes: IntArray,
    val tags: List<String>,
    val isClosed: Boolean,
    val loop: Int,
) {
    val stepCount: Int get() = tags.size

    /** The node at which step [step] ends. */
    fun stepEnd(step: Int): Int = nodes[(step + 1) % nodes.size]

    companion object {
        fun of(project: Project, nodes: DocumentNodes): List<Outline> {
            val walks = project.path.walks().map { walk ->
                val steps = 0 until walk.stepCount
                Outline(walk.nodes(), IntArray(walk.stepCount) { walk.shape(it) }, steps.map { walk.tag(it) }, walk.isClosed, -1)
            }
            val loops = project.loops.mapIndexed { i, loop ->
                val start = nodes.loopStart(i)
                Outline(IntArray(loop.nodeCount) { start + it }, IntArray(loop.nodeCount) { -1 }, loop.segmentTags, true, i)
            }
            return walks + loops
        }
    }
}
