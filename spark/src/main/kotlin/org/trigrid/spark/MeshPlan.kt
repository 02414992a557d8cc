package org.trigrid.spark

import org.trigrid.MeshOptions
import org.trigrid.io.CurveDivision
import java.io.Serializable

/** The options of a domain, by those that its file asks for. */
internal fun interface OptionsRule : Serializable {
    fun over(given: MeshOptions): MeshOptions
}

/** How outlines are to be meshed; goes to all machines. */
internal class MeshPlan(
    val options: OptionsRule,
    val division: CurveDivision,
    /** Whether the connectors of a project's path stay as lines inside the domain. */
    val keepConnectors: Boolean,
    /** Of the elements, 1 or 2. */
    val order: Int,
    /** 0 for no new partitions. */
    val elementsPerPartition: Long,
) : Serializable {
    private companion object {
        private const val serialVersionUID = 1L
    }
}
