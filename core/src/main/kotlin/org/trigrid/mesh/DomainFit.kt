package org.trigrid.mesh

import org.trigrid.domain.Domain

/** Checks that a mesh keeps the nodes and segments of its domain and covers its area. */
internal class DomainFit(private val mesh: TriMesh, private val domain: Domain, private val found: ViolationList) {
    /** The mesh's number of each node of the domain, or -1. */
    private val meshNodes = findNodes()

    fun check() {
        checkNodes()
        checkBoundary()
        checkEmbedded()
        checkPoints()
        checkRegions()
        checkArea()
    }

    private fun findNodes(): IntArray {
        val byPlace = HashMap<Place, Int>()
        for (node in 0 until mesh.nodeCount) {
            if (mesh.kindOf(node) != NodeKind.INTERIOR) byPlace[Place(mesh.x(node), mesh.y(node))] = node
        }
        return IntArray(domain.nodeCount) { byPlace[Place(domain.x(it), domain.y(it))] ?: -1 }
    }

    private fun checkNodes() {
        for (node in meshNodes.indices) {
            if (meshNodes[node] >= 0) continue
            val x = domain.x(node)
            val y = domain.y(node)
            found.add(MeshViolationKind.GIVEN_NODE, x, y, "node $node of the domain at ($x, $y) is not in the mesh at that place")
        }
        val given = BooleanArray(mesh.nodeCount)
        for (node in meshNodes) if (node >= 0) given[node] = true
        for (node in given.indices) {
            if (!given[node] && mesh.kindOf(node) != NodeKind.INTERIOR) {
                found.atNode(MeshViolationKind.GIVEN_NODE, node, "counts as given and is no node of the domain")
            }
        }
    }

    private fun checkBoundary() {
        val tags = HashMap<Long, Int>()
        for (edge in 0 until mesh.boundaryEdgeCount) {
            tags[directed(mesh.edgeStart(edge), mesh.edgeEnd(edge))] = mesh.edgeTag(edge)
        }
        for (segment in 0 until domain.segmentCount) {
            if (domain.isEmbedded(segment)) continue
            val a = meshNodes[domain.segmentStart(segment)]
            val b = meshNodes[domain.segmentEnd(segment)]
            if (a < 0 || b < 0) continue
            val tag = tags.remove(directed(a, b))
            if (tag == null) {
                found.atEdge(MeshViolationKind.MISSING_SEGMENT, a, b, "is segment $segment of the domain and no boundary edge")
            } else {
                checkTag(a, b, tag, segment)
            }
        }
        for (edge in 0 until mesh.boundaryEdgeCount) {
            val a = mesh.edgeStart(edge)
            val b = mesh.edgeEnd(edge)
            if (directed(a, b) in tags) found.atEdge(MeshViolationKind.EXTRA_BOUNDARY_EDGE, a, b, "is no segment of the domain")
        }
    }

    private fun checkEmbedded() {
        if ((0 until domain.segmentCount).none { domain.isEmbedded(it) }) return
        val tags = HashMap<Long, Int>()
        for (edge in mesh.boundaryEdgeCount until mesh.taggedEdgeCount) {
            tags[undirected(mesh.edgeStart(edge), mesh.edgeEnd(edge))] = mesh.edgeTag(edge)
        }
        for (segment in 0 until domain.segmentCount) {
            if (!domain.isEmbedded(segment)) continue
            val a = meshNodes[domain.segmentStart(segment)]
            val b = meshNodes[domain.segmentEnd(segment)]
            if (a < 0 || b < 0) continue
            val tag = tags[undirected(a, b)]
            if (tag == null) {
                found.atEdge(MeshViolationKind.MISSING_EMBEDDED_SEGMENT, a, b, "is embedded segment $segment of the domain and not in the mesh")
            } else {
                checkTag(a, b, tag, segment)
            }
        }
    }

    private fun checkPoints() {
        val points = HashSet<Pair<Int, String>>()
        for (p in 0 until mesh.pointCount) points.add(mesh.pointNode(p) to mesh.tags[mesh.pointTag(p)])
        for (p in 0 until domain.pointCount) {
            val node = meshNodes[domain.pointNode(p)]
            val tag = domain.tags[domain.pointTag(p)]
            if (node >= 0 && node to tag !in points) found.atNode(MeshViolationKind.GIVEN_NODE, node, "is no point of the group '$tag'")
        }
    }

