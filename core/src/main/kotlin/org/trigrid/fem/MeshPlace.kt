package org.trigrid.fem

/** A place in a mesh, and how far it is from the place asked for. */
public class MeshPlace internal constructor(
    /** The element that holds the place. */
    @get:JvmName("element") public val element: Int,
    /** In the domain's unit. */
    @get:JvmName("x") public val x: Double,
    /** In the domain's unit. */
    @get:JvmName("y") public val y: Double,
    /** From the place asked for, in the domain's unit; 0 inside of the mesh. */
    @get:JvmName("distance") public val distance: Double,
) {
    override fun toString(): String = "($x, $y) in element $element"
}
