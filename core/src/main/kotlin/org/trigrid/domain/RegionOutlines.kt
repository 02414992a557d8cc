package org.trigrid.domain

import org.trigrid.geometry.IntList

/** A loop whose inside belongs to a region. */
internal class RegionOutline(
    /** x0, y0, x1, y1, …; not modified. */
    val xy: DoubleArray,
    val region: Region,
)

/**
 * Finds the smallest outline round each face of a line work. Decided without coordinates: going from face to face, one enters
 * or leaves the outlines that the segment between them belongs to.
 */
internal class RegionOutlines(
    private val xy: DoubleArray,
    /** 2 per segment; not modified. */
    private val segments: IntArray,
    private val faces: LineWorkFaces,
    private val outlines: List<RegionOutline>,
) {
    private val owners = owners()
    private val doubleAreas = DoubleArray(outlines.size) { doubleArea(outlines[it].xy) }

    /** Per face the outline, or -1. */
    fun smallest(): IntArray {
        val outside = faces.faceBound
        val sidesOf = faces.sides()
        val around = arrayOfNulls<IntArray>(outside + 1)
        around[outside] = IntArray(0)
        val todo = IntList()
        todo.add(outside)
        while (todo.size > 0) {
            val face = todo.removeLast()
            for (side in sidesOf[face]) {
                val next = numberOf(faces.faceOf(side xor 1), outside)
                if (around[next] != null) continue
                around[next] = toggled(around[face]!!, owners[side / 2])
                todo.add(next)
            }
        }
        return IntArray(outside) { face -> around[face]?.minByOrNull { doubleAreas[it] } ?: -1 }
    }

    private fun numberOf(face: Int, outside: Int) = if (face >= 0) face else outside

    /** Those in one of the two, but not in both. */
    private fun toggled(around: IntArray, crossed: IntArray): IntArray {
        if (crossed.isEmpty()) return around
        return (around.filter { it !in crossed } + crossed.filter { it !in around }).toIntArray()
    }

    /** The outlines that each segment belongs to. */
    private fun owners(): Array<IntArray> {
        val places = PlaceIndex(xy.size / 2)
        for (node in 0 until xy.size / 2) places.numberOf(xy[2 * node], xy[2 * node + 1])
        val bySegment = HashMap<Long, IntList>()
        for ((k, outline) in outlines.withIndex()) {
            val nodes = IntArray(outline.xy.size / 2) { places.numberOf(outline.xy[2 * it], outline.xy[2 * it + 1]) }
            for (i in nodes.indices) bySegment.getOrPut(key(nodes[i], nodes[(i + 1) % nodes.size])) { IntList() }.add(k)
        }
        return Array(segments.size / 2) {
            bySegment[key(segments[2 * it], segments[2 * it + 1])]?.toArray() ?: NOBODY
        }
    }

    private fun key(a: Int, b: Int): Long = (Math.min(a, b).toLong() shl 32) or Math.max(a, b).toLong()

    private fun doubleArea(loop: DoubleArray): Double {
        val nodes = loop.size / 2
        return Math.abs(SignedArea.twice(loop, IntArray(2 * nodes) { (it / 2 + it % 2) % nodes }, 0, nodes))
    }

    private companion object {
        val NOBODY = IntArray(0)
    }
}
