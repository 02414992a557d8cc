package org.trigrid.picture

import org.trigrid.mesh.MeshTopology
import org.trigrid.mesh.NodeKind
import org.trigrid.mesh.TriMesh
import org.trigrid.quality.TriangleQuality

/** Draws a mesh; line widths and letters follow the length of its edges on the sheet. */
internal class MeshPicture(private val mesh: TriMesh, private val options: PictureOptions) {
    private val view = View(mesh.xy, options.size.toDouble(), MARGIN)
    private val edgeNodes = MeshTopology.edges(mesh.elements, mesh.neighbours)

    /** Median length of the edges on the sheet. */
    private val edgeLength = medianLength()
    private val lineWidth = (0.035 * edgeLength).coerceIn(0.3, 1.1)
    private val legend = if (options.quality && mesh.elementCount > 0) QualityLegend(mesh) else null
    private val regions = if (options.quality || mesh.regions.size == 1) null else RegionLegend(mesh.regions, options)

    fun draw(): Scene {
        val drawn = view.width + 2 * MARGIN
        val legendWidth = if (legend != null) QualityLegend.WIDTH else regions?.width ?: 0.0
        val legendHeight = if (legend != null) QualityLegend.HEIGHT else regions?.height ?: 0.0
        val scene = Scene(drawn + legendWidth, maxOf(view.height + 2 * MARGIN, legendHeight + 2 * MARGIN))
        drawElements(scene)
        if (!options.quality || edgeLength > LEAST_EDGE) drawInnerEdges(scene)
        drawTagged(scene, mesh.boundaryEdgeCount, mesh.taggedEdgeCount, Palette.EMBEDDED)
        drawTagged(scene, 0, mesh.boundaryEdgeCount, Palette.BOUNDARY)
        val donuts = if (options.nodes ?: options.nodeNumbers) drawNodes(scene) else DoubleArray(0)
        drawNumbers(scene, donuts)
        drawPoints(scene)
        legend?.draw(scene, drawn, MARGIN)
        regions?.draw(scene, drawn, MARGIN)
        return scene
    }

    private fun medianLength(): Double {
        val lengths = DoubleArray(edgeNodes.size / 2) {
            val a = edgeNodes[2 * it]
            val b = edgeNodes[2 * it + 1]
            Math.hypot(mesh.x(b) - mesh.x(a), mesh.y(b) - mesh.y(a)) * view.scale
        }
        if (lengths.isEmpty()) return options.size.toDouble()
        lengths.sort()
        return lengths[lengths.size / 2]
    }

    private fun drawElements(scene: Scene) {
        if (!options.quality) {
            for (r in mesh.regions.indices) scene.add(Triangles(regions?.colourOf(r) ?: Palette.MATERIAL, corners { mesh.regionOf(it) == r }))
            return
        }
        val classes = ByteArray(mesh.elementCount) { Palette.qualityClass(TriangleQuality.of(mesh, it)).toByte() }
        for (c in Palette.qualityColours.indices) {
            scene.add(Triangles(Palette.qualityColours[c], corners { classes[it].toInt() == c }))
        }
    }

    private inline fun corners(wanted: (Int) -> Boolean): DoubleArray {
        var count = 0
        for (t in 0 until mesh.elementCount) if (wanted(t)) count++
        val result = DoubleArray(6 * count)
        var at = 0
        for (t in 0 until mesh.elementCount) {
            if (!wanted(t)) continue
            for (k in 0..2) {
                result[at++] = view.x(mesh.x(mesh.nodeOf(t, k)))
                result[at++] = view.y(mesh.y(mesh.nodeOf(t, k)))
            }
        }
        return result
    }

    private fun drawInnerEdges(scene: Scene) {
        // On the coloured elements lines are there to part them, not to be seen.
        val colour = if (options.quality) Palette.PAPER else Palette.MESH_LINE
        scene.add(Strokes(colour, if (options.quality) 0.7 * lineWidth else lineWidth, strokes(edgeNodes, 0, edgeNodes.size / 2)))
    }

    private fun drawTagged(scene: Scene, from: Int, to: Int, colour: Int) {
        scene.add(Strokes(colour, maxOf(0.9, 1.9 * lineWidth), strokes(mesh.edges, from, to)))
    }

    private fun strokes(pairs: IntArray, from: Int, to: Int): DoubleArray {
        val result = DoubleArray(4 * (to - from))
        var at = 0
        for (i in 2 * from until 2 * to) {
            result[at++] = view.x(mesh.x(pairs[i]))
            result[at++] = view.y(mesh.y(pairs[i]))
        }
        return result
    }

