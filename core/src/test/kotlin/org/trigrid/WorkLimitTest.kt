package org.trigrid

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class WorkLimitTest {
    @Test
    fun `what is within both limits may be made`() = assertNull(WorkLimit(1e6, 4000).refusal(1_000_000, 200_000_000))

    @Test
    fun `too many elements are refused with their number, the memory and the option`() {
        val refusal = WorkLimit(2.5e6, 4000).refusal(1_000_000, Long.MAX_VALUE)!!
        for (part in listOf("2.50e+06 elements", "401 MB", "1000000", "--max-elements")) assertTrue(part in refusal) { refusal }
    }

    @Test
    fun `more memory than the heap may have is refused with the option that raises it`() {
        val refusal = WorkLimit(2.5e6, 4000).refusal(20_000_000, 256_000_000)!!
        for (part in listOf("401 MB", "256 MB", "-Xmx", "TRIGRID_JAVA_OPTS")) assertTrue(part in refusal) { refusal }
    }

    @Test
    fun `the boundary counts too`() {
        assertEquals(200.0 * 1_000_000, WorkLimit(0.0, 1_000_000).bytes)
    }
}
