package org.trigrid.editor

import com.tngtech.archunit.core.domain.JavaClasses
import com.tngtech.archunit.core.importer.ClassFileImporter
import com.tngtech.archunit.core.importer.ImportOption
import com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses
import com.tngtech.archunit.library.Architectures.layeredArchitecture
import org.junit.jupiter.api.Test

/** Holds the directions: document, command, tool, session, and only then the window. */
class ArchitectureTest {
    private val editor: JavaClasses =
        ClassFileImporter().withImportOption(ImportOption.DoNotIncludeTests()).importPackages(ROOT)

    @Test
    fun `packages depend in one direction only`() {
        layeredArchitecture().consideringOnlyDependenciesInLayers()
            .layer("document").definedBy("$ROOT.document..")
            .layer("command").definedBy("$ROOT.command..")
            .layer("tool").definedBy("$ROOT.tool..")
            .layer("meshing").definedBy("$ROOT.meshing..")
            .layer("files").definedBy("$ROOT.files..")
            .layer("session").definedBy("$ROOT.session..")
            .layer("inspector").definedBy("$ROOT.inspector..")
            .layer("canvas").definedBy("$ROOT.canvas..")
            .layer("app").definedBy(ROOT, "$ROOT.app..")
            .whereLayer("app").mayNotBeAccessedByAnyLayer()
            .whereLayer("canvas").mayOnlyBeAccessedByLayers("app")
            .whereLayer("inspector").mayOnlyBeAccessedByLayers("app")
            .whereLayer("session").mayOnlyBeAccessedByLayers("inspector", "canvas", "app")
            .whereLayer("files").mayOnlyBeAccessedByLayers("session", "app")
            .whereLayer("meshing").mayOnlyBeAccessedByLayers("session", "inspector", "canvas", "app")
            .whereLayer("tool").mayOnlyBeAccessedByLayers("meshing", "session", "inspector", "canvas", "app")
            .because("an edit runs from the tool by a command to the document, and the window only shows it")
            .check(editor)
    }

    @Test
    fun `what decides knows no windows`() {
        noClasses().that().resideInAnyPackage(
            "$ROOT.document..", "$ROOT.command..", "$ROOT.tool..", "$ROOT.meshing..", "$ROOT.files..", "$ROOT.session..",
        ).or().haveSimpleNameEndingWith("ViewModel").or().haveSimpleNameContaining("Raster")
            .should().dependOnClassesThat().resideInAnyPackage("javafx..", "java.awt..", "atlantafx..")
            .because("it is tested without a window, and on machines without a display")
            .check(editor)
    }

    @Test
    fun `geometry is left to the library`() {
        noClasses().should().dependOnClassesThat().resideInAPackage("org.locationtech..")
            .because("the editor has no geometry of its own")
            .check(editor)
    }

    private companion object {
        const val ROOT = "org.trigrid.editor"
    }
}
