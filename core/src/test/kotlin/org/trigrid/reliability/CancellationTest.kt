package org.trigrid.reliability

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.assertThrows
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.RandomDomains
import org.trigrid.StageClock
import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.Stage
import org.trigrid.diagnostics.TooManyElementsException
import org.trigrid.domain.Domain
import org.trigrid.front.Strategy
import org.trigrid.numbering.NumberingMethod
import org.trigrid.spacing.Sizes

/** Runs that hear every question a stage asks, however soon after the last: nothing here depends on the clock. */
class CancellationTest {
    /** Counts the questions and says no to number [last]. */
    private class Counter(private val last: Int = Int.MAX_VALUE) : ProgressMonitor {
        val asked = IntArray(Stage.entries.size)
        val stages = LinkedHashSet<Stage>()
        var count = 0
        var fraction = 0.0
        var fell = 0.0
        var widestStep = 0.0

        override fun update(stage: Stage, fraction: Double): Boolean {
            count++
            asked[stage.ordinal]++
            stages.add(stage)
            fell = Math.max(fell, this.fraction - fraction)
            if (stage == Stage.FRONT && asked[stage.ordinal] > 1) widestStep = Math.max(widestStep, fraction - this.fraction)
            this.fraction = fraction
            return count < last
        }
    }

    @Test
    fun `each stage asks often for the work it has`() {
        // Many elements on few nodes, many nodes, many loops.
        val square = Domain.of(RandomLoops.subdivided(RandomLoops.square(0.0, 0.0, 1.0), 120))
        val ring = Domain.of(RandomLoops.ring(10_000))
        val sieve = RandomDomains.families.first { it.name == "hundreds of holes" }.make(1)
        val coarse = MeshOptions.builder().sizes(Sizes.GRADE).gradation(1.0).build()
        for ((domain, options) in listOf(square to MeshOptions.DEFAULT, ring to coarse, sieve to MeshOptions.DEFAULT)) {
            val counter = Counter()
            val report = MeshGenerator.run(domain, options, StageClock(counter, 0), null).report
            val work = mapOf(
                Stage.CHECK to report.boundaryNodeCount, Stage.SIZES to report.boundaryNodeCount,
                Stage.FRONT to report.elementCount, Stage.IMPROVE to report.elementCount, Stage.RENUMBER to report.elementCount,
            )
            for ((stage, steps) in work) {
                val asked = counter.asked[stage.ordinal]
                assertTrue(asked * LONGEST >= steps) { "$stage asked $asked times for $steps" }
            }
            // The front has a third of the whole; between two questions it has made no more than its share of these elements.
            val most = counter.widestStep / FRONT_SHARE * report.expectedElements
            assertTrue(most <= LONGEST) { "$most elements of the front between two questions" }
        }
    }

    @Test
    fun `a run ends at the very question that is answered with no`() {
        val domain = Domain.of(RandomLoops.ring(200))
        for (strategy in Strategy.entries) {
            val options = MeshOptions.builder().strategy(strategy).build()
            val whole = Counter().also { MeshGenerator.run(domain, options, StageClock(it, 0), null) }.count
            assertTrue(whole > 2 * Stage.entries.size) { "$whole questions" }
            for (last in 1..whole step Math.max(1, whole / 60)) {
                val counter = Counter(last)
                assertThrows<MeshingCancelledException> { MeshGenerator.run(domain, options, StageClock(counter, 0), null) }
                assertEquals(last, counter.count)
            }
        }
    }

    @TestFactory
    fun `progress never falls, tells every stage and ends at one`(): List<DynamicTest> =
        RandomDomains.small.map { family -> DynamicTest.dynamicTest(family.name) { requireSteady(family, 3) } }

    @Tag("corpus")
    @TestFactory
    fun `progress never falls on many domains`(): List<DynamicTest> =
        RandomDomains.families.map { family ->
            DynamicTest.dynamicTest(family.name) {
                for (seed in 300L until 400L) if (seed % family.every == 0L) requireSteady(family, seed)
            }
        }

    private fun requireSteady(family: RandomDomains.Family, seed: Long) {
        val domain = family.make(seed)
        val options = FuzzRun.options(seed)
        val quick = options.toBuilder().improve(false).numbering(NumberingMethod.NONE).build()
        for (chosen in listOf(options, quick)) {
            val counter = Counter()
            try {
                MeshGenerator.run(domain, chosen, StageClock(counter, 0), null)
            } catch (_: TooManyElementsException) {
                // The options of the run set a limit, which a few of the large domains exceed.
                return
            }
            assertEquals(0.0, counter.fell) { "${family.name} $seed" }
            assertEquals(1.0, counter.fraction)
            assertEquals(Stage.entries, counter.stages.toList())
        }
    }

    private companion object {
        /** Nodes or elements between two questions: what takes some milliseconds at the most. */
        const val LONGEST = 1024

        /** What StageClock gives to the front. */
        const val FRONT_SHARE = 0.34
    }
}
