package org.trigrid.editor.meshing

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.editor.command.ProjectCommands
import org.trigrid.editor.session.drawWith
import org.trigrid.editor.session.newSession
import org.trigrid.editor.tool.ShapeKind

class FrontPlaybackTest {
    private val session = newSession()

    private fun film(): FrontPlayback {
        session.drawWith(ShapeKind.RECTANGLE, 0.0, 0.0, 6.0, 4.0)
        session.playFront()
        return assertNotNull(session.playback).let { session.playback!! }
    }

    @Test
    fun `it steps on and back, from the boundary to nothing`() {
        val film = film()
        assertEquals(20, film.front.size / 2)
        val first = film.currentSide!!
        film.step(1)
        assertEquals(0, film.lastElement)
        assertArrayEquals(first, intArrayOf(film.trace.nodeOf(0, 0), film.trace.nodeOf(0, 1)))
        film.step(-5)
        assertEquals(0, film.position)
        film.goTo(film.length)
        assertEquals(0, film.front.size)
        assertNull(film.currentSide)
        assertTrue("${film.length} of ${film.length}" in film.words)
    }

    @Test
    fun `it plays at its speed, stops at the end and begins again`() {
        val film = film()
        film.speed = FrontPlayback.Speed.SLOW
        assertFalse(film.pass(1.0))
        film.toggle()
        repeat(10) { film.pass(0.1) }
        assertTrue(film.position in 4..5)
        film.toggle()
        assertFalse(film.pass(1.0))
        film.toggle()
        film.pass(1e6)
        assertEquals(film.length, film.position)
        assertFalse(film.isPlaying)
        film.toggle()
        assertEquals(0, film.position)
        assertTrue(film.isPlaying)
    }

    @Test
    fun `a change of the drawing ends it, and a large mesh is refused`() {
        film()
        session.drawWith(ShapeKind.CIRCLE, 3.0, 2.0, 4.0, 2.0)
        assertNull(session.playback)
        session.execute(ProjectCommands.options("at most", session.document.project.options.toBuilder().maxElements(10).build()))
        session.playFront()
        assertNull(session.playback)
        assertTrue(session.isMessageError)
    }
}
