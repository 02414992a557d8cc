package org.trigrid.front

internal object Tune {
    fun d(n: String, v: Double) = System.getProperty("t.$n")?.toDouble() ?: v
    @JvmField val pFactor = d("pFactor", 0.78)
    @JvmField val nodeClear = d("nodeClear", 0.62)
    @JvmField val edgeClear = d("edgeClear", 0.5)
    @JvmField val reach = d("reach", 0.85)
    @JvmField val bonus = d("bonus", 1.15)
    @JvmField val bonusR = d("bonusR", 0.62)
    @JvmField val order = d("order", 1.0).toInt()
    @JvmField val at = d("at", 0.6)
}
