package org.trigrid.domain

import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.geometry.Point2
import org.trigrid.shape.Line
import org.trigrid.shape.Shape

/**
 * The paper's completed domain: shapes one after the other, each exploded at once to nodes at the path's end.
 *
 * A shape whose first point is the path's end shares that node; else a straight step bridges the gap, or, where the
 * walk so far is closed, the shape begins another loop. An opening is joined to the walk by a connector, a line
 * travelled there and back ([appendConnector], [back], or [appendOpening]), or stands by itself as a loop ([newLoop]).
 *
 * Nodes have serial numbers from 0 in the order in which they were made; each stands for one place, so a node that the
 * walk passes twice has one number. Nodes can be moved, deleted and inserted; a shape is linked to its nodes until one
 * of them is edited, and [rebuild] links it again.
 *
 * Immutable: every change returns another path, which shares what has not changed, so snapshots cost little.
 */
public class Path private constructor(internal val steps: List<PathStep>) {
    private val replay: PathReplay by lazy(LazyThreadSafetyMode.PUBLICATION) { PathReplay(steps) }
    private val appended: List<ShapeStep> = steps.filterIsInstance<ShapeStep>()

    /** Appends a shape. @throws org.trigrid.diagnostics.InvalidShapeException if it cannot be exploded. */
    public fun append(shape: Shape): Path = plus(AppendStep(shape, false))

    /** Appends a line that will be travelled [back], so that what is appended between hangs on it. */
    public fun appendConnector(line: Line): Path = plus(AppendStep(line, true))

    /**
     * Travels the last connector back to where it began.
     *
     * @throws IllegalStateException if no connector is to be travelled back.
     */
    public fun back(): Path {
        check(replay.openConnectorCount > 0) { "there is no connector to travel back" }
        return plus(BackStep)
    }

    /** A connector, a closed shape at its end, and the connector back. */
    public fun appendOpening(connector: Line, shape: Shape): Path = appendConnector(connector).append(shape).back()

    /**
     * Ends the walk, so that the next shape begins a loop of its own. Whether such a loop bounds the domain from outside
     * or is an opening is found from what lies in what, whatever its direction.
     */
    public fun newLoop(): Path = plus(NewLoopStep)

    /** Closes the walk by a line from its end to its first node; the same path if it is closed. */
    public fun close(spacing: Double): Path {
        val walk = walks().lastOrNull()
        if (walk == null || walk.isClosed) return this
        val nodes = walk.nodes()
        return append(Line(node(nodes.last()), node(nodes.first()), spacing))
    }

    /** Shapes appended, connectors among them. */
    @get:JvmName("shapeCount")
    public val shapeCount: Int get() = appended.size

    /** The shape with the given number, 0-based in the order of appending. */
    public fun shape(shape: Int): Shape {
        val step = appended[shape]
        return if (step is ConnectStep) replay.connectors[shape] ?: step.shape else step.shape
    }

    /** Whether the shape is a connector. */
    public fun isConnector(shape: Int): Boolean = appended[shape].isConnector

    /** Whether the shape is a connector made by [connect], whose ends stay at their nodes. */
    public fun joinsWalks(shape: Int): Boolean = appended[shape] is ConnectStep

    /** Whether the shape's nodes are as it was exploded: none was moved, deleted or inserted. */
    public fun isLinked(shape: Int): Boolean = replay.touched.none { shape in it }

    /** Nodes along the shape's steps, in the order of travel, each once; ascending only as long as nothing was edited. */
    public fun nodesOf(shape: Int): IntArray {
        val nodes = LinkedHashSet<Int>()
        for (walk in replay.walks) {
            for ((i, leg) in walk.legs.withIndex()) {
                if (leg.shape != shape) continue
                nodes.add(walk.nodes[i].number)
                nodes.add(walk.nodes[i + 1].number)
            }
        }
        return nodes.toIntArray()
    }

