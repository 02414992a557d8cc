package org.trigrid.editor.app

import javafx.application.Application
import javafx.scene.image.Image
import javafx.stage.Stage
import org.trigrid.editor.files.Preferences
import java.nio.file.Path
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors

/** Starts JavaFX and opens the window. */
internal class EditorApp : Application() {
    private val worker: ExecutorService = Executors.newCachedThreadPool { work ->
        Thread(work, "editor-background").apply {
            isDaemon = true
            priority = Thread.NORM_PRIORITY - 1
        }
    }

    override fun start(stage: Stage) {
        // Before any control is made, so that none asks for colours that are not there yet.
        Theme.LIGHT.apply()
        val window = EditorWindow(stage, Preferences(Preferences.folder()), worker)
        stage.icons.add(Image(checkNotNull(javaClass.getResourceAsStream("icon.png"))))
        stage.show()
        val screenshot = ScreenshotRun.of(parameters.named)
        val file = parameters.unnamed.firstOrNull()?.let { Path.of(it) }
        if (file != null) window.files.show(file) else if (screenshot == null) window.files.offerRecovery()
        screenshot?.run(window)
    }

    override fun stop() {
        worker.shutdownNow()
    }
}
