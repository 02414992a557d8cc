package org.trigrid.editor.app

import javafx.scene.input.Clipboard
import javafx.scene.input.ClipboardContent
import org.trigrid.editor.canvas.DrawingCanvas
import org.trigrid.editor.command.AddShapes
import org.trigrid.editor.command.ConnectOpenings
import org.trigrid.editor.command.DeleteSelection
import org.trigrid.editor.command.TransformSelection
import org.trigrid.editor.document.Selection
import org.trigrid.editor.inspector.NumberQuestion
import org.trigrid.editor.session.Clip
import org.trigrid.editor.session.EditorSession
import org.trigrid.editor.tool.Figures
import org.trigrid.editor.tool.Grid
import org.trigrid.editor.tool.TwoPointTool
import org.trigrid.geometry.Point2
import org.trigrid.shape.Similarity

/** Copy and paste, mirror, turn, scale and repeat; connect, find and measure. */
internal class EditActions(private val session: EditorSession, private val canvas: DrawingCanvas, private val dialogs: Dialogs) {
    private val clip: Clip get() = Clip.of(session.document, session.selection)

    fun copy() {
        if (clip.isEmpty) return session.say("Pick shapes first, then copy them", true)
        Clipboard.getSystemClipboard().setContent(ClipboardContent().apply { putString(clip.toText()) })
        session.say("Copied")
    }

    fun cut() {
        copy()
        delete()
    }

    fun paste() {
        val text = Clipboard.getSystemClipboard().string ?: return session.say("There is nothing to paste", true)
        val pasted = Clip.parse(text)
        if (pasted == null || pasted.isEmpty) return session.say("Only shapes, projects and lists of points can be pasted", true)
        add(pasted, if (session.document.isEmpty) Similarity.translation(0.0, 0.0) else shift(), "paste")
        if (session.document.isEmpty) canvas.fit()
    }

    fun duplicate() = add(clip, shift(), "duplicate")

    fun delete() {
        if (!session.selection.isEmpty) session.execute(DeleteSelection(session.selection))
    }

    fun selectAll() = session.select(Selection.all(session.document))

    fun mirror() = session.use(
        TwoPointTool(session, "Mirror", "Click the first point of the mirror line", "Click its second point") { a, b ->
            session.execute(TransformSelection(Similarity.reflection(a, b), "mirror"))
            session.selectTool()
        },
    )

    fun rotate() {
        val middle = middle() ?: return
        val numbers = dialogs.askForNumbers("Rotate", NumberQuestion("Angle, degrees", 90.0), *centre(middle)) ?: return
        session.execute(TransformSelection(Similarity.rotation(Point2(numbers[1], numbers[2]), numbers[0]), "rotate"))
    }

    fun scale() {
        val middle = middle() ?: return
        val numbers = dialogs.askForNumbers("Scale", NumberQuestion.positive("Factor", 2.0), *centre(middle)) ?: return
        session.execute(TransformSelection(Similarity.scaling(Point2(numbers[1], numbers[2]), numbers[0]), "scale"))
    }

    fun array() {
        if (clip.isEmpty) return session.say("Pick shapes first, then repeat them", true)
        val step = ARRAY_STEPS * Grid.stepFor(canvas.transform.pixel)
        val numbers = dialogs.askForNumbers(
            "Repeat in rows and columns",
            NumberQuestion.whole("Columns", 3, 1..MOST_COPIES), NumberQuestion.whole("Rows", 1, 1..MOST_COPIES),
            NumberQuestion("Distance in x", step), NumberQuestion("Distance in y", step),
        ) ?: return
        val columns = numbers[0].toInt()
        val rows = numbers[1].toInt()
        val copies = (0 until rows * columns).drop(1)
            .map { clip.moved(Similarity.translation(it % columns * numbers[2], it / columns * numbers[3])) }
        session.execute(AddShapes(copies.flatMap { it.shapes }, copies.flatMap { it.loops }, "array"))
    }

    /** Joins the openings that are picked, or all where nothing is. */
    fun connectOpenings() {
        val document = session.document
        val openings = ConnectOpenings.of(document, session.selection)
        when {
            openings.isNotEmpty() -> if (session.execute(ConnectOpenings(openings))) session.say("Connected")
            session.selection.isEmpty -> session.say("There is no opening without a connector", true)
            else -> session.say("What is picked is no opening without a connector", true)
        }
    }

    fun findNode() {
        val nodes = session.document.nodes
        if (nodes.count == 0) return session.say("There is no node yet", true)
        val picked = session.selection.nodes.singleOrNull() ?: 0
        val question = NumberQuestion.whole("Number", picked, 0 until nodes.count)
        val number = dialogs.askForNumbers("Find node", question)?.first()?.toInt() ?: return
        session.selectTool()
        session.select(Selection.ofNode(number))
        canvas.lookAt(nodes.x(number), nodes.y(number))
    }

    fun measure() = session.use(
        TwoPointTool(session, "Measure", "Click the first point", "Click the second point") { a, b ->
            session.say("From ${place(a)} to ${place(b)}: length ${Figures.length(a.distanceTo(b))}")
        },
    )

    private fun add(what: Clip, by: Similarity, name: String) {
        val moved = what.moved(by)
        if (moved.isEmpty) return session.say("Pick shapes first", true)
        session.selectTool()
        session.execute(AddShapes(moved.shapes, moved.loops, name))
    }

    private fun shift(): Similarity {
        val step = Grid.stepFor(canvas.transform.pixel)
        return Similarity.translation(step, -step)
    }

    private fun centre(middle: Point2) = arrayOf(NumberQuestion("About x", middle.x), NumberQuestion("About y", middle.y))

    /** Middle of the nodes of what is picked. */
    private fun middle(): Point2? {
        val document = session.document
        val picked = session.selection
        val nodes = LinkedHashSet(picked.nodes)
        for (shape in picked.shapes) for (node in document.path.nodesOf(shape)) nodes.add(node)
        for (outline in document.outlines) if (outline.loop in picked.loops) for (node in outline.nodes) nodes.add(node)
        if (nodes.isEmpty()) {
            session.say("Pick shapes or nodes first", true)
            return null
        }
        val all = document.nodes
        return Point2(
            (nodes.minOf { all.x(it) } + nodes.maxOf { all.x(it) }) / 2,
            (nodes.minOf { all.y(it) } + nodes.maxOf { all.y(it) }) / 2,
        )
    }

    private fun place(p: Point2) = "${Figures.length(p.x)}, ${Figures.length(p.y)}"

    private companion object {
        const val MOST_COPIES = 200

        /** Steps of the grid between copies, at first. */
        const val ARRAY_STEPS = 2
    }
}