    /**
     * Another shape in place of one; edits of that one's nodes are dropped, unless only the name is another. Of a connector
     * made by [connect] spacing and name change, its ends stay at their nodes.
     *
     * @throws IllegalArgumentException if something else than a line is to take the place of such a connector.
     */
    public fun replaceShape(shape: Int, by: Shape): Path {
        val index = indexOf(shape)
        val old = appended[shape]
        require(old !is ConnectStep || by is Line) { "a connector is a line" }
        val step = if (old is ConnectStep) ConnectStep(by as Line, old.from, old.to, old.isTurned) else AppendStep(by, old.isConnector)
        val isOnlyRenamed = by.name != old.shape.name && by == shape(shape).withName(by.name)
        if (isOnlyRenamed) return Path(steps.mapIndexed { i, other -> if (i == index) step else other })
        return Path(PathHistory.withoutEdits(steps, replay, shape, mapOf(index to step)))
    }

    /** The path without a shape, its way back if it is a connector, and the edits of its nodes. */
    public fun removeShape(shape: Int): Path {
        indexOf(shape)
        return Path(PathHistory.withoutShape(steps, replay, shape))
    }

    /** Drops the edits of the shape's nodes, those it shares with its neighbours among them: it is linked again. */
    public fun rebuild(shape: Int): Path {
        indexOf(shape)
        return Path(PathHistory.withoutEdits(steps, replay, shape, emptyMap()))
    }

    @get:JvmName("nodeCount")
    public val nodeCount: Int get() = replay.nodes.size

    public fun x(node: Int): Double = replay.nodes[node].x

    public fun y(node: Int): Double = replay.nodes[node].y

    /** The place of a node. */
    public fun node(node: Int): Point2 = Point2(x(node), y(node))

    /** The places of all nodes, by serial number. */
    public fun nodes(): List<Point2> = java.util.List.copyOf(replay.nodes.map { Point2(it.x, it.y) })

    /** x0, y0, x1, y1, …; a copy. */
    public fun nodeCoordinates(): DoubleArray =
        DoubleArray(2 * nodeCount) { if (it % 2 == 0) replay.nodes[it / 2].x else replay.nodes[it / 2].y }

    /** Where the next shape is to begin, or null for an empty path. */
    public fun end(): Point2? = replay.lastNode?.let { Point2(it.x, it.y) }

    /** The walks over the nodes: one for each loop, and those that came off when a node was moved onto another. */
    public fun walks(): List<PathWalk> = java.util.List.copyOf(
        replay.walks.map { walk ->
            val count = if (walk.isClosed) walk.nodes.size - 1 else walk.nodes.size
            val numbers = IntArray(count) { walk.nodes[it].number }
            val shapes = IntArray(walk.legs.size) { walk.legs[it].shape }
            PathWalk(numbers, walk.legs.map { it.tag }, shapes, walk.isClosed, walk.group)
        },
    )

    /**
     * Moves a node. Moved onto another, the one of the two with the higher serial number is removed, later numbers fall
     * by one, and a walk that thereby passes one place twice falls apart there.
     *
     * @throws IndexOutOfBoundsException if there is no such node.
     * @throws IllegalArgumentException if a coordinate is not a number.
     */
    public fun moveNode(node: Int, x: Double, y: Double): Path {
        requireNumbers(x, y)
        val move = MoveStep(key(node), x, y, false)
        val last = steps.lastOrNull()
        val replacesLast = last is MoveStep && last.node == move.node && steps.size - 1 !in replay.merging
        return if (replacesLast) Path(steps.dropLast(1) + move) else plus(move)
    }

    /**
     * Moves several nodes at once. One moved onto a node that stays, or onto the new place of another, merges with it as
     * with [moveNode]; the old places of nodes that move are free, so that nodes may change places.
     *
     * @param nodes which ones, each once.
     * @param xy their new places: x0, y0, x1, y1, …
     * @throws IndexOutOfBoundsException if there is no such node.
     * @throws IllegalArgumentException if there are not two coordinates for each node, or one is not a number.
     */
    public fun moveNodes(nodes: IntArray, xy: DoubleArray): Path {
        require(xy.size == 2 * nodes.size) { "${nodes.size} nodes need ${2 * nodes.size} coordinates, not ${xy.size}" }
        for (i in nodes.indices) requireNumbers(xy[2 * i], xy[2 * i + 1])
        return if (nodes.isEmpty()) this else Path(NodeMoves(steps, replay, nodes.map { key(it) }, xy).steps())
    }

    /**
     * Travels the closed walk that passes a node the other way round; of several walks there the first. What a walk that came
     * off another bounds is left out where it was included, and the other way about.
     *
     * @throws IllegalArgumentException if no closed walk passes the node.
     */
    public fun turnWalk(node: Int): Path {
        val path = plus(TurnStep(key(node)))
        require(path.replay.undone.isEmpty()) { "no closed walk passes node $node" }
        return path
    }

