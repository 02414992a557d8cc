package org.trigrid.improve

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.geometry.HalfEdges
import org.trigrid.mesh.MutableMesh

class MeshImproverTest {
    @Test
    fun `keeps a valid mesh of the same domain`() {
        forAllMeshes { mesh, name ->
            val boundary = boundaryEdges(mesh)
            val fixed = mesh.xy.copyOf(2 * mesh.fixedNodeCount)
            val area = area(mesh)
            val euler = euler(mesh)
            MeshImprover(mesh, 0.01).run()
            checkValid(mesh, name)
            assertEquals(boundary, boundaryEdges(mesh), name)
            assertArrayEquals(fixed, mesh.xy.copyOf(2 * mesh.fixedNodeCount), name)
            assertEquals(area, area(mesh), 1e-12 * area, name)
            assertEquals(euler, euler(mesh), name)
        }
    }

    @Test
    fun `never lowers a poor least quality`() {
        forAllMeshes { mesh, name ->
            val before = RawMeshes.minQuality(mesh)
            MeshImprover(mesh, 0.01).run()
            assertTrue(RawMeshes.minQuality(mesh) >= minOf(before, 0.7)) { "$name: $before, then ${RawMeshes.minQuality(mesh)}" }
        }
    }

    @Test
    fun `makes a good mesh of a disordered lattice`() {
        for (seed in 1L..5L) {
            val mesh = RawMeshes.lattice(30, 30, 1.0, seed)
            MeshImprover(mesh, 0.01).run()
            assertTrue(RawMeshes.meanQuality(mesh) > 0.97) { "mean q ${RawMeshes.meanQuality(mesh)}" }
            assertTrue(RawMeshes.minQuality(mesh) > 0.7) { "least q ${RawMeshes.minQuality(mesh)}" }
        }
    }

    @Test
    fun `gives the same mesh each time`() {
        val meshes = List(2) { RawMeshes.lattice(20, 15, 1.0, 3L, hole = true).also { MeshImprover(it, 0.01).run() } }
        val (first, second) = meshes
        assertEquals(first.elementCount, second.elementCount)
        assertArrayEquals(first.xy.copyOf(2 * first.nodeCount), second.xy.copyOf(2 * second.nodeCount))
        assertArrayEquals(first.elements.copyOf(3 * first.elementCount), second.elements.copyOf(3 * second.elementCount))
    }

    @Test
    fun `scales with the domain bit for bit`() {
        val small = RawMeshes.lattice(12, 12, 1.0, 8L)
        val large = RawMeshes.lattice(12, 12, 1.0, 8L)
        for (i in large.xy.indices) large.xy[i] *= 1024.0
        for (i in large.sizes.indices) large.sizes[i] *= 1024.0
        MeshImprover(small, 0.01).run()
        MeshImprover(large, 0.01).run()
        val expected = DoubleArray(2 * small.nodeCount) { 1024 * small.xy[it] }
        assertArrayEquals(expected, large.xy.copyOf(2 * large.nodeCount))
    }

    @Test
    fun `reports progress that never goes back and ends at 1`() {
        val seen = ArrayList<Double>()
        MeshImprover(RawMeshes.lattice(8, 8, 1.0, 1L), 0.01, { seen.add(it) }).run()
        assertEquals(seen.sorted(), seen)
        assertEquals(1.0, seen.last())
    }

    @Test
    fun `leaves a mesh without free nodes alone but for flips`() {
        val mesh = RawMeshes.lattice(1, 1, 0.0, 1L)
        MeshImprover(mesh, 0.01).run()
        assertEquals(2, mesh.elementCount)
        assertEquals(4, mesh.nodeCount)
    }

    private fun forAllMeshes(check: (MutableMesh, String) -> Unit) {
        for (seed in 1L..20L) {
            for (disorder in listOf(0.0, 0.4, 1.0)) {
                check(RawMeshes.lattice(9, 8, disorder, seed), "plain, seed $seed, disorder $disorder")
                check(RawMeshes.lattice(9, 2, disorder, seed), "strip, seed $seed, disorder $disorder")
                check(RawMeshes.lattice(3, 3, disorder, seed).sparse(), "few nodes too close, seed $seed, disorder $disorder")
                check(RawMeshes.lattice(9, 8, disorder, seed).sparse(), "too close, seed $seed, disorder $disorder")
                check(RawMeshes.lattice(12, 9, disorder, seed, hole = true), "hole, seed $seed, disorder $disorder")
                check(RawMeshes.lattice(9, 9, disorder, seed, line = true), "line, seed $seed, disorder $disorder")
            }
        }
    }

    /** The mesh with wanted lengths so large that collapses are tried everywhere. */
    private fun MutableMesh.sparse(): MutableMesh = also { sizes.fill(2.5) }

    private fun checkValid(mesh: MutableMesh, name: String) {
        val used = java.util.BitSet()
        val edges = HashSet<Pair<Int, Int>>()
        for (h in 0 until 3 * mesh.elementCount) {
            val a = mesh.elements[h]
            val b = mesh.elements[HalfEdges.next(h)]
            used.set(a)
            assertTrue(edges.add(Pair(a, b))) { "$name: edge $a-$b twice" }
            val twin = mesh.twins[h]
            if (twin < 0) continue
            assertEquals(h, mesh.twins[twin], name)
            assertEquals(b, mesh.elements[twin], name)
            assertEquals(a, mesh.elements[HalfEdges.next(twin)], name)
        }
        for (t in 0 until mesh.elementCount) assertTrue(RawMeshes.isPositive(mesh, t)) { "$name: element $t" }
        assertEquals(mesh.nodeCount, used.cardinality(), name)
        for (a in 0 until mesh.fixedNodeCount) {
            for (b in 0 until a) if (mesh.isEmbedded(a, b)) assertTrue(Pair(a, b) in edges) { "$name: embedded $a-$b" }
        }
    }

    private fun boundaryEdges(mesh: MutableMesh): Set<Pair<Int, Int>> = (0 until 3 * mesh.elementCount)
        .filter { mesh.twins[it] < 0 }
        .map { Pair(mesh.elements[it], mesh.elements[HalfEdges.next(it)]) }
        .toSet()

    private fun area(mesh: MutableMesh): Double = (0 until 3 * mesh.elementCount).sumOf { h ->
        val a = 2 * mesh.elements[h]
        val b = 2 * mesh.elements[HalfEdges.next(h)]
        0.5 * (mesh.xy[a] * mesh.xy[b + 1] - mesh.xy[a + 1] * mesh.xy[b])
    }

    private fun euler(mesh: MutableMesh): Int {
        val boundary = (0 until 3 * mesh.elementCount).count { mesh.twins[it] < 0 }
        val edges = (3 * mesh.elementCount + boundary) / 2
        return mesh.nodeCount - edges + mesh.elementCount
    }
}
