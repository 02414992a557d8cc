package org.trigrid.editor.canvas

import org.trigrid.editor.meshing.Colouring
import org.trigrid.editor.meshing.MeshView
import org.trigrid.mesh.TriMesh

/**
 * A mesh made ready for drawing: its elements in the order of a curve that fills the plane, in blocks with boxes, so
 * that what is off the screen is passed over block by block. Immutable once made; may be drawn by any thread.
 */
internal class MeshRaster(val view: MeshView) {
    private val mesh: TriMesh = view.mesh
    private val count = mesh.elementCount
    private val order: IntArray

    /** Coordinates of the nodes, in the order in which the elements first have them. */
    private val xy: DoubleArray
    private val nodes = IntArray(3 * count)

    /** Which edges of each element it draws: bit k that from corner k on. Each edge is drawn by one of its elements. */
    private val ownEdges = ByteArray(count)
    private val boxes: DoubleArray
    private val small: SmallElements

    /** Groups of elements, which are drawn as one where they are finer than a pixel together: the largest first. */
    private val groups: List<SmallElements>
    private val meanArea: Double
    private val colourings = java.util.EnumMap<Colouring, IntArray>(Colouring::class.java)

    init {
        val given = mesh.elementNodes()
        val coordinates = mesh.nodeCoordinates()
        order = ElementOrder.of(coordinates, given)
        xy = DoubleArray(coordinates.size)
        renumber(given, coordinates)
        boxes = DoubleArray(4 * ((count + BLOCK - 1) / BLOCK))
        for (block in 0 until boxes.size / 4) measure(block)
        small = SmallElements(xy, nodes, 1)
        groups = GROUPS.map { SmallElements(xy, nodes, it) }
        meanArea = if (count == 0) 0.0 else (0 until count).sumOf { mesh.area(it) } / count
    }

    /** Gives elements and nodes that are neighbours in the plane places that are neighbours in memory. */
    private fun renumber(given: IntArray, coordinates: DoubleArray) {
        val places = IntArray(coordinates.size / 2) { -1 }
        var next = 0
        for (i in 0 until count) {
            for (k in 0..2) {
                val node = given[3 * order[i] + k]
                if (places[node] < 0) {
                    xy[2 * next] = coordinates[2 * node]
                    xy[2 * next + 1] = coordinates[2 * node + 1]
                    places[node] = next++
                }
                nodes[3 * i + k] = places[node]
                val isOwn = node < given[3 * order[i] + (k + 1) % 3] || mesh.neighbourOf(order[i], k) < 0
                if (isOwn) ownEdges[i] = (ownEdges[i].toInt() or (1 shl k)).toByte()
            }
        }
    }

    /** Elements whose boxes may reach into what [transform] shows on a screen of that size: few more than those that do. */
    fun forEachVisible(transform: ViewTransform, width: Double, height: Double, action: (Int) -> Unit) =
        visible(0, 0, Math.ceil(width).toInt(), Math.ceil(height).toInt(), transform) { from, to -> for (i in from until to) action(order[i]) }

    /** The element that holds a place of the domain, or -1. */
    fun elementAt(x: Double, y: Double): Int {
        for (block in 0 until boxes.size / 4) {
            val b = 4 * block
            if (x < boxes[b] || y < boxes[b + 1] || x > boxes[b + 2] || y > boxes[b + 3]) continue
            for (i in block * BLOCK until minOf(count, (block + 1) * BLOCK)) if (holds(i, x, y)) return order[i]
        }
        return -1
    }

    /** Draws what [transform] shows within the clip of [raster], which is transparent there. */
    fun draw(raster: PixelRaster, transform: ViewTransform, colouring: Colouring, ink: MeshInk) {
        val colours = coloursOf(colouring)
        val coarse = groups.firstOrNull { it.areMostlySmall(transform) }
        visible(raster.left, raster.top, raster.right, raster.bottom, transform) { from, to ->
            if (coarse == null) fill(raster, transform, from, to, colours, ink.fill) else fillGroups(raster, transform, coarse, from, to, colours, ink.fill)
        }
        val meanEdge = Math.sqrt(meanArea) * EDGE_OF_AREA * transform.scale
        val faintest = if (count < MANY) FAINTEST_EDGE else FAINTEST_OF_MANY
        val strength = ((meanEdge - faintest) / (STRONGEST_EDGE - faintest) * STRONGEST).toInt().coerceIn(0, STRONGEST)
        if (strength == 0) return
        val isPlain = colouring == Colouring.NONE
        val line = if (isPlain) ink.line else ink.lineOnColour
        val share = if (isPlain) strength else (strength * ON_COLOUR).toInt()
        visible(raster.left, raster.top, raster.right, raster.bottom, transform) { from, to -> lines(raster, transform, from, to, line, share) }
    }

