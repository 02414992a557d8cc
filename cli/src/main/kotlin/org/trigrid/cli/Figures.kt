package org.trigrid.cli

import java.util.Locale

/** Figures for people, the same in every locale. */
internal object Figures {
    fun of(value: Double): String = String.format(Locale.ROOT, "%.3f", value)

    fun percent(share: Double): String = String.format(Locale.ROOT, "%.1f %%", 100 * share)

    fun seconds(value: Double): String = String.format(Locale.ROOT, "%.2f s", value)
}
