package org.trigrid.reliability

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.assertThrows
import org.trigrid.MeshGenerator
import org.trigrid.RandomDomains
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import java.util.Random

/** Random valid domains broken in every way that validation names: each fault is told with its place, and nothing is meshed. */
@Timeout(120)
class BrokenDomainsTest {
    private val families = RandomDomains.families.filter { it.every < 10 && "ulp" !in it.name }

    @Test
    fun `each fault beside a valid domain is told alone`() {
        for (family in families) for (kind in KINDS) requireRefused(family.make(4), listOf(kind), "${family.name} $kind")
    }

    @Test
    fun `faults of several kinds at once are all told`() {
        val random = Random(5)
        for (family in families) {
            repeat(6) { seed ->
                val kinds = List(2 + random.nextInt(10)) { KINDS[random.nextInt(KINDS.size)] }
                requireRefused(family.make(seed.toLong()), kinds, "${family.name} $seed $kinds")
            }
        }
    }

    @Tag("corpus")
    @Test
    fun `many combinations of faults are all told`() {
        val random = Random(6)
        for (family in families) {
            repeat(150) { seed ->
                val kinds = List(1 + random.nextInt(12)) { KINDS[random.nextInt(KINDS.size)] }
                requireRefused(family.make(100L + seed), kinds, "${family.name} $seed $kinds")
            }
        }
    }

    @Test
    fun `a domain's own loops, broken, are refused`() {
        val random = Random(7)
        for (family in families) {
            for (seed in 0L until 4L) {
                val domain = family.make(seed)
                val node = domain.segmentStart(random.nextInt(domain.boundaryCount))
                requireKind(withCoordinate(domain, node, Double.NaN), FaultKind.NOT_A_NUMBER, node, family.name)
                requireKind(withCoordinate(domain, node, Double.NEGATIVE_INFINITY), FaultKind.NOT_A_NUMBER, node, family.name)
                val gone = random.nextInt(domain.boundaryCount)
                requireKind(without(domain, gone), FaultKind.OPEN_WALK, domain.segmentEnd(gone), family.name)
                val twice = random.nextInt(domain.boundaryCount)
                requireKind(withSegment(domain, twice, twice, false), FaultKind.OVERLAP, domain.segmentStart(twice), family.name)
                val still = domain.segmentEnd(twice)
                requireKind(withSegment(domain, still, still, true), FaultKind.ZERO_LENGTH, still, family.name)
                assertTrue(DomainCheck.check(turned(domain)).any { it.kind == FaultKind.HOLE_OUTSIDE }) { family.name }
                assertThrows<InvalidDomainException> { MeshGenerator.generate(turned(domain)) }
            }
        }
    }

    private fun requireRefused(valid: Domain, kinds: List<FaultKind>, what: String) {
        val broken = BrokenDomain(valid)
        // Open walks go side by side: between them nobody can say what is outside, as DomainCheck says.
        kinds.sortedBy { it == FaultKind.OPEN_WALK || it == FaultKind.NOT_A_NUMBER }.forEach { broken.add(it) }
        val domain = broken.domain()
        val faults = DomainCheck.check(domain)
        assertNull(broken.complaint(faults)) { "$what: ${broken.complaint(faults)}" }
        val thrown = assertThrows<InvalidDomainException> { MeshGenerator.generate(domain) }
        assertEquals(faults.map { it.toString() }, thrown.faults.map { it.toString() })
    }

    private fun requireKind(domain: Domain, kind: FaultKind, node: Int, what: String) {
        val faults = DomainCheck.check(domain)
        assertTrue(faults.any { it.kind == kind && node in it.nodes() }) { "$what: no $kind at node $node in $faults" }
        assertThrows<InvalidDomainException> { MeshGenerator.generate(domain) }
    }

    private fun withCoordinate(domain: Domain, node: Int, x: Double): Domain {
        val xy = domain.xy.copyOf()
        xy[2 * node] = x
        return Domain(xy, domain.segments, domain.segmentTags, domain.embedded, domain.tags, "domain")
    }

    private fun without(domain: Domain, segment: Int): Domain = changed(domain) { pairs -> pairs.removeAt(segment) }

    /** With another boundary segment: a copy of segment [a], or from node [a] to node [b]. */
    private fun withSegment(domain: Domain, a: Int, b: Int, byNodes: Boolean): Domain = changed(domain) { pairs ->
        pairs.add(domain.boundaryCount, if (byNodes) intArrayOf(a, b) else intArrayOf(domain.segmentStart(a), domain.segmentEnd(b)))
    }

    /** Every loop the other way round: holes without anything round them. */
    private fun turned(domain: Domain): Domain {
        val segments = IntArray(2 * domain.boundaryCount) { domain.segments[2 * domain.boundaryCount - 1 - it] }
        val count = domain.boundaryCount
        return Domain(domain.xy, segments, IntArray(count), BooleanArray(count), listOf("b"), "domain")
    }

    private fun changed(domain: Domain, change: (MutableList<IntArray>) -> Unit): Domain {
        val pairs = MutableList(domain.segmentCount) { intArrayOf(domain.segmentStart(it), domain.segmentEnd(it)) }
        change(pairs)
        val embedded = domain.segmentCount - domain.boundaryCount
        val isEmbedded = BooleanArray(pairs.size) { it >= pairs.size - embedded }
        return Domain(domain.xy, IntArray(2 * pairs.size) { pairs[it / 2][it % 2] }, IntArray(pairs.size), isEmbedded, listOf("b"), "domain")
    }

    private companion object {
        /** A domain of plain segments has no regions to tell wrong. */
        val KINDS = FaultKind.entries.filter { it != FaultKind.REGION_POINT }
    }
}
