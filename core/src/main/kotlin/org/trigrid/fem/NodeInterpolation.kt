package org.trigrid.fem

import org.trigrid.mesh.TriMesh

/**
 * Values anywhere in a mesh of values at its nodes, linear in each element; for probes, for cuts, and to carry a field over to
 * another mesh. Immutable, and free to be asked by several threads at once.
 */
public class NodeInterpolation private constructor(private val elements: LinearElements, private val locator: PointLocator) {
    private val mesh: TriMesh get() = locator.mesh

    /**
     * The value at ([x], [y]), NaN outside of the mesh.
     *
     * @param nodeValues size nodeCount; not modified.
     * @throws IllegalArgumentException if there is not one value for each node.
     */
    public fun valueAt(nodeValues: DoubleArray, x: Double, y: Double): Double {
        requireFull(nodeValues)
        val element = locator.elementAt(x, y)
        return if (element < 0) Double.NaN else valueIn(element, nodeValues, x, y)
    }

    /**
     * The value at the place of the mesh that is nearest to ([x], [y]); the same as [valueAt] inside. Meshes of a curved
     * boundary with different spacing do not quite cover each other: this is how to carry a field from one to the other.
     *
     * @param nodeValues size nodeCount; not modified.
     * @throws IllegalArgumentException if there is not one value for each node, or a coordinate is not a finite number.
     */
    public fun nearestValueAt(nodeValues: DoubleArray, x: Double, y: Double): Double {
        requireFull(nodeValues)
        val place = locator.nearest(x, y)
        return valueIn(place.element, nodeValues, place.x, place.y)
    }

    /**
     * The field at the nodes of another mesh, by [nearestValueAt].
     *
     * @param nodeValues size nodeCount of this mesh; not modified.
     * @throws IllegalArgumentException if there is not one value for each node.
     */
    public fun carriedTo(other: TriMesh, nodeValues: DoubleArray): DoubleArray =
        DoubleArray(other.nodeCount) { nearestValueAt(nodeValues, other.x(it), other.y(it)) }

    private fun requireFull(nodeValues: DoubleArray) =
        require(nodeValues.size == mesh.nodeCount) { "${mesh.nodeCount} nodes, but ${nodeValues.size} values" }

    /** Weights are cut off at 0, so that rounding at the rim cannot leave the range of the three values. */
    private fun valueIn(element: Int, nodeValues: DoubleArray, x: Double, y: Double): Double {
        val weights = elements.weights(element, x, y)
        var sum = 0.0
        var value = 0.0
        for (corner in 0..2) {
            val weight = Math.max(0.0, weights[corner])
            sum += weight
            value += weight * nodeValues[mesh.nodeOf(element, corner)]
        }
        return value / sum
    }

    public companion object {
        /** @throws IllegalArgumentException if an element's area is not above 0. */
        @JvmStatic
        public fun of(mesh: TriMesh): NodeInterpolation = NodeInterpolation(LinearElements.of(mesh), PointLocator.of(mesh))

        /** As the other, sharing a locator that is already there. */
        @JvmStatic
        public fun of(locator: PointLocator): NodeInterpolation = NodeInterpolation(LinearElements.of(locator.mesh), locator)
    }
}