    /** A pixel beyond the clip counts as well, since lines and small elements are up to two pixels wide. */
    private inline fun visible(x0: Int, y0: Int, x1: Int, y1: Int, t: ViewTransform, draw: (Int, Int) -> Unit) {
        val left = t.domainX(x0 - 1.0)
        val top = t.domainY(y0 - 1.0)
        val right = t.domainX(x1 + 1.0)
        val bottom = t.domainY(y1 + 1.0)
        for (block in 0 until boxes.size / 4) {
            val b = 4 * block
            if (boxes[b] > right || boxes[b + 2] < left || boxes[b + 1] > top || boxes[b + 3] < bottom) continue
            draw(block * BLOCK, minOf(count, (block + 1) * BLOCK))
        }
    }

    private fun fill(raster: PixelRaster, t: ViewTransform, from: Int, to: Int, colours: IntArray?, plain: Int) {
        for (i in from until to) fill(raster, t, i, if (colours == null) plain else colours[i])
    }

    /** As [fill], but groups that are finer than a pixel as one. */
    private fun fillGroups(raster: PixelRaster, t: ViewTransform, groups: SmallElements, from: Int, to: Int, colours: IntArray?, plain: Int) {
        for (i in from until to step groups.size) {
            if (!groups.draw(raster, t, i / groups.size, if (colours == null) plain else colours[i])) {
                fill(raster, t, i, Math.min(to, i + groups.size), colours, plain)
            }
        }
    }

    private fun fill(raster: PixelRaster, t: ViewTransform, i: Int, colour: Int) {
        if (small.draw(raster, t, i, colour)) return
        val ax = t.screenX(xy[2 * nodes[3 * i]])
        val ay = t.screenY(xy[2 * nodes[3 * i] + 1])
        val bx = t.screenX(xy[2 * nodes[3 * i + 1]])
        val by = t.screenY(xy[2 * nodes[3 * i + 1] + 1])
        val cx = t.screenX(xy[2 * nodes[3 * i + 2]])
        val cy = t.screenY(xy[2 * nodes[3 * i + 2] + 1])
        raster.triangle(ax, ay, bx, by, cx, cy, colour)
    }

    private fun lines(raster: PixelRaster, t: ViewTransform, from: Int, to: Int, colour: Int, strength: Int) {
        for (i in from until to) {
            val own = ownEdges[i].toInt()
            for (k in 0..2) {
                if (own shr k and 1 == 0) continue
                val a = nodes[3 * i + k]
                val b = nodes[3 * i + if (k == 2) 0 else k + 1]
                raster.line(
                    t.screenX(xy[2 * a]), t.screenY(xy[2 * a + 1]), t.screenX(xy[2 * b]), t.screenY(xy[2 * b + 1]), colour, strength,
                )
            }
        }
    }

    /** A colour an element, or null for one colour for all. */
    private fun coloursOf(colouring: Colouring): IntArray? {
        if (colouring == Colouring.NONE) return null
        return synchronized(colourings) {
            colourings.getOrPut(colouring) {
                IntArray(count) { ColourScale.of(colouring).colour(view.level(order[it], colouring)) }
            }
        }
    }

    private fun holds(i: Int, x: Double, y: Double): Boolean {
        for (k in 0..2) {
            val a = 2 * nodes[3 * i + k]
            val b = 2 * nodes[3 * i + (k + 1) % 3]
            if ((xy[b] - xy[a]) * (y - xy[a + 1]) - (xy[b + 1] - xy[a + 1]) * (x - xy[a]) < 0) return false
        }
        return true
    }

    private fun measure(block: Int) {
        val b = 4 * block
        boxes[b] = Double.POSITIVE_INFINITY
        boxes[b + 1] = Double.POSITIVE_INFINITY
        boxes[b + 2] = Double.NEGATIVE_INFINITY
        boxes[b + 3] = Double.NEGATIVE_INFINITY
        for (at in 3 * block * BLOCK until 3 * minOf(count, (block + 1) * BLOCK)) {
            val x = xy[2 * nodes[at]]
            val y = xy[2 * nodes[at] + 1]
            boxes[b] = Math.min(boxes[b], x)
            boxes[b + 1] = Math.min(boxes[b + 1], y)
            boxes[b + 2] = Math.max(boxes[b + 2], x)
            boxes[b + 3] = Math.max(boxes[b + 3], y)
        }
    }

    private companion object {
        const val BLOCK = 64

        /** Divisors of [BLOCK]. */
        val GROUPS = intArrayOf(16, 4)

        /** Mean edges, in pixels, between which lines come up from nothing. */
        const val FAINTEST_EDGE = 3.0

        /** Of so many elements as are drawn slowly, the faintest lines are left out. */
        const val FAINTEST_OF_MANY = 4.0
        const val MANY = 100_000
        const val STRONGEST_EDGE = 12.0
        const val STRONGEST = 230

        /** Lines between colours are fainter, so that the colours speak. */
        const val ON_COLOUR = 0.6

        /** Edge of an equilateral triangle over the root of its area. */
        const val EDGE_OF_AREA = 1.52
    }
}
