package org.trigrid.picture

import org.trigrid.domain.Domain
import org.trigrid.domain.parts

/** Draws a domain: its material, its segments coloured by group, its nodes as small donuts. */
internal class DomainPicture(private val domain: Domain, private val options: PictureOptions) {
    private val view = View(domain.xy, options.size.toDouble(), MARGIN)
    private val regions = if (domain.regions.size == 1) null else RegionLegend(domain.regions, options)
    private val usedTags = domain.tags.indices.filter { it in domain.segmentTags }

    fun draw(): Scene {
        val drawn = view.width + 2 * MARGIN
        val showTags = usedTags.size > 1
        val legendRows = minOf(usedTags.size, MAX_ROWS)
        val tagsHeight = if (showTags) legendRows * ROW else 0.0
        val regionsTop = if (showTags) MARGIN + tagsHeight + ROW / 2 else MARGIN
        val legendHeight = if (regions == null) tagsHeight else regionsTop - MARGIN + regions.height
        val height = maxOf(view.height + 2 * MARGIN, if (legendHeight > 0) legendHeight + 2 * MARGIN else 0.0)
        val scene = Scene(drawn + maxOf(if (showTags) legendWidth() else 0.0, regions?.width ?: 0.0), height)
        drawMaterial(scene)
        drawSegments(scene, showTags)
        val donuts = donuts()
        if (options.nodes ?: true) scene.add(Donuts(Palette.NODE, donuts))
        if (options.nodeNumbers) {
            val size = (0.6 * medianSegment()).coerceIn(6.0, 15.0)
            val layout = LabelLayout(scene.width, scene.height, size)
            for (s in 0 until domain.segmentCount) {
                if (!length(s).isFinite()) continue
                layout.blockLine(x(domain.segmentStart(s)), y(domain.segmentStart(s)), x(domain.segmentEnd(s)), y(domain.segmentEnd(s)))
            }
            scene.add(Labels(Palette.INK, size, false, NodeLabels.place(layout, size, donuts, options.firstNumber)))
        }
        if (showTags) drawLegend(scene, drawn)
        regions?.draw(scene, drawn, regionsTop)
        return scene
    }

    private fun drawMaterial(scene: Scene) {
        if (regions == null) {
            scene.add(Area(Palette.MATERIAL, walks()))
            return
        }
        for ((region, parts) in domain.parts().groupBy { it.region }.toSortedMap()) {
            val walks = parts.flatMap { it.boundaries }.map { nodes ->
                DoubleArray(2 * nodes.size) { if (it % 2 == 0) x(nodes[it / 2]) else y(nodes[it / 2]) }
            }
            scene.add(Area(regions.colourOf(region), walks))
        }
    }

    private fun drawSegments(scene: Scene, showTags: Boolean) {
        val width = (0.12 * medianSegment()).coerceIn(0.8, 2.2)
        for (tag in usedTags) {
            for (embedded in listOf(false, true)) {
                val chosen = (0 until domain.segmentCount).filter {
                    domain.segmentTag(it) == tag && domain.isEmbedded(it) == embedded && length(it).isFinite()
                }
                val xy = DoubleArray(4 * chosen.size)
                chosen.forEachIndexed { i, s ->
                    xy[4 * i] = x(domain.segmentStart(s))
                    xy[4 * i + 1] = y(domain.segmentStart(s))
                    xy[4 * i + 2] = x(domain.segmentEnd(s))
                    xy[4 * i + 3] = y(domain.segmentEnd(s))
                }
                val colour = if (showTags) colourOf(tag) else if (embedded) Palette.EMBEDDED else Palette.BOUNDARY
                scene.add(Strokes(colour, width, xy))
            }
        }
    }

    private fun colourOf(tag: Int): Int =
        options.groupColours[domain.tags[tag]] ?: Palette.groups[usedTags.indexOf(tag) % Palette.groups.size]

