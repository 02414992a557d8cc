package org.trigrid.interop

import org.ejml.ops.DConvertMatrixStruct
import org.ejml.sparse.csc.CommonOps_DSCC
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.trigrid.fem.SparsityPattern
import org.trigrid.mesh.GridMeshes

class EjmlMatricesTest {
    @Test
    fun `entries are the pairs of nodes that share an element`() {
        val mesh = GridMeshes.shaken(6, 5, 1L) { i, j -> i == 2 && j == 2 }.mesh
        val matrix = EjmlMatrices.structure(mesh)
        assertTrue(CommonOps_DSCC.checkStructure(matrix))
        assertEquals(mesh.nodeCount + 2 * mesh.edgeCount, matrix.nonZeroLength)
        val dense = DConvertMatrixStruct.convert(matrix, null as org.ejml.data.DMatrixRMaj?)
        for (t in 0 until mesh.elementCount) for (i in 0..2) for (j in 0..2) {
            assertEquals(1.0, dense.get(mesh.nodeOf(t, i), mesh.nodeOf(t, j)))
        }
        assertEquals(matrix.nonZeroLength.toDouble(), dense.data.sum())
    }

    @Test
    fun `assembled values stand where the pattern says`() {
        val mesh = GridMeshes.shaken(4, 3, 2L) { _, _ -> false }.mesh
        val pattern = SparsityPattern.of(mesh, 2)
        val matrix = EjmlMatrices.matrix(pattern, DoubleArray(pattern.entryCount) { it + 1.0 })
        assertTrue(CommonOps_DSCC.checkStructure(matrix))
        assertEquals(2 * mesh.nodeCount, matrix.numRows)
        for (row in 0 until pattern.rowCount) for (entry in pattern.rowStart(row) until pattern.rowStart(row + 1)) {
            assertEquals(entry + 1.0, matrix.get(pattern.column(entry), row))
        }
        assertThrows<IllegalArgumentException> { EjmlMatrices.matrix(pattern, DoubleArray(3)) }
    }
}