    /** On both sides of every segment; between segments [RegionCheck] looks that nothing changes. */
    private fun checkRegions() {
        if (domain.regions.size == 1 && mesh.regions.size == 1) {
            if (domain.regions[0].name == mesh.regions[0].name) return
        }
        val sides = TaggedSides(mesh)
        val edges = HashMap<Long, Int>()
        for (edge in 0 until mesh.taggedEdgeCount) edges[directed(mesh.edgeStart(edge), mesh.edgeEnd(edge))] = edge
        for (segment in 0 until domain.segmentCount) {
            val a = meshNodes[domain.segmentStart(segment)]
            val b = meshNodes[domain.segmentEnd(segment)]
            val same = edges[directed(a, b)]
            val edge = same ?: edges[directed(b, a)] ?: continue
            val half = sides.leftOf(edge)
            val left = if (same != null) domain.regionOnLeft(segment) else domain.regionOnRight(segment)
            val right = if (same != null) domain.regionOnRight(segment) else domain.regionOnLeft(segment)
            checkRegion(half / 3, left, a, b)
            if (mesh.neighbours[half] >= 0) checkRegion(mesh.neighbours[half], right, a, b)
        }
    }

    private fun checkRegion(element: Int, wanted: Int, a: Int, b: Int) {
        val actual = mesh.regions.getOrNull(mesh.regionOf(element))?.name
        val name = domain.regions.getOrNull(wanted)?.name
        if (actual != name) found.atEdge(MeshViolationKind.WRONG_REGION, a, b, "has region '$actual' beside it, its segment has '$name'")
    }

    private fun checkTag(a: Int, b: Int, tag: Int, segment: Int) {
        val wanted = domain.tags[domain.segmentTag(segment)]
        val actual = mesh.tags.getOrNull(tag)
        if (actual == wanted) return
        found.atEdge(MeshViolationKind.WRONG_TAGGED_EDGE, a, b, "has the tag '$actual', its segment has '$wanted'")
    }

    private fun checkArea() {
        val covered = CompensatedSum()
        for (t in 0 until mesh.elementCount) covered.add(mesh.area(t))
        val wanted = domainArea()
        val error = Math.abs(covered.value - wanted)
        if (error <= AREA_TOLERANCE * Math.abs(wanted) + roundings()) return
        found.add(
            MeshViolationKind.AREA, Double.NaN, Double.NaN,
            "the elements cover ${covered.value}, the domain has $wanted: off by ${error / Math.abs(wanted)} of it",
        )
    }

    /** Shoelace formula about the first node, products with their rounding remainders. */
    private fun domainArea(): Double {
        val sum = CompensatedSum()
        if (domain.nodeCount == 0) return 0.0
        val ox = domain.x(0)
        val oy = domain.y(0)
        for (segment in 0 until domain.segmentCount) {
            if (domain.isEmbedded(segment)) continue
            val a = domain.segmentStart(segment)
            val b = domain.segmentEnd(segment)
            sum.addProduct(domain.x(a) - ox, domain.y(b) - oy)
            sum.addProduct(-(domain.x(b) - ox), domain.y(a) - oy)
        }
        return 0.5 * sum.value
    }

    /** What rounding may do to the areas: needles have far less area than the products that it is the difference of. */
    private fun roundings(): Double {
        var products = 0.0
        for (segment in 0 until domain.segmentCount) {
            val a = domain.segmentStart(segment)
            val b = domain.segmentEnd(segment)
            products += Math.abs((domain.x(a) - domain.x(0)) * (domain.y(b) - domain.y(0)))
            products += Math.abs((domain.x(b) - domain.x(0)) * (domain.y(a) - domain.y(0)))
        }
        for (t in 0 until mesh.elementCount) {
            val a = mesh.nodeOf(t, 0)
            val b = mesh.nodeOf(t, 1)
            val c = mesh.nodeOf(t, 2)
            products += Math.abs((mesh.x(b) - mesh.x(a)) * (mesh.y(c) - mesh.y(a)))
            products += Math.abs((mesh.y(b) - mesh.y(a)) * (mesh.x(c) - mesh.x(a)))
        }
        return ROUNDINGS * products
    }

    private fun directed(a: Int, b: Int): Long = (a.toLong() shl 32) or b.toLong()

    private fun undirected(a: Int, b: Int): Long = directed(minOf(a, b), maxOf(a, b))

    /** Equal for equal coordinates; 0.0 and -0.0 are the same place. */
    private data class Place(val xBits: Long, val yBits: Long) {
        constructor(x: Double, y: Double) : this((x + 0.0).toRawBits(), (y + 0.0).toRawBits())
    }

    private companion object {
        const val AREA_TOLERANCE = 1e-12

        /** Half units in the last place by which half a product of two differences may be off, with room to spare. */
        const val ROUNDINGS = 4 * 1.1102230246251565e-16
    }
}

/** Neumaier's sum (1974, ZAMM 54:39-51): what each addition rounds away is kept aside. */
internal class CompensatedSum {
    private var sum = 0.0
    private var lost = 0.0

    val value: Double get() = sum + lost

    fun add(v: Double) {
        val t = sum + v
        lost += if (Math.abs(sum) >= Math.abs(v)) (sum - t) + v else (v - t) + sum
        sum = t
    }

    fun addProduct(a: Double, b: Double) {
        val product = a * b
        add(product)
        add(Math.fma(a, b, -product))
    }
}
