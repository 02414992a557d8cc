package org.trigrid.cli.bench

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource
import org.trigrid.MeshGenerator
import org.trigrid.domain.DomainCheck

class BenchmarkDomainsTest {
    @ParameterizedTest
    @EnumSource(BenchmarkFamily::class, names = ["SIEVE"], mode = EnumSource.Mode.EXCLUDE)
    fun `a domain has about the elements asked for`(family: BenchmarkFamily) {
        val wanted = 3e4
        val elements = MeshGenerator.generate(BenchmarkDomains.create(family, wanted)).mesh.elementCount
        assertEquals(1.0, elements / wanted, 0.2, "$elements elements")
    }

    @ParameterizedTest
    @EnumSource(BenchmarkFamily::class)
    fun `small domains are valid too`(family: BenchmarkFamily) {
        val domain = BenchmarkDomains.create(family, 100.0)
        assertTrue(DomainCheck.check(domain).isEmpty())
    }

    @Test
    fun `plates have the holes of their names`() {
        assertEquals(201, BenchmarkDomains.create(BenchmarkFamily.PLATE, 1e3).loopCount)
        assertEquals(2, BenchmarkDomains.create(BenchmarkFamily.HOLE, 1e3).loopCount)
        assertEquals(10_001, BenchmarkDomains.create(BenchmarkFamily.SIEVE, 1e3).loopCount)
    }

    @ParameterizedTest
    @EnumSource(BenchmarkFamily::class, names = ["COAST", "AIRFOIL"])
    fun `a domain is the same each time`(family: BenchmarkFamily) {
        val first = BenchmarkDomains.create(family, 5e3).nodeCoordinates()
        assertArrayEquals(first, BenchmarkDomains.create(family, 5e3).nodeCoordinates())
    }

    @Test
    fun `numbers of elements that make no sense are refused`() {
        for (elements in listOf(0.0, -1.0, Double.NaN, 1e9)) {
            assertThrows(IllegalArgumentException::class.java) { BenchmarkDomains.create(BenchmarkFamily.SQUARE, elements) }
        }
    }
}
