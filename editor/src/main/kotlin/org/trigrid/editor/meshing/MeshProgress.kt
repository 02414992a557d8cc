package org.trigrid.editor.meshing

import org.trigrid.diagnostics.Stage

/** How far a run has come. */
internal class MeshProgress(val stage: Stage, val fraction: Double) {
    val words: String get() = when (stage) {
        Stage.CHECK -> "Checking"
        Stage.SIZES -> "Finding sizes"
        Stage.FRONT -> "Advancing the front"
        Stage.IMPROVE -> "Improving"
        Stage.RENUMBER -> "Renumbering"
    }
}
