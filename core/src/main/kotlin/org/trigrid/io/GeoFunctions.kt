package org.trigrid.io

/** The functions of Gmsh's scripts. */
internal object GeoFunctions {
    /** The value of a function, of two numbers unless [y] is NaN; null if there is none of the [name]. */
    fun of(name: String, x: Double, y: Double): Double? = if (y.isNaN()) of(name, x) else ofTwo(name, x, y)

    private fun ofTwo(name: String, x: Double, y: Double): Double? = when (name) {
        "Atan2" -> StrictMath.atan2(x, y)
        "Hypot" -> StrictMath.hypot(x, y)
        "Fmod", "Modulo" -> x % y
        "Max" -> maxOf(x, y)
        "Min" -> minOf(x, y)
        else -> null
    }

    private fun of(name: String, x: Double): Double? = when (name) {
        "Sin" -> StrictMath.sin(x)
        "Cos" -> StrictMath.cos(x)
        "Tan" -> StrictMath.tan(x)
        "Asin" -> StrictMath.asin(x)
        "Acos" -> StrictMath.acos(x)
        "Atan" -> StrictMath.atan(x)
        "Sinh" -> StrictMath.sinh(x)
        "Cosh" -> StrictMath.cosh(x)
        "Tanh" -> StrictMath.tanh(x)
        "Sqrt" -> Math.sqrt(x)
        "Exp" -> StrictMath.exp(x)
        "Log" -> StrictMath.log(x)
        "Log10" -> StrictMath.log10(x)
        "Fabs", "Abs" -> Math.abs(x)
        "Floor" -> Math.floor(x)
        "Ceil" -> Math.ceil(x)
        "Round" -> Math.floor(x + 0.5)
        else -> null
    }
}
