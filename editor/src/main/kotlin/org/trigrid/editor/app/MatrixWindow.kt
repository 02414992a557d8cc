package org.trigrid.editor.app

import javafx.scene.Scene
import javafx.scene.image.ImageView
import javafx.scene.input.KeyCode
import javafx.scene.layout.StackPane
import javafx.stage.Stage
import javafx.stage.Window
import org.trigrid.editor.meshing.MeshView
import org.trigrid.mesh.TriMesh
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
        stage.title = "Matrix structure"
        stage.initOwner(owner)
        stage.scene = Scene(frame, WIDTH, HEIGHT)
        stage.scene.setOnKeyPressed { if (it.code == KeyCode.ESCAPE) stage.close() }
    }

    private companion object {
        const val PIXELS = 1800
        const val MARGIN = 24.0
        const val WIDTH = 1040.0
        const val HEIGHT = 580.0
    }
}
