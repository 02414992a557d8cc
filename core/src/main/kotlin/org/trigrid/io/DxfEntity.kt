package org.trigrid.io

/** The values of one entity by their group codes. */
internal class DxfEntity(private val pairs: DxfPairs) {
    private val values = HashMap<Int, Double>()
    val line: Int = pairs.lineNumber

    /** x, y, bulge of LWPOLYLINE; x, y of SPLINE. */
    val vertices = ArrayList<DoubleArray>()
    val knots = ArrayList<Double>()
    val weights = ArrayList<Double>()
    var layer = "0"
        private set

    /** Of the block that an INSERT puts here, or that a BLOCK begins. */
    var block = ""
        private set
    private val type = pairs.value

    /** Reads up to the next entity; false at the end of the file. */
    fun read(): Boolean {
        while (pairs.next()) {
            when (pairs.code) {
                0 -> return true
                2 -> block = pairs.value
                8 -> layer = pairs.value.ifEmpty { "0" }
                in 10..59, in 140..149, in 210..239 -> putNumber()
                60, 67, in 70..79 -> values[pairs.code] = pairs.int().toDouble()
            }
        }
        return false
    }

    private fun putNumber() {
        val value = pairs.number()
        val isList = type == "LWPOLYLINE" || type == "SPLINE"
        when {
            isList && pairs.code == 10 -> vertices.add(doubleArrayOf(value, 0.0, 0.0))
            isList && pairs.code == 20 -> vertices.lastOrNull()?.set(1, value)
            type == "LWPOLYLINE" && pairs.code == 42 -> vertices.lastOrNull()?.set(2, value)
            type == "SPLINE" && pairs.code == 40 -> knots.add(value)
            type == "SPLINE" && pairs.code == 41 -> weights.add(value)
            else -> values[pairs.code] = value
        }
    }

    operator fun get(code: Int): Double = values[code] ?: 0.0

    fun valueOr(code: Int, standard: Double): Double = values[code] ?: standard

    /** Not to be seen, or on the sheet that shows the drawing. */
    fun isHidden(): Boolean = get(60) != 0.0 || get(67) != 0.0

    fun flags(): Int = get(70).toInt()

    /** Seen from below, where x runs the other way; other planes are none of the drawing. */
    fun isMirrored(): Boolean {
        if (get(210) != 0.0 || get(220) != 0.0) fail("the entity is not in the plane of the drawing")
        return get(230) < 0
    }

    fun fail(reason: String): Nothing = pairs.failAtLine(line, reason)
}
