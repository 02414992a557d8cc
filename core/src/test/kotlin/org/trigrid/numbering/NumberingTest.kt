package org.trigrid.numbering

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.mesh.GridMeshes
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.TriMesh
import java.util.Random

class NumberingTest {
    /** Two rows of three nodes: 0 3 5 above 2 4 1. */
    private val six = NodeGraph.ofEdges(6, intArrayOf(0, 3, 3, 5, 2, 4, 4, 1, 0, 2, 3, 4, 5, 1, 0, 4, 3, 1))

    @Test
    fun `six nodes by hand`() {
        assertEquals(listOf(2, 5, 0, 1, 3, 4), NodeGraph.nodesByDegree(six.starts).toList())
        assertArrayEquals(intArrayOf(2, 0, 1, 3), six.neighbours(4))
        val sweep = CuthillMcKee(six)
        assertEquals(2, sweep.run(intArrayOf(2), 0, 1, 9))
        assertArrayEquals(intArrayOf(2, 0, 4, 3, 1, 5), sweep.order.copyOf(6))
        assertEquals(3, sweep.depth)
        assertEquals(5, sweep.lastLevel)
        assertEquals(-1, sweep.run(intArrayOf(4), 0, 1, 3))
        val given = NumberingMetrics.of(six, Permutation.identity(6))
        assertEquals(4, given.halfBandwidth)
        assertEquals(9, given.bandwidth)
        // Rows 0 to 5 begin at columns 0, 1, 0, 0, 0, 1.
        assertEquals(1L + 1 + 3 + 4 + 5 + 5, given.profile)
        assertEquals(19.0 / 6, given.meanWavefront, 1e-15)
        val best = Renumbering.order(six, intArrayOf(0, 2, 4, 1, 5, 3), NumberingMethod.BEST)
        assertEquals(2, NumberingMetrics.of(six, best).halfBandwidth)
        val paper = Renumbering.order(six, intArrayOf(0, 2, 4, 1, 5, 3), NumberingMethod.CUTHILL_MCKEE)
        assertEquals(2, paper.oldNumber(0))
    }

    @Test
    fun `bandwidth as the paper's equations 6 to 10 say`() {
        val mesh = GridMeshes.shaken(7, 5, 9L).mesh
        var p = 0
        var q = 0
        for (node in 0 until mesh.nodeCount) {
            val around = (0 until mesh.elementCount).filter { t -> (0..2).any { mesh.nodeOf(t, it) == node } }
                .flatMap { t -> (0..2).map { mesh.nodeOf(t, it) } }
            p = maxOf(p, around.max() - node + 1)
            q = maxOf(q, node - around.min() + 1)
        }
        assertEquals(p + q - 1, Numbering.metrics(mesh).bandwidth)
        assertEquals(mesh.bandwidth, Numbering.metrics(mesh).bandwidth)
        assertEquals(Numbering.metrics(mesh).profile, NumberingMetrics.of(NodeGraph.of(mesh), Permutation.identity(mesh.nodeCount)).profile)
    }

    @Test
    fun `a strip gets the bandwidth of its short side`() {
        val strip = GridMeshes.shaken(60, 3, 4L).mesh
        val best = Numbering.renumber(strip, NumberingMethod.BEST)
        assertTrue(best.halfBandwidth <= 5, "B ${best.halfBandwidth}")
        val square = GridMeshes.shaken(20, 20, 4L).mesh
        assertTrue(Numbering.renumber(square, NumberingMethod.BEST).halfBandwidth <= 24)
    }

    @Test
    fun `a grid of the size of Fig 7 comes near its bandwidth`() {
        // Fig. 7: 26 nodes and 34 elements, bandwidth 13.
        val grid = GridMeshes.shaken(6, 3, 2L) { i, j -> i == 5 && j == 0 }
        assertEquals(27, grid.mesh.nodeCount)
        assertEquals(34, grid.mesh.elementCount)
        val paper = Numbering.renumber(grid.mesh, NumberingMethod.CUTHILL_MCKEE)
        val best = Numbering.renumber(grid.mesh, NumberingMethod.BEST)
        assertTrue(paper.bandwidth <= 15, "${paper.bandwidth}")
        assertTrue(best.bandwidth <= 13, "${best.bandwidth}")
    }

    @Test
    fun `random meshes keep all promises`() {
        for (seed in 0L..60L) {
            val random = Random(seed)
            val out = BooleanArray(150) { random.nextInt(5) == 0 }
            val grid = GridMeshes.shaken(15, 10, seed) { i, j -> out[15 * j + i] }
            val mesh = grid.mesh
            val graph = NodeGraph.of(mesh)
            val given = Numbering.metrics(mesh)
            for (method in NumberingMethod.entries) {
                val permutation = Numbering.permutation(mesh, method)
                assertEquals((0 until mesh.nodeCount).toSet(), permutation.newNumbers().toSet())
                val metrics = NumberingMetrics.of(graph, permutation)
                assertEquals(metrics.halfBandwidth, NumberingMetrics.of(graph, permutation.reversed()).halfBandwidth)
                val lowest = (0 until mesh.nodeCount).maxOf { (graph.degree(it) + 1) / 2 }
                assertTrue(metrics.halfBandwidth >= lowest)
                val renumbered = permutation.apply(mesh)
                assertEquals(metrics.profile, Numbering.metrics(renumbered).profile)
                assertEquals(emptyList<Any>(), MeshCheck.check(renumbered, grid.domain))
                if (method == NumberingMethod.CUTHILL_MCKEE) continue
                assertTrue(metrics.halfBandwidth <= given.halfBandwidth)
                val again = Numbering.metrics(Numbering.renumber(renumbered, NumberingMethod.BEST))
                assertTrue(again.halfBandwidth <= metrics.halfBandwidth)
                assertTrue(again.halfBandwidth < metrics.halfBandwidth || again.profile <= metrics.profile)
            }
        }
    }

