package org.trigrid.spacing

/**
 * The boundary's field brought within the user's sizes and the global bounds.
 *
 * - [minSize] is a plain floor: no inner edge is asked to be shorter, even beside shorter boundary segments.
 * - The largest size, those of regions, the user's sizes and those of sources are ceilings. Boundary segments are never divided, so beside a segment longer than the
 *   ceiling the size falls from the segment's own to the ceiling by the gradation: `max over nodes i of (h_i - g |x - x_i|)`
 *   is still allowed. So no coarse side gets a row of needles.
 */
internal class BoundedField(
    private val boundaryField: SizeField,
    private val ceiling: SizeCeiling,
    private val minSize: Double,
    /** Envelope of the negative sizes of the nodes that are coarser than the ceiling there; null if none is. */
    private val coarseNodes: ConeTree?,
) : SizeField {
    /** Whether the hints are triangles. */
    private val isOfTriangles = boundaryField is LinearField

    override val lastHint: Int get() = boundaryField.lastHint

    override val detail: Double get() = ceiling.detail

    override fun hintOf(node: Int): Int = boundaryField.hintOf(node)

    override fun sizeAt(x: Double, y: Double, hint: Int): Double {
        val ofBoundary = boundaryField.sizeAt(x, y, hint)
        val ceiling = ceiling.at(x, y, if (isOfTriangles) boundaryField.lastHint else -1)
        if (ofBoundary <= ceiling) return Math.max(minSize, ofBoundary)
        val allowed = if (coarseNodes == null) ceiling else -coarseNodes.min(x, y, coarseNodes.winner, -ceiling)
        return Math.max(minSize, Math.min(ofBoundary, allowed))
    }
}
