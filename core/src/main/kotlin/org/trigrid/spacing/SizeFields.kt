package org.trigrid.spacing

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.domain.Domain
import org.trigrid.geometry.IntList

/** Makes the size field that the rules ask for. */
internal object SizeFields {
    /**
     * The field of a valid domain with embedded points, whose triangulation without those points is [mesh]. Points that are near
     * others get small elements round them.
     */
    fun createWithPoints(domain: Domain, rules: SizeRules, mesh: ConstrainedDelaunay, checkpoint: Checkpoint): SizeField {
        return PointField.over(create(domain.withoutLonePoints(), rules, mesh, checkpoint), domain, rules, checkpoint)
    }

    /** The field of a valid domain of segments, whose triangulation is [mesh]. */
    @JvmStatic
    @JvmOverloads
    fun create(
        domain: Domain,
        rules: SizeRules,
        mesh: ConstrainedDelaunay,
        checkpoint: Checkpoint = Checkpoint.unheard(),
    ): SizeField {
        val gradation = rules.gradation
        checkpoint.ask()
        val sizes = nodeSizes(domain)
        checkpoint.ask()
        val cones = ConeTree(domain.xy, sizes, gradation, checkpoint)
        val limited = DoubleArray(domain.nodeCount) {
            checkpoint.pass()
            cones.min(domain.x(it), domain.y(it), it, Double.POSITIVE_INFINITY)
        }
        val ofBoundary = when (rules.sizes) {
            Sizes.SMOOTH -> linearField(domain, mesh, limited, cones, gradation, checkpoint)
            Sizes.GRADE -> GradedField(cones)
        }
        return bounded(ofBoundary, domain, limited, rules, RegionSizes.of(domain, mesh, checkpoint), checkpoint)
    }

    private fun linearField(
        domain: Domain, mesh: ConstrainedDelaunay, sizes: DoubleArray, cones: ConeTree, gradation: Double, checkpoint: Checkpoint,
    ): LinearField {
        val typical = typicalSizes(domain, sizes, checkpoint)
        val reaches = reaches(domain, checkpoint)
        return LinearField(mesh, sizes, typical, reaches, cones, gradation, checkpoint)
    }

    /**
     * How many elements the field asks for, at least as many as the boundary makes necessary; good to some 15 % where the
     * domain is wide against its sizes.
     */
    @JvmStatic
    @JvmOverloads
    fun estimateElements(mesh: ConstrainedDelaunay, field: SizeField, checkpoint: Checkpoint = Checkpoint.unheard()): Double =
        ElementEstimate(mesh, field, checkpoint).total()

    private fun bounded(
        ofBoundary: SizeField, domain: Domain, sizes: DoubleArray, rules: SizeRules, regions: RegionSizes?, checkpoint: Checkpoint,
    ): SizeField {
        val hasSizes = rules.function != null || rules.sources.count > 0 || regions != null
        if (!hasSizes && rules.minSize == 0.0 && rules.maxSize == Double.POSITIVE_INFINITY) return ofBoundary
        val ceiling = ceiling(domain, rules, regions, checkpoint)
        val coarse = IntList()
        for (node in sizes.indices) {
            checkpoint.pass()
            if (sizes[node] > ceiling.atNode(node, domain.x(node), domain.y(node))) coarse.add(node)
        }
        val coarseXy = DoubleArray(2 * coarse.size) { domain.xy[2 * coarse[it / 2] + it % 2] }
        val coarseNodes = ConeTree(coarseXy, DoubleArray(coarse.size) { -sizes[coarse[it]] }, rules.gradation, checkpoint)
        return BoundedField(ofBoundary, ceiling, rules.minSize, if (coarse.size > 0) coarseNodes else null)
    }

