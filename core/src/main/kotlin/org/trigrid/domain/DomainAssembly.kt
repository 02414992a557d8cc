package org.trigrid.domain

/** What a [DomainBuilder] made of its loops; they are numbered from 0 in the order in which they were added. */
public class DomainAssembly internal constructor(
    @get:JvmName("domain") public val domain: Domain,
    private val roles: List<LoopRole>,
    private val reversed: BooleanArray,
    private val parents: IntArray,
) {
    /** Loops added to the builder. The domain may have more, where a loop passed through a node twice. */
    @get:JvmName("loopCount")
    public val loopCount: Int get() = roles.size

    /** The role given, or found out. */
    public fun role(loop: Int): LoopRole = roles[loop]

    /** Whether the loop was turned so that the domain lies on its left. */
    public fun isReversed(loop: Int): Boolean = reversed[loop]

    /** The smallest loop that contains this one, or -1. */
    public fun parentOf(loop: Int): Int = parents[loop]

    /** The loops that were turned, ascending. */
    public fun reversedLoops(): IntArray = reversed.indices.filter { reversed[it] }.toIntArray()
}
