package org.trigrid.editor.document

/**
 * Colours that boundary groups have by themselves, `#rrggbb`: those of Okabe and Ito (2002), which colour-blind people can
 * tell apart; without yellow, which fails on white.
 */
internal class GroupPalette private constructor(private val colours: List<String>) {
    /** The colour of [group]: the one chosen for it, or that of its place among all [groups]. */
    fun colourOf(group: String, groups: List<String>, chosen: Map<String, String>): String =
        chosen[group] ?: colours[Math.floorMod(groups.indexOf(group), colours.size)]

    companion object {
        val ON_LIGHT = GroupPalette(listOf("#1b2a38", "#d55e00", "#0072b2", "#009e73", "#b3568f", "#b87d00", "#2b8fc4", "#8b5a2b"))
        val ON_DARK = GroupPalette(listOf("#dbe4ec", "#ff8a3d", "#56b4e9", "#2fd0a0", "#e39ac6", "#f0c040", "#9ad1f5", "#c89a6a"))
    }
}
