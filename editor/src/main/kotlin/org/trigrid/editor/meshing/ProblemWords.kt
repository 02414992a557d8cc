package org.trigrid.editor.meshing

import org.trigrid.diagnostics.FaultKind
import org.trigrid.domain.WarningKind
import org.trigrid.editor.tool.Figures

/** What faults and warnings are called in the problem list. */
internal object ProblemWords {
    private val LONG_NUMBER = Regex("""-?\d+\.\d{5,}(?:E-?\d+)?""")

    /** [message] with numbers as short as people read them. */
    fun shortened(message: String): String = LONG_NUMBER.replace(message) { Figures.length(it.value.toDouble()) }

    fun title(kind: FaultKind): String = when (kind) {
        FaultKind.NOT_A_NUMBER -> "Not a number"
        FaultKind.CROSSING -> "Lines cross"
        FaultKind.TOUCHING -> "Node on a line"
        FaultKind.DUPLICATE_NODE -> "Two nodes at one place"
        FaultKind.ZERO_LENGTH -> "No length"
        FaultKind.SPIKE -> "Spike"
        FaultKind.OPEN_WALK -> "Not closed"
        FaultKind.HOLE_OUTSIDE -> "Hole outside"
        FaultKind.OVERLAP -> "Lines overlap"
        FaultKind.DEGENERATE_LOOP -> "No area"
        FaultKind.EMBEDDED_OUTSIDE -> "Inner line or point outside"
        FaultKind.REGION_POINT -> "Region unclear"
    }

    fun title(kind: WarningKind): String = when (kind) {
        WarningKind.NARROW_GAP -> "Narrow gap"
        WarningKind.CLOSE_LOOPS -> "Loops close together"
        WarningKind.SHARP_ANGLE -> "Sharp angle"
        WarningKind.SPACING_JUMP -> "Spacing jumps"
    }
}
