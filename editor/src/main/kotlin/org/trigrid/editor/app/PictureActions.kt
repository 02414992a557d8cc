package org.trigrid.editor.app

import org.trigrid.editor.canvas.DrawingCanvas
import org.trigrid.editor.command.ProjectCommands
import org.trigrid.editor.inspector.NumberQuestion
import org.trigrid.editor.session.EditorSession
import org.trigrid.editor.tool.TwoPointTool
import org.trigrid.geometry.Point2
import org.trigrid.project.Background
import java.nio.file.Path

/** The picture that is traced over: laid behind, moved, turned, scaled, faded and locked. */
internal class PictureActions(private val session: EditorSession, private val canvas: DrawingCanvas, private val dialogs: Dialogs) {
    val isThere: Boolean get() = session.document.picture != null

    val isLocked: Boolean get() = session.document.picture?.isLocked == true

    /** Lays a picture behind the drawing, as wide as what is seen. */
    fun set(file: Path, width: Double) {
        val view = canvas.transform
        val corner = Point2(view.left, view.domainY(canvas.height))
        val pixel = canvas.width * view.pixel / width.coerceAtLeast(1.0)
        val picture = Background(file.toAbsolutePath().normalize().toString(), corner, pixel, 0.0, Background.USUAL_OPACITY, false)
        session.selectTool()
        session.execute(ProjectCommands.picture("set picture", picture))
        session.say("Drag the picture where it belongs, scale it by two points, then lock it (menu Picture)")
    }

    fun scale() {
        if (free() == null) return
        twoPoints("Scale picture", "Click a point of the picture", "Click another one whose distance you know") { a, b ->
            val distance = dialogs.askForNumbers("Distance of the two points", NumberQuestion.positive("Distance", a.distanceTo(b)))?.first()
            val picture = session.document.picture
            if (distance == null || picture == null) return@twoPoints
            change("scale picture", picture.scaled(a, distance / a.distanceTo(b)))
        }
    }

    fun move() {
        if (free() == null) return
        twoPoints("Move picture", "Click a point of the picture", "Click where it belongs") { a, b ->
            val picture = session.document.picture ?: return@twoPoints
            change("move picture", picture.withLowerLeft(Point2(picture.lowerLeft.x + b.x - a.x, picture.lowerLeft.y + b.y - a.y)))
        }
    }

    /** Turns the picture so that a line on it, given by two points, runs at a known angle. */
    fun rotate() {
        if (free() == null) return
        twoPoints("Rotate picture", "Click a point of the picture that stays", "Click another one whose direction you know") { a, b ->
            val now = Math.toDegrees(StrictMath.atan2(b.y - a.y, b.x - a.x))
            val wanted = dialogs.askForNumbers("Direction of the line", NumberQuestion("Angle, degrees", now))?.first()
            val picture = session.document.picture
            if (wanted != null && picture != null) change("rotate picture", picture.rotated(a, wanted - now))
        }
    }

    fun fade(change: Double) {
        val picture = there() ?: return
        val opacity = (picture.opacity + change).coerceIn(LEAST_OPACITY, 1.0)
        session.execute(ProjectCommands.picture("fade picture", picture.withOpacity(opacity), "fade picture"))
    }

    fun lock(value: Boolean) {
        val picture = there() ?: return
        change(if (value) "lock picture" else "unlock picture", picture.withLock(value))
    }

    fun remove() {
        if (there() != null) session.execute(ProjectCommands.picture("remove picture", null))
    }

    private fun change(name: String, picture: Background) {
        session.execute(ProjectCommands.picture(name, picture))
    }

    private fun twoPoints(label: String, first: String, second: String, done: (Point2, Point2) -> Unit) = session.use(
        TwoPointTool(session, label, first, second) { a, b ->
            session.selectTool()
            done(a, b)
        },
    )

    private fun there(): Background? = session.document.picture.also {
        if (it == null) session.say("Set a background picture first", true)
    }

    /** The picture if it may be moved. */
    private fun free(): Background? {
        val picture = there() ?: return null
        if (!picture.isLocked) return picture
        session.say("The picture is locked; unlock it in the menu Picture first", true)
        return null
    }

    private companion object {
        const val LEAST_OPACITY = 0.05
    }
}
