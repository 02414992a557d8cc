package org.trigrid.cli.bench

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** What was measured on. */
internal object Machine {
    fun describe(): String {
        val memory = Runtime.getRuntime().maxMemory() / (1 shl 20)
        return "${processor()}, ${Runtime.getRuntime().availableProcessors()} cores seen; " +
            "${System.getProperty("os.name")} ${System.getProperty("os.arch")}; " +
            "${System.getProperty("java.vm.name")} ${System.getProperty("java.runtime.version")}, heap up to $memory MB"
    }

    private fun processor(): String = try {
        Files.readAllLines(Path.of("/proc/cpuinfo")).first { it.startsWith("model name") }.substringAfter(':').trim()
    } catch (_: IOException) {
        "unknown processor"
    } catch (_: NoSuchElementException) {
        "unknown processor"
    }
}
