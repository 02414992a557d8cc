package org.trigrid.mesh

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.domain.Domain

class MeshCheckTest {
    private val ring = GridMeshes.shaken(9, 7, 5L) { i, j -> i in 3..4 && j in 2..4 }

    private fun kinds(mesh: TriMesh, domain: Domain = ring.domain) = MeshCheck.check(mesh, domain).map { it.kind }.toSet()

    private fun changed(
        mesh: TriMesh = ring.mesh,
        xy: DoubleArray = mesh.xy,
        elements: IntArray = mesh.elements,
        neighbours: IntArray = mesh.neighbours,
        kinds: ByteArray = mesh.kinds,
        edges: IntArray = mesh.edges,
        edgeTags: IntArray = mesh.edgeTags,
        boundaryEdgeCount: Int = mesh.boundaryEdgeCount,
    ) = TriMesh(xy, elements, neighbours, kinds, edges, edgeTags, boundaryEdgeCount, mesh.tags, mesh.regionName)

    @Test
    fun `valid meshes with holes, touching holes and several parts pass`() {
        assertEquals(emptyList<MeshViolation>(), MeshCheck.check(ring.mesh, ring.domain))
        val touching = GridMeshes.shaken(8, 8, 6L) { i, j -> (i == 2 && j == 2) || (i == 3 && j == 3) || (i == 5 && j == 2) }
        assertEquals(emptyList<MeshViolation>(), MeshCheck.check(touching.mesh, touching.domain))
        val parts = GridMeshes.shaken(9, 4, 7L) { i, _ -> i == 4 }
        assertEquals(emptyList<MeshViolation>(), MeshCheck.check(parts.mesh, parts.domain))
        val corners = GridMeshes.grid(4, 4) { i, j -> (i < 2) != (j < 2) }
        assertEquals(emptyList<MeshViolation>(), MeshCheck.check(corners.mesh, corners.domain))
        for (seed in 0L..40L) {
            val random = java.util.Random(seed)
            val out = BooleanArray(100) { random.nextInt(4) == 0 }
            val some = GridMeshes.shaken(10, 10, seed) { i, j -> out[10 * j + i] }
            assertEquals(emptyList<MeshViolation>(), MeshCheck.check(some.mesh, some.domain), "seed $seed")
        }
    }

    @Test
    fun `a clockwise element is named with its place`() {
        val elements = ring.mesh.elementNodes()
        elements[3] = ring.mesh.elements[4]
        elements[4] = ring.mesh.elements[3]
        val violation = MeshCheck.check(changed(elements = elements)).first { it.kind == MeshViolationKind.NOT_POSITIVE }
        assertTrue(violation.message.startsWith("element 1 "), violation.message)
        val x = (0..2).sumOf { ring.mesh.x(ring.mesh.nodeOf(1, it)) } / 3
        assertEquals(x, violation.x, 1e-12)
    }

    @Test
    fun `a moved boundary node breaks the fit and the area`() {
        val xy = ring.mesh.nodeCoordinates()
        val node = (0 until ring.mesh.nodeCount).first { ring.mesh.kindOf(it) == NodeKind.BOUNDARY }
        xy[2 * node] += 1e-9
        val found = kinds(changed(xy = xy))
        assertTrue(MeshViolationKind.GIVEN_NODE in found, "$found")
        assertEquals(emptyList<MeshViolation>(), MeshCheck.check(changed(xy = xy)))
    }

    @Test
    fun `a missing element shows as boundary and as area`() {
        val mesh = ring.mesh
        val inner = (0 until mesh.elementCount).first { t -> (0..2).all { mesh.neighbourOf(t, it) >= 0 } }
        val kept = (0 until mesh.elementCount).filter { it != inner }
        val elements = kept.flatMap { t -> (0..2).map { mesh.nodeOf(t, it) } }.toIntArray()
        val holed = TriMesh.of(mesh.xy, elements)
        assertEquals(emptyList<MeshViolation>(), MeshCheck.check(holed))
        val found = kinds(holed)
        assertTrue(MeshViolationKind.EXTRA_BOUNDARY_EDGE in found && MeshViolationKind.AREA in found, "$found")
    }