    /** Closed walks along the segments; which way they go on where several leave a node does not change the area. */
    private fun walks(): List<DoubleArray> {
        val first = IntArray(domain.nodeCount) { -1 }
        val next = IntArray(domain.segmentCount)
        for (s in domain.segmentCount - 1 downTo 0) {
            if (domain.isEmbedded(s)) continue
            next[s] = first[domain.segmentStart(s)]
            first[domain.segmentStart(s)] = s
        }
        val walks = ArrayList<DoubleArray>()
        for (start in 0 until domain.nodeCount) {
            while (first[start] >= 0) {
                val walk = ArrayList<Double>()
                var node = start
                while (first[node] >= 0) {
                    val s = first[node]
                    first[node] = next[s]
                    walk.add(x(node))
                    walk.add(y(node))
                    node = domain.segmentEnd(s)
                }
                if (node == start && walk.all { it.isFinite() }) walks.add(walk.toDoubleArray())
            }
        }
        return walks
    }

    private fun donuts(): DoubleArray {
        val nearest = DoubleArray(domain.nodeCount) { Double.POSITIVE_INFINITY }
        for (s in 0 until domain.segmentCount) {
            val length = length(s)
            if (!length.isFinite()) continue
            nearest[domain.segmentStart(s)] = minOf(nearest[domain.segmentStart(s)], length)
            nearest[domain.segmentEnd(s)] = minOf(nearest[domain.segmentEnd(s)], length)
        }
        return DoubleArray(3 * domain.nodeCount) {
            when (it % 3) {
                0 -> onSheet(x(it / 3))
                1 -> onSheet(y(it / 3))
                else -> donutRadius(1.6 * nearest[it / 3])
            }
        }
    }

    private fun medianSegment(): Double {
        val lengths = DoubleArray(domain.segmentCount) { length(it) }
        lengths.sort()
        val median = if (lengths.isEmpty()) Double.NaN else lengths[lengths.size / 2]
        return if (median.isFinite()) median else view.width
    }

    private fun length(s: Int): Double = Math.hypot(
        x(domain.segmentEnd(s)) - x(domain.segmentStart(s)), y(domain.segmentEnd(s)) - y(domain.segmentStart(s)),
    )

    private fun drawLegend(scene: Scene, left: Double) {
        val labels = ArrayList<Label>()
        usedTags.take(MAX_ROWS).forEachIndexed { i, tag ->
            val middle = MARGIN + (i + 0.5) * ROW
            val last = i == MAX_ROWS - 1 && usedTags.size > MAX_ROWS
            if (!last) scene.add(Strokes(colourOf(tag), 3.0, doubleArrayOf(left, middle, left + SAMPLE, middle)))
            val text = if (last) "and ${usedTags.size - MAX_ROWS + 1} more" else short(domain.tags[tag])
            labels.add(Label(left + SAMPLE + 10, middle + 0.36 * TEXT, Anchor.START, text))
        }
        scene.add(Labels(Palette.INK, TEXT, false, labels))
    }

    private fun legendWidth(): Double =
        SAMPLE + 10 + MARGIN + usedTags.take(MAX_ROWS).maxOf { LabelLayout.widthOf(short(domain.tags[it]), TEXT) }

    private fun short(tag: String): String = if (tag.length <= 28) tag else tag.take(27) + "\u2026"

    /** A node without a place is drawn, and its number refused, off the sheet. */
    private fun onSheet(coordinate: Double): Double = if (coordinate.isFinite()) coordinate else OFF_SHEET

    private fun x(node: Int): Double = view.x(domain.x(node))

    private fun y(node: Int): Double = view.y(domain.y(node))

    private companion object {
        const val MARGIN = 30.0
        const val ROW = 24.0
        const val TEXT = 14.0
        const val SAMPLE = 28.0
        const val MAX_ROWS = 24
        const val OFF_SHEET = -1000.0
    }
}
