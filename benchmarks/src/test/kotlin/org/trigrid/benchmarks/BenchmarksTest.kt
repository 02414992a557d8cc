package org.trigrid.benchmarks

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.openjdk.jmh.runner.Runner
import org.openjdk.jmh.runner.options.OptionsBuilder
import org.openjdk.jmh.runner.options.TimeValue
import org.openjdk.jmh.runner.options.VerboseMode
import java.nio.file.Files

/** The benchmarks run: once each, on a small domain, without a process of their own. */
class BenchmarksTest {
    @Test
    fun `every benchmark runs`() {
        val log = Files.createTempFile("trigrid-jmh", ".log")
        val options = OptionsBuilder()
            .include("org\\.trigrid\\.benchmarks\\..*")
            .param("family", "CIRCLE").param("elements", "1e2").param("format", "msh22")
            .forks(0).warmupIterations(0).measurementIterations(1).measurementTime(TimeValue.milliseconds(1))
            .shouldFailOnError(true).verbosity(VerboseMode.SILENT).output(log.toString())
            .build()
        val results = Runner(options).run()
        val names = results.map { it.params.benchmark.removePrefix("org.trigrid.benchmarks.") }.sorted()
        val expected = listOf(
            "FileBenchmark.read", "FileBenchmark.write", "StageBenchmark.advanceFront", "StageBenchmark.improvement",
            "StageBenchmark.renumbering", "StageBenchmark.sizes", "StageBenchmark.validation", "StageBenchmark.whole",
        )
        assertEquals(expected, names)
        for (result in results) assertTrue(result.primaryResult.score > 0, result.params.benchmark)
    }
}
