package org.trigrid.improve

import java.util.SplittableRandom
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.geometry.HalfEdges

class ConnectivityTest {
    @Test
    fun `random surgery keeps twins, valences and outgoing half-edges right`() {
        for (seed in 1L..10L) {
            val random = SplittableRandom(seed)
            val mesh = RawMeshes.lattice(8, 8, 0.0, seed)
            val connectivity = Connectivity(mesh)
            repeat(400) {
                val h = random.nextInt(3 * mesh.elementCount)
                if (!connectivity.isAlive(h) || mesh.twins[h] < 0) return@repeat
                val a = mesh.elements[h]
                when (random.nextInt(3)) {
                    0 -> if (isSound(connectivity, h, forCollapse = false)) connectivity.flip(h)
                    1 -> connectivity.split(h, random.nextDouble(), random.nextDouble(), 1.0)
                    else -> if (connectivity.isFree(a) && isSound(connectivity, h, forCollapse = true)) connectivity.collapse(h)
                }
                check(connectivity)
            }
        }
    }

    @Test
    fun `an undone collapse leaves no trace`() {
        for (seed in 1L..10L) {
            val random = SplittableRandom(seed)
            val mesh = RawMeshes.lattice(8, 8, 0.5, seed, hole = seed % 2 == 0L)
            val connectivity = Connectivity(mesh)
            repeat(200) {
                val h = random.nextInt(3 * mesh.elementCount)
                if (!connectivity.isFree(mesh.elements[h]) || !isSound(connectivity, h, forCollapse = true)) return@repeat
                val elements = mesh.elements.copyOf()
                val twins = mesh.twins.copyOf()
                val n = mesh.elements[h]
                val m = mesh.elements[HalfEdges.next(h)]
                val left = mesh.elements[HalfEdges.previous(h)]
                val right = mesh.elements[HalfEdges.previous(mesh.twins[h])]
                connectivity.collapse(h)
                connectivity.undoCollapse(h, n, m, left, right, 1.0)
                assertArrayEquals(elements, mesh.elements)
                assertArrayEquals(twins, mesh.twins)
                check(connectivity)
            }
        }
    }

    /** Whether the operation leaves a mesh without double edges. */
    private fun isSound(connectivity: Connectivity, h: Int, forCollapse: Boolean): Boolean {
        val mesh = connectivity.mesh
        val a = mesh.elements[h]
        val b = mesh.elements[HalfEdges.next(h)]
        val c = mesh.elements[HalfEdges.previous(h)]
        val d = mesh.elements[HalfEdges.previous(mesh.twins[h])]
        val neighbours = neighbours(connectivity)
        if (!forCollapse) return c != d && d !in neighbours.getValue(c)
        return neighbours.getValue(a).intersect(neighbours.getValue(b)) == setOf(c, d) && connectivity.valence[c] > 3 && connectivity.valence[d] > 3
    }

    private fun neighbours(connectivity: Connectivity): Map<Int, Set<Int>> {
        val result = HashMap<Int, HashSet<Int>>()
        val mesh = connectivity.mesh
        for (h in 0 until 3 * mesh.elementCount) {
            if (!connectivity.isAlive(h)) continue
            val a = mesh.elements[h]
            val b = mesh.elements[HalfEdges.next(h)]
            result.getOrPut(a) { HashSet() }.add(b)
            result.getOrPut(b) { HashSet() }.add(a)
        }
        return result
    }

    private fun check(connectivity: Connectivity) {
        val mesh = connectivity.mesh
        val valence = IntArray(mesh.nodeCount)
        for (h in 0 until 3 * mesh.elementCount) {
            if (!connectivity.isAlive(h)) continue
            val a = mesh.elements[h]
            valence[a]++
            val twin = mesh.twins[h]
            if (twin < 0) continue
            assertTrue(connectivity.isAlive(twin))
            assertEquals(h, mesh.twins[twin])
            assertEquals(a, mesh.elements[HalfEdges.next(twin)])
            assertEquals(mesh.elements[HalfEdges.next(h)], mesh.elements[twin])
        }
        for (n in 0 until mesh.nodeCount) {
            assertEquals(valence[n], connectivity.valence[n])
            val out = connectivity.outgoing[n]
            if (valence[n] == 0) assertEquals(-1, out) else assertEquals(n, mesh.elements[out])
        }
    }
}
