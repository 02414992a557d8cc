package org.trigrid.editor.app

import javafx.animation.PauseTransition
import javafx.scene.control.TabPane
import javafx.scene.robot.Robot
import javafx.util.Duration
import org.trigrid.editor.document.Selection
import org.trigrid.editor.meshing.Colouring
import org.trigrid.editor.session.Change
import java.nio.file.Path

/**
 * For the documentation: brings the window into a state, writes what it looks like to a file and ends the program.
 *
 * `--screenshot=FILE`, and as wanted `--theme=dark`, `--mesh=true`, `--colouring=quality`, `--pick=SHAPE`, `--tab=N`,
 * `--problems=true`, `--matrix=true`, `--film=ELEMENTS`, `--welcome=false`.
 */
internal class ScreenshotRun private constructor(private val target: Path, private val wishes: Map<String, String>) {
    fun run(window: EditorWindow) {
        val session = window.session
        // So that nothing is shown as pointed at.
        Robot().mouseMove(0.0, 0.0)
        window.chooseTheme(Theme.of(wishes["theme"].orEmpty()) ?: Theme.LIGHT)
        if (wishes["welcome"] == "false") window.startDrawing()
        wishes["colouring"]?.let { name ->
            session.view = session.view.copy(colouring = Colouring.entries.first { it.name.equals(name, ignoreCase = true) })
        }
        wishes["pick"]?.let { session.select(Selection.ofShape(it.toInt())) }
        wishes["tab"]?.let { (window.stage.scene.lookup(".tab-pane") as TabPane).selectionModel.select(it.toInt()) }
        if (wishes["problems"] == "true") window.toggleProblems()
        wishes["film"]?.let { return film(window, it.toInt()) }
        if (wishes["mesh"] != "true") return later { shoot(window) }
        session.listen {
            if (it == Change.MESH && session.mesh != null) {
                if (wishes["matrix"] == "true") matrix(window) else later { shoot(window) }
            }
        }
        session.generate()
    }

    /** The front after a number of elements. */
    private fun film(window: EditorWindow, elements: Int) {
        val session = window.session
        session.listen {
            val film = session.playback
            if (it == Change.PLAYBACK && film != null && film.position == 0) {
                session.withPlayback { played -> played.goTo(elements) }
                later { shoot(window) }
            }
        }
        session.playFront()
    }

    private fun matrix(window: EditorWindow) {
        val mesh = window.session.mesh ?: return
        window.session.mesher.unnumbered(mesh) {
            val matrix = MatrixWindow(window.stage, mesh, it)
            matrix.stage.show()
            later { shoot(matrix.stage.scene.root, window) }
        }
    }

    private fun shoot(window: EditorWindow) = shoot(window.stage.scene.root, window)

    private fun shoot(root: javafx.scene.Parent, window: EditorWindow) {
        PngFile.write(ExportActions.snapshot(root, 1.0), target)
        window.session.saved(window.session.document, Path.of("screenshot"))
        window.exit()
        javafx.application.Platform.exit()
    }

    private fun later(action: () -> Unit) {
        PauseTransition(Duration.seconds(SETTLE_SECONDS)).apply { setOnFinished { action() } }.play()
    }

    companion object {
        private const val SETTLE_SECONDS = 2.5

        /** The run that the options ask for, or null. */
        fun of(options: Map<String, String>): ScreenshotRun? = options["screenshot"]?.let { ScreenshotRun(Path.of(it), options) }
    }
}
