package org.trigrid.numbering

/** A stretch of the boundary from which a graph is swept: [count] of its nodes from place [from], round its end. */
internal class SweepStart(val from: Int, val count: Int, val way: Way) {
    enum class Way {
        /** Cuthill-McKee. */
        SWEEP,

        /** Merged levels from the stretch to what is farthest from it. */
        MERGED,

        /** Merged levels from what is farthest from the stretch to it. */
        MERGED_BACK,
    }
}
