package org.trigrid.editor.app

import javafx.scene.Scene
import javafx.scene.control.Label
import javafx.scene.image.ImageView
import javafx.scene.layout.BorderPane
import javafx.scene.layout.HBox
import javafx.scene.layout.StackPane
import javafx.stage.Stage
import javafx.stage.Window
import org.trigrid.editor.meshing.MeshView
import org.trigrid.mesh.TriMesh
import org.trigrid.numbering.NumberingMetrics
import org.trigrid.picture.Pictures

/** The structure of the coefficient matrix before and after renumbering, side by side. */
internal class MatrixWindow(owner: Window?, view: MeshView, before: TriMesh) {
    private val image = ImageView(PngFile.toFx(Pictures.matrix(before, view.mesh).toImage(PIXELS)))
    val stage = Stage()

    init {
        image.isPreserveRatio = true
        image.isSmooth = true
        val frame = StackPane(image)
        image.fitWidthProperty().bind(frame.widthProperty().subtract(MARGIN))
        image.fitHeightProperty().bind(frame.heightProperty().subtract(MARGIN))
        frame.setMinSize(0.0, 0.0)
        frame.style = "-fx-background-color: white"
        val words = HBox(Label(words("Before", before)), Label(words("After", view.mesh)))
        words.styleClass.add("status-bar")
        val root = BorderPane(frame)
        root.bottom = words
        stage.title = "Matrix structure"
        stage.initOwner(owner)
        stage.scene = Scene(root, WIDTH, HEIGHT)
        stage.scene.stylesheets.add(EditorWindow.stylesheet)
    }

    private fun words(name: String, mesh: TriMesh): String {
        val metrics = NumberingMetrics.of(mesh)
        return "$name: bandwidth ${metrics.bandwidth}, profile ${metrics.profile}"
    }

    private companion object {
        const val PIXELS = 1800
        const val MARGIN = 24.0
        const val WIDTH = 1040.0
        const val HEIGHT = 580.0
    }
}
