package org.trigrid.diagnostics

/** What is wrong with a domain, and where. */
public class Fault(
    @get:JvmName("kind") public val kind: FaultKind,
    /** One line that says what is wrong, with node numbers and coordinates. */
    @get:JvmName("message") public val message: String,
    /** The place of the fault, in the domain's coordinates. */
    @get:JvmName("x") public val x: Double,
    @get:JvmName("y") public val y: Double,
    private val nodeArray: IntArray,
) {
    /** The nodes concerned, as numbered in the domain (0-based). A copy. */
    public fun nodes(): IntArray = nodeArray.copyOf()

    override fun toString(): String = "$kind: $message"
}

/** The kinds of faults that a domain may have. */
public enum class FaultKind {
    /** A coordinate is NaN or infinite, or above 1e60, beyond which products of coordinates leave the range of numbers. */
    NOT_A_NUMBER,

    /** Two boundary segments cross in their interiors. */
    CROSSING,

    /** A node lies inside a segment that does not end in it. */
    TOUCHING,

    /** Two nodes with different numbers lie at the same place. */
    DUPLICATE_NODE,

    /** A segment whose two ends are the same place, or nearer to each other than 1e-60. */
    ZERO_LENGTH,

    /** The boundary runs to a node and straight back, and is not a connector. */
    SPIKE,

    /** A walk that does not end where it began. */
    OPEN_WALK,

    /** A hole that lies outside of every outer loop, or crosses none but has no material round it. */
    HOLE_OUTSIDE,

    /** Two loops or segments cover the same place. */
    OVERLAP,

    /** A loop with fewer than three nodes, or no area at all. */
    DEGENERATE_LOOP,

    /** An embedded segment or point lies outside of the domain. */
    EMBEDDED_OUTSIDE,

    /** A point that tells a region lies outside, on a segment, or where a point of another region lies too. */
    REGION_POINT,
}
