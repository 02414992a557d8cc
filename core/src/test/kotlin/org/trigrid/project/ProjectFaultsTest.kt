package org.trigrid.project

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.FaultKind
import org.trigrid.domain.Path
import org.trigrid.shape.Circle
import org.trigrid.shape.Line
import org.trigrid.shape.Lines
import org.trigrid.shape.Rectangle

class ProjectFaultsTest {
    private val crossed = Path.of(Lines.of(1.0, 0.0, 0.0, 8.0, 0.0, 2.0, 5.0, 8.0, 5.0, 0.0, 0.4))

    private fun kinds(path: Path) = Project.of(path).faults().map { it.kind }

    @Test
    fun `lines that cross are found though walks are open, several of them too`() {
        assertEquals(listOf(FaultKind.OPEN_WALK, FaultKind.CROSSING), kinds(crossed))
        val more = crossed.newLoop().append(Lines.of(1.0, 20.0, 0.0, 24.0, 4.0, 24.0, 0.0, 20.0, 3.0)).newLoop()
            .append(Rectangle(40.0, 0.0, 44.0, 4.0, 1.0)).newLoop().append(Rectangle(41.5, 1.5, 45.5, 5.5, 1.0))
        assertEquals(listOf(2, 4), listOf(FaultKind.OPEN_WALK, FaultKind.CROSSING).map { kind -> kinds(more).count { it == kind } })
    }

    @Test
    fun `what only the missing segment would meet is no fault`() {
        val path = Path.of(Lines.of(1.0, 0.0, 0.0, 6.0, 0.0, 6.0, 4.0, 0.0, 4.0)).newLoop().append(Circle(0.0, 2.0, 1.0, 0.5))
        assertEquals(listOf(FaultKind.OPEN_WALK), kinds(path))
        assertEquals(listOf(FaultKind.OPEN_WALK), kinds(Path.of(Line(0.0, 0.0, 1.0, 0.0, 1.0))))
    }

    @Test
    fun `a domain without faults has none, one with faults has those of the domain`() {
        assertTrue(kinds(Path.of(Rectangle(0.0, 0.0, 4.0, 4.0, 1.0))).isEmpty())
        assertTrue(FaultKind.CROSSING in kinds(Path.of(Rectangle(0.0, 0.0, 4.0, 4.0, 1.0)).newLoop().append(Rectangle(1.5, 1.5, 5.5, 5.5, 1.0))))
    }
}
