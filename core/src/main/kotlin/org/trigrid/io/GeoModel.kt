package org.trigrid.io

import org.trigrid.domain.Region

/** What a `.geo` script defines. Numbers of entities are those of the script. */
internal class GeoModel {
    /** @param size wanted length of edges, NaN for none. */
    class Point(val x: Double, val y: Double, var size: Double)

    class Curve(val curve: PlaneCurve, val begin: Point, val end: Point)

    class Loop(val curves: List<Int>, val place: Int)

    class Surface(val number: Int, val loops: List<Int>, val place: Int)

    val points = Numbered<Point>()
    val curves = Numbered<Curve>()
    val loops = Numbered<Loop>()
    val surfaces = ArrayList<Surface>()

    /** Curves inside of a surface, by its number. */
    val inner = HashMap<Int, ArrayList<Int>>()

    /** Points inside of a surface, by its number. */
    val innerPoints = HashMap<Int, ArrayList<Int>>()
    val pointTags = HashMap<Int, String>()
    val curveTags = HashMap<Int, String>()

    /** The physical groups of surfaces. */
    val regions = HashMap<Int, Region>()
    val divisions = HashMap<Int, OutlineDivision>()
    lateinit var complaint: GeoTokens

    /** The first number that no entity of a kind has, by Gmsh's name for it. */
    fun newNumber(name: String): Int? = when (name) {
        "newp" -> points.next
        "newl", "newc" -> curves.next
        "newll", "newcl" -> loops.next
        "news" -> 1 + (surfaces.maxOfOrNull { it.number } ?: 0)
        else -> null
    }
}

/** Entities of one kind by their numbers. */
internal class Numbered<T> {
    private val entities = LinkedHashMap<Int, T>()

    /** One above the largest number. */
    var next = 1
        private set

    val numbers: List<Int> get() = entities.keys.toList()

    operator fun get(number: Int): T? = entities[number]

    operator fun set(number: Int, entity: T) {
        entities[number] = entity
        next = Math.max(next, number + 1)
    }
}
