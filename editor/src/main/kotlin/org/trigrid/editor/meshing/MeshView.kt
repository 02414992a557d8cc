package org.trigrid.editor.meshing

import org.trigrid.MeshReport
import org.trigrid.editor.document.EditorDocument
import org.trigrid.mesh.NodeKind
import org.trigrid.mesh.TriMesh
import org.trigrid.quality.ElementFigures

/** A finished mesh with the figures of its elements, and the document it was made of. Immutable. */
internal class MeshView(
    val document: EditorDocument?,
    val mesh: TriMesh,
    val report: MeshReport?,
    /** The mesh before renumbering, or null. */
    val unnumbered: TriMesh? = null,
) {
    val figures: ElementFigures = ElementFigures.of(mesh)

    /** Elements about each node. */
    private val degrees: ByteArray by lazy(LazyThreadSafetyMode.PUBLICATION) {
        val counts = ByteArray(mesh.nodeCount)
        for (element in 0 until mesh.elementCount) for (corner in 0..2) counts[mesh.nodeOf(element, corner)]++
        counts
    }

    /** Longest edge of an element, in the domain's unit. */
    fun size(element: Int): Double {
        var longest = 0.0
        for (corner in 0..2) {
            val a = mesh.nodeOf(element, corner)
            val b = mesh.nodeOf(element, (corner + 1) % 3)
            longest = maxOf(longest, Math.hypot(mesh.x(a) - mesh.x(b), mesh.y(a) - mesh.y(b)))
        }
        return longest
    }

    /** Longest edge of the smallest element about each node: what room its number has. */
    private val rooms: FloatArray by lazy(LazyThreadSafetyMode.PUBLICATION) {
        val rooms = FloatArray(mesh.nodeCount) { Float.POSITIVE_INFINITY }
        for (element in 0 until mesh.elementCount) {
            val size = size(element).toFloat()
            for (corner in 0..2) mesh.nodeOf(element, corner).let { rooms[it] = minOf(rooms[it], size) }
        }
        rooms
    }

    /** Longest edge of the smallest element about [node], in the domain's unit. */
    fun room(node: Int): Double = rooms[node].toDouble()

    /** How far the degrees of an element's inner nodes are from six, at the worst; the boundary sets those of its own. */
    fun degreeError(element: Int): Int = (0..2).maxOf { corner ->
        val node = mesh.nodeOf(element, corner)
        if (mesh.kindOf(node) == NodeKind.INTERIOR) Math.abs(degrees[node] - IDEAL_DEGREE) else 0
    }

    /** Where an element stands between the worst, 0, and the best, 1; for sizes between small and large. */
    fun level(element: Int, colouring: Colouring): Double = when (colouring) {
        Colouring.NONE -> 1.0
        Colouring.QUALITY -> figures.quality(element)
        Colouring.MIN_ANGLE -> figures.minAngle(element) / EQUILATERAL
        Colouring.SIZE -> if (sizes[1] > sizes[0]) Math.log(size(element) / sizes[0]) / Math.log(sizes[1] / sizes[0]) else 0.5
        Colouring.DEGREE -> 1 - degreeError(element).coerceAtMost(WORST_DEGREE) / WORST_DEGREE.toDouble()
    }

    /** Smallest and largest [size] of all. */
    val sizes: DoubleArray by lazy(LazyThreadSafetyMode.PUBLICATION) {
        val range = doubleArrayOf(Double.POSITIVE_INFINITY, 0.0)
        for (element in 0 until mesh.elementCount) {
            val size = size(element)
            range[0] = minOf(range[0], size)
            range[1] = maxOf(range[1], size)
        }
        range
    }

    companion object {
        const val EQUILATERAL = 60.0
        const val WORST_DEGREE = 4
        private const val IDEAL_DEGREE = 6
    }
}
