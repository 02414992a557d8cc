package org.trigrid.interop

import org.ejml.data.DMatrixSparseCSC
import org.trigrid.mesh.TriMesh
import org.trigrid.numbering.NodeGraph
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
        val graph = NodeGraph.of(mesh)
        val nodes = mesh.nodeCount
        val entries = graph.targets.size + nodes
        val matrix = DMatrixSparseCSC(nodes, nodes, entries)
        var at = 0
        for (node in 0 until nodes) {
            matrix.col_idx[node] = at
            val from = at
            matrix.nz_rows[at++] = node
            for (k in graph.starts[node] until graph.starts[node + 1]) matrix.nz_rows[at++] = graph.targets[k]
            Arrays.sort(matrix.nz_rows, from, at)
        }
        matrix.col_idx[nodes] = at
        matrix.nz_length = at
        matrix.indicesSorted = true
        Arrays.fill(matrix.nz_values, 0, at, 1.0)
        return matrix
    }
}
