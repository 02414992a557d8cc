package org.trigrid.improve

import java.util.SplittableRandom
import org.trigrid.geometry.HalfEdges
import org.trigrid.geometry.Predicates
import org.trigrid.mesh.EdgeSet
import org.trigrid.mesh.MutableMesh
import org.trigrid.quality.TriangleQuality

/** Bad but valid meshes for the tests: perturbed lattices with random diagonals and random flips. */
internal object RawMeshes {
    /**
     * A lattice of [columns] by [rows] squares of side 1, its diagonals and inner nodes [disorder]ed. With [hole], the
     * squares in the middle are left out; with [line], the edges of the lattice along row 1 are embedded.
     */
    fun lattice(
        columns: Int, rows: Int, disorder: Double, seed: Long, hole: Boolean = false, line: Boolean = false,
    ): MutableMesh {
        val random = SplittableRandom(seed)
        val numbers = Array(rows + 1) { IntArray(columns + 1) { -1 } }
        val xy = ArrayList<Double>()
        fun isCell(i: Int, j: Int): Boolean {
            if (i < 0 || j < 0 || i >= columns || j >= rows) return false
            return !(hole && i >= columns / 3 && i < 2 * columns / 3 && j >= rows / 3 && j < 2 * rows / 3)
        }
        fun cellsAt(i: Int, j: Int) = listOf(isCell(i - 1, j - 1), isCell(i, j - 1), isCell(i - 1, j), isCell(i, j)).count { it }
        fun isFixed(i: Int, j: Int) = cellsAt(i, j) < 4 || (line && j == 1)
        var count = 0
        for (fixed in listOf(true, false)) {
            for (j in 0..rows) {
                for (i in 0..columns) {
                    if (cellsAt(i, j) == 0 || isFixed(i, j) != fixed) continue
                    numbers[j][i] = count++
                    xy.add(i + if (fixed) 0.0 else random.nextDouble(-0.3, 0.3) * disorder)
                    xy.add(j + if (fixed) 0.0 else random.nextDouble(-0.3, 0.3) * disorder)
                }
            }
        }
        val fixedCount = (0..rows).sumOf { j -> (0..columns).count { cellsAt(it, j) > 0 && isFixed(it, j) } }
        val embedded = if (line) EdgeSet(IntArray(2 * columns) { numbers[1][(it + 1) / 2] }) else EdgeSet.EMPTY
        val mesh = MutableMesh(xy.toDoubleArray(), fixedCount, DoubleArray(count) { 1.1 }, 2 * columns * rows, embedded)
        mesh.nodeCount = count
        for (j in 0 until rows) {
            for (i in 0 until columns) {
                if (!isCell(i, j)) continue
                val a = numbers[j][i]
                val b = numbers[j][i + 1]
                val c = numbers[j + 1][i + 1]
                val d = numbers[j + 1][i]
                if (random.nextBoolean()) {
                    mesh.addElement(a, b, c)
                    mesh.addElement(a, c, d)
                } else {
                    mesh.addElement(a, b, d)
                    mesh.addElement(b, c, d)
                }
            }
        }
        link(mesh)
        flipAtRandom(mesh, random, (disorder * 2 * mesh.elementCount).toInt())
        return mesh
    }

    private fun link(mesh: MutableMesh) {
        val open = HashMap<Pair<Int, Int>, Int>()
        for (h in 0 until 3 * mesh.elementCount) {
            val a = mesh.elements[h]
            val b = mesh.elements[HalfEdges.next(h)]
            val twin = open.remove(Pair(b, a))
            if (twin == null) open[Pair(a, b)] = h else mesh.link(h, twin)
        }
    }

    private fun flipAtRandom(mesh: MutableMesh, random: SplittableRandom, times: Int) {
        val connectivity = Connectivity(mesh)
        repeat(times) {
            val h = random.nextInt(3 * mesh.elementCount)
            if (mesh.twins[h] < 0 || mesh.isEmbedded(mesh.elements[h], mesh.elements[HalfEdges.next(h)])) return@repeat
            if (isConvex(mesh, h)) connectivity.flip(h)
        }
    }

    /** Whether both elements stay positive when the edge is flipped. */
    private fun isConvex(mesh: MutableMesh, h: Int): Boolean {
        val g = mesh.twins[h]
        val a = mesh.elements[h]
        val b = mesh.elements[g]
        val c = mesh.elements[HalfEdges.previous(h)]
        val d = mesh.elements[HalfEdges.previous(g)]
        return orient(mesh, a, d, c) > 0 && orient(mesh, b, c, d) > 0
    }

    fun isPositive(mesh: MutableMesh, element: Int): Boolean =
        orient(mesh, mesh.elements[3 * element], mesh.elements[3 * element + 1], mesh.elements[3 * element + 2]) > 0

    fun minQuality(mesh: MutableMesh): Double = (0 until mesh.elementCount).minOf { quality(mesh, it) }

    fun meanQuality(mesh: MutableMesh): Double = (0 until mesh.elementCount).sumOf { quality(mesh, it) } / mesh.elementCount

    private fun quality(mesh: MutableMesh, element: Int): Double {
        val a = 2 * mesh.elements[3 * element]
        val b = 2 * mesh.elements[3 * element + 1]
        val c = 2 * mesh.elements[3 * element + 2]
        return TriangleQuality.shape(mesh.xy[a], mesh.xy[a + 1], mesh.xy[b], mesh.xy[b + 1], mesh.xy[c], mesh.xy[c + 1])
    }

    private fun orient(mesh: MutableMesh, a: Int, b: Int, c: Int): Double = Predicates.orient(
        mesh.xy[2 * a], mesh.xy[2 * a + 1], mesh.xy[2 * b], mesh.xy[2 * b + 1], mesh.xy[2 * c], mesh.xy[2 * c + 1],
    )
}