    @Test
    fun `an element laid over another is shared too often`() {
        val doubled = ring.mesh.elementNodes() + ring.mesh.elementNodes().copyOf(3)
        assertTrue(MeshViolationKind.SHARED_TOO_OFTEN in kinds(TriMesh.of(ring.mesh.xy, doubled)))
    }

    @Test
    fun `wrong neighbours, unused nodes, wrong kinds and tags are found`() {
        val mesh = ring.mesh
        val neighbours = mesh.elementNeighbours()
        val half = neighbours.indexOfFirst { it >= 0 }
        neighbours[half] = TriMesh.NONE
        assertTrue(MeshViolationKind.WRONG_NEIGHBOUR in kinds(changed(neighbours = neighbours)))
        val more = changed(xy = mesh.xy + doubleArrayOf(2.0, 2.0), kinds = mesh.kinds + NodeKind.INTERIOR.code)
        assertEquals(setOf(MeshViolationKind.UNUSED_NODE), kinds(more))
        val kinds = mesh.kinds.copyOf()
        kinds[mesh.edgeStart(0)] = NodeKind.INTERIOR.code
        assertTrue(MeshViolationKind.WRONG_KIND in kinds(changed(kinds = kinds)))
        val tags = mesh.edgeTags.copyOf()
        tags[0] = 1 - tags[0]
        assertEquals(setOf(MeshViolationKind.WRONG_TAGGED_EDGE), kinds(changed(edgeTags = tags)))
        val edges = mesh.edges.copyOf()
        edges[0] = mesh.edges[1]
        edges[1] = mesh.edges[0]
        assertTrue(MeshViolationKind.WRONG_TAGGED_EDGE in kinds(changed(edges = edges)))
        val xy = mesh.xy.copyOf()
        xy[0] = Double.NaN
        assertTrue(MeshViolationKind.NOT_A_NUMBER in kinds(changed(xy = xy)))
    }

    @Test
    fun `an embedded segment must be an edge`() {
        val base = GridMeshes.grid(4, 4)
        val a = (0 until base.mesh.nodeCount).first { base.mesh.x(it) == 1.0 && base.mesh.y(it) == 2.0 }
        val b = (0 until base.mesh.nodeCount).first { base.mesh.x(it) == 2.0 && base.mesh.y(it) == 2.0 }
        val d = base.domain
        val m = base.mesh
        val count = d.nodeCount
        fun domainTo(x: Double): Domain = Domain(
            d.xy + doubleArrayOf(1.0, 2.0, x, 2.0), d.segments + intArrayOf(count, count + 1), d.segmentTags + 0,
            BooleanArray(d.segmentCount) { false } + true, d.tags, "plate",
        )
        val lined = TriMeshFactory.of(
            m.xy, m.elements, m.edges + intArrayOf(b, a), m.edgeTags + 0, m.tags, "plate",
        )
        assertEquals(1, lined.taggedEdgeCount - lined.boundaryEdgeCount)
        assertEquals(NodeKind.EMBEDDED, lined.kindOf(a))
        assertEquals(emptyList<MeshViolation>(), MeshCheck.check(lined, domainTo(2.0)))
        val xy = m.xy.copyOf()
        assertTrue(MeshViolationKind.GIVEN_NODE in kinds(changed(m, xy = xy), domainTo(2.0)))
        assertThrowsNoEdge(m, a)
    }

    private fun assertThrowsNoEdge(m: TriMesh, a: Int) {
        val far = (0 until m.nodeCount).first { m.x(it) == 3.0 && m.y(it) == 3.0 }
        val error = org.junit.jupiter.api.Assertions.assertThrows(IllegalArgumentException::class.java) {
            TriMeshFactory.of(m.xy, m.elements, intArrayOf(a, far), intArrayOf(0), m.tags, "plate")
        }
        assertTrue("no edge" in error.message!!, error.message)
    }
}
