package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.mesh.MeshRenumbering
import org.trigrid.mesh.TriMesh

/** New numbers for the nodes of a mesh: each number from 0 to size - 1 exactly once. Immutable. */
public class Permutation private constructor(private val newNumbers: IntArray, private val oldNumbers: IntArray) {
    @get:JvmName("size")
    public val size: Int get() = newNumbers.size

    /** The new number of the node numbered [old] before. */
    public fun newNumber(old: Int): Int = newNumbers[old]

    /** The number that the node numbered [new] had before. */
    public fun oldNumber(new: Int): Int = oldNumbers[new]

    /** New number of each node, by old number; a copy. */
    public fun newNumbers(): IntArray = newNumbers.copyOf()

    /** Old number of each node, by new number; a copy. */
    public fun oldNumbers(): IntArray = oldNumbers.copyOf()

    /** The permutation that undoes this one. */
    public fun inverse(): Permutation = Permutation(oldNumbers, newNumbers)

    /** The same order from its end: number i becomes size - 1 - i. The bandwidth stays, the profile may change. */
    public fun reversed(): Permutation = ofOrder(IntArray(size) { oldNumbers[size - 1 - it] })

    /** [mesh] with its nodes renumbered. */
    public fun apply(mesh: TriMesh): TriMesh = apply(mesh, Checkpoint.unheard())

    internal fun apply(mesh: TriMesh, checkpoint: Checkpoint): TriMesh = MeshRenumbering.apply(mesh, newNumbers, checkpoint)

    internal fun newNumbersShared(): IntArray = newNumbers

    public companion object {
        /** Every node keeps its number. */
        @JvmStatic
        public fun identity(size: Int): Permutation {
            val same = IntArray(size) { it }
            return Permutation(same, same)
        }

        /**
         * @param newNumbers new number of each node, by old number; not modified.
         * @throws IllegalArgumentException if a number is out of range or given twice.
         */
        @JvmStatic
        public fun ofNewNumbers(newNumbers: IntArray): Permutation =
            Permutation(newNumbers.copyOf(), inverseOf(newNumbers))

        /**
         * @param order old number of each node, by new number: the nodes in their new order; not modified.
         * @throws IllegalArgumentException if a number is out of range or given twice.
         */
        @JvmStatic
        public fun ofOrder(order: IntArray): Permutation = Permutation(inverseOf(order), order.copyOf())

        private fun inverseOf(numbers: IntArray): IntArray {
            val inverse = IntArray(numbers.size) { -1 }
            for (i in numbers.indices) {
                val n = numbers[i]
                require(n in numbers.indices && inverse[n] < 0) { "number $n at place $i is out of range or given twice" }
                inverse[n] = i
            }
            return inverse
        }
    }
}
