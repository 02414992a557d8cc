package org.trigrid.mesh

import org.trigrid.domain.Domain

/**
 * Proves a mesh valid, or names what is wrong with it and where. Takes linear time.
 *
 * With a domain the proof is whole: when every element is positive and the boundary of their sum is that of the domain,
 * then each point of the domain lies in exactly one element; and when regions change at tagged edges only, and are right on
 * both sides of each, then they are right everywhere. Signs of areas are exact.
 */
public object MeshCheck {
    /** No more violations than this are described; a mesh with that many is broken as a whole. */
    public const val LIMIT: Int = 1000

    /** Everything that can be checked without the domain; empty for a valid mesh. */
    @JvmStatic
    public fun check(mesh: TriMesh): List<MeshViolation> {
        val found = ViolationList(mesh)
        checkTopology(mesh, found)
        return found.toList()
    }

    /** As [check], and that the mesh covers [domain] with its nodes and segments kept exactly; empty for a valid mesh. */
    @JvmStatic
    public fun check(mesh: TriMesh, domain: Domain): List<MeshViolation> {
        val found = ViolationList(mesh)
        if (checkTopology(mesh, found)) DomainFit(mesh, domain, found).check()
        return found.toList()
    }

    /** @throws IllegalArgumentException if [check] finds something. */
    internal fun requireValid(mesh: TriMesh) {
        val violation = check(mesh).firstOrNull() ?: return
        throw IllegalArgumentException("the mesh is not valid: ${violation.message} at (${violation.x}, ${violation.y})")
    }

    /** @return false if numbers or neighbours are so wrong that further checks make no sense. */
    private fun checkTopology(mesh: TriMesh, found: ViolationList): Boolean {
        val shape = ElementCheck(mesh, found)
        if (!shape.checkCoordinates() || !shape.checkRanges()) return false
        shape.checkPositive()
        shape.checkUsed()
        val conformity = ConformityCheck(mesh, found)
        conformity.checkEdges()
        val sound = conformity.checkNeighbours()
        TaggedEdgeCheck(mesh, found).check()
        if (sound) RegionCheck(mesh, found).check()
        if (sound && found.isEmpty) EulerCheck(mesh, found).check()
        return sound
    }
}

/** Collects violations of one mesh, up to [MeshCheck.LIMIT]. */
internal class ViolationList(private val mesh: TriMesh) {
    private val violations = ArrayList<MeshViolation>()

    val isEmpty: Boolean get() = violations.isEmpty()

    fun toList(): List<MeshViolation> = java.util.List.copyOf(violations)

    fun add(kind: MeshViolationKind, x: Double, y: Double, message: String) {
        if (violations.size < MeshCheck.LIMIT) violations.add(MeshViolation(kind, message, x, y))
    }

    fun atNode(kind: MeshViolationKind, node: Int, what: String) =
        add(kind, mesh.x(node), mesh.y(node), "node ${place(node)} $what")

    fun atElement(kind: MeshViolationKind, element: Int, what: String) {
        val a = mesh.nodeOf(element, 0)
        val b = mesh.nodeOf(element, 1)
        val c = mesh.nodeOf(element, 2)
        val x = mesh.x(a) / 3 + mesh.x(b) / 3 + mesh.x(c) / 3
        val y = mesh.y(a) / 3 + mesh.y(b) / 3 + mesh.y(c) / 3
        add(kind, x, y, "element $element with nodes $a, $b, $c at ($x, $y) $what")
    }

    fun atEdge(kind: MeshViolationKind, a: Int, b: Int, what: String) {
        val x = 0.5 * (mesh.x(a) + mesh.x(b))
        val y = 0.5 * (mesh.y(a) + mesh.y(b))
        add(kind, x, y, "edge from node ${place(a)} to node ${place(b)} $what")
    }

    private fun place(node: Int): String = "$node at (${mesh.x(node)}, ${mesh.y(node)})"
}
