package org.trigrid.editor.app

import javafx.scene.SnapshotParameters
import javafx.scene.image.WritableImage
import javafx.stage.FileChooser
import javafx.stage.Window
import org.trigrid.MeshRework
import org.trigrid.editor.canvas.DrawingCanvas
import org.trigrid.editor.meshing.Colouring
import org.trigrid.editor.meshing.MeshView
import org.trigrid.editor.session.EditorSession
import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import org.trigrid.mesh.EdgeMiddles
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.picture.PictureOptions
import org.trigrid.picture.Pictures
import org.trigrid.project.ShapeMiddles
import java.nio.file.Path

/** Writes meshes and pictures. */
internal class ExportActions(
    private val session: EditorSession,
    private val files: FileActions,
    private val canvas: DrawingCanvas,
    private val window: () -> Window?,
) {
    /** @param order 1 for elements of three nodes, 2 for elements of six, those in the middles on the true curves. */
    fun mesh(order: Int = 1) {
        if (session.mesh == null) return session.say("Make a mesh first, then export it", true)
        val chooser = files.chooser(if (order == 1) "Export the mesh" else "Export the mesh with six nodes an element")
        val formats = MeshFormats.all().filter { it.canWrite && it.highestOrder >= order }
        val filters = formats.map { format -> FileChooser.ExtensionFilter(format.title, format.endings.map { "*$it" }) }
        chooser.extensionFilters.addAll(filters)
        chooser.initialFileName = baseName() + formats.first().endings.first()
        val chosen = chooser.showSaveDialog(window())?.toPath() ?: return
        // The chosen kind counts; an ending typed that belongs to another kind counts more.
        val picked = formats.getOrElse(filters.indexOf(chooser.selectedExtensionFilter)) { formats.first() }
        val format = if (picked.fits(chosen)) picked else formats.firstOrNull { it.fits(chosen) } ?: picked
        val file = if (format.fits(chosen)) chosen else ended(chosen, format.endings.first())
        if (files.mayWrite(chosen, file)) writeMesh(file, format, order)
    }

    /** @return whether it was written, as of all below. */
    fun writeMesh(file: Path, format: MeshFormat, order: Int = 1): Boolean {
        val mesh = session.mesh ?: return false
        val isWritten = export(file) {
            if (order == 1) MeshFormats.write(mesh.mesh, it, format) else MeshFormats.write(secondOrder(mesh), it, format)
        }
        if (isWritten && !session.isMeshCurrent) {
            session.say("Wrote ${file.fileName} with the mesh from before the last changes; F5 makes a new one", true)
        }
        return isWritten
    }

    private fun secondOrder(mesh: MeshView): QuadraticMesh {
        val middles = mesh.document?.let { ShapeMiddles(it.path) } ?: EdgeMiddles.STRAIGHT
        return MeshRework.secondOrder(mesh.mesh, middles)
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
