package org.trigrid.spacing

import org.trigrid.MeshOptions
import org.trigrid.Sizes
import org.trigrid.domain.Domain

/** Makes the size field that the options ask for. */
internal object SizeFields {
    /** The field of a valid domain, made on a triangulation of its own where one is needed. */
    @JvmStatic
    fun create(domain: Domain, options: MeshOptions): SizeField = create(domain, options, ConstrainedDelaunay.of(domain))

    /** The field of a valid domain whose triangulation is at hand. */
    @JvmStatic
    fun create(domain: Domain, options: MeshOptions, mesh: ConstrainedDelaunay): SizeField {
        val gradation = options.gradation
        val cones = ConeTree(domain.xy, nodeSizes(domain), gradation)
        val limited = DoubleArray(domain.nodeCount) {
            cones.min(domain.x(it), domain.y(it), it, Double.POSITIVE_INFINITY)
        }
        return when (options.sizes) {
            Sizes.SMOOTH -> LinearField(mesh, limited, cones, gradation)
            Sizes.GRADE -> GradedField(cones)
        }
    }

    /**
     * Mean length of the segments that end in each node, in the domain's unit; positive infinity for a node without a
     * segment.
     */
    @JvmStatic
    fun nodeSizes(domain: Domain): DoubleArray {
        val sizes = DoubleArray(domain.nodeCount)
        val segmentsOfNode = IntArray(domain.nodeCount)
        for (s in 0 until domain.segmentCount) {
            val a = domain.segmentStart(s)
            val b = domain.segmentEnd(s)
            val length = Math.hypot(domain.x(b) - domain.x(a), domain.y(b) - domain.y(a))
            sizes[a] += length
            sizes[b] += length
            segmentsOfNode[a]++
            segmentsOfNode[b]++
        }
        for (node in sizes.indices) {
            sizes[node] = if (segmentsOfNode[node] > 0) sizes[node] / segmentsOfNode[node] else Double.POSITIVE_INFINITY
        }
        return sizes
    }
}
