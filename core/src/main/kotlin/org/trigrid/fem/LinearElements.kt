package org.trigrid.fem

import org.trigrid.mesh.TriMesh

/**
 * Areas and shape functions of the elements of a mesh taken as linear ones: on each, the shape function of a corner is 1
 * there, 0 at the other two, and linear between, so that its gradient is constant (Zienkiewicz & Taylor, *The Finite
 * Element Method*, vol. 1, section 4.2).
 *
 * Lengths are in the domain's unit, areas in its square, gradients per that unit. Immutable.
 *
 * @sample org.trigrid.samples.HeatInMachinePart.addConduction
 */
public class LinearElements private constructor(
    @get:JvmName("mesh") public val mesh: TriMesh,
    private val areas: DoubleArray,
    private val gradients: DoubleArray,
) {
    /** Area of an element. */
    public fun area(element: Int): Double = areas[element]

    /** Areas of all elements, size elementCount; a copy. */
    public fun areas(): DoubleArray = areas.copyOf()

    /** Derivative by x of the shape function of [corner] 0..2 of [element]. */
    public fun gradientX(element: Int, corner: Int): Double = gradients[6 * element + 2 * corner]

    /** Derivative by y of the shape function of [corner] 0..2 of [element]. */
    public fun gradientY(element: Int, corner: Int): Double = gradients[6 * element + 2 * corner + 1]

    /**
     * Gradients of all shape functions, six numbers an element: by x and by y for corner 0, then corners 1 and 2; a copy.
     * The stiffness of Laplace's operator is `area * (gradientX(i) * gradientX(j) + gradientY(i) * gradientY(j))`.
     */
    public fun gradients(): DoubleArray = gradients.copyOf()

    /**
     * The shape functions of an element at a place: the weights of its three corners, which add up to 1; below 0 beyond a
     * side.
     */
    public fun weights(element: Int, x: Double, y: Double): DoubleArray {
        val weights = DoubleArray(3)
        for (corner in 0..2) {
            // Measured from the next corner, where this function is 0, so that nothing is lost far from the origin.
            val from = mesh.nodeOf(element, (corner + 1) % 3)
            weights[corner] = gradientX(element, corner) * (x - mesh.x(from)) + gradientY(element, corner) * (y - mesh.y(from))
        }
        return weights
    }

    /**
     * Gradient of a field given at the nodes: by x and by y for each element, size 2 * elementCount.
     *
     * @param nodeValues size nodeCount; not modified.
     * @throws IllegalArgumentException if there is not one value for each node.
     */
    public fun gradientsOf(nodeValues: DoubleArray): DoubleArray {
        require(nodeValues.size == mesh.nodeCount) { "${mesh.nodeCount} nodes, but ${nodeValues.size} values" }
        val result = DoubleArray(2 * areas.size)
        for (element in areas.indices) {
            for (corner in 0..2) {
                val value = nodeValues[mesh.nodeOf(element, corner)]
                result[2 * element] += value * gradientX(element, corner)
                result[2 * element + 1] += value * gradientY(element, corner)
            }
        }
        return result
    }

    /**
     * The area that belongs to each node, a third of its elements' areas: the integral of its shape function, and so the load
     * of a source of 1, or the diagonal of the lumped mass matrix. Size nodeCount.
     */
    public fun nodeAreas(): DoubleArray {
        val result = DoubleArray(mesh.nodeCount)
        for (element in areas.indices) {
            for (corner in 0..2) result[mesh.nodeOf(element, corner)] += areas[element] / 3
        }
        return result
    }

    public companion object {
        /** @throws IllegalArgumentException if an element's area is not above 0. */
        @JvmStatic
        public fun of(mesh: TriMesh): LinearElements {
            val areas = DoubleArray(mesh.elementCount) { mesh.area(it) }
            val gradients = DoubleArray(6 * areas.size)
            for (element in areas.indices) {
                val twice = 2 * areas[element]
                require(twice > 0) { "element $element has area ${areas[element]}" }
                for (corner in 0..2) {
                    val next = mesh.nodeOf(element, (corner + 1) % 3)
                    val last = mesh.nodeOf(element, (corner + 2) % 3)
                    gradients[6 * element + 2 * corner] = (mesh.y(next) - mesh.y(last)) / twice
                    gradients[6 * element + 2 * corner + 1] = (mesh.x(last) - mesh.x(next)) / twice
                }
            }
            return LinearElements(mesh, areas, gradients)
        }
    }
}
