package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import java.nio.file.Path

class DomainWritersTest {
    @TempDir
    lateinit var folder: Path

    private val ringed: Domain = Domain.builder()
        .outer(doubleArrayOf(0.0, 0.0, 9.0, 0.0, 9.0, 9.1, 0.0, 9.0), "rim")
        .hole(doubleArrayOf(1.0, 1.0, 8.0, 1.0, 8.0, 8.0, 1.0, 1 / 3.0 + 7), "bore")
        .outer(doubleArrayOf(4.0, 4.0, 5.0, 4.0, 5.0, 5.0), "isle").build()

    @Test
    fun `a domain with an island comes back from every format`() {
        for (format in DomainFormats.all().filter { it.canWrite }) {
            val file = folder.resolve("d" + format.endings[0])
            DomainFormats.write(listOf(NamedDomain("one", ringed)), file, format)
            val back = DomainFormats.read(file)
            assertEquals(ringed.area, back.sumOf { it.domain.area }, 1e-12, format.name)
            for (named in back) assertEquals(emptyList<Any>(), DomainCheck.check(named.domain), format.name)
            val places = back.flatMap { named -> (0 until named.domain.nodeCount).map { named.domain.x(it) to named.domain.y(it) } }
            assertEquals((0 until ringed.nodeCount).map { ringed.x(it) to ringed.y(it) }.toSet(), places.toSet(), format.name)
        }
    }

    @Test
    fun `a hole point is in the hole, beside the island`() {
        val points = HolePoints.of(ringed)
        assertEquals(2, points.size)
        val others = HolePoints.of(Domain.of(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0)))
        assertArrayEquals(doubleArrayOf(), others)
    }

    @Test
    fun `several domains go where there is room for them`() {
        val two = listOf(NamedDomain("a \"b\" é", ringed), NamedDomain("b", ringed))
        assertThrows(IllegalArgumentException::class.java) { DomainFormats.write(two, folder.resolve("x.poly"), DomainFormat.POLY) }
        DomainFormats.write(two, folder.resolve("x.geojson"), DomainFormat.GEOJSON)
        assertEquals("a \"b\" é_1", DomainFormats.read(folder.resolve("x.geojson")).first().name)
    }
}
