package org.trigrid.front

import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.util.Random

class FrontIndexTest {
    @Test
    fun `a query misses no edge, whatever has been inserted and removed`() {
        val random = Random(3)
        for (round in 0 until 20) {
            val index = FrontIndex(-1.0, -1.0, 1.0, 1.0)
            val edges = HashMap<Int, DoubleArray>()
            for (step in 0 until 3000) {
                val id = random.nextInt(400)
                val present = edges.remove(id)
                if (present != null) {
                    index.remove(id)
                } else {
                    val length = StrictMath.pow(10.0, -5 * random.nextDouble())
                    val ax = 2 * random.nextDouble() - 1
                    val ay = 2 * random.nextDouble() - 1
                    val edge = doubleArrayOf(ax, ay, clamp(ax + length * random.nextGaussian()), clamp(ay + length * random.nextGaussian()))
                    edges[id] = edge
                    index.insert(id, edge[0], edge[1], edge[2], edge[3])
                }
                if (step % 10 == 0) checkQuery(random, index, edges)
            }
        }
    }

    private fun checkQuery(random: Random, index: FrontIndex, edges: Map<Int, DoubleArray>) {
        val half = StrictMath.pow(10.0, -4 * random.nextDouble())
        val x = 2 * random.nextDouble() - 1
        val y = 2 * random.nextDouble() - 1
        index.query(x - half, y - half, x + half, y + half)
        val found = index.found.copyOf(index.foundCount).toSet()
        assertTrue(found.size == index.foundCount) { "an edge was found twice" }
        assertTrue(edges.keys.containsAll(found)) { "a removed edge was found" }
        for ((id, e) in edges) {
            val meets = Math.min(e[0], e[2]) <= x + half && Math.max(e[0], e[2]) >= x - half &&
                Math.min(e[1], e[3]) <= y + half && Math.max(e[1], e[3]) >= y - half
            if (meets) assertTrue(id in found) { "edge ${e.toList()} was missed near ($x, $y), half side $half" }
        }
    }

    private fun clamp(v: Double) = Math.max(-1.0, Math.min(1.0, v))
}
