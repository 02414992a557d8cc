package org.trigrid.spark

import org.apache.spark.TaskContext
import org.apache.spark.sql.Row
import org.apache.spark.sql.types.StructType
import org.trigrid.MeshGenerator
import org.trigrid.MeshResult
import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.numbering.Numbering

/** Makes rows of outlines and of their domains. */
internal class DomainMeshing(private val plan: MeshPlan, private val sink: MeshSink, private val schema: StructType) {
    /** The row of an outline that cannot be read. */
    fun unread(outline: Outline, error: Exception): Row = MeshRow(schema).also {
        putPlace(it, outline, -1, 0, null)
        FailureRows.put(it, error)
    }.toRow()

    /** The row of the domain with the number [index], a mesh or what is wrong with the domain. */
    fun mesh(outline: Outline, domains: List<OutlineDomain>, index: Int): Row {
        val given = domains[index]
        val row = MeshRow(schema)
        putPlace(row, outline, index, domains.size, given.name)
        val start = System.nanoTime()
        val mesh = try {
            val result = MeshGenerator.generate(given.domain, given.options, MONITOR)
            made(given, result).also { putFigures(row, result, it) }
        } catch (error: MeshingCancelledException) {
            TaskContext.get()?.killTaskIfInterrupted()
            throw error
        } catch (error: Exception) {
            FailureRows.put(row, error)
            return row.toRow()
        }
        sink.put(row, outline, index, domains.size, mesh)
        row.set(MeshColumns.SECONDS, (System.nanoTime() - start) / 1e9)
        return row.toRow()
    }

    private fun putPlace(row: MeshRow, outline: Outline, index: Int, count: Int, name: String?) {
        row.set(MeshColumns.ID, outline.id)
        row.set(MeshColumns.DOMAIN, index)
        row.set(MeshColumns.DOMAINS, count)
        row.set(MeshColumns.NAME, name)
    }

    private fun made(given: OutlineDomain, result: MeshResult): MadeMesh {
        if (plan.order == 1) return MadeMesh(result.mesh, null)
        return MadeMesh(result.mesh, Numbering.renumber(QuadraticMesh.of(result.mesh, given.middles()), given.options.numbering))
    }

    private fun putFigures(row: MeshRow, result: MeshResult, mesh: MadeMesh) {
        val report = result.report
        val numbering = mesh.quadratic?.let { Numbering.metrics(it) } ?: report.numberingAfter
        row.set(MeshColumns.NODES, mesh.quadratic?.nodeCount ?: report.nodeCount)
        row.set(MeshColumns.ELEMENTS, report.elementCount)
        row.set(MeshColumns.BOUNDARY_NODES, report.boundaryNodeCount)
        row.set(MeshColumns.LOOPS, report.loopCount)
        row.setFigure(MeshColumns.EXPECTED_ELEMENTS, report.expectedElements)
        row.set(MeshColumns.FALLBACKS, report.fallbacks)
        row.setFigure(MeshColumns.MIN_QUALITY, report.quality.minQuality)
        row.setFigure(MeshColumns.MEAN_QUALITY, report.quality.meanQuality)
        row.setFigure(MeshColumns.MIN_ANGLE, report.quality.minAngle)
        row.setFigure(MeshColumns.MEAN_MIN_ANGLE, report.quality.meanMinAngle)
        row.setFigure(MeshColumns.MAX_ANGLE, report.quality.maxAngle)
        row.setFigure(MeshColumns.DEGREE_6, report.quality.degree6)
        row.set(MeshColumns.BANDWIDTH, numbering.bandwidth)
        row.set(MeshColumns.PROFILE, numbering.profile)
        row.set(MeshColumns.STRAIGHTENED_EDGES, mesh.quadratic?.straightenedEdgeCount)
    }

    companion object {
        /** Lets Spark end a task. */
        val MONITOR: ProgressMonitor = ProgressMonitor { _, _ -> TaskContext.get()?.isInterrupted() != true }
    }
}
