package org.trigrid.geometry

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.hypot
import kotlin.random.Random

class InsertionOrderTest {
    @Test
    fun `both orders are permutations, whatever the points`() {
        val random = Random(1)
        for (count in listOf(0, 1, 2, 15, 16, 1000)) {
            val clouds = listOf(DoubleArray(2 * count) { random.nextDouble() }, DoubleArray(2 * count), DoubleArray(2 * count) { 1e9 + it })
            for (xy in clouds) {
                assertArrayEquals(IntArray(count) { it }, InsertionOrder.of(xy).sortedArray())
                assertArrayEquals(IntArray(count) { it }, InsertionOrder.alongCurve(xy).sortedArray())
            }
        }
    }

    @Test
    fun `neighbours on the curve are neighbours in the plane`() {
        val side = 64
        val xy = DoubleArray(2 * side * side) { ((if (it % 2 == 0) it / 2 % side else it / 2 / side)).toDouble() }
        val order = InsertionOrder.alongCurve(xy)
        var length = 0.0
        for (i in 1 until order.size) {
            length += hypot(xy[2 * order[i]] - xy[2 * order[i - 1]], xy[2 * order[i] + 1] - xy[2 * order[i - 1] + 1])
        }
        assertTrue(length < 1.6 * (order.size - 1)) { "mean step ${length / (order.size - 1)}" }
    }

    @Test
    fun `early rounds are spread over all points`() {
        val count = 10_000
        val xy = DoubleArray(2 * count) { if (it % 2 == 0) it.toDouble() else 0.0 }
        val early = InsertionOrder.of(xy).take(count / 8)
        assertEquals(0.5, early.average() / count, 0.05)
        assertTrue(early.max() > 0.95 * count && early.min() < 0.05 * count)
    }
}
