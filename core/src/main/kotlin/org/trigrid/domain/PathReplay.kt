package org.trigrid.domain

import org.trigrid.geometry.Point2
import org.trigrid.shape.Line
import org.trigrid.shape.Shape

/** A node of the path under construction. */
internal class PathNode(val key: NodeKey, var x: Double, var y: Double) {
    /** All the keys by which the node is known: a node that several shapes share has one from each. */
    val keys: ArrayList<NodeKey> = arrayListOf(key)

    /** Serial number, set once the replay is over. */
    var number: Int = -1
}

/** The way from one node of a walk to the next. */
internal class PathLeg(
    /** Number of the shape it came from, or -1. */
    val shape: Int,
    val tag: String,
)

/**
 * Makes a path's nodes and walks from its history.
 *
 * @throws org.trigrid.diagnostics.InvalidShapeException as exploding does.
 */
internal class PathReplay(steps: List<PathStep>) {
    /** Nodes by serial number. */
    val nodes: ArrayList<PathNode> = ArrayList()
    val walks: ArrayList<PathTrace> = ArrayList()

    /** Per step of the history: the shapes whose nodes an edit touched. */
    val touched: Array<Set<Int>> = Array(steps.size) { emptySet() }

    /** Steps that could not be done, because their node or their way back is no more, ascending. */
    val undone: ArrayList<Int> = ArrayList()

    /** Moves that put a node onto another. */
    val merging: HashSet<Int> = HashSet()

    /** Connectors between walks by their shapes' numbers, with the ends that they have. */
    val connectors: HashMap<Int, Line> = HashMap()

    private val byKey = HashMap<NodeKey, PathNode>()
    private val byPlace = HashMap<Place, PathNode>()
    private val openConnectors = ArrayList<Int>()
    private var current: PathTrace = PathTrace(0)
    private var shapeCount = 0

    init {
        for ((i, step) in steps.withIndex()) {
            val done = when (step) {
                is AppendStep -> append(step)
                is ConnectStep -> connect(step)
                is BackStep -> goBack()
                is NewLoopStep -> startLoop()
                is MoveStep -> {
                    if ((steps.getOrNull(i - 1) as? MoveStep)?.isWithNext != true) lift(steps, i)
                    move(i, step)
                }
                is DeleteStep -> delete(i, step)
                is TurnStep -> turn(step)
                is InsertStep -> insert(i, step)
            }
            if (!done) undone.add(i)
        }
        if (current.nodes.isNotEmpty()) walks.add(current)
        walks.sortBy { it.group }
        for ((number, node) in nodes.withIndex()) node.number = number
    }

    val lastNode: PathNode? get() = current.nodes.lastOrNull()

    val openConnectorCount: Int get() = openConnectors.size

    fun nodeOf(key: NodeKey): PathNode? = byKey[key]

    private fun append(step: AppendStep): Boolean {
        val shape = shapeCount++
        val xy = step.nodes
        val leg = PathLeg(shape, tagOf(step.shape))
        join(xy, leg.tag)
        val first = current.nodes.last()
        know(first, NodeKey(shape, 0))
        val last = xy.size / 2 - 1
        for (k in 1..last) {
            val closing = if (k < last) null else closingNode(step.shape, first, xy)
            val node = closing ?: nodeAt(xy[2 * k], xy[2 * k + 1], NodeKey(shape, k))
            know(node, NodeKey(shape, k))
            current.go(node, leg)
        }
        if (step.isConnector) openConnectors.add(shape)
        return true
    }

    /** Brings the walk to the shape's first node: it is the walk's end already, or begins a loop, or lies across a gap. */
    private fun join(xy: DoubleArray, tag: String) {
        val end = current.nodes.lastOrNull()
        if (end != null && isNear(end, xy, 0, 1)) return
        if (end != null && current.isClosed && openConnectors.isEmpty()) startLoop()
        val node = nodeAt(xy[0], xy[1], NodeKey(shapeCount - 1, 0))
        if (current.nodes.isEmpty()) current.nodes.add(node) else current.go(node, PathLeg(-1, tag))
    }

