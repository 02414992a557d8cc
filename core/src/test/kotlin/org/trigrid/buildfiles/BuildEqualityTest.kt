package org.trigrid.buildfiles

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.file.Path
import java.security.MessageDigest
import kotlin.io.path.readBytes

/** Maven and Gradle build the same modules from the same dependencies: what one says, the other says too. */
class BuildEqualityTest {
    private val root = Path.of("..")
    private val maven = MavenBuild(root)
    private val gradle = GradleBuild(root)

    /** Surefire brings the launcher of the JUnit platform itself; Gradle wants it named. */
    private val launcher = "org.junit.platform:junit-platform-launcher"

    @Test
    fun `same modules under the same coordinates`() {
        assertEquals(listOf("core", "cli", "editor", "benchmarks", "samples", "spark"), maven.modules)
        assertEquals(maven.modules, gradle.modules)
        assertEquals("trigrid", gradle.rootName)
        assertEquals(maven.groupId, gradle.group)
        assertEquals(maven.version, gradle.version)
        for (module in maven.modules) assertEquals(maven.artifactId(module), gradle.artifactPrefix + module)
    }

    @Test
    fun `same libraries in the same versions`() {
        assertTrue(maven.managedVersions.size >= 12)
        assertEquals(maven.managedVersions.toSortedMap(), (gradle.libraryVersions - launcher).toSortedMap())
        for ((plugin, version) in gradle.pluginVersions) {
            val expected = if ("dokka" in plugin) maven.dokkaVersion else maven.kotlinVersion
            assertEquals(expected, version, plugin)
        }
    }

    @Test
    fun `the launcher belongs to the JUnit of the catalog`() {
        val (major, rest) = gradle.versions.getValue("junit").split('.', limit = 2)
        assertEquals("5", major)
        assertEquals("1.$rest", gradle.libraryVersions[launcher])
    }

    @Test
    fun `each module has the same dependencies in the same scopes`() {
        for (module in maven.modules) {
            val declared = gradle.dependencies(module)
            assertEquals("test", declared[launcher], "$module: scope of the launcher")
            assertEquals(maven.dependencies(module).toSortedMap(), (declared - launcher).toSortedMap(), module)
        }
    }

    @Test
    fun `same compiler settings`() {
        assertEquals(maven.jvmTarget, gradle.jvmTarget)
        assertEquals(maven.release, gradle.release)
        for (module in maven.modules) {
            assertEquals(maven.compilerArguments(module), gradle.compilerArguments(module), module)
            val serialization = "alias(libs.plugins.kotlin.serialization)" in gradle.script(module)
            assertEquals("kotlinx-serialization" in maven.kotlinPlugins(module), serialization, module)
        }
        assertTrue("-Xexplicit-api=strict" in maven.compilerArguments("core"))
        assertTrue("-Werror" in maven.compilerArguments("cli"))
    }

    @Test
    fun `same tests are run in the same memory`() {
        assertEquals(maven.excludedTags, gradle.excludedTags)
        assertEquals(maven.testMemory, "-Xmx" + gradle.testMemory)
    }

    @Test
    fun `same programs`() {
        for (module in maven.modules) assertEquals(maven.mainClass(module), gradle.mainClass(module), module)
        assertEquals("org.trigrid.cli.Main", gradle.mainClass("cli"))
    }

    @Test
    fun `scripts use only aliases that the catalog has, and all of them`() {
        val known = gradle.libraries.keys + gradle.plugins.keys.map { "plugins.$it" }
        val used = gradle.usedAliases()
        val versions = used.filter { it.startsWith("versions.") }.toSet()
        assertEquals(known.toSortedSet(), (used - versions).toSortedSet())
        for (alias in versions) assertTrue(alias.removePrefix("versions.") in gradle.versions, alias)
    }

    @Test
    fun `the wrapper jar is the one that Gradle published`() {
        val bytes = root.resolve("gradle/wrapper/gradle-wrapper.jar").readBytes()
        val sum = MessageDigest.getInstance("SHA-256").digest(bytes).joinToString("") { "%02x".format(it) }
        assertEquals("91941f522fbfd4431cf57e445fc3d5200c85f957bda2de5251353cf11174f4b5", sum)
    }
}
