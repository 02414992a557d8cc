package org.trigrid.quality

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.trigrid.mesh.TriMesh

class ElementFiguresTest {
    private val mesh = TriMesh.of(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 2.0, 2.0), intArrayOf(0, 1, 2, 1, 3, 2))

    @Test
    fun `each element has its own figures`() {
        val figures = ElementFigures.of(mesh)
        assertEquals(2, figures.elementCount)
        assertEquals(45.0, figures.minAngle(0), 1e-12)
        assertEquals(90.0, figures.maxAngle(0), 1e-12)
        assertEquals(Math.sqrt(3.0) / 2, figures.quality(0), 1e-12)
    }

    @Test
    fun `the report says of the worst element what its figures are`() {
        val worst = QualityReport.of(mesh).worstElements.first()
        val figures = ElementFigures.of(mesh)
        assertEquals(worst.quality, figures.quality(worst.element))
        assertEquals(worst.minAngle, figures.minAngle(worst.element))
    }
}
