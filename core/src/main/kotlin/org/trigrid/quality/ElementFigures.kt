package org.trigrid.quality

import org.trigrid.mesh.TriMesh

/** Quality and angles of each element of a mesh, for pictures and searches; [QualityReport] sums them up. Immutable. */
public class ElementFigures private constructor(private val measures: ElementMeasures) {
    @get:JvmName("elementCount")
    public val elementCount: Int get() = measures.elementCount

    /** Shape quality of an element as [QualityReport] defines it, dimensionless, 1 for an equilateral triangle. */
    public fun quality(element: Int): Double = measures.qualities[element]

    /** Smallest angle of an element, in degrees. */
    public fun minAngle(element: Int): Double = measures.minAngles[element]

    /** Largest angle of an element, in degrees. */
    public fun maxAngle(element: Int): Double = measures.maxAngles[element]

    public companion object {
        /** The figures of all elements of [mesh]. */
        @JvmStatic
        public fun of(mesh: TriMesh): ElementFigures = ElementFigures(ElementMeasures(mesh))
    }
}
