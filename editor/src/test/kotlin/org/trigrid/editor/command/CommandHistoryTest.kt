package org.trigrid.editor.command

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.document.EditorState
import org.trigrid.shape.Circle
import org.trigrid.shape.Line

class CommandHistoryTest {
    private val history = CommandHistory(EditorState(EditorDocument.EMPTY))

    private fun append(name: String, key: Any? = null) = EditCommand.of(name, key) {
        EditorState(it.document.withPath(it.document.path.append(Circle(0.0, 0.0, 1.0, 0.5))))
    }

    @Test
    fun `undo brings back the very document`() {
        val before = history.state.document
        history.execute(append("a"))
        val after = history.state.document
        assertTrue(history.undo())
        assertSame(before, history.state.document)
        assertTrue(history.redo())
        assertSame(after, history.state.document)
        assertFalse(history.redo())
    }

    @Test
    fun `steps are named`() {
        history.execute(append("a"))
        history.execute(append("b"))
        history.undo()
        assertEquals("a", history.undoName)
        assertEquals("b", history.redoName)
        assertEquals(listOf("a", "b"), history.names)
    }

    @Test
    fun `a new step takes the place of what was undone`() {
        history.execute(append("a"))
        history.undo()
        history.execute(append("c"))
        assertNull(history.redoName)
        assertEquals(listOf("c"), history.names)
    }

    @Test
    fun `commands with one key are one step until something ends it`() {
        history.execute(append("pull", "k"))
        history.execute(append("pull", "k"))
        assertEquals(1, history.names.size)
        history.endMerging()
        history.execute(append("pull", "k"))
        assertEquals(2, history.names.size)
        history.undo()
        history.undo()
        assertEquals(0, history.state.document.path.shapeCount)
    }

    @Test
    fun `what was saved is never merged away`() {
        history.execute(append("pull", "k"))
        history.markSaved()
        history.execute(append("pull", "k"))
        assertTrue(history.isModified)
        history.undo()
        assertFalse(history.isModified)
    }

    @Test
    fun `nothing done is no step`() {
        assertFalse(history.execute(EditCommand.of("nothing") { it }))
        assertNull(history.undoName)
    }

    @Test
    fun `a refused command changes nothing`() {
        val before = history.state
        assertThrows(org.trigrid.diagnostics.InvalidShapeException::class.java) {
            history.execute(EditCommand.of("bad") { it.also { Line(0.0, 0.0, 0.0, 0.0, 1.0) } })
        }
        assertSame(before, history.state)
        assertTrue(history.execute(append("a")))
    }

    @Test
    fun `a command must not start another`() {
        assertThrows(IllegalStateException::class.java) {
            history.execute(EditCommand.of("outer") { state -> state.also { history.execute(append("inner")) } })
        }
    }
}
