package org.trigrid.mesh

/** One way in which a mesh is not what it should be, and where. */
public class MeshViolation internal constructor(
    @get:JvmName("kind") public val kind: MeshViolationKind,
    /** One line that says what is wrong, with numbers and coordinates. */
    @get:JvmName("message") public val message: String,
    /** The place, in the domain's coordinates; NaN where the whole mesh is concerned. */
    @get:JvmName("x") public val x: Double,
    @get:JvmName("y") public val y: Double,
) {
    override fun toString(): String = "$kind: $message"
}

/** The kinds of violations that [MeshCheck] finds. */
public enum class MeshViolationKind {
    /** A coordinate is NaN or infinite. */
    NOT_A_NUMBER,

    /** An element is flat or runs clockwise. */
    NOT_POSITIVE,

    /** An edge belongs to more than two elements, or to two on the same side. */
    SHARED_TOO_OFTEN,

    /** The neighbours of an element are not those that its edges say. */
    WRONG_NEIGHBOUR,

    /** A node belongs to no element. */
    UNUSED_NODE,

    /** Counts of nodes, edges and elements do not fit the number of parts and holes (Euler's formula). */
    EULER,

    /** A boundary or embedded edge of the mesh is not listed, listed twice, the wrong way round or without a tag. */
    WRONG_TAGGED_EDGE,

    /** A node's kind is not that of the edges it lies on. */
    WRONG_KIND,

    /** A node of the domain is not in the mesh at exactly its place, or the mesh has one more on its boundary. */
    GIVEN_NODE,

    /** A segment of the domain is not a boundary edge of the mesh. */
    MISSING_SEGMENT,

    /** A boundary edge of the mesh is not a segment of the domain. */
    EXTRA_BOUNDARY_EDGE,

    /** An embedded segment of the domain is not an inner edge of the mesh. */
    MISSING_EMBEDDED_SEGMENT,

    /** The elements do not cover the area of the domain. */
    AREA,

    /** An element is in no region or not in the one that the domain has there, or no tagged edge parts it from another region. */
    WRONG_REGION,
}
