package org.trigrid.picture

/**
 * What a picture shows, for every kind of file the same: items from back to front on a white sheet of [width] x
 * [height] units, x to the right, y down. Things that look alike are one item, however many they are.
 */
internal class Scene(val width: Double, val height: Double) {
    private val all = ArrayList<SceneItem>()

    val items: List<SceneItem> get() = all

    /** Adds an item in front of the others; an empty one is left out. */
    fun add(item: SceneItem) {
        if (!item.isEmpty) all.add(item)
    }
}

/** Colours are 0xRRGGBB. */
internal sealed class SceneItem {
    abstract val isEmpty: Boolean
}

/** Filled triangles, 6 coordinates each. */
internal class Triangles(val colour: Int, val xy: DoubleArray) : SceneItem() {
    override val isEmpty: Boolean get() = xy.isEmpty()
}

/** Lines between two points, 4 coordinates each, with round ends. */
internal class Strokes(val colour: Int, val lineWidth: Double, val xy: DoubleArray) : SceneItem() {
    override val isEmpty: Boolean get() = xy.isEmpty()
}

/** The area inside closed walks (even-odd), each a list of x, y. */
internal class Area(val colour: Int, val walks: List<DoubleArray>) : SceneItem() {
    override val isEmpty: Boolean get() = walks.isEmpty()
}

/** Filled rectangles without edges, x, y, width, height each. */
internal class Boxes(val colour: Int, val xywh: DoubleArray) : SceneItem() {
    override val isEmpty: Boolean get() = xywh.isEmpty()
}

/** Rings with a white middle: x, y, outer radius each. */
internal class Donuts(val colour: Int, val xyr: DoubleArray) : SceneItem() {
    override val isEmpty: Boolean get() = xyr.isEmpty()

    companion object {
        /** Width of the ring, as a part of the outer radius. */
        const val RING = 0.42
    }
}

/** Lines of text of one look; with a halo they stay readable on lines. */
internal class Labels(
    val colour: Int,
    val size: Double,
    val bold: Boolean,
    val labels: List<Label>,
    val halo: Boolean = false,
) : SceneItem() {
    override val isEmpty: Boolean get() = labels.isEmpty()

    companion object {
        /** Width of the halo round the letters, as a part of their size. */
        const val HALO = 0.14
    }
}

/** One line of text; (x, y) is on its base line, at the left, middle or right of it. */
internal class Label(val x: Double, val y: Double, val anchor: Anchor, val text: String)

internal enum class Anchor { START, MIDDLE, END }
