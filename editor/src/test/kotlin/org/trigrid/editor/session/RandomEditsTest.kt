package org.trigrid.editor.session

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.TriGridException
import org.trigrid.editor.command.AddShapes
import org.trigrid.editor.command.ConnectOpenings
import org.trigrid.editor.command.DeleteSelection
import org.trigrid.editor.command.ProjectCommands
import org.trigrid.editor.command.ShapeCommands
import org.trigrid.editor.command.SpreadNodes
import org.trigrid.editor.command.TransformSelection
import org.trigrid.editor.document.Selection
import org.trigrid.editor.tool.PointerInput
import org.trigrid.editor.tool.ShapeKind
import org.trigrid.geometry.Point2
import org.trigrid.project.NodeLoop
import org.trigrid.project.Project
import org.trigrid.project.ProjectFile
import org.trigrid.shape.Similarity
import java.util.Random

/** Hands that do anything at any moment: nothing fails, nothing is lost, all is undone. */
class RandomEditsTest {
    @Test
    fun `whatever is done is undone, redone, saved and read back`() {
        for (seed in 1L..FEW) check(seed)
    }

    @Test
    @Tag("corpus")
    fun `whatever is done, many times`() {
        for (seed in FEW + 1..MANY) check(seed)
    }

    private fun check(seed: Long) {
        val session = newSession()
        session.isLive = seed % LIVE == 0L
        val random = Random(seed)
        repeat(STEPS) { step ->
            val before = text(session)
            try {
                if (session.document.nodes.count > MOST_NODES) session.undo() else act(session, random)
                assertFalse(session.message.startsWith("The mesh could not be made"), session.message)
                assertTrue(session.document.arrows.size >= 0 && session.document.outlines.all { it.stepCount >= 0 })
            } catch (error: Exception) {
                throw AssertionError("seed $seed, step $step, after $before", error)
            }
        }
        repeat(STEPS) { session.tool.backspace() }
        session.selectTool()
        session.isLive = false
        val end = text(session)
        assertEquals(end, ProjectFile.format(read(end, seed)))
        travel(session, seed)
    }

    /** To the begin and back, by way of the same drawings. */
    private fun travel(session: EditorSession, seed: Long) {
        val texts = ArrayList<String>()
        while (session.undoName != null) {
            texts.add(text(session))
            session.undo()
        }
        assertTrue(session.document.isEmpty, "seed $seed")
        assertFalse(session.isModified)
        for (wanted in texts.reversed()) {
            session.redo()
            assertEquals(wanted, text(session), "seed $seed")
        }
    }

    private fun read(text: String, seed: Long): Project = try {
        ProjectFile.parse(text, "seed $seed")
    } catch (error: TriGridException) {
        throw AssertionError("what was written cannot be read: $text", error)
    }

    private fun text(session: EditorSession): String = ProjectFile.format(session.document.project)

    private fun act(session: EditorSession, random: Random) {
        when (random.nextInt(24)) {
            0, 1, 2 -> draw(session, random)
            3 -> session.draw(ShapeKind.entries[random.nextInt(ShapeKind.entries.size)])
            4, 5, 6 -> session.press(input(random).also { session.move(it) })
            7 -> session.release(input(random))
            8, 9 -> session.dragFrom(place(random), place(random), place(random), place(random), random.nextBoolean())
            10 -> session.selectTool(random.nextBoolean())
            11 -> session.withTool { it.enter() || it.backspace() || it.cancel() }
            12 -> session.tool.typed(Point2(place(random), place(random)))
            13 -> pick(session, random)
            14 -> if (random.nextInt(3) == 0) session.execute(DeleteSelection(session.selection))
            15 -> session.undo()
            16 -> session.redo()
            17 -> transform(session, random)
            18 -> session.problems.getOrNull(if (session.problems.isEmpty()) 0 else random.nextInt(session.problems.size))?.fix?.let { session.execute(it) }
            19 -> session.execute(ConnectOpenings(ConnectOpenings.of(session.document, session.selection)))
            20 -> spread(session, random)
            21 -> walk(session, random)
            22 -> paste(session, random)
            23 -> session.execute(ProjectCommands.renameGroup(session.document.groups.firstOrNull() ?: "boundary", "group ${random.nextInt(4)}"))
        }
    }

    private fun draw(session: EditorSession, random: Random) {
        session.draw(ShapeKind.entries[random.nextInt(ShapeKind.entries.size)])
        repeat(2 + random.nextInt(4)) { session.click(place(random), place(random), shift = random.nextInt(5) == 0, alt = random.nextInt(5) == 0) }
        session.tool.enter()
    }

    private fun pick(session: EditorSession, random: Random) {
        val document = session.document
        if (document.isEmpty) return
        session.select(
            when (random.nextInt(4)) {
                0 -> Selection.all(document)
                1 -> Selection(nodes = (0..random.nextInt(3)).map { random.nextInt(document.nodes.count) }.toSet())
                2 -> if (document.path.shapeCount > 0) Selection.ofShape(random.nextInt(document.path.shapeCount)) else Selection.NONE
                else -> Selection.NONE
            },
        )
    }

    private fun transform(session: EditorSession, random: Random) {
        val by = when (random.nextInt(4)) {
            0 -> Similarity.translation(place(random) - 5, place(random) - 5)
            1 -> Similarity.rotation(Point2(5.0, 5.0), 15.0 * random.nextInt(24))
            2 -> Similarity.scaling(Point2(5.0, 5.0), if (random.nextBoolean()) 2.0 else 0.5)
            else -> Similarity.reflection(Point2(0.0, 0.0), Point2(1.0, 1.0))
        }
        session.execute(TransformSelection(by, "transform"))
    }

    private fun spread(session: EditorSession, random: Random) {
        val count = session.document.nodes.count
        if (count < 2) return
        val a = random.nextInt(count)
        val b = random.nextInt(count)
        if (a != b) session.execute(SpreadNodes(a, b, 0.3 + random.nextDouble(), 0.5 + random.nextDouble()))
    }

    private fun walk(session: EditorSession, random: Random) {
        session.execute(
            when (random.nextInt(5)) {
                0 -> ShapeCommands.closeLoop()
                1 -> ShapeCommands.goBack()
                2 -> ShapeCommands.beginLoop()
                3 -> ShapeCommands.reverse(session.selection.shapes)
                else -> ShapeCommands.rebuild(session.selection.shapes)
            },
        )
    }

    private fun paste(session: EditorSession, random: Random) {
        val clip = Clip.of(session.document, session.selection)
        val x = place(random)
        val loop = NodeLoop(doubleArrayOf(x, 0.0, x + 2, 0.0, x, 3.0), "pasted")
        session.execute(AddShapes(clip.shapes, if (random.nextBoolean()) clip.loops + loop else clip.loops, "paste"))
    }

    private fun input(random: Random) = PointerInput(
        place(random), place(random), PIXEL * 3, random.nextInt(4) == 0, random.nextInt(4) == 0, clickCount = 1 + random.nextInt(4) / 3,
    )

    /** Round ones meet, others do not. */
    private fun place(random: Random): Double = if (random.nextInt(3) > 0) random.nextInt(11).toDouble() else 10 * random.nextDouble()

    private companion object {
        const val MOST_NODES = 160
        const val FEW = 12L
        const val MANY = 500L
        const val STEPS = 100

        /** One in so many is meshed at every step. */
        const val LIVE = 4L
    }
}
