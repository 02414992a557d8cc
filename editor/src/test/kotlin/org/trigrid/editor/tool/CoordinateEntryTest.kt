package org.trigrid.editor.tool

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.geometry.Point2

class CoordinateEntryTest {
    @Test
    fun `after the first number Tab goes on to the second`() {
        for (text in listOf("3", "@-1.5", " +2e3 ")) {
            assertTrue(CoordinateEntry.awaitsSecond(text), text)
            assertNotNull(CoordinateEntry.parse(CoordinateEntry.withSeparator(text) + "4", null))
        }
        for (text in listOf("", "3,", "3,4", "@2<", "x")) assertFalse(CoordinateEntry.awaitsSecond(text), text)
    }

    private val last = Point2(10.0, 20.0)

    @Test
    fun `places as they stand`() {
        assertEquals(Point2(3.0, 4.0), CoordinateEntry.parse("3,4", last))
        assertEquals(Point2(-3.5, 0.25), CoordinateEntry.parse(" -3.5 ; .25 ", last))
        assertEquals(Point2(1e3, -2e-3), CoordinateEntry.parse("1e3 -2e-3", last))
    }

    @Test
    fun `places from the last point`() {
        assertEquals(Point2(11.0, 20.0), CoordinateEntry.parse("@1,0", last))
        assertEquals(Point2(1.0, 0.0), CoordinateEntry.parse("@1,0", null))
    }

    @Test
    fun `length and angle`() {
        assertEquals(Point2(10.0, 22.0), CoordinateEntry.parse("@2<90", last))
        val place = CoordinateEntry.parse("@2<30", last)!!
        assertEquals(10 + Math.sqrt(3.0), place.x, 1e-12)
        assertEquals(21.0, place.y, 1e-12)
        assertEquals(Point2(-2.0, 0.0), CoordinateEntry.parse("2<180", last))
    }

    @Test
    fun `what is no place`() {
        for (text in listOf("", "3", "3,", "a,b", "@", "3,4,5", "2<", "1e999,0")) assertNull(CoordinateEntry.parse(text, last), text)
    }
}
