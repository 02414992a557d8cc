package org.trigrid.project

import org.trigrid.MeshOptions
import org.trigrid.domain.Domain

/** A domain as a file gives it, and the options that the file asks to mesh it with. */
public class DomainInput internal constructor(
    /** From the file, or after the file. */
    @get:JvmName("name") public val name: String,
    @get:JvmName("domain") public val domain: Domain,
    @get:JvmName("options") public val options: MeshOptions,
) {
    override fun toString(): String = "$name (${domain.nodeCount} nodes)"
}
