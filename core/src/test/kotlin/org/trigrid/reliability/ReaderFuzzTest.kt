package org.trigrid.reliability

import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.TestFactory
import org.trigrid.diagnostics.FileFormatException
import java.util.Random

/** Damaged files of every kind: each is read, or refused with its place, soon and with little memory. */
class ReaderFuzzTest {
    @TestFactory
    fun `a file cut off anywhere is read or refused`(): List<DynamicTest> = eachFormat { format, sample ->
        for (end in 0 until sample.length) requireSound(format, sample.substring(0, end))
    }

    @TestFactory
    fun `damaged files are read or refused`(): List<DynamicTest> = eachFormat { format, sample ->
        val random = Random(1)
        repeat(400) { requireSound(format, DamagedText.damaged(sample, random)) }
    }

    @Tag("corpus")
    @TestFactory
    fun `many damaged files are read or refused`(): List<DynamicTest> = eachFormat { format, sample ->
        val random = Random(2)
        repeat(8000) { requireSound(format, DamagedText.damaged(sample, random)) }
    }

    @TestFactory
    fun `noise, deep nesting and long lines are refused`(): List<DynamicTest> = eachFormat { format, sample ->
        val random = Random(3)
        repeat(100) { requireSound(format, DamagedText.noise(random, 1 + random.nextInt(400))) }
        for (text in DamagedText.extremes(sample)) requireSound(format, text)
    }

    private fun eachFormat(test: (FileKind, String) -> Unit): List<DynamicTest> = FileKind.all().map { format ->
        DynamicTest.dynamicTest(format.name) { for (sample in format.samples) test(format, sample) }
    }

    private fun requireSound(format: FileKind, text: String) {
        val meter = AllocationMeter()
        val since = System.nanoTime()
        try {
            format.read(text)
        } catch (e: FileFormatException) {
            assertTrue(e.message!!.length < MOST_MESSAGE) { "a message of ${e.message!!.length} characters" }
            assertTrue(e.line >= 1 || PLACELESS.any { it in e.message!! }) { "no place: ${e.message}" }
        } catch (e: Throwable) {
            throw AssertionError("${format.name}: $e for ${shown(text)}", e)
        }
        val allowed = FIXED_BYTES + BYTES_PER_CHARACTER * text.length.toLong()
        val used = meter.bytes()
        assertTrue(used <= allowed) { "${format.name}: $used bytes for ${text.length} characters: ${shown(text)}" }
        val seconds = (System.nanoTime() - since) / 1e9
        assertTrue(seconds < MOST_SECONDS + text.length * 5e-6) { "${format.name}: $seconds s for ${text.length} characters: ${shown(text)}" }
    }

    private fun shown(text: String) = if (text.length <= 3000) text else text.take(400) + " … of ${text.length} characters"

    private companion object {
        /** What concerns a file as a whole. */
        val PLACELESS = listOf("there is no polygon in it", "Java's heap ends at")

        /** All that is allocated while reading, most of it garbage soon. */
        const val BYTES_PER_CHARACTER = 600L
        const val FIXED_BYTES = 8_000_000L
        const val MOST_SECONDS = 5.0
        const val MOST_MESSAGE = 1000
    }
}

/** Bytes allocated by this thread since the meter was made. */
private class AllocationMeter {
    private val bean = java.lang.management.ManagementFactory.getThreadMXBean() as com.sun.management.ThreadMXBean
    private val from = bean.getThreadAllocatedBytes(Thread.currentThread().id)

    fun bytes(): Long = bean.getThreadAllocatedBytes(Thread.currentThread().id) - from
}
