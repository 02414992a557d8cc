package org.trigrid.improve

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.Stage
import org.trigrid.geometry.IntList
import org.trigrid.mesh.MeshDivision
import org.trigrid.mesh.MeshPiece
import org.trigrid.mesh.MutableMesh
import org.trigrid.parallel.Crew

/**
 * Improves a large mesh in parts, each by itself, and then the band around the seams between them. How it is divided depends
 * on the mesh alone, so the result is the same for any number of threads; a part fits the processor's caches besides.
 *
 * The mesh's elements must come in an order in which those near each other are near in space: a part is a run of them.
 */
internal class DividedImprovement(
    private val mesh: MutableMesh,
    private val tolerance: Double,
    private val crew: Crew,
    private val report: (Double) -> Unit,
) {
    private val checkpoint = checkpoint(report)

    /** Improves the mesh in [count] parts and compacts it. */
    fun run(count: Int) {
        val size = mesh.elementCount.toLong()
        val partOf = IntArray(mesh.elementCount) { (it * count / size).toInt() }
        checkpoint.ask()
        val division = MeshDivision(mesh, partOf, count, checkpoint)
        val parts = arrayOfNulls<MeshPiece>(count)
        crew.run(count, { report(PARTS_SHARE * it) }) { index, progress ->
            val part = division.part(index, checkpoint(progress))
            MeshImprover(part.mesh, tolerance, progress).run()
            parts[index] = part
        }
        mendSeams(division.join(parts.requireNoNulls().asList(), checkpoint))
        report(1.0)
    }

    private fun mendSeams(seams: IntArray) {
        val isSeam = BooleanArray(mesh.nodeCount)
        for (node in seams) isSeam[node] = true
        val partOf = band(isSeam)
        val division = MeshDivision(mesh, partOf, 2, checkpoint)
        val part = division.part(BAND, checkpoint)
        val changed = IntList()
        part.wholeNodes.forEachIndexed { local, node -> if (isSeam[node]) changed.add(local) }
        MeshImprover(part.mesh, tolerance) { report(PARTS_SHARE + (1 - PARTS_SHARE) * it) }.run(changed.toArray())
        division.replace(BAND, part, checkpoint)
        mesh.compact { checkpoint.pass() }
    }

    /** Per element whether it lies within [WIDTH] elements of a seam: [BAND] or 0. */
    private fun band(isSeam: BooleanArray): IntArray {
        val partOf = IntArray(mesh.elementCount)
        val found = IntList()
        for (t in 0 until mesh.elementCount) {
            checkpoint.pass()
            if (!isSeam[mesh.elements[3 * t]] && !isSeam[mesh.elements[3 * t + 1]] && !isSeam[mesh.elements[3 * t + 2]]) continue
            partOf[t] = BAND
            found.add(t)
        }
        var from = 0
        for (ring in 0 until WIDTH) {
            val to = found.size
            for (i in from until to) {
                checkpoint.pass()
                for (h in 3 * found[i]..3 * found[i] + 2) {
                    val twin = mesh.twins[h]
                    if (twin < 0 || partOf[twin / 3] == BAND) continue
                    partOf[twin / 3] = BAND
                    found.add(twin / 3)
                }
            }
            from = to
        }
        return partOf
    }

    private fun checkpoint(progress: (Double) -> Unit) = Checkpoint(
        ProgressMonitor { _, _ ->
            progress(0.0)
            true
        },
        Stage.IMPROVE,
    )

    private companion object {
        const val BAND = 1

        /** Elements from the seam to the edge of the band, across edges. */
        const val WIDTH = 5

        /** Share of the parts in the work. */
        const val PARTS_SHARE = 0.92
    }
}
