package org.trigrid

import java.util.Locale

/** What a mesh will cost in elements and memory, told before it is made, and whether that may be. */
internal class WorkLimit(private val expectedElements: Double, boundaryNodes: Int) {
    /** Peak memory of the whole run, in bytes. */
    val bytes: Double = BYTES_PER_ELEMENT * expectedElements + BYTES_PER_BOUNDARY_NODE * boundaryNodes

    /**
     * Why the mesh is not made, or null if it may be.
     *
     * @param heapBytes the most that the Java heap may grow to.
     */
    fun refusal(maxElements: Int, heapBytes: Long): String? = when {
        expectedElements > maxElements ->
            needs() + ", but the limit is $maxElements elements; raise maxElements (--max-elements), or the sizes"
        expectedElements > MOST_ELEMENTS -> needs() + ", but no mesh of more than ${MOST_ELEMENTS.toInt()} elements can be made"
        bytes > heapBytes ->
            needs() + ", but Java's heap ends at ${megabytes(heapBytes.toDouble())} MB; raise it by Java's option -Xmx " +
                "(in TRIGRID_JAVA_OPTS for the command trigrid), or raise the sizes"
        else -> null
    }

    private fun needs() =
        "this domain needs about %.3g elements and %s MB".format(Locale.ROOT, expectedElements, megabytes(bytes))

    private fun megabytes(bytes: Double) = "%.0f".format(Locale.ROOT, bytes / 1e6)

    private companion object {
        /** The front may make four times as many before it gives in, and arrays hold three numbers for each. */
        const val MOST_ELEMENTS = 150_000_000.0

        /** Measured at a million elements: a run with 155 bytes of heap for each passes, one with 140 does not. */
        const val BYTES_PER_ELEMENT = 160.0

        /** Measured on a boundary of 400,000 nodes. */
        const val BYTES_PER_BOUNDARY_NODE = 200.0
    }
}
