package org.trigrid.editor.files

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.Properties
import kotlin.io.path.exists

/** What is remembered from one start to the next: a small properties file in [folder]. */
internal class Preferences(private val folder: Path) {
    private val file = folder.resolve("editor.properties")
    private val values = Properties()

    init {
        try {
            if (file.exists()) Files.newBufferedReader(file).use { values.load(it) }
        } catch (_: IOException) {
            // Without its preferences the editor starts as it did the first time.
        } catch (_: IllegalArgumentException) {
            values.clear()
        }
    }

    operator fun get(key: String): String? = values.getProperty(key)

    operator fun set(key: String, value: String?) {
        if (value == null) values.remove(key) else values.setProperty(key, value)
        save()
    }

    fun number(key: String): Double? = get(key)?.toDoubleOrNull()?.takeIf { it.isFinite() }

    fun flag(key: String, otherwise: Boolean): Boolean = get(key)?.toBooleanStrictOrNull() ?: otherwise

    /** Files opened or saved lately, the last first. */
    val recent: List<Path>
        get() = (0 until MOST_RECENT).mapNotNull { get("recent.$it") }.map { Path.of(it) }

    fun remember(opened: Path) {
        val files = (listOf(opened.toAbsolutePath().normalize()) + recent).distinct().take(MOST_RECENT)
        for (i in 0 until MOST_RECENT) {
            val entry = files.getOrNull(i)
            if (entry == null) values.remove("recent.$i") else values.setProperty("recent.$i", entry.toString())
        }
        save()
    }

    fun forget(gone: Path) {
        val files = recent.filter { it != gone }
        for (i in 0 until MOST_RECENT) {
            val entry = files.getOrNull(i)
            if (entry == null) values.remove("recent.$i") else values.setProperty("recent.$i", entry.toString())
        }
        save()
    }

    private fun save() {
        try {
            Files.createDirectories(folder)
            val beside = folder.resolve("editor.properties.new")
            Files.newBufferedWriter(beside).use { values.store(it, null) }
            Files.move(beside, file, java.nio.file.StandardCopyOption.REPLACE_EXISTING)
        } catch (_: IOException) {
            // Work must not stop because a preference could not be kept.
        }
    }

    companion object {
        const val MOST_RECENT = 10

        /** The folder for settings by the platform's habit; the system property `trigrid.home` names another one. */
        fun folder(): Path {
            System.getProperty("trigrid.home")?.let { return Path.of(it) }
            val home = Path.of(System.getProperty("user.home"))
            val os = System.getProperty("os.name").lowercase()
            return when {
                os.contains("win") -> (System.getenv("APPDATA")?.let { Path.of(it) } ?: home).resolve("TriGrid")
                os.contains("mac") -> home.resolve("Library/Application Support/TriGrid")
                else -> (System.getenv("XDG_CONFIG_HOME")?.takeIf { it.isNotEmpty() }?.let { Path.of(it) } ?: home.resolve(".config")).resolve("trigrid")
            }
        }
    }
}
