package org.trigrid.editor.document

/** What is picked: shapes by number, loops by number, nodes by their number in the document. Immutable. */
internal class Selection(
    val shapes: Set<Int> = emptySet(),
    val loops: Set<Int> = emptySet(),
    val nodes: Set<Int> = emptySet(),
) {
    val isEmpty: Boolean get() = shapes.isEmpty() && loops.isEmpty() && nodes.isEmpty()

    /** The one shape that is picked and nothing else, or -1. */
    val onlyShape: Int get() = if (shapes.size == 1 && loops.isEmpty() && nodes.isEmpty()) shapes.first() else -1

    /** Without what [document] no longer has. */
    fun within(document: EditorDocument): Selection {
        val path = document.path.shapeCount
        val count = document.nodes.count
        val fits = shapes.all { it < path } && loops.all { it < document.loops.size } && nodes.all { it < count }
        if (fits) return this
        return Selection(
            shapes.filterTo(sortedSetOf()) { it < path },
            loops.filterTo(sortedSetOf()) { it < document.loops.size },
            nodes.filterTo(sortedSetOf()) { it < count },
        )
    }

    /** Adds what is not in it and removes what is. */
    fun toggled(other: Selection): Selection =
        Selection(toggled(shapes, other.shapes), toggled(loops, other.loops), toggled(nodes, other.nodes))

    fun plus(other: Selection): Selection =
        Selection(shapes + other.shapes, loops + other.loops, nodes + other.nodes)

    override fun equals(other: Any?): Boolean =
        other is Selection && other.shapes == shapes && other.loops == loops && other.nodes == nodes

    override fun hashCode(): Int = 31 * (31 * shapes.hashCode() + loops.hashCode()) + nodes.hashCode()

    private fun toggled(a: Set<Int>, b: Set<Int>): Set<Int> = (a - b) + (b - a)

    companion object {
        val NONE: Selection = Selection()

        fun ofShape(shape: Int): Selection = Selection(shapes = setOf(shape))

        fun ofLoop(loop: Int): Selection = Selection(loops = setOf(loop))

        fun ofNode(node: Int): Selection = Selection(nodes = setOf(node))

        fun all(document: EditorDocument): Selection =
            Selection((0 until document.path.shapeCount).toSet(), document.loops.indices.toSet())
    }
}
