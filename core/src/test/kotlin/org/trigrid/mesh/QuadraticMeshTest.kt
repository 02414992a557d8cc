package org.trigrid.mesh

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.MeshRework
import org.trigrid.numbering.NodeGraph
import org.trigrid.numbering.Numbering
import org.trigrid.numbering.NumberingMethod
import org.trigrid.numbering.NumberingMetrics
import org.trigrid.numbering.Permutation
import java.util.Random

class QuadraticMeshTest {
    private val one = TriMesh.of(doubleArrayOf(0.0, 0.0, 2.0, 0.0, 0.0, 1.0), intArrayOf(0, 1, 2))

    /** The middle of the edge from (0, 0) to (2, 0) at the height [y], others straight. */
    private fun bent(y: Double) = EdgeMiddles { mesh, edge ->
        val straight = EdgeMiddles.STRAIGHT.middleOf(mesh, edge)
        if (mesh.y(mesh.edgeStart(edge)) == 0.0 && mesh.y(mesh.edgeEnd(edge)) == 0.0) doubleArrayOf(straight[0], y) else straight
    }

    @Test
    fun `middles come between their corners`() {
        val mesh = QuadraticMesh.of(one)
        assertEquals(6, mesh.nodeCount)
        assertArrayEquals(doubleArrayOf(0.0, 0.0, 2.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.5, 0.0, 0.5), mesh.nodeCoordinates())
        assertArrayEquals(intArrayOf(0, 1, 2, 3, 4, 5), mesh.elementNodes())
        assertEquals(1.0, mesh.area(0))
        assertEquals(2.0, mesh.leastJacobian(0))
        assertArrayEquals(intArrayOf(0, 1, 2, 3, 4, 5), mesh.nodesOn("boundary"))
        assertEquals(0, mesh.straightenedEdgeCount)
    }

    @Test
    fun `a curved edge takes two thirds of its height off the area`() {
        val mesh = QuadraticMesh.of(one, bent(-0.25))
        assertEquals(1 + 2.0 / 3 * 2 * 0.25, mesh.area(0), 1e-15)
        assertEquals(0, mesh.straightenedEdgeCount)
    }

    @Test
    fun `a middle that folds its element goes back towards the straight one, no farther than it must`() {
        for (y in doubleArrayOf(0.22, 0.24, 0.3, 5.0, -0.3)) {
            val mesh = QuadraticMesh.of(one, bent(y))
            assertTrue(mesh.leastJacobian(0) >= 0.1 * 2, "$y: ${mesh.leastJacobian(0)}")
            assertEquals(if (y > 0.225) 1 else 0, mesh.straightenedEdgeCount, "$y")
            if (Math.abs(y) < 1) assertTrue(Math.abs(mesh.y(mesh.edgeMiddle(0))) > 0.2, "${mesh.y(mesh.edgeMiddle(0))}")
        }
    }

    @Test
    fun `the least Jacobian is that of many places`() {
        val random = Random(5)
        repeat(300) {
            val places = DoubleArray(12) { random.nextGaussian() }
            val least = QuadraticJacobian(places).least()
            var sampled = Double.POSITIVE_INFINITY
            val steps = 60
            for (i in 0..steps) for (k in 0..steps - i) sampled = minOf(sampled, jacobian(places, i / 60.0, k / 60.0))
            assertTrue(least <= sampled + 1e-12 && least > sampled - 0.05, "$least, sampled $sampled")
        }
    }

    /** By the derivatives of the usual shape functions of six-node triangles. */
    private fun jacobian(p: DoubleArray, u: Double, v: Double): Double {
        val w = 1 - u - v
        val du = doubleArrayOf(1 - 4 * w, 4 * u - 1, 0.0, 4 * (w - u), 4 * v, -4 * v)
        val dv = doubleArrayOf(1 - 4 * w, 0.0, 4 * v - 1, -4 * u, 4 * u, 4 * (w - v))
        fun sum(d: DoubleArray, c: Int) = (0..5).sumOf { d[it] * p[2 * it + c] }
        return sum(du, 0) * sum(dv, 1) - sum(du, 1) * sum(dv, 0)
    }

    @Test
    fun `whatever middles are asked for, no element folds and nothing else changes`() {
        val random = Random(11)
        repeat(20) {
            val mesh = GridMeshes.grid(2 + random.nextInt(5), 2 + random.nextInt(5)).mesh
            val size = 3 * random.nextDouble()
            val quadratic = QuadraticMesh.of(mesh) { m, edge ->
                EdgeMiddles.STRAIGHT.middleOf(m, edge).also { for (c in 0..1) it[c] += size * random.nextGaussian() }
            }
            for (t in 0 until mesh.elementCount) assertTrue(quadratic.leastJacobian(t) >= 0.1 * 2 * mesh.area(t) * (1 - 1e-12))
            assertTrue(quadratic.straightenedEdgeCount <= mesh.taggedEdgeCount)
            assertEquals(mesh.nodeCount + mesh.edgeCount, quadratic.nodeCount)
        }
    }

    @Test
    fun `all nodes are renumbered, the mesh stays`() {
        val mesh = GridMeshes.grid(30, 8).mesh
        val raw = QuadraticMesh.of(mesh, bent(-0.1))
        val ordered = MeshRework.secondOrder(mesh, bent(-0.1))
        assertTrue(ordered.halfBandwidth < raw.halfBandwidth / 5, "${raw.halfBandwidth} -> ${ordered.halfBandwidth}")
        assertEquals(ordered.halfBandwidth, Numbering.metrics(ordered).halfBandwidth)
        val graph = NodeGraph.of(ordered)
        val byGraph = NumberingMetrics.of(graph, Permutation.identity(ordered.nodeCount))
        assertEquals(Numbering.metrics(ordered).toString(), byGraph.toString())
        fun places(m: QuadraticMesh) = (0 until m.elementCount).map { t -> (0..5).map { m.x(m.nodeOf(t, it)) to m.y(m.nodeOf(t, it)) } }.toSet()
        assertEquals(places(raw), places(ordered))
        for (e in 0 until raw.taggedEdgeCount) {
            assertEquals(raw.x(raw.edgeMiddle(e)), ordered.x(ordered.edgeMiddle(e)))
            assertEquals(raw.y(raw.edgeEnd(e)), ordered.y(ordered.edgeEnd(e)))
        }
        assertEquals(NumberingMethod.NONE.let { Numbering.renumber(raw, it) }, raw)
    }

    @Test
    fun `a mesh that is not valid is refused`() {
        val folded = TriMesh.of(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 2.0, 0.0), intArrayOf(0, 1, 2))
        assertThrows(IllegalArgumentException::class.java) { QuadraticMesh.of(folded) }
        assertThrows(IllegalArgumentException::class.java) { QuadraticMesh.of(one) { _, _ -> doubleArrayOf(Double.NaN, 0.0) } }
    }
}
