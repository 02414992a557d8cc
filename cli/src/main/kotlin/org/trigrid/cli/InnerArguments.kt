package org.trigrid.cli

import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.domain.InnerParts
import org.trigrid.domain.Region
import org.trigrid.geometry.Point2
import org.trigrid.project.InputOptions
import org.trigrid.shape.Line
import picocli.CommandLine
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException

/** The options that put regions, points and lines into a domain. */
internal class InnerArguments {
    @Option(
        names = ["--region"], paramLabel = "NAME[=M][,H]@X,Y",
        description = [
            "The part of the domain round the place (X, Y), or round each of several, belongs to the region NAME, of the material " +
                "number M and with elements no larger than H. A hole that the place lies in is filled. May be given again.",
        ],
    )
    var regions: List<String> = emptyList()

    @Option(
        names = ["--point"], paramLabel = "[NAME@]X,Y",
        description = ["The place (X, Y) becomes a node of the mesh, and so do more of them. May be given again."],
    )
    var points: List<String> = emptyList()

    @Option(
        names = ["--line"], paramLabel = "[NAME[,H]@]X,Y,X,Y",
        description = [
            "Segments between these places inside the domain, or with H nodes at that distance along them, become edges of the " +
                "mesh. May be given again.",
        ],
    )
    var lines: List<String> = emptyList()

    @Option(
        names = ["--join-domains"],
        description = ["The polygons of a file are regions of one domain, and sides that they share its interfaces."],
    )
    var joinDomains: Boolean = false

    /** [base] with what was asked for; what cannot be understood is a usage error. */
    fun over(base: InputOptions, commandLine: CommandLine): InputOptions {
        var parts = InnerParts.NONE
        for (text in regions) parts = withRegion(parts, text, commandLine)
        for (text in points) {
            val xy = places(text) ?: fail("--point must be of the form X,Y or NAME@X,Y, not $text", commandLine)
            val name = text.substringBeforeLast('@', "").trim().ifEmpty { "point" }
            for (i in 0 until xy.size / 2) parts = parts.withPoint(name, xy[2 * i], xy[2 * i + 1])
        }
        for (text in lines) parts = withLine(parts, text, commandLine)
        return base.withInner(parts).withJoin(joinDomains)
    }

    private fun withLine(parts: InnerParts, text: String, commandLine: CommandLine): InnerParts {
        val head = text.substringBeforeLast('@', "")
        val spacing = if (',' in head) head.substringAfter(',').trim().toDoubleOrNull() else Double.POSITIVE_INFINITY
        val xy = places(text)
        if (spacing == null || xy == null || xy.size < 4) {
            fail("--line must be of the form X,Y,X,Y,... or NAME@X,Y,X,Y,... or NAME,H@X,Y,X,Y,..., not $text", commandLine)
        }
        return try {
            parts.withLine(head.substringBefore(',').trim().ifEmpty { "line" }, *if (',' in head) divided(xy, spacing) else xy)
        } catch (error: InvalidShapeException) {
            fail("--line $text: ${error.message}", commandLine)
        }
    }

    /** Nodes about [spacing] apart on each side of the line. */
    private fun divided(xy: DoubleArray, spacing: Double): DoubleArray {
        var result = doubleArrayOf(xy[0], xy[1])
        for (i in 2 until xy.size step 2) {
            val nodes = Line.explode(Point2(xy[i - 2], xy[i - 1]), Point2(xy[i], xy[i + 1]), spacing, 1.0)
            result += nodes.copyOfRange(2, nodes.size)
        }
        return result
    }

    private fun withRegion(parts: InnerParts, text: String, commandLine: CommandLine): InnerParts {
        val head = text.substringBeforeLast('@', "")
        val name = head.substringBefore(',').substringBefore('=').trim()
        val material = if ('=' in head) head.substringAfter('=').substringBefore(',').trim().toIntOrNull() else 0
        val size = if (',' in head) head.substringAfter(',').trim().toDoubleOrNull() else Double.POSITIVE_INFINITY
        val xy = places(text)
        if (name.isEmpty() || material == null || size == null || xy == null) {
            fail("--region must be of the form NAME@X,Y or NAME=M,H@X,Y, with a material number M and a largest size H, not $text", commandLine)
        }
        return try {
            val region = Region.of(name).withMaterial(material).withMaxSize(size)
            (0 until xy.size / 2).fold(parts) { all, i -> all.withRegion(region, xy[2 * i], xy[2 * i + 1]) }
        } catch (error: IllegalArgumentException) {
            fail("--region $text: ${error.message}", commandLine)
        }
    }

    /** x0, y0, … after the last @, or null. */
    private fun places(text: String): DoubleArray? {
        val numbers = text.substringAfterLast('@').split(',').map { it.trim().toDoubleOrNull() }
        return if (null in numbers || numbers.size % 2 != 0) null else numbers.filterNotNull().toDoubleArray()
    }

    private fun fail(message: String, commandLine: CommandLine): Nothing = throw ParameterException(commandLine, message)
}
