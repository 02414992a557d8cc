package org.trigrid.editor.app

import javafx.scene.control.Button
import javafx.scene.control.Hyperlink
import javafx.scene.control.Label
import javafx.scene.control.ScrollPane
import javafx.scene.control.Tooltip
import javafx.scene.image.ImageView
import javafx.scene.image.PixelFormat
import javafx.scene.image.WritableImage
import javafx.scene.input.KeyCode
import javafx.scene.layout.FlowPane
import javafx.scene.layout.HBox
import javafx.scene.layout.Region
import javafx.scene.layout.VBox
import org.trigrid.MeshGenerator
import org.trigrid.editor.canvas.Box
import org.trigrid.editor.canvas.MeshRaster
import org.trigrid.editor.canvas.PixelRaster
import org.trigrid.editor.canvas.ViewTransform
import org.trigrid.editor.files.Gallery
import org.trigrid.editor.files.Preferences
import org.trigrid.editor.meshing.Colouring
import org.trigrid.editor.meshing.MeshView
import java.nio.file.Path
import java.util.concurrent.Executor
import kotlin.io.path.exists

/** What there is to see before anything is drawn: how to begin, files opened lately, the gallery. */
internal class WelcomeView(
    private val preferences: Preferences,
    private val worker: Executor,
    private val publisher: Executor,
    private val theme: () -> Theme,
    private val openFile: (Path) -> Unit,
    private val openCase: (Gallery) -> Unit,
    private val chooseFile: () -> Unit,
    private val draw: () -> Unit,
) : ScrollPane() {
    private val recent = VBox()
    private val gallery = FlowPane()

    init {
        styleClass.add("welcome")
        maxWidth = WIDTH
        maxHeight = Region.USE_PREF_SIZE
        isFitToWidth = true
        hbarPolicy = ScrollBarPolicy.NEVER
        val title = Label("TriGrid").apply { styleClass.add("welcome-title") }
        val words = Label("Draw a domain, or open one; then press Mesh.").apply { styleClass.add("inspector-note") }
        val start = Button("Start drawing").apply {
            id = "start-drawing"
            styleClass.add("accent")
            setOnAction { draw() }
        }
        val open = Button("Open a file…").apply { setOnAction { chooseFile() } }
        gallery.styleClass.add("welcome-gallery")
        gallery.prefWrapLength = WIDTH - PADDING
        gallery.minWidth = 0.0
        recent.spacing = 2.0
        val all = VBox(title, words, HBox(start, open).apply { spacing = 10.0 }, recent, heading("The paper's cases"), gallery)
        all.styleClass.add("welcome-content")
        content = all
        refresh()
    }

    fun refresh() {
        recent.children.clear()
        val files = preferences.recent.filter { it.exists() }.take(RECENT)
        if (files.isNotEmpty()) recent.children.add(heading("Opened lately"))
        for (file in files) {
            val link = Hyperlink(file.fileName.toString())
            link.tooltip = Tooltip(file.toString())
            link.setOnAction { openFile(file) }
            recent.children.add(link)
        }
        recent.isManaged = files.isNotEmpty()
        gallery.children.setAll(Gallery.entries.map { item(it) })
    }

    private fun heading(words: String) = Label(words).apply { styleClass.add("section-heading") }

    private fun item(case: Gallery): VBox {
        val picture = ImageView()
        picture.fitWidth = THUMB_WIDTH
        picture.fitHeight = THUMB_HEIGHT
        val item = VBox(picture, Label(case.label).apply { styleClass.add("gallery-label") })
        item.styleClass.add("gallery-item")
        item.prefWidth = ITEM_WIDTH
        item.isFocusTraversable = true
        item.accessibleText = case.label
        item.setOnMouseClicked { openCase(case) }
        item.setOnKeyPressed { if (it.code == KeyCode.ENTER || it.code == KeyCode.SPACE) openCase(case) }
        val ink = theme().colours.mesh
        worker.execute {
            val document = case.document()
            val box = Box.of(document.nodes.bounds()) ?: return@execute
            val mesh = MeshView(null, MeshGenerator.generate(document.project.toDomain(), document.project.options).mesh, null)
            val raster = PixelRaster((THUMB_WIDTH * DENSITY).toInt(), (THUMB_HEIGHT * DENSITY).toInt())
            val view = ViewTransform.fit(box, raster.width.toDouble(), raster.height.toDouble(), THUMB_MARGIN)
            MeshRaster(mesh).draw(raster, view, Colouring.NONE, ink)
            publisher.execute {
                val image = WritableImage(raster.width, raster.height)
                image.pixelWriter.setPixels(0, 0, raster.width, raster.height, PixelFormat.getIntArgbPreInstance(), raster.pixels, 0, raster.width)
                picture.image = image
            }
        }
        return item
    }

    private companion object {
        const val WIDTH = 650.0
        const val PADDING = 80.0
        const val RECENT = 5
        const val ITEM_WIDTH = 180.0
        const val THUMB_WIDTH = 150.0
        const val THUMB_HEIGHT = 100.0
        const val THUMB_MARGIN = 8.0
        const val DENSITY = 2.0
    }
}
