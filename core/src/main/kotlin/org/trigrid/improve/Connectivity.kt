package org.trigrid.improve

import org.trigrid.geometry.HalfEdges.next
import org.trigrid.geometry.HalfEdges.previous
import org.trigrid.mesh.MutableMesh

/**
 * Surgery on the connectivity of a mesh: flips, collapses and splits that keep twins, valences and one outgoing
 * half-edge per node right. No geometry: who calls has checked that every element stays positive.
 *
 * The *valence* of a node is the number of elements around it; for a node inside it equals the degree, for a boundary
 * node it is one less per fan of elements. Nodes and elements that die are used again by later splits.
 */
internal class Connectivity(@JvmField val mesh: MutableMesh, progress: ImproveProgress = ImproveProgress {}) {
    /** A half-edge that starts at the node, or -1 for a dead or unused one. */
    @JvmField
    var outgoing: IntArray = IntArray(mesh.nodeCount)

    /** Elements around each node. */
    @JvmField
    var valence: IntArray = IntArray(mesh.nodeCount)

    private var deadElements = IntArray(64)
    private var deadElementCount = 0
    private var deadNodes = IntArray(64)
    private var deadNodeCount = 0

    init {
        java.util.Arrays.fill(outgoing, -1)
        val elements = mesh.elements
        for (t in 0 until mesh.elementCount) {
            progress.pass()
            if (elements[3 * t] < 0) {
                bury(t)
                continue
            }
            for (h in 3 * t..3 * t + 2) {
                outgoing[elements[h]] = h
                valence[elements[h]]++
            }
        }
    }

    /** Whether a node may move or go. */
    fun isFree(node: Int): Boolean = node >= mesh.fixedNodeCount

    /** Whether the node has so few elements that it must not lose one: 3 around a free node, 1 at a fixed one. */
    fun isAtLeast(node: Int): Boolean = valence[node] <= if (isFree(node)) 3 else 1

    /** Whether a free node and all nodes around it are inside the domain and have the valence 6. */
    fun isRegular(node: Int): Boolean {
        if (valence[node] != 6) return false
        var h = outgoing[node]
        for (i in 0 until 6) {
            val n = mesh.elements[next(h)]
            if (valence[n] != 6 || !isFree(n)) return false
            h = mesh.twins[previous(h)]
        }
        return true
    }

    /** The half-edge from a free node to its neighbour [to]. */
    fun halfEdge(from: Int, to: Int): Int {
        var h = outgoing[from]
        while (mesh.elements[next(h)] != to) h = mesh.twins[previous(h)]
        return h
    }

    /**
     * Turns the edge a-b of the elements (a, b, c) and (b, a, d) into d-c:
     * ```
     *       c                c
     *      / \              /|\
     *     / t \            / | \
     *    a--h->b    ->    a t|s b
     *     \ s /            \ | /
     *      \ /              \|/
     *       d                d
     * ```
     * [h] is then a-d; the new edge is `next(h)`.
     */
    fun flip(h: Int) {
        val elements = mesh.elements
        val twins = mesh.twins
        val g = twins[h]
        val nh = next(h)
        val ph = previous(h)
        val ng = next(g)
        val pg = previous(g)
        val a = elements[h]
        val b = elements[g]
        val c = elements[ph]
        val d = elements[pg]
        val outerH = twins[nh]
        val outerG = twins[ng]
        elements[nh] = d
        elements[ng] = c
        mesh.link(h, outerG)
        mesh.link(g, outerH)
        mesh.link(nh, ng)
        outgoing[a] = h
        outgoing[b] = g
        outgoing[c] = ng
        outgoing[d] = nh
        valence[a]--
        valence[b]--
        valence[c]++
        valence[d]++
    }

