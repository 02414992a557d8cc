package org.trigrid.domain

/** Something in a valid domain that will cost element quality, and where. */
public class DomainWarning internal constructor(
    @get:JvmName("kind") public val kind: WarningKind,
    /** One line that says what is wrong, with node numbers and coordinates. */
    @get:JvmName("message") public val message: String,
    /** The place, in the domain's coordinates. */
    @get:JvmName("x") public val x: Double,
    @get:JvmName("y") public val y: Double,
    private val nodeArray: IntArray,
) {
    /** The nodes concerned, as numbered in the domain (0-based). A copy. */
    public fun nodes(): IntArray = nodeArray.copyOf()

    override fun toString(): String = "$kind: $message"
}