    private fun ceiling(domain: Domain, rules: SizeRules, regions: RegionSizes?, checkpoint: Checkpoint): SizeCeiling {
        val sources = rules.sources.graded(rules.gradation, rules.pose)
        val minX = (0 until domain.nodeCount).minOf { domain.x(it) }
        val minY = (0 until domain.nodeCount).minOf { domain.y(it) }
        val extentX = (0 until domain.nodeCount).maxOf { domain.x(it) } - minX
        val extentY = (0 until domain.nodeCount).maxOf { domain.y(it) } - minY
        val extent = Math.max(extentX, extentY)
        val sampled = rules.function?.let {
            SampledSizes(it, rules.pose, minX, minY, extent, InsideLocator(domain), rules.gradation, checkpoint)
        }
        val detail = sampled?.evenCell ?: if (sources != null) extent / SOURCE_CELLS else Double.POSITIVE_INFINITY
        return SizeCeiling(rules.maxSize, sampled, sources, regions, detail)
    }

    /**
     * Size typical of the boundary near each node: the mean length of the [WINDOW] segments before and after it in its
     * loop, weighted by length, times [SHARE]; never below [sizes], and just that for nodes on embedded segments alone.
     */
    private fun typicalSizes(domain: Domain, sizes: DoubleArray, checkpoint: Checkpoint): DoubleArray {
        val typical = DoubleArray(sizes.size) { Double.POSITIVE_INFINITY }
        for (loop in 0 until domain.loopCount) {
            val first = domain.loopStart(loop)
            val count = domain.loopStart(loop + 1) - first
            val window = Math.min(WINDOW, count / 2)
            val lengths = DoubleArray(count) { checkpoint.pass(); domain.segmentLength(first + it) }
            for (i in 0 until count) {
                checkpoint.pass()
                var sum = 0.0
                var squares = 0.0
                for (k in i - window until i + window) {
                    val length = lengths[Math.floorMod(k, count)]
                    sum += length
                    squares += length * length
                }
                val node = domain.segmentStart(first + i)
                typical[node] = Math.min(typical[node], SHARE * squares / sum)
            }
        }
        for (node in sizes.indices) {
            if (typical[node] == Double.POSITIVE_INFINITY) typical[node] = sizes[node]
            typical[node] = Math.max(typical[node], sizes[node])
        }
        return typical
    }

    /**
     * How far each node's spacing rules: [PERIMETERS] times the length of the shortest loop it lies on, else of the embedded
     * lines that hang together with its own.
     */
    private fun reaches(domain: Domain, checkpoint: Checkpoint): DoubleArray {
        val reach = DoubleArray(domain.nodeCount) { Double.POSITIVE_INFINITY }
        for (loop in 0 until domain.loopCount) {
            val segments = domain.loopStart(loop) until domain.loopStart(loop + 1)
            val length = segments.sumOf { checkpoint.pass(); domain.segmentLength(it) }
            for (s in segments) {
                checkpoint.pass()
                val node = domain.segmentStart(s)
                reach[node] = Math.min(reach[node], PERIMETERS * length)
            }
        }
        if (domain.boundaryCount == domain.segmentCount) return reach
        val lengths = EmbeddedLengths(domain)
        for (s in domain.boundaryCount until domain.segmentCount) {
            for (node in intArrayOf(domain.segmentStart(s), domain.segmentEnd(s))) {
                if (reach[node] == Double.POSITIVE_INFINITY) reach[node] = PERIMETERS * lengths.at(node)
            }
        }
        return reach
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
            val length = domain.segmentLength(s)
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

    /** Parts of the domain's width in which sources are looked for when elements are counted. */
    private const val SOURCE_CELLS = 64

    /** Segments before and after a node that make its stretch of the boundary. */
    private const val WINDOW = 8

    /** Share of the stretch's mean length that a finer node may grow to; larger shares lose the grading of smooth curves. */
    private const val SHARE = 1.0 / 3

    /** Small enough for three holes a millionth of the domain wide, large enough to leave plates of holes alone. */
    private const val PERIMETERS = 4.0
}
