package org.trigrid

import com.tngtech.archunit.base.DescribedPredicate
import com.tngtech.archunit.core.domain.JavaClass
import com.tngtech.archunit.core.domain.JavaClasses
import com.tngtech.archunit.core.importer.ClassFileImporter
import com.tngtech.archunit.core.importer.ImportOption
import com.tngtech.archunit.lang.ArchCondition
import com.tngtech.archunit.lang.ConditionEvents
import com.tngtech.archunit.lang.SimpleConditionEvent
import com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes
import com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses
import com.tngtech.archunit.library.GeneralCodingRules
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Holds the directions in which packages may depend on each other; `docs/index.md` draws them. */
class ArchitectureTest {
    private val core: JavaClasses =
        ClassFileImporter().withImportOption(ImportOption.DoNotIncludeTests()).importPackages(ROOT)

    @Test
    fun `packages depend in one direction only`() {
        classes().should(keepToAllowedPackages())
            .because("stages meet in small types, so that each can be read and tested alone")
            .check(core)
    }

    @Test
    fun `every package is known here`() {
        val found = core.map { packageOf(it) }.toSortedSet()
        assertEquals(emptySet<String>(), found - ALLOWED.keys - ROOT_PACKAGE)
    }

    @Test
    fun `stages know the options of the root package but not the generator`() {
        noClasses().that().resideOutsideOfPackage(ROOT)
            .should().dependOnClassesThat(inRootButNotOptions())
            .because("the generator calls the stages")
            .check(core)
    }

    @Test
    fun `the generator does no input or output`() {
        noClasses().that().resideInAPackage(ROOT)
            .should().dependOnClassesThat().resideInAnyPackage(
                "$ROOT.io..", "$ROOT.picture..", "$ROOT.project..", "$ROOT.interop..", "java.nio.file..",
            )
            .check(core)
    }

    @Test
    fun `core never prints, exits or starts a thread`() {
        GeneralCodingRules.NO_CLASSES_SHOULD_ACCESS_STANDARD_STREAMS.check(core)
        noClasses().should().callMethod(System::class.java, "exit", Int::class.javaPrimitiveType)
            .orShould().dependOnClassesThat().areAssignableTo(Thread::class.java)
            .because("a library leaves that to the program it is part of")
            .check(core)
    }

    @Test
    fun `core knows no window, no command line and no random number`() {
        noClasses().should().dependOnClassesThat()
            .resideInAnyPackage("javafx..", "picocli..", "javax.swing..", "$ROOT.cli..", "$ROOT.editor..")
            .check(core)
        noClasses().should().callMethod(Math::class.java, "random")
            .orShould().callConstructor(java.util.Random::class.java)
            .because("the same input makes the same bytes")
            .check(core)
    }

    private fun keepToAllowedPackages() = object : ArchCondition<JavaClass>("keep to the packages allowed") {
        override fun check(item: JavaClass, events: ConditionEvents) {
            val from = packageOf(item)
            if (from == ROOT_PACKAGE) return
            val allowed = ALLOWED[from].orEmpty() + from + "diagnostics" + ROOT_PACKAGE
            for (dependency in item.directDependenciesFromSelf) {
                val target = dependency.targetClass.baseComponentType
                if (!target.packageName.startsWith(ROOT)) continue
                val to = packageOf(target)
                if (to !in allowed) events.add(SimpleConditionEvent.violated(dependency, "$from -> $to: " + dependency.description))
            }
        }
    }

    private fun inRootButNotOptions() = object : DescribedPredicate<JavaClass>("are of $ROOT but not options") {
        override fun test(target: JavaClass): Boolean =
            target.packageName == ROOT && OPTIONS.none { target.name.startsWith("$ROOT.$it") }
    }

    private fun packageOf(type: JavaClass): String = type.packageName.removePrefix(ROOT).removePrefix(".").substringBefore('.')

    private companion object {
        const val ROOT = "org.trigrid"
        const val ROOT_PACKAGE = ""
        val OPTIONS = listOf("MeshOptions", "Sizes", "Strategy")

        private val ground = setOf("geometry", "domain", "mesh")
        private val stages = ground + setOf("shape", "spacing", "quality", "numbering", "front", "improve")

        /** Package to the packages it may use, besides itself, `diagnostics` and the options. */
        val ALLOWED: Map<String, Set<String>> = mapOf(
            "diagnostics" to emptySet(),
            "geometry" to emptySet(),
            "shape" to setOf("geometry"),
            "domain" to setOf("geometry", "shape"),
            "mesh" to setOf("geometry", "domain"),
            "quality" to setOf("geometry", "mesh"),
            "numbering" to setOf("mesh"),
            "spacing" to ground,
            "front" to ground + setOf("spacing", "quality"),
            "improve" to ground + setOf("spacing", "quality"),
            "interop" to stages,
            "io" to stages + "interop",
            "project" to stages + setOf("interop", "io"),
            "picture" to stages + setOf("interop", "io"),
        )
    }
}
