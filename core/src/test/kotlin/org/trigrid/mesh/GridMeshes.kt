package org.trigrid.mesh

import org.trigrid.domain.Domain

/** Small structured meshes for tests, with the domain they mesh. */
internal class GridMesh(val mesh: TriMesh, val domain: Domain)

internal object GridMeshes {
    /**
     * [columns] x [rows] squares of side [h], each cut in two; squares for which [hole] holds are left out.
     * Boundary edges are tagged by the axis direction they run in, holes touching at a node are allowed.
     */
    fun grid(columns: Int, rows: Int, h: Double = 1.0, hole: (Int, Int) -> Boolean = { _, _ -> false }): GridMesh {
        val used = IntArray((columns + 1) * (rows + 1)) { -1 }
        val xy = ArrayList<Double>()
        fun node(i: Int, j: Int): Int {
            val at = j * (columns + 1) + i
            if (used[at] < 0) {
                used[at] = xy.size / 2
                xy.add(i * h)
                xy.add(j * h)
            }
            return used[at]
        }
        val elements = ArrayList<Int>()
        for (j in 0 until rows) for (i in 0 until columns) {
            if (hole(i, j)) continue
            val a = node(i, j)
            val b = node(i + 1, j)
            val c = node(i + 1, j + 1)
            val d = node(i, j + 1)
            elements.addAll(if ((i + j) % 2 == 0) listOf(a, b, c, a, c, d) else listOf(a, b, d, b, c, d))
        }
        return ofArrays(xy.toDoubleArray(), elements.toIntArray())
    }

    /** The mesh of the arrays, its boundary edges tagged `along x` or `along y`, and the domain made of them. */
    fun ofArrays(xy: DoubleArray, elements: IntArray): GridMesh {
        val plain = TriMesh.of(xy, elements)
        val boundary = MeshTopology.boundaryEdges(plain.elements, plain.neighbours)
        val tags = IntArray(boundary.size / 2) {
            val dx = Math.abs(plain.x(boundary[2 * it + 1]) - plain.x(boundary[2 * it]))
            val dy = Math.abs(plain.y(boundary[2 * it + 1]) - plain.y(boundary[2 * it]))
            if (dx >= dy) 0 else 1
        }
        val names = listOf("along x", "along y")
        val mesh = TriMeshFactory.of(xy.copyOf(), elements.copyOf(), boundary, tags, names, "plate")
        val numbers = IntArray(plain.nodeCount) { -1 }
        val given = ArrayList<Double>()
        for (node in boundary) {
            if (numbers[node] >= 0) continue
            numbers[node] = given.size / 2
            given.add(plain.x(node))
            given.add(plain.y(node))
        }
        val segments = IntArray(boundary.size) { numbers[boundary[it]] }
        val domain = Domain(given.toDoubleArray(), segments, tags, BooleanArray(tags.size), names, "plate")
        return GridMesh(mesh, domain)
    }

    /** A grid whose inner nodes are moved about a little, and whose nodes are numbered at random; seeded. */
    fun shaken(columns: Int, rows: Int, seed: Long, hole: (Int, Int) -> Boolean = { _, _ -> false }): GridMesh {
        val random = java.util.Random(seed)
        val straight = grid(columns, rows, 1.0, hole).mesh
        val xy = straight.nodeCoordinates()
        for (node in 0 until straight.nodeCount) {
            if (straight.kindOf(node) != NodeKind.INTERIOR) continue
            xy[2 * node] += 0.3 * (random.nextDouble() - 0.5)
            xy[2 * node + 1] += 0.3 * (random.nextDouble() - 0.5)
        }
        val moved = ofArrays(xy, straight.elementNodes())
        return GridMesh(moved.mesh.renumbered(randomPermutation(straight.nodeCount, random)), moved.domain)
    }

    fun randomPermutation(size: Int, random: java.util.Random): IntArray {
        val result = IntArray(size) { it }
        for (i in size - 1 downTo 1) {
            val j = random.nextInt(i + 1)
            val swap = result[i]
            result[i] = result[j]
            result[j] = swap
        }
        return result
    }
}
