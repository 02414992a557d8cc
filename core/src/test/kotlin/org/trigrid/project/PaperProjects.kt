package org.trigrid.project

import org.trigrid.MeshOptions
import org.trigrid.domain.Path
import org.trigrid.geometry.Point2
import org.trigrid.shape.Arc
import org.trigrid.shape.Circle
import org.trigrid.shape.Curve
import org.trigrid.shape.Direction
import org.trigrid.shape.Distribution
import org.trigrid.shape.Ellipse
import org.trigrid.shape.Line
import org.trigrid.shape.Lines
import org.trigrid.shape.Polygon
import org.trigrid.shape.Rectangle

/** The paper's cases, built through the library; `src-test-data/paper` holds their files. */
internal object PaperProjects {
    private const val HEXAGON_X = 1.1

    /** By file name, without `.trigrid.json`. */
    fun all(): Map<String, Project> = linkedMapOf(
        "small-grid" to Project.of(smallGrid()),
        "general" to Project.of(general()),
        "general-edited" to Project.of(generalEdited()),
        "machine-part" to machinePart(MachineSizes.UNIFORM),
        "machine-part-dense" to machinePart(MachineSizes.DENSE),
        "machine-part-thinner" to machinePart(MachineSizes.THINNER),
        "owen" to Project.of(owen()),
        "bastian" to Project.of(bastian()),
        "hand" to Project.of(hand()),
    )

    /** Fig. 7: sides of unit spacing round an area that has room for 34 nearly equilateral elements. */
    fun smallGrid(): Path = Path.of(Lines.of(1.0, 0.0, 0.0, 4.0, 0.0, 4.5, 0.9, 2.0, 5.2, -0.5, 0.9, 0.0, 0.0).withName("side"))

    /** Fig. 8(a): lines, curves, an ellipse on a neck; rectangle, triangle, hexagon and circle left out. */
    fun general(): Path {
        val path = Path.of(
            Lines.of(0.4, 0.0, 0.0, 6.0, 0.0, 7.0, 1.0, 9.0, 1.0).withName("bottom"),
            Curve.of(0.3, 9.0, 1.0, 9.8, 2.0, 9.4, 3.2, 10.0, 4.25).withName("right"),
            Ellipse(Point2(10.4, 4.5), Point2(12.4, 4.5), 2.0, 1.2, 0.36)
                .withDistribution(Distribution.SYMMETRIC).withRatio(1.6).withName("ellipse"),
            Lines.of(0.4, 10.0, 4.75, 9.5, 6.0, 8.0, 6.5).withName("right"),
            Curve.of(0.3, 8.0, 6.5, 7.0, 7.6, 5.5, 7.0, 4.5, 8.0, 3.0, 8.2, 1.5, 7.4).withName("top"),
            Lines.of(0.4, 1.5, 7.4, 0.0, 8.0, 0.0, 6.5).withName("left"),
            Curve.of(0.3, 0.0, 6.5, -0.7, 5.5, 0.2, 4.5, -0.6, 3.4, 0.0, 2.5).withName("left"),
        )
        // Without the ellipse's first node the outline passes on to the ellipse by two nodes, a neck.
        val neck = path.nodesOf(2).first()
        return path.deleteNode(neck)
            .append(Line(0.0, 2.5, 0.0, 0.0, 0.4).withName("left"))
            .appendConnector(Line(0.0, 0.0, 1.2, 1.2, 0.5).withName("connector"))
            .append(Rectangle(1.2, 1.2, 2.8, 2.2, 0.35).withDirection(Direction.CLOCKWISE).withName("rectangle"))
            .appendConnector(Line(1.2, 1.2, 4.6, 1.0, 0.5).withName("connector"))
            .append(Polygon(Point2(4.6, 1.0), Point2(5.3, 1.6), 3, 0.35).withDirection(Direction.CLOCKWISE).withName("triangle"))
            .back()
            .appendConnector(Line(1.2, 1.2, 1.0, 4.4, 0.5).withName("connector"))
            .append(Polygon(Point2(1.0, 4.4), Point2(2.0, 5.2), 6, 0.35).withDirection(Direction.CLOCKWISE).withName("hexagon"))
            .appendConnector(Line(1.0, 4.4, 4.7, 4.3, 0.5).withName("connector"))
            .append(Circle(Point2(4.7, 4.3), Point2(6.0, 4.3), 0.35).withDirection(Direction.CLOCKWISE).withName("circle"))
            .back().back().back()
    }

