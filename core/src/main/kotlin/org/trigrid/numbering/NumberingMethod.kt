package org.trigrid.numbering

/** How the nodes of a mesh are numbered. */
public enum class NumberingMethod {
    /** As the front made them. */
    NONE,

    /** The paper's Cuthill-McKee: from each boundary node of lowest degree, the best kept. */
    CUTHILL_MCKEE,

    /** The best of several orderings by bandwidth, then profile; never worse than as generated. */
    BEST,
}
