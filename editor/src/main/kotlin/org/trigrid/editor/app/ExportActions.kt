package org.trigrid.editor.app

import javafx.scene.SnapshotParameters
import javafx.scene.image.WritableImage
import javafx.stage.FileChooser
import javafx.stage.Window
import org.trigrid.editor.canvas.DrawingCanvas
import org.trigrid.editor.meshing.Colouring
import org.trigrid.editor.session.EditorSession
import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import org.trigrid.picture.PictureOptions
import org.trigrid.picture.Pictures
import java.nio.file.Path

/** Writes meshes and pictures. */
internal class ExportActions(
    private val session: EditorSession,
    private val files: FileActions,
    private val canvas: DrawingCanvas,
    private val window: () -> Window?,
) {
    fun mesh() {
        val mesh = session.mesh ?: return session.say("Make a mesh first, then export it", true)
        val chooser = files.chooser("Export the mesh")
        val formats = MeshFormats.all().filter { it.canWrite }
        val filters = formats.map { format -> FileChooser.ExtensionFilter(format.title, format.endings.map { "*$it" }) }
        chooser.extensionFilters.addAll(filters)
        chooser.initialFileName = baseName() + formats.first().endings.first()
        val chosen = chooser.showSaveDialog(window())?.toPath() ?: return
        // The chosen kind counts; an ending typed that belongs to another kind counts more.
        val picked = formats.getOrElse(filters.indexOf(chooser.selectedExtensionFilter)) { formats.first() }
        val format = if (picked.fits(chosen)) picked else MeshFormats.forWriting(chosen) ?: picked
        val file = if (format.fits(chosen)) chosen else ended(chosen, format.endings.first())
        if (files.mayWrite(chosen, file)) writeMesh(file, format)
    }

    /** @return whether it was written, as of all below. */
    fun writeMesh(file: Path, format: MeshFormat): Boolean {
        val mesh = session.mesh ?: return false
        return export(file) { MeshFormats.write(mesh.mesh, it, format) }
    }

    fun svg() {
        val chosen = choose("Export as SVG", "SVG picture", ".svg") ?: return
        writeSvg(chosen)
    }

    fun writeSvg(file: Path): Boolean = export(file) { picture().writeSvg(it) }

    /** What the window shows. */
    fun png() {
        val chosen = choose("Export what is shown as PNG", "PNG picture", ".png") ?: return
        writePng(chosen)
    }

    fun writePng(file: Path): Boolean = export(file) { PngFile.write(canvas.picture(EXPORT_DENSITY), it) }

    private fun picture(): org.trigrid.picture.Picture {
        val mesh = session.mesh
        val colours = session.document.project.colours.mapValues { (_, colour) -> colour.substring(1).toInt(16) }
        val options = PictureOptions.builder().quality(session.view.colouring != Colouring.NONE).groupColours(colours).build()
        if (mesh != null && session.view.showMesh) return Pictures.mesh(mesh.mesh, options)
        return Pictures.domain(session.document.project.toDomain(), options)
    }

    private fun choose(title: String, kind: String, ending: String): Path? {
        if (session.document.isEmpty) {
            session.say("Draw something first, then export it", true)
            return null
        }
        val chooser = files.chooser(title)
        chooser.extensionFilters.add(FileChooser.ExtensionFilter(kind, "*$ending"))
        chooser.initialFileName = baseName() + ending
        return chooser.showSaveDialog(window())?.toPath()?.let { chosen -> ended(chosen, ending).takeIf { files.mayWrite(chosen, it) } }
    }

    private fun export(file: Path, write: (Path) -> Unit): Boolean {
        val isWritten = files.attempt("$file cannot be written") { write(file) }
        if (isWritten) session.say("Wrote ${file.fileName}")
        return isWritten
    }

    private fun ended(file: Path, ending: String): Path =
        if (file.fileName.toString().endsWith(ending, ignoreCase = true)) file else file.resolveSibling(file.fileName.toString() + ending)

    private fun baseName(): String = session.title.substringBefore('.').ifEmpty { "mesh" }

    companion object {
        private const val EXPORT_DENSITY = 2.0

        /** [node] as it looks, with [density] pixels to one of the window's. */
        fun snapshot(node: javafx.scene.Node, density: Double): WritableImage {
            val parameters = SnapshotParameters()
            parameters.transform = javafx.scene.transform.Transform.scale(density, density)
            return node.snapshot(parameters, null)
        }
    }
}
