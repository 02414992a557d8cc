package org.trigrid.quality

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.mesh.TriMesh
import org.trigrid.parallel.Crew

/** Quality and angles of every element of a mesh. */
internal class ElementMeasures(
    val mesh: TriMesh,
    val checkpoint: Checkpoint = Checkpoint.unheard(),
    crew: Crew = Crew.CALLER,
) {
    val elementCount: Int = mesh.elementCount
    val qualities: DoubleArray = DoubleArray(elementCount)

    /** Degrees. */
    val minAngles: DoubleArray = DoubleArray(elementCount)

    /** Degrees. */
    val maxAngles: DoubleArray = DoubleArray(elementCount)
    val angleHistogram: IntArray = IntArray(ANGLE_CLASSES)

    init {
        val pieces = (elementCount + PIECE - 1) / PIECE
        val histograms = Array(pieces) { IntArray(ANGLE_CLASSES) }
        crew.run(pieces, { checkpoint.ask() }) { piece, progress ->
            for (t in piece * PIECE until Math.min(elementCount, (piece + 1) * PIECE)) {
                if (t and ASK_MASK == 0) progress(0.0)
                measure(t, histograms[piece])
            }
        }
        for (histogram in histograms) for (i in histogram.indices) angleHistogram[i] += histogram[i]
    }

    private fun measure(t: Int, angleHistogram: IntArray) {
        val xy = mesh.xy
        val a = 2 * mesh.elements[3 * t]
        val b = 2 * mesh.elements[3 * t + 1]
        val c = 2 * mesh.elements[3 * t + 2]
        val abx = xy[b] - xy[a]
        val aby = xy[b + 1] - xy[a + 1]
        val bcx = xy[c] - xy[b]
        val bcy = xy[c + 1] - xy[b + 1]
        val cax = xy[a] - xy[c]
        val cay = xy[a + 1] - xy[c + 1]
        val ab = abx * abx + aby * aby
        val bc = bcx * bcx + bcy * bcy
        val ca = cax * cax + cay * cay
        val doubleArea = aby * cax - abx * cay
        qualities[t] = TWO_ROOT_3 * doubleArea / (ab + bc + ca)
        // The dot products at the corners; the longest side is opposite the smallest one, and the largest angle.
        val atA = -(abx * cax + aby * cay)
        val atB = -(abx * bcx + aby * bcy)
        val atC = -(bcx * cax + bcy * cay)
        val size = Math.abs(doubleArea)
        val largest = degrees(size, minOf(atA, minOf(atB, atC)))
        val smallest = degrees(size, maxOf(atA, maxOf(atB, atC)))
        minAngles[t] = smallest
        maxAngles[t] = largest
        angleHistogram[angleClass(smallest)]++
        angleHistogram[angleClass(180 - smallest - largest)]++
        angleHistogram[angleClass(largest)]++
    }

    private fun degrees(doubleArea: Double, dot: Double): Double = StrictMath.atan2(doubleArea, dot) * (180 / Math.PI)

    private fun angleClass(degrees: Double): Int = (degrees / (180 / ANGLE_CLASSES)).toInt().coerceIn(0, ANGLE_CLASSES - 1)

    fun qualityHistogram(): IntArray {
        val classes = IntArray(QUALITY_CLASSES)
        for (q in qualities) {
            checkpoint.pass()
            classes[(q * QUALITY_CLASSES).toInt().coerceIn(0, QUALITY_CLASSES - 1)]++
        }
        return classes
    }

    /** The [count] elements of lowest quality, worst first, ties by number. */
    fun worst(count: Int): List<WorstElement> {
        val wanted = minOf(count, elementCount)
        val found = IntArray(wanted)
        var size = 0
        for (t in 0 until elementCount) {
            checkpoint.pass()
            if (wanted == 0 || size == wanted && !(qualities[t] < qualities[found[size - 1]])) continue
            var at = if (size < wanted) size++ else size - 1
            while (at > 0 && qualities[t] < qualities[found[at - 1]]) {
                found[at] = found[at - 1]
                at--
            }
            found[at] = t
        }
        return java.util.List.copyOf(found.map { describe(it) })
    }

    private fun describe(t: Int): WorstElement {
        var x = 0.0
        var y = 0.0
        for (k in 0..2) {
            x += mesh.x(mesh.nodeOf(t, k)) / 3
            y += mesh.y(mesh.nodeOf(t, k)) / 3
        }
        return WorstElement(t, qualities[t], minAngles[t], x, y)
    }

    private companion object {
        const val TWO_ROOT_3 = 3.4641016151377544
        const val ANGLE_CLASSES = 18
        const val QUALITY_CLASSES = 10

        /** Elements that one thread measures at a time. */
        const val PIECE = 50_000
        const val ASK_MASK = 4095
    }
}
