package org.trigrid.domain

import org.trigrid.shape.Shape

/** One step of a path's history; replayed in order by [PathReplay], the steps make the path's nodes and walks. */
internal sealed interface PathStep

/** A shape, exploded, appended to the end. */
internal class AppendStep(val shape: Shape, val isConnector: Boolean) : PathStep {
    /** x0, y0, x1, y1, …; not modified. */
    val nodes: DoubleArray = shape.explode()
}

/** The last connector not yet travelled back is travelled back. */
internal object BackStep : PathStep

/** The walk ends; the next shape begins another. */
internal object NewLoopStep : PathStep

/** A change of single nodes, named by where they came from so that it outlives changes of other shapes. */
internal sealed interface EditStep : PathStep {
    fun mapped(map: (NodeKey) -> NodeKey): EditStep

    fun keys(): List<NodeKey>
}

internal class MoveStep(val node: NodeKey, val x: Double, val y: Double) : EditStep {
    override fun mapped(map: (NodeKey) -> NodeKey): EditStep = MoveStep(map(node), x, y)

    override fun keys(): List<NodeKey> = listOf(node)
}

internal class DeleteStep(val node: NodeKey) : EditStep {
    override fun mapped(map: (NodeKey) -> NodeKey): EditStep = DeleteStep(map(node))

    override fun keys(): List<NodeKey> = listOf(node)
}

/** A node [node] at (x, y) between two neighbours. */
internal class InsertStep(
    val node: NodeKey,
    val from: NodeKey,
    val to: NodeKey,
    val x: Double,
    val y: Double,
) : EditStep {
    override fun mapped(map: (NodeKey) -> NodeKey): EditStep = InsertStep(node, map(from), map(to), x, y)

    override fun keys(): List<NodeKey> = listOf(from, to)
}

/**
 * Where a node came from: the [ordinal]-th node of the path's [shape]-th shape, or, with shape [INSERTED], the node
 * inserted as number [ordinal].
 */
internal class NodeKey(val shape: Int, val ordinal: Int) {
    override fun equals(other: Any?): Boolean = other is NodeKey && other.shape == shape && other.ordinal == ordinal

    override fun hashCode(): Int = 31 * shape + ordinal

    override fun toString(): String = if (shape == INSERTED) "+$ordinal" else "$shape:$ordinal"

    companion object {
        const val INSERTED: Int = -1

        /** Reads what [toString] writes; null if it is nothing of the kind. */
        fun parse(text: String): NodeKey? {
            val inserted = text.startsWith("+")
            val parts = if (inserted) listOf("$INSERTED", text.substring(1)) else text.split(':')
            if (parts.size != 2 || parts.any { it.isEmpty() }) return null
            val shape = parts[0].toIntOrNull() ?: return null
            val ordinal = parts[1].toIntOrNull() ?: return null
            val isKey = ordinal >= 0 && (shape >= 0 || inserted)
            return NodeKey(shape, ordinal).takeIf { isKey && it.toString() == text }
        }
    }
}
