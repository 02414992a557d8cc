package org.trigrid.picture

import org.trigrid.mesh.MeshTopology
import org.trigrid.mesh.TriMesh
import org.trigrid.numbering.NumberingMetrics
import java.util.BitSet

/** Draws where the coefficient matrix has entries, with the band shaded and its figures below, as Figs. 7(c, d), 9(f). */
internal object MatrixPicture {
    private const val SIDE = 480.0
    private const val MARGIN = 30.0
    private const val GAP = 48.0
    private const val TITLE = 17.0
    private const val TEXT = 14.0

    /** Entries of larger matrices share cells. */
    private const val MOST_CELLS = 480

    fun draw(panels: List<Pair<String, TriMesh>>): Scene {
        val titled = panels.any { it.first.isNotEmpty() }
        val top = MARGIN + if (titled) 1.7 * TITLE else 0.0
        val width = 2 * MARGIN + panels.size * SIDE + (panels.size - 1) * GAP
        val scene = Scene(width, top + SIDE + 3.4 * TEXT + MARGIN)
        panels.forEachIndexed { i, (title, mesh) ->
            val left = MARGIN + i * (SIDE + GAP)
            if (title.isNotEmpty()) {
                scene.add(Labels(Palette.INK, TITLE, true, listOf(Label(left, MARGIN + TITLE, Anchor.START, title))))
            }
            drawPanel(scene, mesh, left, top)
        }
        return scene
    }

    private fun drawPanel(scene: Scene, mesh: TriMesh, left: Double, top: Double) {
        val metrics = NumberingMetrics.of(mesh)
        drawBand(scene, metrics, left, top)
        if (mesh.nodeCount > 0) scene.add(Boxes(Palette.ENTRY, entries(mesh, left, top)))
        val frame = doubleArrayOf(
            left, top, left + SIDE, top, left + SIDE, top, left + SIDE, top + SIDE,
            left + SIDE, top + SIDE, left, top + SIDE, left, top + SIDE, left, top,
        )
        scene.add(Strokes(Palette.FRAME, 1.0, frame))
        val first = top + SIDE + 1.9 * TEXT
        val figures = "bandwidth ${QualityLegend.grouped(metrics.bandwidth.toLong())}    profile ${QualityLegend.grouped(metrics.profile)}"
        scene.add(Labels(Palette.INK, TEXT, true, listOf(Label(left, first, Anchor.START, figures))))
        val counts = "${QualityLegend.grouped(metrics.nodeCount.toLong())} rows, " +
            "${QualityLegend.grouped(metrics.nodeCount + 2L * mesh.edgeCount)} entries"
        scene.add(Labels(Palette.MUTED, TEXT, false, listOf(Label(left, first + 1.5 * TEXT, Anchor.START, counts))))
    }

    private fun drawBand(scene: Scene, metrics: NumberingMetrics, left: Double, top: Double) {
        if (metrics.nodeCount == 0) return
        val right = left + SIDE
        val bottom = top + SIDE
        val band = SIDE * minOf(1.0, (metrics.halfBandwidth + 1.0) / metrics.nodeCount)
        val walk = doubleArrayOf(
            left, top, left + band, top, right, bottom - band, right, bottom, right - band, bottom, left, top + band,
        )
        scene.add(Area(Palette.BAND, listOf(walk)))
    }

    /** A box for each run of full cells in a row; single entries of small matrices keep a little space between them. */
    private fun entries(mesh: TriMesh, left: Double, top: Double): DoubleArray {
        val nodes = mesh.nodeCount
        val cells = minOf(nodes, MOST_CELLS)
        val full = BitSet(cells * cells)
        for (n in 0 until nodes) full.set(cell(n, nodes, cells) * (cells + 1))
        val edges = MeshTopology.edges(mesh.elements, mesh.neighbours)
        for (i in edges.indices step 2) {
            val a = cell(edges[i], nodes, cells)
            val b = cell(edges[i + 1], nodes, cells)
            full.set(a * cells + b)
            full.set(b * cells + a)
        }
        val size = SIDE / cells
        val inset = if (size > 4) 0.1 * size else 0.0
        val boxes = ArrayList<Double>()
        for (row in 0 until cells) {
            var from = full.nextSetBit(row * cells)
            while (from in row * cells until (row + 1) * cells) {
                val to = if (inset > 0) from + 1 else minOf(full.nextClearBit(from), (row + 1) * cells)
                boxes.add(left + (from - row * cells) * size + inset)
                boxes.add(top + row * size + inset)
                boxes.add((to - from) * size - 2 * inset)
                boxes.add(size - 2 * inset)
                from = full.nextSetBit(to)
            }
        }
        return boxes.toDoubleArray()
    }

    private fun cell(node: Int, nodes: Int, cells: Int): Int = (node.toLong() * cells / nodes).toInt()
}
