package org.trigrid.front

import org.trigrid.domain.Domain
import org.trigrid.geometry.IntList

/**
 * Notes how the front advances over a domain, and tells afterwards what the front was after any number of elements.
 *
 * Pass it to [org.trigrid.MeshGenerator.generate] as the listener; a trace serves one run, and one thread at a time. Memory
 * is about 28 bytes an element.
 */
public class FrontTrace(
    /** The domain that is meshed. */
    @get:JvmName("domain") public val domain: Domain,
) : FrontListener {
    private val elements = IntList()
    private var xy: DoubleArray = domain.nodeCoordinates()
    private var nodes = domain.nodeCount

    /** The front after the first [advanced] elements, from which later ones are found. */
    private var sides = FrontSides(domain)
    private var advanced = 0

    /** Elements made. */
    @get:JvmName("elementCount")
    public var elementCount: Int = 0
        private set

    /** The domain's nodes and the new ones. */
    @get:JvmName("nodeCount")
    public val nodeCount: Int get() = nodes

    override fun elementMade(a: Int, b: Int, c: Int, x: Double, y: Double) {
        elements.add(a)
        elements.add(b)
        elements.add(c)
        elementCount++
        if (c < nodes) return
        if (2 * c + 1 >= xy.size) xy = xy.copyOf(Math.max(2 * c + 2, xy.size + xy.size / 2))
        xy[2 * c] = x
        xy[2 * c + 1] = y
        nodes = c + 1
    }

    /** The place of a node as the front made it, in the domain's unit. */
    public fun x(node: Int): Double = xy[2 * node]

    /** As [x]. */
    public fun y(node: Int): Double = xy[2 * node + 1]

    /** Node [corner], 0..2, of the element made as number [element], from 0; the first two are the side it was made over. */
    public fun nodeOf(element: Int, corner: Int): Int = elements[3 * element + corner]

    /**
     * The front after the first [count] elements: two nodes a side, what is still to be meshed on the side's left. To go on
     * from the count asked for before costs time for the elements between, to go back for all [count].
     *
     * @throws IndexOutOfBoundsException if [count] is not in 0..[elementCount].
     */
    public fun frontAfter(count: Int): IntArray {
        if (count !in 0..elementCount) throw IndexOutOfBoundsException("$count is not in 0..$elementCount")
        if (count < advanced) {
            sides = FrontSides(domain)
            advanced = 0
        }
        while (advanced < count) {
            sides.advance(nodeOf(advanced, 0), nodeOf(advanced, 1), nodeOf(advanced, 2))
            advanced++
        }
        return sides.toArray()
    }
}
