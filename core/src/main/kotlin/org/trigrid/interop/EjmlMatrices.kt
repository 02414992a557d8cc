package org.trigrid.interop

import org.ejml.data.DMatrixSparseCSC
import org.trigrid.fem.SparsityPattern
import org.trigrid.mesh.TriMesh
import java.util.Arrays

/** Meshes as EJML matrices. */
public object EjmlMatrices {
    /**
     * The structure of the coefficient matrix: a 1 on the diagonal and for each pair of nodes of an element, row
     * indices ascending in each column. Symmetric, nodeCount x nodeCount. Fill its values for an assembly of linear
     * elements with one unknown a node.
     */
    @JvmStatic
    public fun structure(mesh: TriMesh): DMatrixSparseCSC {
        val pattern = SparsityPattern.of(mesh)
        val ones = DoubleArray(pattern.entryCount)
        Arrays.fill(ones, 1.0)
        return matrix(pattern, ones)
    }

    /**
     * The matrix of a pattern and the values of its entries: what a program has assembled, ready for EJML's solvers.
     * Value k stands in EJML's column `r` and row `pattern.column(k)`, where `r` is the pattern's row of entry k: this is the
     * matrix itself if it is symmetric, as those of finite elements mostly are, and else its transpose.
     *
     * @sample org.trigrid.samples.HeatInMachinePart.solve
     * @param values size entryCount; kept in the matrix, not copied.
     * @throws IllegalArgumentException if there is not one value for each entry.
     */
    @JvmStatic
    public fun matrix(pattern: SparsityPattern, values: DoubleArray): DMatrixSparseCSC {
        require(values.size == pattern.entryCount) { "${pattern.entryCount} entries, but ${values.size} values" }
        val matrix = DMatrixSparseCSC(pattern.rowCount, pattern.rowCount, 0)
        matrix.col_idx = pattern.rowStarts()
        matrix.nz_rows = pattern.columns()
        matrix.nz_values = values
        matrix.nz_length = values.size
        matrix.indicesSorted = true
        return matrix
    }
}
