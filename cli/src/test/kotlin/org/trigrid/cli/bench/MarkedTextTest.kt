package org.trigrid.cli.bench

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class MarkedTextTest {
    private val marked = MarkedText.replaced("", "one")

    @Test
    fun `what stands round the marks stays`() {
        val document = "# Speed\n\n" + marked + "\nAn explanation.\n"
        assertEquals(document.replace("one", "two\n\nthree"), MarkedText.replaced(document, "two\n\nthree\n"))
    }

    @Test
    fun `a text without marks, or with an end only, is replaced`() {
        assertEquals(marked, MarkedText.replaced("something else", "one"))
        assertEquals(marked, MarkedText.replaced("<!-- measured: end -->", "one"))
    }
}
