package org.trigrid.project

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.geometry.Point2

class BackgroundTest {
    private val picture = Background("photos/hand.png", Point2(-3.0, 1.5), 0.01, 30.0, 0.4, false)

    @Test
    fun `background and colours are read back`() {
        val colours = linkedMapOf("skin" to "#d55e00", "domain" to "#0072B2")
        val project = Project.builder().background(picture).colours(colours).build()
        val text = ProjectFile.format(project)
        val again = ProjectFile.parse(text, "again")
        assertEquals(text, ProjectFile.format(again))
        assertEquals(colours.toList(), again.colours.toList())
        val read = assertNotNull(again.background).let { again.background!! }
        assertEquals("photos/hand.png", read.file)
        assertEquals(Point2(-3.0, 1.5), read.lowerLeft)
        assertEquals(30.0, read.rotationDegrees)
        assertEquals(0.4, read.opacity)
        assertFalse(read.isLocked)
        assertEquals(text, ProjectFile.format(again.toBuilder().build()))
    }

    @Test
    fun `it is scaled and turned about a place that stays`() {
        val centre = Point2(1.0, 1.0)
        val pixel = Point2(320.0, 200.0)
        val before = picture.placement().apply(pixel)
        val scaled = picture.scaled(centre, 2.0).placement().apply(pixel)
        assertEquals(1 + 2 * (before.x - 1), scaled.x, 1e-12)
        assertEquals(1 + 2 * (before.y - 1), scaled.y, 1e-12)
        val turned = picture.rotated(centre, 90.0).placement().apply(pixel)
        assertEquals(1 - (before.y - 1), turned.x, 1e-12)
        assertEquals(1 + (before.x - 1), turned.y, 1e-12)
    }

    @Test
    fun `what cannot be is refused with its place`() {
        for (bad in listOf(
            """"colours": {"a": "red"}""", """"colours": {"a": 1}""",
            """"background": {"file": "", "lowerLeft": [0, 0], "pixelSize": 1}""",
            """"background": {"file": "a.png", "lowerLeft": [0, 0], "pixelSize": 0}""",
            """"background": {"file": "a.png", "lowerLeft": [0, 0], "pixelSize": 1, "opacity": 2}""",
            """"background": {"file": "a.png", "lowerLeft": [0, 0], "pixelSize": 1, "colour": 2}""",
        )) {
            assertThrows(FileFormatException::class.java) { ProjectFile.parse("""{"format": "trigrid", "version": 1, $bad}""", "bad") }
        }
    }
}
