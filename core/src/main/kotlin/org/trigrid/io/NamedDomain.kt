package org.trigrid.io

import org.trigrid.domain.Domain

/** One of the domains of a file. */
public class NamedDomain(
    /** From the file, or after the file; with a number where one feature has several polygons. */
    @get:JvmName("name") public val name: String,
    @get:JvmName("domain") public val domain: Domain,
) {
    override fun toString(): String = "$name (${domain.nodeCount} nodes)"
}
