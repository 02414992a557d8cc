package org.trigrid.improve

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.mesh.EdgeSet
import org.trigrid.mesh.MutableMesh

class LaplacianSmootherTest {
    @Test
    fun `puts each node at the mean of its neighbours`() {
        val mesh = RawMeshes.lattice(9, 9, 0.0, 4L)
        for (n in mesh.fixedNodeCount until mesh.nodeCount) mesh.xy[2 * n] += 0.2 * (n % 2)
        LaplacianSmoother(mesh, 1e-6, isGuarded = false).run {}
        val connectivity = Connectivity(mesh)
        val star = Star()
        for (n in mesh.fixedNodeCount until mesh.nodeCount) {
            star.gather(connectivity, n)
            star.centre()
            assertEquals(star.x, mesh.xy[2 * n], 1e-4)
            assertEquals(star.y, mesh.xy[2 * n + 1], 1e-4)
        }
    }

    @Test
    fun `the guard keeps elements positive where the mean lies outside of the domain`() {
        val unguarded = dart()
        LaplacianSmoother(unguarded, 0.01, isGuarded = false).run {}
        assertTrue((0 until unguarded.elementCount).any { !RawMeshes.isPositive(unguarded, it) })
        val guarded = dart()
        val before = RawMeshes.minQuality(guarded)
        LaplacianSmoother(guarded, 0.01, isGuarded = true).run {}
        assertTrue((0 until guarded.elementCount).all { RawMeshes.isPositive(guarded, it) })
        assertTrue(RawMeshes.minQuality(guarded) >= before)
    }

    @Test
    fun `keeps the connectivity and the fixed nodes`() {
        val mesh = RawMeshes.lattice(10, 8, 1.0, 2L, hole = true, line = true)
        val elements = mesh.elements.copyOf()
        val fixed = mesh.xy.copyOf(2 * mesh.fixedNodeCount)
        LaplacianSmoother(mesh, 0.01, isGuarded = true).run {}
        assertArrayEquals(elements, mesh.elements)
        assertArrayEquals(fixed, mesh.xy.copyOf(2 * mesh.fixedNodeCount))
        for (t in 0 until mesh.elementCount) assertTrue(RawMeshes.isPositive(mesh, t))
    }

    /** A dart with a deep re-entrant corner and one free node, which its neighbours' mean would take out of it. */
    private fun dart(): MutableMesh {
        val xy = doubleArrayOf(0.0, 0.0, 4.0, -6.0, 0.0, 1.0, -4.0, -6.0, 0.0, 0.5)
        val mesh = MutableMesh(xy, 4, DoubleArray(5) { 1.0 }, 4, EdgeSet.EMPTY)
        mesh.nodeCount = 5
        for (k in 0..3) mesh.addElement(4, k, (k + 1) % 4)
        for (k in 0..3) mesh.link(3 * k + 2, 3 * ((k + 1) % 4))
        return mesh
    }
}