    private fun closingNode(shape: Shape, first: PathNode, xy: DoubleArray): PathNode? {
        if (shape.isClosed()) return first
        val start = current.nodes.first()
        val last = xy.size / 2 - 1
        return if (isNear(start, xy, last, last - 1)) start else null
    }

    /** Whether an end of a shape is meant to be [node]: at its place but for a tiny part of the interval there. */
    private fun isNear(node: PathNode, xy: DoubleArray, end: Int, next: Int): Boolean {
        val interval = StrictMath.hypot(xy[2 * next] - xy[2 * end], xy[2 * next + 1] - xy[2 * end + 1])
        return StrictMath.hypot(xy[2 * end] - node.x, xy[2 * end + 1] - node.y) <= SAME_END * interval
    }

    private fun nodeAt(x: Double, y: Double, key: NodeKey): PathNode = byPlace.getOrPut(Place(x, y)) {
        PathNode(key, x, y).also { nodes.add(it) }
    }

    private fun know(node: PathNode, key: NodeKey) {
        if (byKey.put(key, node) == null && node.key != key) node.keys.add(key)
    }

    private fun goBack(): Boolean {
        if (openConnectors.isEmpty()) return false
        val shape = openConnectors.removeAt(openConnectors.size - 1)
        val begin = current.legs.indexOfFirst { it.shape == shape }
        if (begin < 0) return true
        var end = begin
        while (end < current.legs.size && current.legs[end].shape == shape) end++
        val leg = current.legs[begin]
        for (i in end downTo begin) current.go(current.nodes[i], leg)
        return true
    }

    private fun startLoop(): Boolean {
        openConnectors.clear()
        if (current.nodes.isEmpty()) return true
        walks.add(current)
        current = PathTrace(current.group + 1)
        return true
    }

    private fun connect(step: ConnectStep): Boolean {
        val shape = shapeCount++
        val from = byKey[step.from] ?: return false
        val to = byKey[step.to] ?: return false
        val walk = allWalks().firstOrNull { from in it.nodes } ?: return false
        val opening = allWalks().firstOrNull { it !== walk && it.isClosed && to in it.nodes } ?: return false
        if (to in walk.nodes || opening === current && openConnectors.isNotEmpty()) return false
        val line = step.line.withEnds(Point2(from.x, from.y), Point2(to.x, to.y))
        connectors[shape] = line
        walk.detour(wayOf(line, shape, from, to), PathLeg(shape, tagOf(line)), opening.begunAt(to, step.isTurned))
        takeIn(opening, walk, step.isTurned)
        return true
    }

    /** The connector's nodes from one end to the other. */
    private fun wayOf(line: Line, shape: Int, from: PathNode, to: PathNode): List<PathNode> {
        val xy = line.explode()
        val last = xy.size / 2 - 1
        return List(last + 1) { k ->
            val node = if (k == 0) from else if (k == last) to else nodeAt(xy[2 * k], xy[2 * k + 1], NodeKey(shape, k))
            node.also { know(it, NodeKey(shape, k)) }
        }
    }

    /** [opening] is part of [walk] now; what had come off it keeps its direction to it. */
    private fun takeIn(opening: PathTrace, walk: PathTrace, isTurned: Boolean) {
        val isCurrent = opening === current || walk === current
        if (isCurrent) walks.add(current)
        walks.removeIf { it === opening }
        for ((i, other) in walks.withIndex()) {
            if (other.group != opening.group || other === walk || walk.group == opening.group) continue
            walks[i] = if (isTurned && other.isClosed) other.begunAt(other.nodes.first(), true) else other
            walks[i].group = walk.group
        }
        if (isCurrent) {
            walks.removeIf { it === walk }
            current = walk
        }
    }

