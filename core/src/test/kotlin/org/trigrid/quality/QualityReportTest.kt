package org.trigrid.quality

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.mesh.GridMeshes
import org.trigrid.mesh.TriMesh

class QualityReportTest {
    @Test
    fun `an equilateral and a right triangle by hand`() {
        val high = Math.sqrt(3.0) / 2
        val mesh = TriMesh.of(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 0.5, high, 1.0, -1.0), intArrayOf(0, 1, 2, 0, 3, 1))
        val report = QualityReport.of(mesh)
        val right = Math.sqrt(3.0) / 2
        assertEquals(right, report.minQuality, 1e-15)
        assertEquals((1 + right) / 2, report.meanQuality, 1e-15)
        assertEquals(right + 0.05 * (1 - right), report.quality05, 1e-15)
        assertEquals(45.0, report.minAngle, 1e-12)
        assertEquals(90.0, report.maxAngle, 1e-12)
        assertEquals(52.5, report.meanMinAngle, 1e-12)
        assertEquals(45.15, report.minAngle01, 1e-12)
        assertTrue(report.degree6.isNaN())
        assertEquals(1, report.worstElements[0].element)
        assertEquals(-1.0 / 3, report.worstElements[0].y, 1e-15)
        assertEquals(6, report.angleHistogram().sum())
        assertEquals(1, report.qualityHistogram()[8])
        assertEquals(1, report.qualityHistogram()[9])
    }

    @Test
    fun `degrees of a lattice of equilateral triangles`() {
        val rows = 12
        val xy = ArrayList<Double>()
        val elements = ArrayList<Int>()
        for (j in 0..rows) for (i in 0..rows) {
            xy.add(i + 0.5 * j)
            xy.add(j * Math.sqrt(3.0) / 2)
        }
        for (j in 0 until rows) for (i in 0 until rows) {
            val a = j * (rows + 1) + i
            elements.addAll(listOf(a, a + 1, a + rows + 1, a + 1, a + rows + 2, a + rows + 1))
        }
        val report = QualityReport.of(TriMesh.of(xy.toDoubleArray(), elements.toIntArray()))
        assertEquals(1.0, report.degree6)
        assertEquals((rows - 1) * (rows - 1), report.interiorNodeCount)
        assertEquals(1.0, report.minQuality, 1e-14)
        assertEquals(60.0, report.minAngle, 1e-12)
        assertEquals(0, report.below30)
    }

    @Test
    fun `percentiles are those of a full sort`() {
        val random = java.util.Random(11)
        for (size in 1..300) {
            val values = DoubleArray(size) { if (random.nextBoolean()) random.nextInt(5).toDouble() else random.nextDouble() }
            val sorted = values.sortedArray()
            for (percent in doubleArrayOf(0.0, 1.0, 5.0, 50.0, 99.0, 100.0)) {
                val rank = percent / 100 * (size - 1)
                val low = Math.floor(rank).toInt()
                val expected = sorted[low] + (sorted[minOf(low + 1, size - 1)] - sorted[low]) * (rank - low)
                assertEquals(expected, Percentile.of(values.copyOf(), percent), 1e-15)
            }
        }
    }

    @Test
    fun `the worst elements come in order and the report does not depend on numbers`() {
        val grid = GridMeshes.shaken(20, 20, 3L).mesh
        val report = QualityReport.of(grid, 25)
        val qualities = report.worstElements.map { it.quality }
        assertEquals(25, qualities.size)
        assertEquals(qualities.sorted(), qualities)
        assertEquals(report.minQuality, qualities[0])
        val other = QualityReport.of(grid.renumbered(GridMeshes.randomPermutation(grid.nodeCount, java.util.Random(1))))
        assertEquals(report.meanQuality, other.meanQuality, 1e-15)
        assertArrayEquals(report.angleHistogram(), other.angleHistogram())
        assertEquals(report.quality05, other.quality05)
        assertEquals(report.minAngle05, other.minAngle05)
    }
}
