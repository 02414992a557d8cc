package org.trigrid.domain

import java.io.Serializable

/**
 * A part of a domain with a name and a material of its own: a physical surface of Gmsh, a block label of FEMM, a region of
 * Triangle. Immutable: the `with` functions return changed copies.
 */
public class Region private constructor(
    @get:JvmName("name") public val name: String,
    /** Number of the material in mesh files, above 0; 0 where the writer is to choose a free one. */
    @get:JvmName("material") public val material: Int,
    /** Largest size asked of an edge inside the region, in the domain's unit; infinity for none. */
    @get:JvmName("maxSize") public val maxSize: Double,
) : Serializable {
    /** With another name. */
    public fun withName(value: String): Region = Region(value, material, maxSize)

    /** @throws IllegalArgumentException if [value] is below 0. */
    public fun withMaterial(value: Int): Region {
        require(value >= 0) { "the material number of region \"$name\" must not be below 0, and is $value" }
        return Region(name, value, maxSize)
    }

    /** @throws IllegalArgumentException unless [value] is > 0; infinity is for none. */
    public fun withMaxSize(value: Double): Region {
        require(value > 0) { "the largest size of region \"$name\" must be above 0, not $value" }
        return Region(name, material, value)
    }

    override fun equals(other: Any?): Boolean =
        other is Region && name == other.name && material == other.material && maxSize == other.maxSize

    override fun hashCode(): Int = name.hashCode()

    override fun toString(): String = name

    public companion object {
        private const val serialVersionUID = 1L

        /** The name of the region where none is given, `domain`. */
        public const val DEFAULT_NAME: String = "domain"

        /** A region without a material number and without a largest size. */
        @JvmStatic
        public fun of(name: String): Region = Region(name, 0, Double.POSITIVE_INFINITY)
    }
}