    private fun allWalks(): List<PathTrace> = walks + current

    /** Takes nodes that are moved at the same time off their places, so that those are free for one another. */
    private fun lift(steps: List<PathStep>, first: Int) {
        var i = first
        do {
            val move = steps[i++] as MoveStep
            byKey[move.node]?.let { byPlace.remove(Place(it.x, it.y), it) }
        } while (move.isWithNext && steps.getOrNull(i) is MoveStep)
    }

    private fun move(step: Int, move: MoveStep): Boolean {
        val node = byKey[move.node] ?: return false
        touched[step] = shapesAt(node)
        place(node, move.x, move.y, step)
        return true
    }

    /** Puts [node] at (x, y); where another is there already, the one with the higher serial number is removed. */
    private fun place(node: PathNode, x: Double, y: Double, step: Int) {
        byPlace.remove(Place(node.x, node.y), node)
        node.x = x
        node.y = y
        val other = byPlace.putIfAbsent(Place(x, y), node)
        if (other == null || other === node) return
        merging.add(step)
        touched[step] = touched[step] + shapesAt(other)
        val keepsOther = nodes.indexOf(other) < nodes.indexOf(node)
        merge(if (keepsOther) other else node, if (keepsOther) node else other)
    }

    private fun merge(kept: PathNode, removed: PathNode) {
        byPlace[Place(kept.x, kept.y)] = kept
        nodes.remove(removed)
        for (key in removed.keys) byKey[key] = kept
        kept.keys.addAll(removed.keys)
        for (walk in allWalks()) {
            val meetsOnce = walk.count(kept) == 1 && walk.count(removed) == 1
            walk.replace(removed, kept)
            if (meetsOnce && (walk !== current || openConnectors.isEmpty())) walk.splitAt(kept)?.let { walks.add(it) }
        }
    }

    private fun delete(step: Int, delete: DeleteStep): Boolean {
        val node = byKey[delete.node] ?: return false
        touched[step] = shapesAt(node)
        byPlace.remove(Place(node.x, node.y), node)
        nodes.remove(node)
        for (key in node.keys) byKey.remove(key)
        for (walk in allWalks()) walk.remove(node)
        walks.removeIf { it.nodes.isEmpty() }
        return true
    }

    private fun turn(step: TurnStep): Boolean {
        val node = byKey[step.node] ?: return false
        val walk = allWalks().firstOrNull { it.isClosed && node in it.nodes } ?: return false
        walk.turn()
        return true
    }

    private fun insert(step: Int, insert: InsertStep): Boolean {
        val from = byKey[insert.from] ?: return false
        val to = byKey[insert.to] ?: return false
        val node = PathNode(insert.node, insert.x, insert.y)
        val shapes = HashSet<Int>()
        for (walk in allWalks()) walk.insert(from, to, node, shapes)
        if (shapes.isEmpty()) return false
        touched[step] = shapes
        byKey[insert.node] = node
        nodes.add(nodes.indexOf(from) + 1, node)
        place(node, insert.x, insert.y, step)
        return true
    }

    private fun shapesAt(node: PathNode): Set<Int> = HashSet<Int>().also { shapes ->
        for (walk in allWalks()) walk.shapesAt(node, shapes)
    }

    private fun tagOf(shape: Shape): String = shape.name.ifEmpty { Path.UNNAMED_TAG }

    private companion object {
        /** Share of the interval at a shape's end within which the end is the path's end. */
        const val SAME_END = 1e-6
    }
}

/** A place as a key: `0.0` and `-0.0` are one. */
private class Place(x: Double, y: Double) {
    private val x = x + 0.0
    private val y = y + 0.0

    override fun equals(other: Any?): Boolean = other is Place && other.x == x && other.y == y

    override fun hashCode(): Int = 31 * x.hashCode() + y.hashCode()
}
