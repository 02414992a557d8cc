package org.trigrid.io

/** What a `.geo` script defines. Numbers of entities are those of the script. */
internal class GeoModel {
    /** @param size wanted length of edges, NaN for none. */
    class Point(val x: Double, val y: Double, val size: Double)

    class Curve(val curve: PlaneCurve, val begin: Point, val end: Point)

    class Loop(val curves: List<Int>, val place: Int)

    class Surface(val number: Int, val loops: List<Int>, val place: Int)

    val points = HashMap<Int, Point>()
    val curves = LinkedHashMap<Int, Curve>()
    val loops = HashMap<Int, Loop>()
    val surfaces = ArrayList<Surface>()
    val curveTags = HashMap<Int, String>()
    val surfaceNames = HashMap<Int, String>()
    val divisions = HashMap<Int, OutlineDivision>()
    lateinit var complaint: GeoTokens

    /** The first number that no entity of a kind has, by Gmsh's name for it. */
    fun newNumber(name: String): Int? = when (name) {
        "newp" -> 1 + (points.keys.maxOrNull() ?: 0)
        "newl", "newc" -> 1 + (curves.keys.maxOrNull() ?: 0)
        "newll", "newcl" -> 1 + (loops.keys.maxOrNull() ?: 0)
        "news" -> 1 + (surfaces.maxOfOrNull { it.number } ?: 0)
        else -> null
    }
}