    /** Pulls the free node at the start of [h] into the node at its end; two elements and the node die. */
    fun collapse(h: Int) {
        val elements = mesh.elements
        val twins = mesh.twins
        val n = elements[h]
        val m = elements[next(h)]
        val g = twins[h]
        val left = elements[previous(h)]
        val right = elements[previous(g)]
        var at = h
        do {
            elements[at] = m
            at = twins[previous(at)]
        } while (at != h)
        val innerLeft = twins[previous(h)]
        val innerRight = twins[next(g)]
        val outerLeft = twins[next(h)]
        val outerRight = twins[previous(g)]
        mesh.link(innerLeft, outerLeft)
        mesh.link(innerRight, outerRight)
        outgoing[m] = innerLeft
        outgoing[left] = next(innerLeft)
        outgoing[right] = innerRight
        valence[m] += valence[n] - 4
        valence[left]--
        valence[right]--
        outgoing[n] = -1
        valence[n] = 0
        mesh.sizes[n] = Double.NaN
        if (deadNodeCount == deadNodes.size) deadNodes = deadNodes.copyOf(2 * deadNodeCount)
        deadNodes[deadNodeCount++] = n
        bury(h / 3)
        bury(g / 3)
    }

    /**
     * Takes back [collapse] of [h] as long as nothing has happened since: [h] ran from [n], of wanted length [size], to
     * [m], between the nodes [left] and [right].
     */
    fun undoCollapse(h: Int, n: Int, m: Int, left: Int, right: Int, size: Double) {
        val elements = mesh.elements
        val twins = mesh.twins
        // The links of the dead elements still tell what lay around them.
        val g = twins[h]
        deadNodeCount--
        deadElementCount -= 2
        elements[h] = n
        elements[next(h)] = m
        elements[previous(h)] = left
        elements[g] = m
        elements[next(g)] = n
        elements[previous(g)] = right
        mesh.link(next(h), twins[next(h)])
        mesh.link(previous(h), twins[previous(h)])
        mesh.link(next(g), twins[next(g)])
        mesh.link(previous(g), twins[previous(g)])
        var count = 0
        var at = h
        do {
            elements[at] = n
            count++
            at = twins[previous(at)]
        } while (at != h)
        outgoing[n] = h
        outgoing[m] = g
        valence[n] = count
        valence[m] -= count - 4
        valence[left]++
        valence[right]++
        mesh.sizes[n] = size
    }

    /** Puts a new node on the inner edge [h], which becomes its first half, and returns the node. Its valence is 4. */
    fun split(h: Int, x: Double, y: Double, size: Double): Int {
        val n = newNode(x, y, size)
        val t = newElement()
        val s = newElement()
        val elements = mesh.elements
        val twins = mesh.twins
        val g = twins[h]
        val nh = next(h)
        val ng = next(g)
        val a = elements[h]
        val b = elements[g]
        val c = elements[previous(h)]
        val d = elements[previous(g)]
        val outerH = twins[nh]
        val outerG = twins[ng]
        elements[t] = n
        elements[t + 1] = b
        elements[t + 2] = c
        elements[s] = n
        elements[s + 1] = a
        elements[s + 2] = d
        elements[nh] = n
        elements[ng] = n
        mesh.link(h, s)
        mesh.link(g, t)
        mesh.link(nh, t + 2)
        mesh.link(ng, s + 2)
        twins[t + 1] = -1
        twins[s + 1] = -1
        mesh.link(t + 1, outerH)
        mesh.link(s + 1, outerG)
        outgoing[n] = nh
        outgoing[a] = h
        outgoing[b] = g
        outgoing[c] = previous(h)
        outgoing[d] = previous(g)
        valence[n] = 4
        valence[c]++
        valence[d]++
        return n
    }

    /** Whether the element of a half-edge is alive. */
    fun isAlive(h: Int): Boolean = mesh.elements[h - h % 3] >= 0

    private fun bury(t: Int) {
        mesh.elements[3 * t] = -1
        if (deadElementCount == deadElements.size) deadElements = deadElements.copyOf(2 * deadElementCount)
        deadElements[deadElementCount++] = t
    }

    /** First half-edge of an element to fill. */
    private fun newElement(): Int =
        3 * if (deadElementCount > 0) deadElements[--deadElementCount] else mesh.addElement(0, 0, 0)

    private fun newNode(x: Double, y: Double, size: Double): Int {
        if (deadNodeCount == 0) {
            val n = mesh.addNode(x, y, size)
            if (n >= outgoing.size) {
                outgoing = outgoing.copyOf(n + n / 2 + 16)
                valence = valence.copyOf(outgoing.size)
            }
            return n
        }
        val n = deadNodes[--deadNodeCount]
        mesh.xy[2 * n] = x
        mesh.xy[2 * n + 1] = y
        mesh.sizes[n] = size
        return n
    }
}
