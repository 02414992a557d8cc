package org.trigrid.buildfiles

import java.nio.file.Path
import kotlin.io.path.readText

/** What the Gradle scripts and the version catalog say, read from the checkout at [root]. */
internal class GradleBuild(private val root: Path) {
    private val catalog = root.resolve("gradle/libs.versions.toml").readText()
    private val rootScript = root.resolve("build.gradle.kts").readText()
    private val settings = root.resolve("settings.gradle.kts").readText()

    val versions: Map<String, String> =
        Regex("""(?m)^([\w-]+) = "([^"]+)"$""").findAll(table("versions"))
            .associate { it.groupValues[1] to it.groupValues[2] }

    /** Alias, written with dots as in the scripts, to `group:artifact`. */
    val libraries: Map<String, String> =
        libraryLines().associate { dotted(it.groupValues[1]) to it.groupValues[2] }

    /** `group:artifact` to version. */
    val libraryVersions: Map<String, String> =
        libraryLines().associate { it.groupValues[2] to versions.getValue(it.groupValues[3]) }

    /** Alias to plugin id. */
    val plugins: Map<String, String> = pluginLines().associate { dotted(it.groupValues[1]) to it.groupValues[2] }

    /** Plugin id to version. */
    val pluginVersions: Map<String, String> =
        pluginLines().associate { it.groupValues[2] to versions.getValue(it.groupValues[3]) }

    val modules: List<String> =
        Regex("""include\("([^"]+)"\)""").findAll(settings).map { it.groupValues[1] }.toList()

    val rootName: String = one(settings, """rootProject\.name = "([^"]+)"""")
    val group: String = one(rootScript, """group = "([^"]+)"""")
    val version: String = one(rootScript, """version = "([^"]+)"""")
    val artifactPrefix: String = one(rootScript, """artifactId = "([^"$]+)\$""")
    val excludedTags: String = one(rootScript, """getOrElse\("([^"]+)"\)""")
    val jvmTarget: String = one(rootScript, """JvmTarget\.JVM_(\d+)""")
    val release: String = one(rootScript, """release\.set\((\d+)\)""")
    val testMemory: String = one(rootScript, """maxHeapSize = "([^"]+)"""")

    fun script(module: String): String = root.resolve(module).resolve("build.gradle.kts").readText()

    /** `group:artifact` to Maven's word for the scope, of each dependency that the module declares. */
    fun dependencies(module: String): Map<String, String> {
        val block = one(script(module), """(?s)\ndependencies \{\n(.*?)\n}""")
        return block.lines().map { it.trim() }.filter { it.isNotEmpty() }.associate { line ->
            val (configuration, argument) = requireNotNull(Regex("""(\w+)\((.+)\)""").matchEntire(line)) {
                "$module: not understood: $line"
            }.destructured
            coordinates(argument) to SCOPES.getValue(configuration)
        }
    }

    fun compilerArguments(module: String): Set<String> = buildSet {
        Regex(""""(-X[\w=-]+)"""").findAll(rootScript).forEach { add(it.groupValues[1]) }
        if ("allWarningsAsErrors.set(true)" in rootScript) add("-Werror")
        if ("explicitApi()" in script(module)) add("-Xexplicit-api=strict")
    }

    fun mainClass(module: String): String? =
        Regex("""mainClass\.set\("([^"]+)"\)""").find(script(module))?.groupValues?.get(1)

    /** Aliases that the scripts use: of libraries, of plugins (`plugins.…`) and of versions (`versions.…`). */
    fun usedAliases(): Set<String> =
        (listOf(rootScript) + modules.map { script(it) })
            .flatMap { Regex("""\blibs\.([A-Za-z0-9.]+)""").findAll(it).map { use -> use.groupValues[1] } }
            .map { it.substringBefore(".get") }
            .toSet()

    private fun coordinates(argument: String): String = when {
        argument.startsWith("project(\":") -> "$group:$artifactPrefix" + one(argument, """":([^"]+)"""")
        else -> libraries.getValue(one(argument, """libs\.([a-z.]+?)(?:\.get\(|$)"""))
    }

    private fun libraryLines() =
        Regex("""(?m)^([\w-]+) = \{ module = "([^"]+)", version.ref = "([^"]+)" }$""").findAll(table("libraries"))

    private fun pluginLines() =
        Regex("""(?m)^([\w-]+) = \{ id = "([^"]+)", version.ref = "([^"]+)" }$""").findAll(table("plugins"))

    private fun table(name: String): String = one(catalog, """(?s)\[$name]\n(.*?)(?:\n\[|$)""")

    private fun dotted(alias: String) = alias.replace('-', '.')

    private fun one(text: String, pattern: String): String =
        requireNotNull(Regex(pattern).find(text)) { "no match for $pattern" }.groupValues[1]

    private companion object {
        val SCOPES = mapOf(
            "api" to "compile",
            "implementation" to "compile",
            "compileOnly" to "provided",
            "annotationProcessor" to "provided",
            "runtimeOnly" to "runtime",
            "testImplementation" to "test",
            "testRuntimeOnly" to "test",
        )
    }
}