    /**
     * Joins two walks by a connector from a node of one to a node of the other, travelled there and back: where the first
     * passes [from] it goes round the second, which keeps what it bounds in or out of the domain as it was. The connector
     * is a shape of its own, the last one; without it ([removeShape]) the walks are apart again.
     *
     * @param spacing wanted distance of the connector's nodes.
     * @throws IllegalArgumentException if the nodes are on one walk, or that of [to] is not closed.
     * @throws org.trigrid.diagnostics.InvalidShapeException if the connector cannot be exploded.
     */
    public fun connect(from: Int, to: Int, spacing: Double): Path {
        val walks = walks()
        return connect(from, to, spacing, PathDomain(nodeCoordinates(), walks).turnedGroups())
    }

    /** @param turned groups of walks that run against the direction which they have in the domain. */
    internal fun connect(from: Int, to: Int, spacing: Double, turned: Set<Int>): Path {
        val line = Line(node(from), node(to), spacing)
        val isTurned = (groupOf(from) in turned) != (groupOf(to) in turned)
        val path = plus(ConnectStep(line, key(from), key(to), isTurned))
        require(path.replay.undone.isEmpty()) { "nodes $from and $to are not on two walks, the second of them closed" }
        return path
    }

    /** Deletes a node; its neighbours are joined by a straight step, later numbers fall by one. */
    public fun deleteNode(node: Int): Path = plus(DeleteStep(key(node)))

    /**
     * Inserts a node between two neighbours of a walk; it gets the number after [from], later numbers rise by one.
     *
     * @throws IllegalArgumentException if the nodes are no neighbours, or a coordinate is not a number.
     */
    public fun insertNode(from: Int, to: Int, x: Double, y: Double): Path {
        requireNumbers(x, y)
        val number = steps.count { it is InsertStep }.let { count ->
            maxOf(count, 1 + (steps.filterIsInstance<InsertStep>().maxOfOrNull { it.node.ordinal } ?: -1))
        }
        val path = plus(InsertStep(NodeKey(NodeKey.INSERTED, number), key(from), key(to), x, y))
        require(path.replay.undone.isEmpty()) { "nodes $from and $to are not neighbours" }
        return path
    }

    /** The domain, with connectors dropped and the region called "domain". */
    public fun toDomain(): Domain = toDomain(false)

    /** As [toDomain] with a region name, the region called "domain". */
    public fun toDomain(keepConnectors: Boolean): Domain = toDomain(keepConnectors, "domain")

    /**
     * The domain: where the walk winds round once its outer part is taken anticlockwise. A shape that is travelled as
     * the outer boundary is lies in the domain, one travelled against it is left out.
     *
     * @param keepConnectors whether connectors become edges of the mesh; else they only join the walk.
     * @throws InvalidDomainException if a walk is not closed. Other faults are left to [DomainCheck].
     */
    public fun toDomain(keepConnectors: Boolean, regionName: String): Domain =
        PathDomain(nodeCoordinates(), walks()).make(keepConnectors, regionName)

    private fun groupOf(node: Int): Int {
        val wanted = replay.nodes[node]
        return replay.walks.firstOrNull { wanted in it.nodes }?.group ?: -1
    }

    private fun plus(step: PathStep): Path = Path(steps + step)

    private fun key(node: Int): NodeKey = replay.nodes[node].key

    private fun indexOf(shape: Int): Int = steps.indexOf(appended[shape])

    private fun requireNumbers(x: Double, y: Double) =
        require(x.isFinite() && y.isFinite()) { "coordinates must be numbers, not $x, $y" }

    /** Steps that cannot be done, by their index; a path made by this class has none. */
    internal fun undoneSteps(): List<Int> = replay.undone

    public companion object {
        /** Tag of the segments of shapes without a name. */
        public const val UNNAMED_TAG: String = "boundary"

        /** No shapes. */
        @JvmField
        public val EMPTY: Path = Path(emptyList())

        /** Shapes appended in order. */
        @JvmStatic
        public fun of(vararg shapes: Shape): Path = Path(shapes.map { AppendStep(it, false) })

        internal fun ofSteps(steps: List<PathStep>): Path = Path(java.util.List.copyOf(steps))
    }
}
