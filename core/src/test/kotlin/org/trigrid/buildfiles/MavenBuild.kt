package org.trigrid.buildfiles

import org.w3c.dom.Element
import java.nio.file.Path
import javax.xml.parsers.DocumentBuilderFactory

/** What the `pom.xml` files say, read from the checkout at [root]. */
internal class MavenBuild(private val root: Path) {
    private val parent = parse(root.resolve("pom.xml"))
    private val properties: Map<String, String> =
        parent.child("properties").children().associate { it.tagName to it.textContent.trim() }

    val groupId: String = parent.child("groupId").textContent
    val version: String = parent.child("version").textContent
    val modules: List<String> = parent.child("modules").children("module").map { it.textContent.trim() }

    /** Coordinates `group:artifact` to version, as the parent manages them; modules of this build left out. */
    val managedVersions: Map<String, String> = managed()
        .filter { it.child("groupId").textContent != groupId }
        .associate { coordinates(it) to resolve(it.child("version").textContent) }

    private val managedScopes: Map<String, String> =
        managed().associate { coordinates(it) to (it.optional("scope")?.textContent ?: "compile") }

    fun artifactId(module: String): String = pom(module).child("artifactId").textContent

    /** `group:artifact` to scope of each dependency that the module declares. */
    fun dependencies(module: String): Map<String, String> =
        pom(module).child("dependencies").children("dependency").associate {
            val coordinates = coordinates(it)
            require(it.optional("version") == null) { "$module: the version of $coordinates belongs in the parent" }
            coordinates to (it.optional("scope")?.textContent ?: managedScopes.getValue(coordinates))
        }

    /** Arguments of the Kotlin compiler for main code: those of the parent, then the module's own. */
    fun compilerArguments(module: String): Set<String> =
        (kotlinArguments(parent) + kotlinArguments(pom(module))).toSet()

    fun mainClass(module: String): String? =
        pom(module).descendants("mainClass").firstOrNull()?.textContent

    fun kotlinPlugins(module: String): List<String> =
        pom(module).descendants("compilerPlugins").flatMap { it.children("plugin") }.map { it.textContent.trim() }

    val jvmTarget: String = parent.descendants("jvmTarget").single().textContent
    val release: String = properties.getValue("maven.compiler.release")
    val excludedTags: String = properties.getValue("excludedGroups")
    val kotlinVersion: String = properties.getValue("kotlin.version")
    val dokkaVersion: String = properties.getValue("dokka.version")
    val testMemory: String = parent.descendants("argLine").single().textContent

    private fun pom(module: String) = parse(root.resolve(module).resolve("pom.xml"))

    private fun managed() = parent.child("dependencyManagement").child("dependencies").children("dependency")

    private fun kotlinArguments(project: Element) =
        project.descendants("args").flatMap { it.children("arg") }.map { it.textContent.trim() }

    private fun coordinates(dependency: Element) =
        dependency.child("groupId").textContent + ":" + dependency.child("artifactId").textContent

    private fun resolve(text: String): String =
        Regex("""\$\{([^}]+)}""").replace(text) { properties[it.groupValues[1]] ?: it.value }

    private fun parse(file: Path): Element =
        DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file.toFile()).documentElement
}

private fun Element.children(name: String? = null): List<Element> =
    (0 until childNodes.length).map { childNodes.item(it) }.filterIsInstance<Element>()
        .filter { name == null || it.tagName == name }

private fun Element.optional(name: String): Element? = children(name).singleOrNull()

private fun Element.child(name: String): Element =
    requireNotNull(optional(name)) { "<$tagName> has not exactly one <$name>" }

private fun Element.descendants(name: String): List<Element> {
    val found = getElementsByTagName(name)
    return (0 until found.length).map { found.item(it) as Element }
}
