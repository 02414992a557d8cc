package org.trigrid.quality

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.mesh.TriMesh
import org.trigrid.parallel.Crew

/**
 * How good the elements of a mesh are.
 *
 * Quality is q = 4 sqrt(3) A / (l1^2 + l2^2 + l3^2), dimensionless: 1 for an equilateral triangle, 0 for a flat one,
 * negative for a clockwise one, which no valid mesh has. Angles are in degrees. Percentiles are interpolated linearly
 * between ranks. A mesh without elements has NaN for every figure.
 */
public class QualityReport internal constructor(measures: ElementMeasures, worstCount: Int) {
    @get:JvmName("elementCount")
    public val elementCount: Int = measures.elementCount

    /** Quality of the worst element, 0..1. */
    @get:JvmName("minQuality")
    public val minQuality: Double = measures.qualities.minOrNaN(measures.checkpoint)

    /** 5 % of the elements are worse than this. */
    @get:JvmName("quality05")
    public val quality05: Double

    /** Mean quality of the elements, 0..1. */
    @get:JvmName("meanQuality")
    public val meanQuality: Double = measures.qualities.compensatedMean(measures.checkpoint)

    /** Share of elements with a quality below 0.5, 0..1. */
    @get:JvmName("shareBelowHalf")
    public val shareBelowHalf: Double = measures.qualities.count(measures.checkpoint) { it < 0.5 } / elementCount.toDouble()

    /** Smallest angle of all elements, in degrees. */
    @get:JvmName("minAngle")
    public val minAngle: Double = measures.minAngles.minOrNaN(measures.checkpoint)

    /** Smallest angle that 1 % of the elements fall below. */
    @get:JvmName("minAngle01")
    public val minAngle01: Double

    /** Smallest angle that 5 % of the elements fall below. */
    @get:JvmName("minAngle05")
    public val minAngle05: Double

    /** Mean over the elements of their smallest angle. */
    @get:JvmName("meanMinAngle")
    public val meanMinAngle: Double = measures.minAngles.compensatedMean(measures.checkpoint)

    /** Largest angle of all elements, in degrees. */
    @get:JvmName("maxAngle")
    public val maxAngle: Double = measures.maxAngles.maxOrNaN(measures.checkpoint)

    /** Elements whose largest angle is above 120 degrees. */
    @get:JvmName("above120")
    public val above120: Int = measures.maxAngles.count(measures.checkpoint) { it > 120.0 }

    /** Share of interior nodes with six neighbours, 0..1; NaN without interior nodes. */
    @get:JvmName("degree6")
    public val degree6: Double

    /** Share of interior nodes with five to seven neighbours, 0..1; NaN without interior nodes. */
    @get:JvmName("degree567")
    public val degree567: Double

    /** Number of nodes with elements all round. */
    @get:JvmName("interiorNodeCount")
    public val interiorNodeCount: Int

    /** The worst elements, worst first. */
    @get:JvmName("worstElements")
    public val worstElements: List<WorstElement>

    private val qualities: IntArray
    private val angles = measures.angleHistogram
    private val smallAngles: List<Int>

    init {
        val checkpoint = measures.checkpoint
        worstElements = measures.worst(worstCount)
        qualities = measures.qualityHistogram()
        smallAngles = intArrayOf(10, 20, 30).map { limit -> measures.minAngles.count(checkpoint) { it < limit } }
        val degrees = NodeDegrees.of(measures.mesh, checkpoint)
        interiorNodeCount = degrees.interiorNodeCount
        degree6 = degrees.share(6, 6)
        degree567 = degrees.share(5, 7)
        val none = elementCount == 0
        // From here on the arrays are reordered.
        quality05 = if (none) Double.NaN else Percentile.of(measures.qualities, 5.0, checkpoint)
        minAngle01 = if (none) Double.NaN else Percentile.of(measures.minAngles, 1.0, checkpoint)
        minAngle05 = if (none) Double.NaN else Percentile.of(measures.minAngles, 5.0, checkpoint)
    }

    /** Elements by quality: 10 classes of width 0.1 from 0 to 1; a quality below 0 counts in the first. A copy. */
    public fun qualityHistogram(): IntArray = qualities.copyOf()

    /** All angles of all elements: 18 classes of 10 degrees from 0 to 180. A copy. */
    public fun angleHistogram(): IntArray = angles.copyOf()

    /** Elements with an angle below 10 degrees. */
    @get:JvmName("below10")
    public val below10: Int get() = smallAngles[0]

    /** Elements with an angle below 20 degrees. */
    @get:JvmName("below20")
    public val below20: Int get() = smallAngles[1]

    /** Elements with an angle below 30 degrees. */
    @get:JvmName("below30")
    public val below30: Int get() = smallAngles[2]

    public companion object {
        private const val WORST = 10

        /** The report with the ten worst elements. */
        @JvmStatic
        public fun of(mesh: TriMesh): QualityReport = of(mesh, WORST)

        /** The report with the [worstCount] worst elements, or all where there are fewer. */
        @JvmStatic
        public fun of(mesh: TriMesh, worstCount: Int): QualityReport {
            require(worstCount >= 0) { "worstCount must not be negative: $worstCount" }
            return QualityReport(ElementMeasures(mesh), worstCount)
        }

        /** As [of], in a run that may be cancelled. */
        internal fun of(mesh: TriMesh, checkpoint: Checkpoint, crew: Crew): QualityReport =
            QualityReport(ElementMeasures(mesh, checkpoint, crew), WORST)
    }
}

private inline fun DoubleArray.visit(checkpoint: Checkpoint, action: (Double) -> Unit) {
    for (v in this) {
        checkpoint.pass()
        action(v)
    }
}

private fun DoubleArray.minOrNaN(checkpoint: Checkpoint): Double {
    var least = Double.NaN
    visit(checkpoint) { if (!(it >= least)) least = it }
    return least
}

private fun DoubleArray.maxOrNaN(checkpoint: Checkpoint): Double {
    var most = Double.NaN
    visit(checkpoint) { if (!(it <= most)) most = it }
    return most
}

private inline fun DoubleArray.count(checkpoint: Checkpoint, isMeant: (Double) -> Boolean): Int {
    var count = 0
    visit(checkpoint) { if (isMeant(it)) count++ }
    return count
}

/** Mean by Neumaier's compensated sum. */
private fun DoubleArray.compensatedMean(checkpoint: Checkpoint): Double {
    var sum = 0.0
    var lost = 0.0
    visit(checkpoint) { v ->
        val t = sum + v
        lost += if (Math.abs(sum) >= Math.abs(v)) (sum - t) + v else (v - t) + sum
        sum = t
    }
    return (sum + lost) / size
}
