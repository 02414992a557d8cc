package org.trigrid.editor.inspector

import org.trigrid.editor.command.ProjectCommands
import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.tool.Figures
import org.trigrid.geometry.Point2
import org.trigrid.project.Background
import kotlin.io.path.Path
import kotlin.io.path.name

/** The fields of the picture behind. */
internal object PictureFields {
    /** Its section, or none where there is no picture. */
    fun of(document: EditorDocument): List<InspectorSection> {
        val picture = document.picture ?: return emptyList()
        val corner = picture.lowerLeft
        val fields = listOf(
            InspectorField("Picture", Path(picture.file).name, help = picture.file),
            InspectorField("Position", if (picture.isLocked) LOCKED else FREE, choices = listOf(FREE, LOCKED), help = "A locked picture stays where it is") {
                ProjectCommands.picture(if (it == LOCKED) "lock picture" else "unlock picture", picture.withLock(it == LOCKED))
            },
            number("Opacity", "%", Figures.plain(PERCENT * picture.opacity, 4)) { value ->
                require(value in 0.0..PERCENT) { "Type a number from 0 to 100" }
                picture.withOpacity(value / PERCENT)
            },
            placed(picture, "Rotation", "°", picture.rotationDegrees) { picture.withRotationDegrees(it) },
            placed(picture, "Corner x", "length", corner.x) { picture.withLowerLeft(Point2(it, corner.y)) },
            placed(picture, "Corner y", "length", corner.y) { picture.withLowerLeft(Point2(corner.x, it)) },
            placed(picture, "Pixel", "length", picture.pixelSize) {
                require(it > 0) { "Type a number above 0" }
                picture.scaled(corner, it / picture.pixelSize)
            },
        )
        return listOf(InspectorSection("Background picture", fields))
    }

    private fun placed(picture: Background, label: String, unit: String, value: Double, change: (Double) -> Background) =
        number(label, unit, Figures.exact(value)) {
            require(!picture.isLocked) { "The picture is locked; set it free first" }
            change(it)
        }

    private fun number(label: String, unit: String, value: String, change: (Double) -> Background) =
        InspectorField(label, value, unit) { text ->
            ProjectCommands.picture("${label.lowercase()} of picture", change(FieldNumbers.any(text)), "picture $label")
        }

    private const val LOCKED = "Locked"
    private const val FREE = "Free"
    private const val PERCENT = 100.0
}
