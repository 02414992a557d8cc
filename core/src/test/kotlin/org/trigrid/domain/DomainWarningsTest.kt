package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.domain.WarningKind.CLOSE_LOOPS
import org.trigrid.domain.WarningKind.NARROW_GAP
import org.trigrid.domain.WarningKind.SHARP_ANGLE
import org.trigrid.domain.WarningKind.SPACING_JUMP

class DomainWarningsTest {
    @Test
    fun `an even outline has none`() {
        assertWarnings(rectangle(0.0, 0.0, 10.0, 10.0))
        assertWarnings(Domain.of(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 0.5, 0.8)).respaced(0.1, 1.0))
        assertWarnings(Domain.of(doubleArrayOf(0.0, 0.0, 3.0, 0.0, 3.0, 1.0, 0.0, 1.0)).respaced(1.0, 1.0))
    }

    @Test
    fun `a narrow gap is told once, at its narrowest place`() {
        val neck = Domain.of(
            doubleArrayOf(0.0, 0.0, 10.0, 0.0, 15.0, 4.9, 20.0, 0.0, 30.0, 0.0, 30.0, 10.0, 20.0, 10.0, 15.0, 5.1, 10.0, 10.0, 0.0, 10.0),
        ).respaced(1.0, 1.0)
        val warnings = assertWarnings(neck, NARROW_GAP)
        assertTrue(warnings.any { it.x == 15.0 && (it.y == 4.9 || it.y == 5.1) })
        assertTrue(warnings.size <= 2)
    }

    @Test
    fun `an opening close to the outline`() {
        val domain = Domain.builder().outer(square(0.0, 0.0, 10.0)).hole(square(3.0, 0.2, 4.0)).build().respaced(1.0, 1.0)
        assertWarnings(domain, CLOSE_LOOPS)
        val apart = Domain.builder().outer(square(0.0, 0.0, 10.0)).hole(square(3.0, 3.0, 4.0)).build().respaced(1.0, 1.0)
        assertWarnings(apart)
    }

    @Test
    fun `sharp angles and jumps of the spacing`() {
        val wedge = Domain.of(doubleArrayOf(0.0, 0.0, 10.0, 0.0, 10.0, 0.5))
        val warnings = DomainCheck.warnings(wedge).groupBy { it.kind }
        assertEquals(listOf(0), warnings.getValue(SHARP_ANGLE).map { it.nodes()[0] })
        assertEquals(listOf(1, 2), warnings.getValue(SPACING_JUMP).map { it.nodes()[0] })
        val hole = Domain.builder().outer(square(-20.0, -20.0, 40.0)).hole(doubleArrayOf(0.0, 0.0, 10.0, 0.0, 10.0, 0.5)).build()
        assertTrue(DomainCheck.warnings(hole).none { it.kind == SHARP_ANGLE })
    }

    private fun assertWarnings(domain: Domain, vararg kinds: WarningKind): List<DomainWarning> {
        val warnings = DomainCheck.warnings(domain)
        assertEquals(kinds.toSet(), warnings.map { it.kind }.toSet()) { warnings.joinToString("\n") }
        return warnings
    }

    private fun rectangle(x: Double, y: Double, width: Double, height: Double) =
        Domain.of(doubleArrayOf(x, y, x + width, y, x + width, y + height, x, y + height)).respaced(1.0, 1.0)

    private fun square(x: Double, y: Double, side: Double) = doubleArrayOf(x, y, x + side, y, x + side, y + side, x, y + side)
}