    /** Fig. 8(c): one node of the neck on the other, the upper left moved down, the left side thinned and moved right. */
    fun generalEdited(): Path {
        val path = general()
        val ellipse = path.nodesOf(2).dropLast(1)
        val lower = ellipse.first()
        var edited = path.moveNode(ellipse.last(), path.x(lower), path.y(lower))
        for (node in edited.nodesOf(5)) {
            val x = edited.x(node)
            val y = edited.y(node)
            if (y > 7.0 && x < 1.2) edited = edited.moveNode(node, x, 7.0 + 0.45 * (y - 7.0))
        }
        val left = edited.nodesOf(6).filter { edited.y(it) in 3.6..4.9 }
        for (node in left) edited = edited.moveNode(node, edited.x(node) + 0.15, edited.y(node))
        return edited.deleteNode(left[4]).deleteNode(left[3]).deleteNode(left[1])
    }

    /** Wanted spacing at the machine part's corners, by their place; the factors are relative to [scale]. */
    enum class MachineSizes(
        val scale: Double,
        private val prong: Double,
        private val notch: Double,
        private val arms: Double,
        private val hexagon: Double,
        private val right: Double,
    ) {
        UNIFORM(0.275, 1.0, 1.0, 1.0, 1.0, 1.0),
        DENSE(0.2006, 0.3, 0.3, 0.3, 1.0, 1.0),
        THINNER(0.186, 0.35, 0.5, 0.2, 0.8, 1.8),
        ;

        fun at(x: Double, y: Double): Double = when {
            x == 8.0 -> arms
            y == 5.0 -> notch
            y > 5.9 && x in 2.6..3.4 -> prong
            x == HEXAGON_X -> hexagon
            x > 3.0 && x != 3.6 -> right
            else -> 1.0
        }
    }

    /** The paper's numbers of elements need limits of the sizes in the two cases whose inside would be coarser. */
    private fun machinePart(sizes: MachineSizes): Project {
        val options = when (sizes) {
            MachineSizes.UNIFORM -> MeshOptions.builder().maxSize(0.255)
            MachineSizes.DENSE -> MeshOptions.builder().maxSize(0.185)
            MachineSizes.THINNER -> MeshOptions.builder().gradation(0.4)
        }
        return Project.builder().path(machinePath(sizes)).options(options.build()).build()
    }

    /** Fig. 9, after El-Hamalawi: a prong and two arms with narrow ends, a notch, a slot and a hexagonal hole. */
    fun machinePath(sizes: MachineSizes): Path {
        val slotX = 2.2
        val path = Path.EMPTY
            .sides(sizes, "outline", 0.0, 0.0, slotX, 0.0)
            .appendConnector(Line(slotX, 0.0, slotX, 1.25, 0.156).withName("connector"))
            .arc(sizes, slotX, 1.25, slotX, 2.15)
            .sides(sizes, "slot", slotX, 2.15, 3.6, 2.15)
            .arc(sizes, 3.6, 2.15, 3.6, 1.25)
            .sides(sizes, "slot", 3.6, 1.25, slotX, 1.25)
            .back()
            .sides(
                sizes, "outline", slotX, 0.0, 8.0, 0.0, 8.0, 0.25, 5.4, 0.65, 5.4, 2.75, 8.0, 3.15, 8.0, 3.4, 4.2, 3.4, 3.4, 4.0,
                3.4, 6.0, 3.05, 6.5, 2.7, 6.0, 2.7, 5.0, 2.2, 5.0, 2.2, 6.5, 0.5, 6.5, 0.0, 6.0, 0.0, 4.2,
            )
        val hexagon = Polygon(Point2(0.55, 4.2), Point2(HEXAGON_X, 4.2), 6, sizes.scale * sizes.at(HEXAGON_X, 4.2)).withName("hexagon")
        return path
            .appendOpening(Line(0.0, 4.2, 0.55, 4.2, 0.0786).withName("connector"), hexagon.withDirection(Direction.CLOCKWISE))
            .sides(sizes, "outline", 0.0, 4.2, 0.0, 0.0)
    }

    /** Lines whose spacing runs from that wanted at one corner to that at the next. */
    private fun Path.sides(sizes: MachineSizes, name: String, vararg xy: Double): Path {
        var path = this
        for (i in 2 until xy.size step 2) {
            val first = sizes.at(xy[i - 2], xy[i - 1])
            val last = sizes.at(xy[i], xy[i + 1])
            val spacing = Math.round((first + last) / 2 * sizes.scale * 1e4) / 1e4
            val line = Line(xy[i - 2], xy[i - 1], xy[i], xy[i + 1], spacing).withRatio(last / first).withName(name)
            path = path.append(line)
        }
        return path
    }

    private fun Path.arc(sizes: MachineSizes, x0: Double, y0: Double, x1: Double, y1: Double): Path =
        append(Arc(Point2(x0, y0), Point2(x1, y1), -180.0, sizes.scale * sizes.at(x0, y0)).withName("slot"))

