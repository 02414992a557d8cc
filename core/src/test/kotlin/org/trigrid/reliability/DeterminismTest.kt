package org.trigrid.reliability

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.RandomDomains
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import org.trigrid.mesh.MeshCheck
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.Callable
import java.util.concurrent.Executors

/** The same input gives the same bytes; the same outline, told in another way, much the same mesh. */
class DeterminismTest {
    private val families = RandomDomains.families.filter { it.every == 1 }

    @Test
    fun `two runs and two threads give the same files`() {
        val expected = MeshDigests.lines(8, 9)
        val pool = Executors.newFixedThreadPool(2)
        val runs = List(2) { pool.submit(Callable { MeshDigests.lines(8, 9) }) }
        runs.forEach { assertEquals(expected, it.get()) }
        pool.shutdown()
    }

    @Tag("corpus")
    @Test
    fun `another Java version gives the same files`() {
        val java = otherJava()
        assumeTrue(java != null) { "no other Java is installed; $OTHER_JAVA may name one" }
        val command = listOf(java.toString(), "-Xmx1g", "-cp", System.getProperty("java.class.path"), MeshDigests::class.java.name, "8", "12")
        val process = ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start()
        val lines = process.inputStream.bufferedReader().readLines()
        assertEquals(0, process.waitFor())
        assertEquals(MeshDigests.lines(8, 12), lines)
    }

    private fun otherJava(): Path? {
        val named = System.getenv(OTHER_JAVA)?.let { Path.of(it) }
        if (named != null) return named.resolve("bin/java")
        val siblings = Path.of(System.getProperty("java.home")).toRealPath().parent
        val own = Runtime.version().feature().toString()
        return Files.list(siblings).use { all ->
            all.filter { Files.isExecutable(it.resolve("bin/java")) && own !in it.fileName.toString() && "25" in it.fileName.toString() }
                .map { it.resolve("bin/java") }.findFirst().orElse(null)
        }
    }

    @Test
    fun `a turned or mirrored outline gives much the same mesh`() {
        for (family in families) {
            val domain = family.make(8)
            requireAlike(family, domain, mapped(domain) { x, y -> doubleArrayOf(-y, x) }, "turned")
            requireAlike(family, domain, mapped(domain) { x, y -> doubleArrayOf(-x, -y) }, "turned twice")
            requireAlike(family, domain, reversed(mapped(domain) { x, y -> doubleArrayOf(-x, y) }), "mirrored")
        }
    }

    @Test
    fun `loops that begin elsewhere and in another order give much the same mesh`() {
        for (family in families) {
            val domain = family.make(8)
            val loops = (0 until domain.loopCount).map { (domain.loopStart(it) until domain.loopStart(it + 1)).toList() }
            val shifted = loops.flatMap { it.drop(it.size / 3) + it.take(it.size / 3) }
            requireAlike(family, domain, ordered(domain, shifted), "loops shifted")
            requireAlike(family, domain, ordered(domain, loops.reversed().flatten()), "loops in another order")
        }
    }

    @Tag("corpus")
    @Test
    fun `of many turned and mirrored outlines all but a few give as many elements within 5 percent`() {
        val beyond = ArrayList<String>()
        var pairs = 0
        for (family in families) {
            for (seed in 600L until 625L) {
                val domain = family.make(seed)
                val count = MeshGenerator.generate(domain).mesh.elementCount
                if (count < SMALL) continue
                val (cos, sin) = listOf(StrictMath.cos(1.0), StrictMath.sin(1.0))
                val others = listOf(
                    mapped(domain) { x, y -> doubleArrayOf(-y, x) },
                    mapped(domain) { x, y -> doubleArrayOf(cos * x - sin * y, sin * x + cos * y) },
                    reversed(mapped(domain) { x, y -> doubleArrayOf(-x, y) }),
                )
                for (other in others.filter { isSameOutline(domain, it) }) {
                    pairs++
                    val share = MeshGenerator.generate(other).mesh.elementCount.toDouble() / count
                    if (share !in 0.95..1.05) beyond.add("${family.name} $seed: $count elements, times $share")
                    assertTrue(share in 0.9..1.1) { beyond.last() }
                }
            }
        }
        assertTrue(pairs > 500 && beyond.size <= pairs / 100) { "${beyond.size} of $pairs: $beyond" }
    }

    /** Turned by one radian, nodes some units in the last place apart come to lie otherwise, or fall together. */
    private fun isSameOutline(domain: Domain, other: Domain): Boolean {
        val lengths = DoubleArray(domain.segmentCount) { domain.segmentLength(it) }
        val others = DoubleArray(other.segmentCount) { other.segmentLength(it) }
        lengths.sort()
        others.sort()
        return lengths.indices.all { Math.abs(others[it] / lengths[it] - 1) < 0.01 } && DomainCheck.check(other).isEmpty()
    }

    private fun requireAlike(family: RandomDomains.Family, domain: Domain, other: Domain, what: String) {
        val count = MeshGenerator.generate(domain).mesh.elementCount
        val mesh = MeshGenerator.generate(other).mesh
        assertEquals(emptyList<Any>(), MeshCheck.check(mesh, other)) { "${family.name} $what" }
        if (count < SIZEABLE) return
        val share = mesh.elementCount.toDouble() / count
        assertTrue(share in 0.95..1.05) { "${family.name} $what: $count and ${mesh.elementCount} elements" }
    }

    private fun mapped(domain: Domain, map: (Double, Double) -> DoubleArray): Domain {
        val xy = DoubleArray(domain.xy.size) { map(domain.x(it / 2), domain.y(it / 2))[it % 2] }
        return Domain(xy, domain.segments, domain.segmentTags, domain.embedded, domain.tags, domain.regionMap, domain.points)
    }

    /** Loops and lines the other way round, as a mirrored outline needs. */
    private fun reversed(domain: Domain): Domain {
        val count = domain.boundaryCount
        val segments = IntArray(domain.segments.size) {
            if (it < 2 * count) domain.segments[2 * count - 1 - it] else domain.segments[it xor 1]
        }
        val regions = domain.regionMap.ofParts(IntArray(domain.segmentCount) { if (it < count) count - 1 - it else it })
        return Domain(domain.xy, segments, domain.segmentTags, domain.embedded, domain.tags, regions, domain.points)
    }

    private fun ordered(domain: Domain, order: List<Int>): Domain {
        val all = order + (domain.boundaryCount until domain.segmentCount)
        val segments = IntArray(2 * all.size) { domain.segments[2 * all[it / 2] + it % 2] }
        val tags = IntArray(all.size) { domain.segmentTags[all[it]] }
        val regions = domain.regionMap.ofParts(all.toIntArray())
        return Domain(domain.xy, segments, tags, domain.embedded, domain.tags, regions, domain.points)
    }

    private companion object {
        const val OTHER_JAVA = "TRIGRID_OTHER_JAVA_HOME"
        /** Of a few hundred elements whose sizes differ by orders of magnitude, one tenth may come and go. */
        const val SIZEABLE = 1000
        const val SMALL = 500
    }
}
