package org.trigrid.reliability

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.TestFactory
import org.trigrid.RandomDomains

/** A slice of [FuzzRun] of some minutes, the same each time. */
@Tag("corpus")
class FuzzSliceTest {
    @TestFactory
    fun `random domains are meshed validly within the budget of work`(): List<DynamicTest> =
        RandomDomains.families.map { family ->
            DynamicTest.dynamicTest(family.name) {
                val tally = FuzzTally(family.name)
                for (seed in 200_000L until 200_250L) if (seed % family.every == 0L) FuzzRun.run(family, seed, tally)
                assertEquals(emptyList<String>(), tally.failures)
            }
        }
}
