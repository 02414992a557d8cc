package org.trigrid.editor.app

import javafx.animation.AnimationTimer
import javafx.scene.control.Button
import javafx.scene.control.ChoiceBox
import javafx.scene.control.Label
import javafx.scene.control.Slider
import javafx.scene.control.Tooltip
import javafx.scene.layout.HBox
import javafx.scene.layout.Region
import org.trigrid.editor.meshing.FrontPlayback
import org.trigrid.editor.session.Change
import org.trigrid.editor.session.EditorSession

/** The buttons under the film of the front: step, play, speed, stop. */
internal class FrontBar(private val session: EditorSession, toCanvas: () -> Unit) : HBox() {
    private val slider = Slider()
    private val words = Label()
    private val speed = ChoiceBox<String>()
    private val play = button(Icons.PLAY, "Play  (Space)", "front-play") { session.withPlayback { it.toggle() } }
    private var isUpdating = false
    private var shown: FrontPlayback? = null

    private val clock = object : AnimationTimer() {
        private var last = 0L

        override fun start() {
            last = 0L
            super.start()
        }

        override fun handle(now: Long) {
            val seconds = if (last == 0L) 0.0 else (now - last) / NANOS
            last = now
            if (session.playback?.pass(seconds) == true) session.withPlayback { }
        }
    }

    init {
        styleClass.add("front-bar")
        maxWidth = Region.USE_PREF_SIZE
        maxHeight = Region.USE_PREF_SIZE
        slider.id = "front-slider"
        slider.prefWidth = SLIDER_WIDTH
        slider.isFocusTraversable = false
        slider.valueProperty().addListener { _, _, value -> if (!isUpdating) session.withPlayback { it.goTo(value.toInt()) } }
        speed.id = "front-speed"
        speed.items.addAll(FrontPlayback.Speed.entries.map { it.label })
        speed.tooltip = Tooltip("Elements made in a second")
        speed.valueProperty().addListener { _, _, label ->
            if (!isUpdating) session.withPlayback { it.speed = FrontPlayback.Speed.entries.first { s -> s.label == label } }
        }
        // So that Space and the arrows go on to play the film.
        speed.setOnHidden { toCanvas() }
        speed.minWidth = SPEED_WIDTH
        speed.prefWidth = SPEED_WIDTH
        slider.minWidth = LEAST_WIDTH
        words.minWidth = LEAST_WIDTH
        words.prefWidth = WORDS_WIDTH
        children.addAll(
            button(Icons.FIRST, "Begin  (Home)", "front-first") { session.withPlayback { it.goTo(0) } },
            button(Icons.STEP_BACK, "One element back  (Left)", "front-back") { session.withPlayback { it.step(-1) } },
            play,
            button(Icons.STEP, "One element on  (Right)", "front-step") { session.withPlayback { it.step(1) } },
            button(Icons.LAST, "End  (End)", "front-last") { session.withPlayback { it.goTo(it.length) } },
            slider, speed, words,
            button(Icons.CANCEL, "Stop showing the front  (Esc)", "front-stop") { session.stopPlayback() },
        )
        session.listen { if (it == Change.PLAYBACK) refresh() }
        refresh()
    }

    private fun button(icon: Icons, words: String, name: String, run: () -> Unit): Button {
        val button = Button()
        button.id = name
        button.graphic = icon.node()
        button.styleClass.add("tool-button")
        button.tooltip = Tooltip(words)
        button.accessibleText = words.substringBefore("  ")
        button.isFocusTraversable = false
        button.setOnAction { run() }
        return button
    }

    private fun refresh() {
        val film = session.playback
        isVisible = film != null
        if (film !== shown) {
            shown = film
            if (film != null) clock.start() else clock.stop()
        }
        if (film == null) return
        isUpdating = true
        slider.max = film.length.toDouble()
        slider.value = film.position.toDouble()
        speed.value = film.speed.label
        isUpdating = false
        words.text = film.words
        val icon = if (film.isPlaying) Icons.PAUSE else Icons.PLAY
        if (play.userData != icon) {
            play.userData = icon
            play.graphic = icon.node()
        }
    }

    private companion object {
        const val NANOS = 1e9
        const val SLIDER_WIDTH = 180.0
        const val WORDS_WIDTH = 300.0
        const val SPEED_WIDTH = 118.0
        const val LEAST_WIDTH = 60.0
    }
}
