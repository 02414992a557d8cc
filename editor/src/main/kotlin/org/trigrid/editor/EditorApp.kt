package org.trigrid.editor

import javafx.application.Application
import javafx.application.Platform
import javafx.scene.Scene
import javafx.scene.control.Alert
import javafx.scene.control.Label
import javafx.scene.control.Menu
import javafx.scene.control.MenuBar
import javafx.scene.control.MenuItem
import javafx.scene.input.KeyCombination
import javafx.scene.layout.BorderPane
import javafx.stage.FileChooser
import javafx.stage.Stage
import org.trigrid.diagnostics.TriGridException
import org.trigrid.editor.canvas.DomainCanvas
import org.trigrid.editor.document.OpenDomain
import java.io.IOException
import java.nio.file.Path

/** The window: a menu, the drawing, and a line that says what is shown. */
internal class EditorApp : Application() {
    private val canvas = DomainCanvas()
    private val status = Label()
    private lateinit var window: Stage

    override fun start(stage: Stage) {
        window = stage
        val root = BorderPane(canvas)
        root.top = menuBar()
        root.bottom = status
        status.style = "-fx-padding: 4 8 4 8"
        stage.scene = Scene(root)
        show(null)
        stage.show()
        parameters.raw.firstOrNull()?.let { open(Path.of(it)) }
    }

    private fun menuBar(): MenuBar {
        val file = Menu("_File")
        file.items.addAll(
            item("_Open…", "Shortcut+O") { chooseFile() },
            item("E_xit", "Shortcut+Q") { Platform.exit() },
        )
        return MenuBar(file)
    }

    private fun item(text: String, keys: String, action: () -> Unit): MenuItem {
        val item = MenuItem(text)
        item.accelerator = KeyCombination.valueOf(keys)
        item.setOnAction { action() }
        return item
    }

    private fun chooseFile() {
        val chooser = FileChooser()
        chooser.title = "Open a domain"
        chooser.extensionFilters.addAll(
            FileChooser.ExtensionFilter("Domains", "*.trigrid.json", "*.geojson", "*.json", "*.wkt", "*.poly"),
            FileChooser.ExtensionFilter("All files", "*"),
        )
        chooser.showOpenDialog(window)?.let { open(it.toPath()) }
    }

    private fun open(file: Path) {
        try {
            show(OpenDomain.read(file))
        } catch (error: TriGridException) {
            tell(file, error)
        } catch (error: IOException) {
            tell(file, error)
        }
    }

    private fun show(document: OpenDomain?) {
        canvas.domain = document?.domain
        window.title = if (document == null) TITLE else "${document.file.fileName} – $TITLE"
        status.text = document?.summary() ?: "Open a project or a polygon file."
    }

    private fun tell(file: Path, error: Exception) {
        val alert = Alert(Alert.AlertType.ERROR, error.message ?: error.toString())
        alert.initOwner(window)
        alert.headerText = "$file cannot be opened"
        alert.show()
    }

    private companion object {
        const val TITLE = "TriGrid"
    }
}
