package org.trigrid.api

import java.lang.reflect.Constructor
import java.lang.reflect.Field
import java.lang.reflect.Method
import kotlin.metadata.KmDeclarationContainer
import kotlin.metadata.Visibility
import kotlin.metadata.jvm.KotlinClassMetadata
import kotlin.metadata.jvm.JvmMethodSignature
import kotlin.metadata.jvm.fieldSignature
import kotlin.metadata.jvm.getterSignature
import kotlin.metadata.jvm.setterSignature
import kotlin.metadata.jvm.signature
import kotlin.metadata.visibility

/** What of a class Kotlin calls public or protected; the class file alone does not tell `internal` from `public`. */
internal class KotlinVisibility private constructor(metadata: KotlinClassMetadata?) {
    private val methods = HashSet<String>()
    private val constructors = HashSet<String>()
    private val fields = HashSet<String>()

    /** Whether the class itself is public; a Java class is what its modifiers say. */
    val isPublic: Boolean

    init {
        when (metadata) {
            is KotlinClassMetadata.Class -> {
                isPublic = isOpen(metadata.kmClass.visibility)
                metadata.kmClass.constructors.filter { isOpen(it.visibility) }.forEach { add(constructors, it.signature) }
                metadata.kmClass.companionObject?.let { fields.add(it) }
                fields.add("INSTANCE")
                addMembers(metadata.kmClass)
            }
            is KotlinClassMetadata.FileFacade -> {
                addMembers(metadata.kmPackage)
                isPublic = methods.isNotEmpty()
            }
            else -> isPublic = false
        }
    }

    fun hasMethod(method: Method): Boolean = method.name + descriptor(method.parameterTypes, method.returnType) in methods

    fun hasConstructor(it: Constructor<*>): Boolean = "<init>" + descriptor(it.parameterTypes, Void.TYPE) in constructors

    fun hasField(field: Field): Boolean = field.name in fields

    private fun addMembers(container: KmDeclarationContainer) {
        container.functions.filter { isOpen(it.visibility) }.forEach { add(methods, it.signature) }
        for (property in container.properties) {
            if (!isOpen(property.visibility)) continue
            add(methods, property.getterSignature)
            if (property.setter?.let { isOpen(it.visibility) } == true) add(methods, property.setterSignature)
            property.fieldSignature?.let { fields.add(it.name) }
        }
    }

    private fun add(to: MutableSet<String>, signature: JvmMethodSignature?) {
        if (signature != null) to.add(signature.name + signature.descriptor)
    }

    private fun isOpen(visibility: Visibility) = visibility == Visibility.PUBLIC || visibility == Visibility.PROTECTED

    private fun descriptor(parameters: Array<Class<*>>, result: Class<*>): String =
        parameters.joinToString("", "(", ")") { it.descriptorString() } + result.descriptorString()

    companion object {
        fun of(type: Class<*>): KotlinVisibility =
            KotlinVisibility(type.getAnnotation(Metadata::class.java)?.let { KotlinClassMetadata.readStrict(it) })
    }
}
