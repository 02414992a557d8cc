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
    fun `an outline mirrored, turned by any angle or told in another order gives much the same mesh`() {
        for (family in families) {
            val domain = family.make(8)
            requireAlike(family, 8, sameToTheBit(domain) + turned(domain), SMALL)
        }
    }

    @Tag("corpus")
    @Test
    fun `so do many outlines, nearly all of them the same mesh`() {
        var pairs = 0
        var same = 0
        for (family in families) {
            for (seed in 600L until 625L) {
                val domain = family.make(seed)
                val shares = requireAlike(family, seed, sameToTheBit(domain) + turned(domain), SMALL)
                pairs += shares.size
                same += shares.count { it == 1.0 }
            }
        }
        assertTrue(pairs > 1000 && same > 0.97 * pairs) { "the same count in $same of $pairs" }
    }

    @Test
    fun `an outline turned and moved keeps its mesh, with regions, lines and points`() {
        val star = RandomLoops.star(java.util.Random(5), 40, 0.3, 1)
        val domain = Domain.builder().loop(star).hole(doubleArrayOf(0.2, 0.1, 0.3, 0.1, 0.3, 0.25)).embed(doubleArrayOf(-0.2, 0.0, -0.1, 0.1), "line")
            .embedPoint(0.1, -0.2, "point").build()
        val mesh = MeshGenerator.generate(domain).mesh
        for (angle in listOf(0.3, 1.0, 2.0)) {
            val cos = StrictMath.cos(angle)
            val sin = StrictMath.sin(angle)
            val turned = mapped(domain) { x, y -> doubleArrayOf(5 + cos * x - sin * y, sin * x + cos * y - 3) }
            val other = MeshGenerator.generate(turned).mesh
            assertEquals(emptyList<Any>(), MeshCheck.check(other, turned))
            assertEquals(mesh.nodeCount, other.nodeCount)
            assertEquals(mesh.elementCount, other.elementCount)
            for (node in 0 until mesh.nodeCount) {
                val x = 5 + cos * mesh.x(node) - sin * mesh.y(node)
                val y = sin * mesh.x(node) + cos * mesh.y(node) - 3
                assertTrue((0 until other.nodeCount).any { Math.abs(other.x(it) - x) + Math.abs(other.y(it) - y) < 1e-9 }) { "node $node" }
            }
        }
    }

    @Test
    fun `an outline without symmetry keeps its mesh, mirrored`() {
        val domain = Domain.of(RandomLoops.star(java.util.Random(5), 40, 0.3, 1))
        val mesh = MeshGenerator.generate(domain).mesh
        val mirrored = MeshGenerator.generate(reversed(mapped(domain) { x, y -> doubleArrayOf(-x, y) })).mesh
        val places = (0 until mesh.nodeCount).map { mesh.x(it) to mesh.y(it) }
        assertEquals(places.toSet(), (0 until mirrored.nodeCount).map { -mirrored.x(it) to mirrored.y(it) }.toSet())
    }

    /** Outlines whose coordinates are the same numbers, mirrored, turned by quarters and with loops told otherwise. */
    private fun sameToTheBit(domain: Domain): Map<String, Domain> {
        val loops = (0 until domain.loopCount).map { (domain.loopStart(it) until domain.loopStart(it + 1)).toList() }
        return mapOf(
            "mirrored" to reversed(mapped(domain) { x, y -> doubleArrayOf(-x, y) }),
            "turned once" to mapped(domain) { x, y -> doubleArrayOf(-y, x) },
            "turned twice" to mapped(domain) { x, y -> doubleArrayOf(-x, -y) },
            "loops shifted" to ordered(domain, loops.flatMap { it.drop(it.size / 3) + it.take(it.size / 3) }),
            "loops in another order" to ordered(domain, loops.reversed().flatten()),
        )
    }

    /** By one radian and by 30 degrees, where rounding leaves the outline what it was. */
    private fun turned(domain: Domain): Map<String, Domain> = listOf(1.0, Math.PI / 6).associate { angle ->
        val cos = StrictMath.cos(angle)
        val sin = StrictMath.sin(angle)
        "turned by $angle" to mapped(domain) { x, y -> doubleArrayOf(cos * x - sin * y, sin * x + cos * y) }
    }.filterValues { isSameOutline(domain, it) }

    /** Turned by one radian, nodes some thousands of units in the last place apart come to lie otherwise, or fall together. */
    private fun isSameOutline(domain: Domain, other: Domain): Boolean {
        val lengths = DoubleArray(domain.segmentCount) { domain.segmentLength(it) }
        val others = DoubleArray(other.segmentCount) { other.segmentLength(it) }
        lengths.sort()
        others.sort()
        return lengths.indices.all { Math.abs(others[it] / lengths[it] - 1) < SAME_LENGTH } && DomainCheck.check(other).isEmpty()
    }

    /** Of meshes of [least] elements on requires as many elements within 5 %; tells how many times as many. */
    private fun requireAlike(family: RandomDomains.Family, seed: Long, others: Map<String, Domain>, least: Int): Collection<Double> {
        val (count, shares) = sharesOf(family.make(seed), others) { "${family.name} $seed $it" }
        if (count < least) return emptyList()
        for ((what, share) in shares) assertTrue(share in 0.95..1.05) { "${family.name} $seed $what: $count elements, times $share" }
        return shares.values
    }

    /** How many elements [domain] gets, and how many times as many each of the others, whose meshes are checked. */
    private fun sharesOf(domain: Domain, others: Map<String, Domain>, name: (String) -> String): Pair<Int, Map<String, Double>> {
        val count = MeshGenerator.generate(domain).mesh.elementCount
        val shares = others.mapValues { (what, other) ->
            val mesh = MeshGenerator.generate(other).mesh
            assertEquals(emptyList<Any>(), MeshCheck.check(mesh, other)) { name(what) }
            mesh.elementCount.toDouble() / count
        }
        return Pair(count, shares)
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

        /** Below so many elements a node more or less may be 5 %. */
        const val SMALL = 300

        /** Segments' lengths change by less where coordinates tell the outline well. */
        const val SAME_LENGTH = 1e-6
    }
}
