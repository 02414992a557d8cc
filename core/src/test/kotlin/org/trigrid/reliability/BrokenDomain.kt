package org.trigrid.reliability

import org.trigrid.diagnostics.Fault
import org.trigrid.diagnostics.FaultKind
import org.trigrid.domain.Domain

/**
 * A valid domain with faulty pieces set beside it, each in a cell of its own, so that one does not hide another: what has to
 * be found, and where, is known.
 */
internal class BrokenDomain(private val valid: Domain) {
    private val xy = valid.xy.toMutableList()
    private val boundary = ArrayList<Int>()
    private val embedded = ArrayList<Int>()
    private val minX = (0 until valid.nodeCount).minOf { valid.x(it) }
    private val minY = (0 until valid.nodeCount).minOf { valid.y(it) }
    private val extent = maxOf((0 until valid.nodeCount).maxOf { valid.x(it) } - minX, (0 until valid.nodeCount).maxOf { valid.y(it) } - minY)

    /** A power of two, and places that are whole multiples of it, so that the pieces' coordinates are exact. */
    private val unit = Math.scalb(1.0, maxOf(Math.getExponent(extent), Math.getExponent(Math.ulp(maxOf(Math.abs(minX), Math.abs(minY)))) + 4))
    private var cells = 0
    private var cellX = 0.0
    private var cellY = 0.0
    private var firstNode = 0
    private val pieces = ArrayList<Piece>()

    /** What a piece must be reported as, in the box from its cell's corner, or at one of its nodes where it has no place. */
    private class Piece(val kind: FaultKind, val x: Double, val y: Double, val nodes: IntRange)

    init {
        for (s in 0 until valid.segmentCount) {
            val list = if (valid.isEmbedded(s)) embedded else boundary
            list.add(valid.segmentStart(s))
            list.add(valid.segmentEnd(s))
        }
    }

    fun add(kind: FaultKind) {
        cells++
        cellX = unit * (Math.floor(minX / unit) - 8.0 * cells)
        cellY = unit * Math.floor(minY / unit)
        firstNode = xy.size / 2
        when (kind) {
            FaultKind.NOT_A_NUMBER -> loop(0.0, 0.0, 4.0, 0.0, Double.NaN, 4.0, 0.0, 4.0)
            FaultKind.CROSSING -> loop(0.0, 0.0, 4.0, 4.0, 4.0, 0.0, 0.0, 2.0)
            FaultKind.TOUCHING -> {
                square()
                loop(2.0, 0.0, 1.0, 2.0, 3.0, 2.0)
            }
            FaultKind.DUPLICATE_NODE -> {
                square()
                loop(0.0, 0.0, 1.0, 2.0, 2.0, 1.0)
            }
            FaultKind.ZERO_LENGTH -> {
                square()
                boundary.addAll(listOf(firstNode, firstNode))
            }
            FaultKind.SPIKE -> {
                val (a, b, c, d) = listOf(node(0.0, 0.0), node(4.0, 0.0), node(4.0, 4.0), node(0.0, 4.0))
                val tip = node(5.0, 5.0)
                boundary.addAll(listOf(a, b, b, c, c, tip, tip, c, c, d, d, a))
            }
            FaultKind.OPEN_WALK -> {
                square()
                repeat(2) { boundary.removeLast() }
            }
            FaultKind.HOLE_OUTSIDE -> loop(0.0, 0.0, 0.0, 4.0, 4.0, 4.0, 4.0, 0.0)
            FaultKind.OVERLAP -> {
                square()
                loop(1.0, 1.0, 2.0, 1.0, 2.0, 2.0)
            }
            FaultKind.DEGENERATE_LOOP -> loop(0.0, 0.0, 4.0, 1.0)
            FaultKind.REGION_POINT -> error("a piece has no regions")
            FaultKind.EMBEDDED_OUTSIDE -> embedded.addAll(listOf(node(1.0, 1.0), node(2.0, 3.0)))
        }
        pieces.add(Piece(kind, cellX, cellY, firstNode until xy.size / 2))
    }

    fun domain(): Domain {
        val all = (boundary + embedded).toIntArray()
        val count = all.size / 2
        return Domain(xy.toDoubleArray(), all, IntArray(count), BooleanArray(count) { it >= boundary.size / 2 }, listOf("b"), "domain")
    }

    /** What is wrong with a report: a piece that is not in it, or a fault that is of no piece; null for a true report. */
    fun complaint(faults: List<Fault>): String? {
        for (piece in pieces) {
            if (faults.none { it.kind == piece.kind && isIn(piece, it) }) return "no ${piece.kind} in $faults"
        }
        val foreign = faults.firstOrNull { fault -> pieces.none { isIn(it, fault) && fault.kind == it.kind } }
        return if (foreign == null) null else "$foreign is no fault of ${pieces.map { it.kind }}"
    }

    private fun isIn(piece: Piece, fault: Fault): Boolean {
        val isNear = fault.x in piece.x..piece.x + 6 * unit && fault.y in piece.y..piece.y + 6 * unit
        return fault.nodes().all { it in piece.nodes } && (isNear || piece.kind == FaultKind.NOT_A_NUMBER)
    }

    private fun square() = loop(0.0, 0.0, 4.0, 0.0, 4.0, 4.0, 0.0, 4.0)

    private fun node(x: Double, y: Double): Int {
        xy.add(cellX + unit * x)
        xy.add(cellY + unit * y)
        return xy.size / 2 - 1
    }

    private fun loop(vararg places: Double) {
        val nodes = (0 until places.size / 2).map { node(places[2 * it], places[2 * it + 1]) }
        for (i in nodes.indices) boundary.addAll(listOf(nodes[i], nodes[(i + 1) % nodes.size]))
    }
}
