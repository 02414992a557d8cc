package org.trigrid.api

import java.lang.reflect.Constructor
import java.lang.reflect.Executable
import java.lang.reflect.Field
import java.lang.reflect.Member
import java.lang.reflect.Method
import java.lang.reflect.Modifier
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.relativeTo

/**
 * Writes down what users of the classes in a folder can call: public and protected members of public classes, as Java
 * sees them, without what Kotlin calls internal.
 */
internal class ApiDump(private val folder: Path) {
    fun text(): String = classes().mapNotNull { describe(it) }.joinToString("\n") + "\n"

    private fun classes(): List<Class<*>> = Files.walk(folder).use { files ->
        files.filter { it.extension == "class" }
            .map { it.relativeTo(folder).invariantSeparatorsPathString.removeSuffix(".class").replace('/', '.') }
            .sorted().toList()
    }.map { Class.forName(it, false, javaClass.classLoader) }

    private fun describe(type: Class<*>): String? {
        if (!isVisible(type)) return null
        val visible = KotlinVisibility.of(type)
        val members = type.declaredFields.filter { isOpen(it) && isListed(type, it, visible) }.map { field(it) } +
            type.declaredConstructors.filter { isOpen(it) && visible.hasConstructor(it) }.map { constructor(it) } +
            type.declaredMethods.filter { isOpen(it) && isListed(type, it, visible) }.map { method(it) }
        if (members.isEmpty() && type.simpleName == "Companion") return null
        val supertypes = listOfNotNull(type.superclass.takeIf { it != Any::class.java }) + type.interfaces
        val heading = modifiers(type.modifiers and Modifier.INTERFACE.inv()) + word(type) + " " + type.name +
            if (supertypes.isEmpty()) "" else " : " + supertypes.joinToString { it.name }
        return (listOf("$heading {") + members.sorted().map { "    $it" } + "}\n").joinToString("\n")
    }

    /** Visible itself and within visible classes. */
    private fun isVisible(type: Class<*>): Boolean = generateSequence(type) { it.declaringClass }.all {
        isOpen(it.modifiers) && !it.isSynthetic && !it.isAnonymousClass && KotlinVisibility.of(it).isPublic
    }

    private fun isOpen(member: Member): Boolean = isOpen(member.modifiers) && !member.isSynthetic

    private fun isOpen(modifiers: Int): Boolean = Modifier.isPublic(modifiers) || Modifier.isProtected(modifiers)

    private fun isListed(type: Class<*>, field: Field, visible: KotlinVisibility): Boolean =
        field.isEnumConstant || visible.hasField(field) || companionOf(type)?.let { KotlinVisibility.of(it).hasField(field) } == true

    private fun isListed(type: Class<*>, method: Method, visible: KotlinVisibility): Boolean {
        if (method.isBridge || type.isEnum && method.name in ENUM_METHODS) return false
        return visible.hasMethod(method) || companionOf(type)?.let { KotlinVisibility.of(it).hasMethod(method) } == true
    }

    private fun companionOf(type: Class<*>): Class<*>? = type.declaredClasses.firstOrNull { it.simpleName == "Companion" }

    private fun word(type: Class<*>): String = when {
        type.isInterface -> "interface"
        type.isEnum -> "enum"
        else -> "class"
    }

    private fun field(it: Field) = modifiers(it.modifiers) + it.type.typeName + " " + it.name

    private fun constructor(it: Constructor<*>) = modifiers(it.modifiers) + it.declaringClass.simpleName + signature(it)

    private fun method(it: Method) = modifiers(it.modifiers) + it.genericReturnType.typeName + " " + it.name + signature(it)

    private fun signature(it: Executable): String {
        val errors = it.exceptionTypes.map { error -> error.typeName }
        return it.genericParameterTypes.joinToString(prefix = "(", postfix = ")") { type -> type.typeName } +
            if (errors.isEmpty()) "" else errors.joinToString(prefix = " throws ")
    }

    private fun modifiers(bits: Int) = Modifier.toString(bits and SHOWN).let { if (it.isEmpty()) "" else "$it " }

    private companion object {
        val ENUM_METHODS = setOf("values", "valueOf", "getEntries")
        const val SHOWN = Modifier.PUBLIC or Modifier.PROTECTED or Modifier.STATIC or Modifier.ABSTRACT or Modifier.FINAL
    }
}
