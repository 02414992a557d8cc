package org.trigrid.diagnostics

/**
 * Hears how far a long run has come and may stop it.
 *
 * Called on the thread that meshes, at the start of each stage and then every few milliseconds; it should return at once.
 */
public fun interface ProgressMonitor {
    /**
     * @param stage the work under way.
     * @param fraction of the whole run that is done, 0..1; never falls during one run.
     * @return true to go on, false to cancel: the run then ends with [MeshingCancelledException].
     */
    public fun update(stage: Stage, fraction: Double): Boolean

    public companion object {
        /** Hears nothing and never cancels. */
        @JvmField
        public val NONE: ProgressMonitor = ProgressMonitor { _, _ -> true }
    }
}

/** The stages of a run, in their order. */
public enum class Stage {
    CHECK,
    SIZES,
    FRONT,
    IMPROVE,
    RENUMBER,
}
