package org.trigrid.editor.canvas

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.trigrid.domain.Domain

class ViewTransformTest {
    private val box = Box.of(Domain.of(doubleArrayOf(-1.0, 2.0, 3.0, 2.0, 3.0, 4.0, -1.0, 4.0)))

    @Test
    fun `a box fills the screen as far as its margin and stands in the middle`() {
        val view = ViewTransform.fit(box, 440.0, 500.0, 20.0)
        assertEquals(100.0, view.scale, 1e-12)
        assertEquals(20.0, view.screenX(-1.0), 1e-9)
        assertEquals(420.0, view.screenX(3.0), 1e-9)
        assertEquals(150.0, view.screenY(4.0), 1e-9)
        assertEquals(350.0, view.screenY(2.0), 1e-9)
    }

    @Test
    fun `the way back from the screen ends where it began`() {
        val view = ViewTransform.fit(box, 640.0, 480.0, 30.0)
        assertEquals(1.25, view.domainX(view.screenX(1.25)), 1e-12)
        assertEquals(-7.5, view.domainY(view.screenY(-7.5)), 1e-12)
    }

    @Test
    fun `a box without extent is shown at one pixel per length`() {
        val point = Box.of(Domain.of(doubleArrayOf(5.0, 5.0, 5.0, 5.0, 5.0, 5.0)))
        val view = ViewTransform.fit(point, 100.0, 100.0, 10.0)
        assertEquals(1.0, view.scale)
        assertEquals(50.0, view.screenX(5.0), 1e-9)
    }

    @Test
    fun `coordinates that are no numbers do not count`() {
        val broken = Box.of(Domain.of(doubleArrayOf(0.0, 0.0, Double.NaN, 7.0, 1.0, 1.0)))
        assertEquals(1.0, broken.width)
        assertEquals(1.0, broken.height)
    }
}