    private fun drawPoints(scene: Scene) {
        val xyr = DoubleArray(3 * mesh.pointCount) {
            val node = mesh.pointNode(it / 3)
            if (it % 3 == 0) view.x(mesh.x(node)) else if (it % 3 == 1) view.y(mesh.y(node)) else donutRadius(edgeLength)
        }
        if (xyr.isNotEmpty()) scene.add(Donuts(Palette.EMBEDDED, xyr))
    }

    private fun drawNodes(scene: Scene): DoubleArray {
        val nearest = DoubleArray(mesh.nodeCount) { Double.POSITIVE_INFINITY }
        for (i in edgeNodes.indices step 2) {
            val a = edgeNodes[i]
            val b = edgeNodes[i + 1]
            val length = Math.hypot(mesh.x(b) - mesh.x(a), mesh.y(b) - mesh.y(a)) * view.scale
            nearest[a] = minOf(nearest[a], length)
            nearest[b] = minOf(nearest[b], length)
        }
        val shown = (0 until mesh.nodeCount).filter { options.nodeNumbers || mesh.kindOf(it) != NodeKind.INTERIOR }
        val xyr = DoubleArray(3 * shown.size)
        shown.forEachIndexed { i, node ->
            xyr[3 * i] = view.x(mesh.x(node))
            xyr[3 * i + 1] = view.y(mesh.y(node))
            xyr[3 * i + 2] = donutRadius(nearest[node])
        }
        scene.add(Donuts(Palette.NODE, xyr))
        return xyr
    }

    private fun drawNumbers(scene: Scene, donuts: DoubleArray) {
        if (!options.nodeNumbers && !options.elementNumbers) return
        val size = (0.2 * edgeLength).coerceIn(6.0, 15.0)
        if (options.elementNumbers) {
            val elements = ArrayList<Label>()
            val elementSize = 0.85 * size
            for (t in 0 until mesh.elementCount) elementLabel(t, elementSize)?.let { elements.add(it) }
            scene.add(Labels(Palette.MUTED, elementSize, false, elements))
        }
        if (options.nodeNumbers) {
            val layout = LabelLayout(scene.width, scene.height, size)
            if (options.elementNumbers) blockElements(layout, 0.85 * size)
            for (e in 0 until mesh.boundaryEdgeCount) {
                val a = mesh.edgeStart(e)
                val b = mesh.edgeEnd(e)
                layout.blockLine(view.x(mesh.x(a)), view.y(mesh.y(a)), view.x(mesh.x(b)), view.y(mesh.y(b)))
            }
            val labels = NodeLabels.place(layout, size, donuts, options.firstNumber)
            scene.add(Labels(Palette.INK, size, true, labels, halo = true))
        }
    }

    private fun elementLabel(t: Int, size: Double): Label? {
        val a = mesh.nodeOf(t, 0)
        val b = mesh.nodeOf(t, 1)
        val c = mesh.nodeOf(t, 2)
        val ab = Math.hypot(mesh.x(b) - mesh.x(a), mesh.y(b) - mesh.y(a))
        val bc = Math.hypot(mesh.x(c) - mesh.x(b), mesh.y(c) - mesh.y(b))
        val ca = Math.hypot(mesh.x(a) - mesh.x(c), mesh.y(a) - mesh.y(c))
        val text = (t + options.firstNumber).toString()
        // The text must fit into the circle inside the element.
        val radius = 2 * mesh.area(t) / (ab + bc + ca) * view.scale
        val half = 0.5 * Math.hypot(LabelLayout.widthOf(text, size), LabelLayout.DIGIT_HEIGHT * size)
        if (half > radius) return null
        val x = (bc * mesh.x(a) + ca * mesh.x(b) + ab * mesh.x(c)) / (ab + bc + ca)
        val y = (bc * mesh.y(a) + ca * mesh.y(b) + ab * mesh.y(c)) / (ab + bc + ca)
        return Label(view.x(x), view.y(y) + 0.5 * LabelLayout.DIGIT_HEIGHT * size, Anchor.MIDDLE, text)
    }

    private fun blockElements(layout: LabelLayout, size: Double) {
        for (t in 0 until mesh.elementCount) {
            val label = elementLabel(t, size) ?: continue
            val half = 0.5 * LabelLayout.widthOf(label.text, size)
            layout.block(label.x - half, label.y - LabelLayout.DIGIT_HEIGHT * size, label.x + half, label.y)
        }
    }

    private companion object {
        const val MARGIN = 30.0

        /** Below this many units lines would only dull the colours. */
        const val LEAST_EDGE = 4.0
    }
}

/** Radius of a node whose nearest neighbour is [distance] away on the sheet. */
internal fun donutRadius(distance: Double): Double = (0.16 * distance).coerceIn(0.5, 4.5)
