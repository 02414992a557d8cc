package org.trigrid.domain

import org.trigrid.shape.Line
import org.trigrid.shape.Shape

/** One step of a path's history; replayed in order by [PathReplay], the steps make the path's nodes and walks. */
internal sealed interface PathStep

/** A step that adds a shape; the shapes of a path are numbered by these steps. */
internal sealed interface ShapeStep : PathStep {
    val shape: Shape

    val isConnector: Boolean
}

/** A shape, exploded, appended to the end. */
internal class AppendStep(override val shape: Shape, override val isConnector: Boolean) : ShapeStep {
    /** x0, y0, x1, y1, …; not modified. */
    val nodes: DoubleArray = shape.explode()
}

/** The last connector not yet travelled back is travelled back. */
internal object BackStep : PathStep

/** The walk ends; the next shape begins another. */
internal object NewLoopStep : PathStep

/** A step that names nodes by where they came from, so that it outlives changes of other shapes. */
internal sealed interface KeyedStep : PathStep {
    fun mapped(map: (NodeKey) -> NodeKey): PathStep

    fun keys(): List<NodeKey>
}

/**
 * A connector between two walks, travelled where the first passes node [from]: to node [to] of the second, round that
 * one and back.
 *
 * @param line gives spacing and name; its ends are where the two nodes are.
 * @param isTurned whether the second walk is travelled against the direction that it had.
 */
internal class ConnectStep(val line: Line, val from: NodeKey, val to: NodeKey, val isTurned: Boolean) : ShapeStep, KeyedStep {
    override val shape: Shape get() = line

    override val isConnector: Boolean get() = true

    override fun mapped(map: (NodeKey) -> NodeKey): PathStep = ConnectStep(line, map(from), map(to), isTurned)

    override fun keys(): List<NodeKey> = listOf(from, to)
}

/** A change of single nodes. */
internal sealed interface EditStep : KeyedStep

/** @param isWithNext whether the move that follows happens at the same time, so that neither is in the other's way. */
internal class MoveStep(val node: NodeKey, val x: Double, val y: Double, val isWithNext: Boolean) : EditStep {
    override fun mapped(map: (NodeKey) -> NodeKey): EditStep = MoveStep(map(node), x, y, isWithNext)

    override fun keys(): List<NodeKey> = listOf(node)
}

internal class DeleteStep(val node: NodeKey) : EditStep {
    override fun mapped(map: (NodeKey) -> NodeKey): EditStep = DeleteStep(map(node))

    override fun keys(): List<NodeKey> = listOf(node)
}

/** The closed walk that passes a node is travelled the other way round. */
internal class TurnStep(val node: NodeKey) : EditStep {
    override fun mapped(map: (NodeKey) -> NodeKey): EditStep = TurnStep(map(node))

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
