package org.trigrid.editor.canvas

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test

class ViewTransformTest {
    private val box = Box(-1.0, 2.0, 3.0, 4.0)

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
        val view = ViewTransform.fit(Box(5.0, 5.0, 5.0, 5.0), 100.0, 100.0, 10.0)
        assertEquals(1.0, view.scale)
        assertEquals(50.0, view.screenX(5.0), 1e-9)
    }

    @Test
    fun `zooming leaves the place under the mouse where it is`() {
        val view = ViewTransform.fit(box, 640.0, 480.0, 30.0)
        val closer = view.zoomed(2.5, 100.0, 333.0)
        assertEquals(view.scale * 2.5, closer.scale, 1e-9)
        assertEquals(view.domainX(100.0), closer.domainX(100.0), 1e-12)
        assertEquals(view.domainY(333.0), closer.domainY(333.0), 1e-12)
    }

    @Test
    fun `the sheet follows the mouse`() {
        val view = ViewTransform(10.0, 0.0, 0.0).panned(20.0, -30.0)
        assertEquals(20.0, view.screenX(0.0), 1e-12)
        assertEquals(-30.0, view.screenY(0.0), 1e-12)
    }

    @Test
    fun `no box of what is no number`() {
        assertNull(Box.of(null))
        assertNull(Box.of(doubleArrayOf(0.0, 0.0, Double.NaN, 1.0)))
    }
}
