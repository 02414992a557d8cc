package org.trigrid.shape

import org.trigrid.geometry.Point2

/** Explodes the straight sides between successive vertices, each by itself. */
internal object SideExploder {
    fun explode(vertices: List<Point2>, traits: Traits): DoubleArray {
        val sides = ArrayList<DoubleArray>(vertices.size)
        for (i in 1 until vertices.size) sides.add(Line.explode(vertices[i - 1], vertices[i], traits))
        return join(sides)
    }

    /** Sides end to end; a shared end is kept once. */
    fun join(sides: List<DoubleArray>): DoubleArray {
        val xy = DoubleArray(2 + sides.sumOf { it.size - 2 })
        var at = 0
        for (side in sides) {
            side.copyInto(xy, at)
            at += side.size - 2
        }
        return xy
    }
}