    /** Fig. 10, after Owen: a rectangle with a square and a circle inside, denser at the circle. */
    fun owen(): Path = Path.of(Line(0.0, 0.0, 7.2, 0.0, 0.75).withRatio(0.45).withName("rectangle"))
        .appendOpening(
            Line(7.2, 0.0, 7.2, 2.0, 0.25).withName("connector"),
            Circle(Point2(7.2, 2.0), Point2(7.2, 3.0), 0.126).withDirection(Direction.CLOCKWISE).withName("circle"),
        )
        .append(Line(7.2, 0.0, 10.0, 0.0, 0.6).withRatio(1.8).withName("rectangle"))
        .append(Line(10.0, 0.0, 10.0, 6.0, 0.66).withDistribution(Distribution.SYMMETRIC).withRatio(0.7).withName("rectangle"))
        .append(Line(10.0, 6.0, 7.2, 6.0, 0.6).withRatio(1 / 1.8).withName("rectangle"))
        .append(Lines.of(0.75, 7.2, 6.0, 0.0, 6.0).withRatio(1 / 0.45).withName("rectangle"))
        .append(Line(0.0, 6.0, 0.0, 2.1, 0.95).withName("rectangle"))
        .appendOpening(
            Line(0.0, 2.1, 1.7, 2.1, 0.6).withName("connector"),
            Rectangle(1.7, 2.1, 3.5, 3.9, 0.45).withDirection(Direction.CLOCKWISE).withName("square"),
        )
        .append(Line(0.0, 2.1, 0.0, 0.0, 0.95).withName("rectangle"))

    /** Fig. 11, after Bastian: a large ellipse with a small hole off its centre, denser to the right. */
    fun bastian(): Path = Path.of(
        Ellipse(10.0, 6.0, 10.0, 6.0, 0.56).withDistribution(Distribution.SYMMETRIC).withRatio(6.0).withName("ellipse"),
    ).newLoop().append(
        Circle(7.5, 6.8, 0.5, 0.2).withDirection(Direction.CLOCKWISE).withDistribution(Distribution.SYMMETRIC)
            .withRatio(1.6).withName("hole"),
    )

    /** Fig. 12: a hand traced clockwise by cubic splines, denser at the finger tips and the pits between them. */
    fun hand(): Path {
        val digits = listOf(
            Digit(Point2(-4.1, 4.2), Point2(-2.35, 1.9), 0.62),
            Digit(Point2(-2.5, 8.9), Point2(-1.45, 4.6), 0.55),
            Digit(Point2(-0.35, 9.9), Point2(-0.1, 4.9), 0.58),
            Digit(Point2(1.75, 9.2), Point2(1.25, 4.7), 0.55),
            Digit(Point2(3.7, 7.4), Point2(2.5, 4.1), 0.48),
        )
        val pits = listOf(Point2(-1.55, 2.75), Point2(-0.82, 5.25), Point2(0.6, 5.3), Point2(1.95, 4.8))
        val wristLeft = Point2(-1.5, -2.0)
        val wristRight = Point2(1.7, -2.0)
        var path = Path.of(side(wristLeft, Point2(0.0, 1.0), digits[0], true).withDistribution(Distribution.LINEAR).withRatio(0.35))
        for ((i, pit) in pits.withIndex()) {
            path = path.append(side(pit, Point2(1.0, if (i == 0) 0.6 else 0.0), digits[i], false))
                .append(side(pit, Point2(1.0, if (i == 0) 0.6 else 0.0), digits[i + 1], true))
        }
        return path.append(side(wristRight, Point2(0.0, -1.0), digits.last(), false).withDistribution(Distribution.LINEAR).withRatio(1 / 0.35))
            .append(Line(wristRight, wristLeft, 0.4).withName("wrist"))
    }

    private class Digit(val tip: Point2, base: Point2, val halfWidth: Double) {
        private val length = base.distanceTo(tip)
        val reach = minOf(4.6, 0.75 * length / halfWidth)
        val alongX = (tip.x - base.x) / length
        val alongY = (tip.y - base.y) / length

        /** The place at [height] (0 at the tip, in half-widths downwards), [side] half-widths to the right. */
        fun at(height: Double, side: Double): Point2 = Point2(
            tip.x - halfWidth * (height * alongX - side * alongY),
            tip.y - halfWidth * (height * alongY + side * alongX),
        )
    }

    /** One side of a finger: up from [foot] to the tip on its left, or down from the tip to [foot] on its right. */
    private fun side(foot: Point2, footTangent: Point2, digit: Digit, isLeft: Boolean): Curve {
        val sign = if (isLeft) -1.0 else 1.0
        val vertices = listOf(foot, digit.at(digit.reach, sign * 1.08), digit.at(2.6, sign), digit.at(0.7, sign * 0.86), digit.tip)
        val tipTangent = Point2(digit.alongY, -digit.alongX)
        val ordered = if (isLeft) vertices else vertices.reversed()
        return Curve(ordered, 0.27).clamped(if (isLeft) footTangent else tipTangent, if (isLeft) tipTangent else footTangent)
            .withDistribution(Distribution.SYMMETRIC).withRatio(3.0).withName("skin")
    }
}
