package org.trigrid.spacing

import org.trigrid.MeshOptions
import org.trigrid.Sizes
import org.trigrid.domain.Domain
import org.trigrid.geometry.IntList

/** Makes the size field that the options ask for. */
internal object SizeFields {
    /** The field of a valid domain, made on a triangulation of its own where one is needed. */
    @JvmStatic
    fun create(domain: Domain, options: MeshOptions): SizeField = create(domain, options, ConstrainedDelaunay.of(domain))

    /** The field of a valid domain whose triangulation is at hand. */
    @JvmStatic
    fun create(domain: Domain, options: MeshOptions, mesh: ConstrainedDelaunay): SizeField {
        val gradation = options.gradation
        val sizes = nodeSizes(domain)
        val cones = ConeTree(domain.xy, sizes, gradation)
        val limited = DoubleArray(domain.nodeCount) {
            cones.min(domain.x(it), domain.y(it), it, Double.POSITIVE_INFINITY)
        }
        val ofBoundary = when (options.sizes) {
            Sizes.SMOOTH -> LinearField(mesh, limited, cones, gradation)
            Sizes.GRADE -> GradedField(cones)
        }
        return bounded(ofBoundary, domain, limited, options)
    }

    /**
     * How many elements the field asks for, at least as many as the boundary makes necessary; good to some 15 % where the
     * domain is wide against its sizes.
     */
    @JvmStatic
    fun estimateElements(mesh: ConstrainedDelaunay, field: SizeField): Double = ElementEstimate(mesh, field).total()

    private fun bounded(ofBoundary: SizeField, domain: Domain, sizes: DoubleArray, options: MeshOptions): SizeField {
        val function = options.sizeFunction
        if (function == null && options.minSize == 0.0 && options.maxSize == Double.POSITIVE_INFINITY) return ofBoundary
        val user = function?.let { sample(it, domain, options.gradation) }
        val coarse = IntList()
        for (node in sizes.indices) {
            val ofUser = user?.sizeAt(domain.x(node), domain.y(node)) ?: Double.POSITIVE_INFINITY
            if (sizes[node] > Math.min(options.maxSize, ofUser)) coarse.add(node)
        }
        val coarseXy = DoubleArray(2 * coarse.size) { domain.xy[2 * coarse[it / 2] + it % 2] }
        val coarseNodes = ConeTree(coarseXy, DoubleArray(coarse.size) { -sizes[coarse[it]] }, options.gradation)
        return BoundedField(ofBoundary, user, options.minSize, options.maxSize, if (coarse.size > 0) coarseNodes else null)
    }

    private fun sample(function: SizeFunction, domain: Domain, gradation: Double): SampledSizes {
        val minX = (0 until domain.nodeCount).minOf { domain.x(it) }
        val minY = (0 until domain.nodeCount).minOf { domain.y(it) }
        val extentX = (0 until domain.nodeCount).maxOf { domain.x(it) } - minX
        val extentY = (0 until domain.nodeCount).maxOf { domain.y(it) } - minY
        return SampledSizes(function, minX, minY, Math.max(extentX, extentY), InsideLocator(domain), gradation)
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
