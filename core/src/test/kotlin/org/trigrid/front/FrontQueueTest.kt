package org.trigrid.front

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import java.util.Random
import java.util.TreeMap

class FrontQueueTest {
    @Test
    fun `it gives the smallest key first and among equal keys the older edge`() {
        val random = Random(5)
        for (keyCount in listOf(1, 64, 65, 5000, 300_000)) {
            val queue = FrontQueue(keyCount)
            // By key, then by turn.
            val model = TreeMap<Long, Int>()
            val place = HashMap<Int, Long>()
            var turn = 0L
            repeat(5000) {
                val edge = random.nextInt(300)
                if (random.nextInt(3) == 0) {
                    queue.remove(edge)
                    place.remove(edge)?.let { model.remove(it) }
                } else {
                    val key = random.nextInt(keyCount)
                    queue.put(edge, key)
                    if (place[edge]?.let { it shr 32 } != key.toLong()) {
                        place[edge]?.let { model.remove(it) }
                        val at = (key.toLong() shl 32) or turn++
                        place[edge] = at
                        model[at] = edge
                    }
                }
                assertEquals(model.firstEntry()?.value ?: -1, queue.peek())
                assertEquals(edge in place, queue.contains(edge))
            }
        }
    }

    @Test
    fun `keys out of range go to the ends`() {
        val queue = FrontQueue(10)
        queue.put(1, 99)
        queue.put(2, -5)
        assertEquals(2, queue.peek())
        queue.remove(2)
        assertEquals(1, queue.peek())
    }
}
