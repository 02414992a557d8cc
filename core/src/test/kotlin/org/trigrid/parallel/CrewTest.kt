package org.trigrid.parallel

import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.trigrid.diagnostics.MeshingCancelledException
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.CountDownLatch
import java.util.concurrent.Executors
import java.util.concurrent.atomic.AtomicInteger

@Timeout(20)
class CrewTest {
    private val pool = Executors.newFixedThreadPool(3)

    @AfterEach
    fun `end the pool`() {
        pool.shutdownNow()
    }

    @Test
    fun `each task is done once, by several threads`() {
        val times = IntArray(50)
        val threads = ConcurrentHashMap.newKeySet<Thread>()
        val everyone = CountDownLatch(4)
        Crew(4, pool).run(50, {}) { index, _ ->
            times[index]++
            if (threads.add(Thread.currentThread())) everyone.countDown()
            everyone.await()
        }
        assertArrayEquals(IntArray(50) { 1 }, times)
        assertEquals(4, threads.size)
    }

    @Test
    fun `the caller does it all where nobody comes to help`() {
        var done = 0
        Crew(4) { }.run(10, {}) { _, _ -> done++ }
        assertEquals(10, done)
        Crew.CALLER.run(10, {}) { _, _ -> done++ }
        assertEquals(20, done)
        Crew.CALLER.run(0, {}) { _, _ -> done++ }
        assertEquals(20, done)
    }

    @Test
    fun `the caller alone reports, parts of the whole`() {
        val caller = Thread.currentThread()
        val told = ArrayList<Double>()
        Crew(3, pool).run(40, { assertSame(caller, Thread.currentThread()); told.add(it) }) { _, progress ->
            for (k in 0..4) progress(k / 4.0)
            Thread.sleep(2)
        }
        assertTrue(told.isNotEmpty() && told.all { it in 0.0..1.0 })
    }

    @Test
    fun `what a task throws comes to the caller when all others have ended`() {
        val running = AtomicInteger()
        val thrown = assertThrows(IllegalStateException::class.java) {
            Crew(3, pool).run(100, {}) { index, progress ->
                running.incrementAndGet()
                try {
                    repeat(20) {
                        progress(0.5)
                        Thread.sleep(1)
                    }
                    check(index != 7) { "seven" }
                } finally {
                    running.decrementAndGet()
                }
            }
        }
        assertEquals("seven", thrown.message)
        assertEquals(0, running.get())
    }

    @Test
    fun `a caller who wants to end ends the others too, even with nothing left to do`() {
        val begun = CountDownLatch(2)
        val ended = AtomicInteger()
        assertThrows(MeshingCancelledException::class.java) {
            Crew(2, pool).run(2, { if (begun.count == 0L) throw MeshingCancelledException() }) { _, progress ->
                begun.countDown()
                begun.await()
                try {
                    if (Thread.currentThread().name.startsWith("pool")) while (true) { progress(0.1); Thread.sleep(1) }
                } finally {
                    ended.incrementAndGet()
                }
            }
        }
        assertEquals(2, ended.get())
    }
}
