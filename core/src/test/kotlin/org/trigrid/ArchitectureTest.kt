package org.trigrid

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
        assertEquals(emptySet<String>(), found - ALLOWED.keys)
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
            val allowed = ALLOWED.getValue(from) + from + "diagnostics"
            for (dependency in item.directDependenciesFromSelf) {
                val target = dependency.targetClass.baseComponentType
                if (!target.packageName.startsWith(ROOT)) continue
                val to = packageOf(target)
                if (to !in allowed) events.add(SimpleConditionEvent.violated(dependency, "$from -> $to: " + dependency.description))
            }
        }
    }

    private fun packageOf(type: JavaClass): String = type.packageName.removePrefix(ROOT).removePrefix(".").substringBefore('.')

    private companion object {
        const val ROOT = "org.trigrid"
        const val ROOT_PACKAGE = ""

        private val ground = setOf("geometry", "domain", "mesh")
        private val stages = ground + setOf("shape", "spacing", "quality", "numbering", "front", "improve")

        /** Package to the packages it may use, besides itself and `diagnostics`; the root holds the generator and its options. */
        val ALLOWED: Map<String, Set<String>> = mapOf(
            "diagnostics" to emptySet(),
            "geometry" to emptySet(),
            "parallel" to emptySet(),
            "shape" to setOf("geometry"),
            "domain" to setOf("geometry", "shape"),
            "mesh" to setOf("geometry", "domain"),
            "quality" to setOf("geometry", "mesh", "parallel"),
            "numbering" to setOf("mesh"),
            "spacing" to ground,
            "front" to ground + setOf("spacing", "quality"),
            "improve" to ground + setOf("spacing", "quality", "front", "parallel"),
            ROOT_PACKAGE to stages + "parallel",
            "fem" to ground,
            "interop" to ground + "fem",
            "io" to ground + setOf("shape", "interop"),
            "project" to ground + setOf("shape", "spacing", "numbering", "front", "io", ROOT_PACKAGE),
            "picture" to ground + setOf("quality", "numbering", "io"),
        )
    }
}
