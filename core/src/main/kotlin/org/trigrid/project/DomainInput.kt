package org.trigrid.project

import org.trigrid.MeshOptions
import org.trigrid.domain.Domain
import org.trigrid.domain.InnerParts
import org.trigrid.domain.Path
import org.trigrid.mesh.EdgeMiddles

/** A domain as a file gives it, and the options that the file asks to mesh it with. */
public class DomainInput internal constructor(
    /** From the file, or after the file. */
    @get:JvmName("name") public val name: String,
    @get:JvmName("domain") public val domain: Domain,
    @get:JvmName("options") public val options: MeshOptions,
    /** Of the elements, as the file asks for it: 1 for three nodes an element, 2 for six. */
    @get:JvmName("order") public val order: Int,
    private val path: Path,
) {
    /**
     * Middles of the domain's boundary edges on the curves of a project, straight ones for other files. A new object, for one
     * mesh.
     */
    public fun middles(): EdgeMiddles = ShapeMiddles(path)

    internal fun with(inner: InnerParts): DomainInput = if (inner.isEmpty()) this else DomainInput(name, domain.with(inner), options, order, path)

    override fun toString(): String = "$name (${domain.nodeCount} nodes)"
}
