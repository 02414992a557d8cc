package org.trigrid.front

/**
 * The loop of the advancing front: take the first edge of the queue, make an element over it or put the edge back
 * behind the others, until no edge is left. Strategies differ in the order ([keyOf]) and in the element ([tryEdge]).
 *
 * It always ends: each element that adds a node is paid from a budget, every other one leaves less to mesh, and an
 * edge refused too often takes the constrained-Delaunay way out, which a valid front always has.
 */
internal abstract class FrontAdvancer(protected val state: FrontState, keyCount: Int, private val ticker: FrontTicker) {
    /** Hears of every element; null for nobody. */
    var listener: FrontListener? = null
    private var told = 0

    @JvmField protected val mesh = state.mesh

    @JvmField protected val front = state.front

    @JvmField protected val index = state.index

    @JvmField protected val acceptance = state.acceptance

    @JvmField protected val queue = FrontQueue(keyCount)

    /** Elements made by the constrained-Delaunay way out. */
    var fallbacks = 0
        private set

    /** Place of [edge] in the order; small keys first. */
    protected abstract fun keyOf(edge: Int): Int

    /** Makes one element or more over [edge] and returns true, or changes nothing and returns false. */
    protected abstract fun tryEdge(edge: Int): Boolean

    fun run() {
        for (edge in 0 until front.idBound) {
            ticker.tick(0)
            requeue(edge)
        }
        while (true) {
            val edge = queue.peek()
            if (edge < 0) return
            if (tryEdge(edge)) {
                if (listener != null) tell()
            } else {
                front.fails[edge]++
                requeue(edge)
            }
            ticker.tick(mesh.elementCount)
        }
    }

    private fun tell() {
        while (told < mesh.elementCount) {
            val at = 3 * told++
            val c = mesh.elements[at + 2]
            listener?.elementMade(mesh.elements[at], mesh.elements[at + 1], c, mesh.xy[2 * c], mesh.xy[2 * c + 1])
        }
    }

    /** The way out for [edge], which has just been made the base of the acceptance tests. */
    protected fun takeVisibleNode(edge: Int) {
        fallbacks++
        join(edge, state.wayOut.find(edge))
    }

    /** Makes the element of [edge] and a new node, which it returns, at ([x], [y]). */
    protected fun addNode(edge: Int, x: Double, y: Double): Int {
        val node = state.addNode(front.origin[edge], x, y)
        val fresh = front.advance(edge, node)
        requeueAround(edge)
        requeue(front.next[fresh])
        return node
    }

    /** Makes the element of [edge] and the node of [corner]. */
    protected fun join(edge: Int, corner: Int) {
        when (corner) {
            front.next[front.next[edge]] -> {
                queue.remove(front.earAtEnd(edge))
                closeOrRequeue(edge)
            }
            front.previous[edge] -> {
                queue.remove(front.earAtStart(edge))
                closeOrRequeue(corner)
            }
            else -> {
                val fresh = front.bridge(edge, corner)
                closeOrRequeue(edge)
                closeOrRequeue(fresh)
            }
        }
    }

    private fun closeOrRequeue(edge: Int) {
        val other = front.closeIfFlat(edge)
        if (other < 0) {
            requeueAround(edge)
        } else {
            queue.remove(edge)
            queue.remove(other)
        }
    }

    /** The angles at both ends of [edge] have changed: so have the keys of it and its neighbours. */
    protected open fun requeueAround(edge: Int) {
        requeue(edge)
        requeue(front.previous[edge])
        requeue(front.next[edge])
    }

    protected fun requeue(edge: Int) = queue.put(edge, keyOf(edge))
}
