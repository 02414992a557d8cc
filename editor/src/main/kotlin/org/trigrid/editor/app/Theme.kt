package org.trigrid.editor.app

import atlantafx.base.theme.PrimerDark
import atlantafx.base.theme.PrimerLight
import javafx.application.Application
import org.trigrid.editor.canvas.CanvasColours
import java.io.IOException
import java.util.concurrent.TimeUnit

/** Light or dark. */
internal enum class Theme(val label: String, val colours: CanvasColours) {
    LIGHT("Light", CanvasColours.LIGHT),
    DARK("Dark", CanvasColours.DARK),
    ;

    fun apply() {
        val sheet = if (this == LIGHT) PrimerLight() else PrimerDark()
        Application.setUserAgentStylesheet(sheet.userAgentStylesheet)
    }

    companion object {
        private const val PATIENCE_MILLIS = 800L

        fun of(name: String?): Theme? = entries.firstOrNull { it.name.equals(name, ignoreCase = true) }

        /** What the system prefers; light where it does not say. Asks other programs, so off the window's thread. */
        fun ofSystem(): Theme {
            val os = System.getProperty("os.name").lowercase()
            val answer = when {
                os.contains("mac") -> ask("defaults", "read", "-g", "AppleInterfaceStyle")
                os.contains("win") -> ask(
                    "reg", "query", "HKCU\\Software\\Microsoft\\Windows\\CurrentVersion\\Themes\\Personalize", "/v", "AppsUseLightTheme",
                ).let { if ("0x0" in it) "dark" else "" }
                else -> System.getenv("GTK_THEME").orEmpty() + ask("gsettings", "get", "org.gnome.desktop.interface", "color-scheme")
            }
            return if ("dark" in answer.lowercase()) DARK else LIGHT
        }

        private fun ask(vararg command: String): String = try {
            val process = ProcessBuilder(*command).redirectErrorStream(true).start()
            if (process.waitFor(PATIENCE_MILLIS, TimeUnit.MILLISECONDS)) {
                process.inputStream.bufferedReader().readText()
            } else {
                process.destroy()
                ""
            }
        } catch (_: IOException) {
            ""
        }
    }
}