    @Test
    fun `best is no worse than the paper's method and the same each time`() {
        for (seed in 0L..10L) {
            val mesh = GridMeshes.shaken(24, 12, seed) { i, j -> i in 4..9 && j in 3..7 }.mesh
            val best = Numbering.permutation(mesh, NumberingMethod.BEST)
            val paper = Numbering.renumber(mesh, NumberingMethod.CUTHILL_MCKEE)
            assertTrue(best.apply(mesh).halfBandwidth <= paper.halfBandwidth)
            assertArrayEquals(best.newNumbers(), Numbering.permutation(mesh, NumberingMethod.BEST).newNumbers())
        }
    }

    @Test
    fun `a large mesh is swept along its long side, found in its likeness`() {
        val grid = GridMeshes.shaken(200, 90, 3L).mesh
        val permutation = Numbering.permutation(grid, NumberingMethod.BEST)
        val b = permutation.apply(grid).halfBandwidth
        assertTrue(b in 91..105, "B $b")
        assertArrayEquals(permutation.newNumbers(), Numbering.permutation(grid, NumberingMethod.BEST).newNumbers())
        val graph = NodeGraph.of(grid)
        val walks = Renumbering.boundaryWalks(grid)
        assertEquals(2 * (200 + 90), walks.size)
        val coarse = CoarseGraph.of(graph, walks, 3000)
        assertTrue(coarse.graph.nodeCount in 1000..3000, "${coarse.graph.nodeCount}")
        for (from in coarse.boundary.indices) {
            for (count in listOf(1, coarse.boundary.size / 3, coarse.boundary.size)) {
                val start = coarse.inLargeGraph(SweepStart(from, count, SweepStart.Way.SWEEP))
                assertTrue(start.from in walks.indices && start.count in 1..walks.size, "$from $count: ${start.from} ${start.count}")
            }
        }
    }

    @Test
    fun `merged levels are an order, from sets as from single nodes`() {
        val grid = GridMeshes.shaken(20, 12, 8L) { i, j -> i in 8..12 && j in 4..8 }.mesh
        val graph = NodeGraph.of(grid)
        val ends = PseudoPeripheral(graph).ends()
        val merged = GibbsPooleStockmeyer(graph)
        assertTrue(merged.run(intArrayOf(ends[0]), intArrayOf(ends[1]), Int.MAX_VALUE))
        assertTrue(NumberingMetrics.of(graph, Permutation.ofOrder(merged.order.copyOf(graph.nodeCount))).halfBandwidth < 30)
        val walks = Renumbering.boundaryWalks(grid)
        assertTrue(merged.run(walks.copyOf(12), walks.copyOfRange(30, 42), Int.MAX_VALUE))
        assertEquals(graph.nodeCount, Permutation.ofOrder(merged.order.copyOf(graph.nodeCount)).size)
        assertTrue(!merged.run(walks.copyOf(12), walks.copyOfRange(30, 42), 3))
    }

    @Test
    fun `hill climbing never loses and ends at a permutation`() {
        for (seed in 0L..20L) {
            val mesh = GridMeshes.shaken(8, 8, seed).mesh
            val graph = NodeGraph.of(mesh)
            val climbing = HillClimbing(graph, IntArray(mesh.nodeCount) { it })
            val before = climbing.halfBandwidth
            assertTrue(climbing.climb(1_000_000))
            val metrics = NumberingMetrics.of(graph, Permutation.ofOrder(climbing.order))
            assertEquals(climbing.halfBandwidth, metrics.halfBandwidth)
            assertTrue(metrics.halfBandwidth < before)
        }
    }

    @Test
    fun `permutations are checked and undone`() {
        val permutation = Permutation.ofNewNumbers(intArrayOf(2, 0, 3, 1))
        assertArrayEquals(intArrayOf(1, 3, 0, 2), permutation.oldNumbers())
        assertArrayEquals(permutation.newNumbers(), permutation.inverse().oldNumbers())
        assertArrayEquals(intArrayOf(1, 3, 0, 2), permutation.reversed().newNumbers())
        assertThrows(IllegalArgumentException::class.java) { Permutation.ofOrder(intArrayOf(0, 0)) }
        assertThrows(IllegalArgumentException::class.java) { Permutation.ofOrder(intArrayOf(0, 2)) }
        val empty = TriMesh.of(DoubleArray(0), IntArray(0))
        assertEquals(0, Numbering.renumber(empty, NumberingMethod.BEST).nodeCount)
        assertEquals(0, Numbering.metrics(empty).bandwidth)
    }
}
