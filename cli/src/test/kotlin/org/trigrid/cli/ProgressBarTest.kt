package org.trigrid.cli

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.Stage
import java.io.ByteArrayOutputStream
import java.io.PrintStream

class ProgressBarTest {
    private val bytes = ByteArrayOutputStream()
    private val cancellation = Cancellation()
    private var now = 0L

    private fun bar(showsProgress: Boolean): ProgressBar {
        val stream = PrintStream(bytes, true, Charsets.UTF_8)
        return ProgressBar(Terminal(stream, stream, showsProgress), cancellation) { now }
    }

    @Test
    fun `short work shows nothing`() {
        bar(true).use {
            now = 400_000_000
            assertTrue(it.update(Stage.FRONT, 0.9))
        }
        assertEquals("", bytes.toString())
    }

    @Test
    fun `long work shows how far it is and clears the line at its end`() {
        bar(true).use {
            now = 700_000_000
            it.update(Stage.FRONT, 0.25)
        }
        val text = bytes.toString()
        assertTrue(text.startsWith("\r[" + "#".repeat(10) + "-".repeat(30) + "]  25 % front"), text)
        assertTrue(text.endsWith("\r\u001B[K"), text)
    }

    @Test
    fun `the bar is not drawn more often than the eye sees`() {
        bar(true).use {
            repeat(1000) { i ->
                now = 600_000_000 + i * 1_000_000L
                it.update(Stage.FRONT, i / 1000.0)
            }
        }
        assertEquals(10, bytes.toString().count { it == '[' } - 1)
    }

    @Test
    fun `nothing is shown when nobody watches`() {
        bar(false).use {
            now = 9_000_000_000
            it.update(Stage.FRONT, 0.5)
        }
        assertEquals("", bytes.toString())
    }

    @Test
    fun `a request to stop reaches the mesher`() {
        val bar = bar(false)
        assertTrue(bar.update(Stage.FRONT, 0.1))
        cancellation.request()
        assertFalse(bar.update(Stage.FRONT, 0.2))
    }
}
