package org.trigrid.editor.files

import org.trigrid.MeshOptions
import org.trigrid.front.Strategy
import org.trigrid.numbering.NumberingMethod
import org.trigrid.spacing.Sizes

/** Keeps how people want their meshes made for drawings to come; limits of the size belong to one drawing and are not kept. */
internal class OptionMemory(private val preferences: Preferences) {
    fun remember(options: MeshOptions) {
        preferences["mesh.sizes"] = options.sizes.name
        preferences["mesh.gradation"] = options.gradation.toString()
        preferences["mesh.strategy"] = options.strategy.name
        preferences["mesh.improve"] = options.improve.toString()
        preferences["mesh.tolerance"] = options.smoothingTolerance.toString()
        preferences["mesh.numbering"] = options.numbering.name
    }

    /** The options of a new drawing. */
    fun options(): MeshOptions {
        val usual = MeshOptions.DEFAULT
        return usual.toBuilder()
            .sizes(Sizes.entries.named("mesh.sizes") ?: usual.sizes)
            .gradation(preferences.number("mesh.gradation")?.takeIf { it > 0 } ?: usual.gradation)
            .strategy(Strategy.entries.named("mesh.strategy") ?: usual.strategy)
            .improve(preferences.flag("mesh.improve", usual.improve))
            .smoothingTolerance(preferences.number("mesh.tolerance")?.takeIf { it > 0 } ?: usual.smoothingTolerance)
            .numbering(NumberingMethod.entries.named("mesh.numbering") ?: usual.numbering)
            .build()
    }

    private fun <E : Enum<E>> List<E>.named(key: String): E? = firstOrNull { it.name == preferences[key] }
}
