package org.trigrid.improve

import org.trigrid.mesh.MutableMesh

/** Which nodes have a changed star: those to look at again, once for each purpose. */
internal class Changes(private val mesh: MutableMesh) {
    private var flags = ByteArray(mesh.nodeCount)

    /** The elements around [node] have changed. */
    fun touch(node: Int) = touch(node, SURGERY or SMOOTHING or TRIAL or FLIPS)

    fun touchAll() {
        for (node in 0 until mesh.nodeCount) touch(node)
    }

    /** The elements around [node] have changed in a way that matters for [purposes] alone. */
    fun touch(node: Int, purposes: Int) {
        if (node >= flags.size) flags = flags.copyOf(node + node / 2 + 16)
        flags[node] = (flags[node].toInt() or purposes).toByte()
    }

    /** Whether [node] is to be looked at for [purpose]; afterwards it is not. */
    fun take(node: Int, purpose: Int): Boolean {
        if (node >= flags.size) return false
        val flag = flags[node].toInt()
        if (flag and purpose == 0) return false
        flags[node] = (flag and purpose.inv()).toByte()
        return true
    }

    /** Whether [node] is to be looked at for [purpose]. */
    fun has(node: Int, purpose: Int): Boolean = node < flags.size && flags[node].toInt() and purpose != 0

    /** No node is to be looked at for [purpose]. */
    fun clear(purpose: Int) {
        for (node in flags.indices) flags[node] = (flags[node].toInt() and purpose.inv()).toByte()
    }

    /** Starts a pass of trials: what has been touched up to now is due, and stays so while the pass lasts. */
    fun beginTrials() {
        for (node in flags.indices) {
            val flag = flags[node].toInt()
            val kept = flag and (TRIAL or DUE).inv()
            flags[node] = (if (flag and TRIAL != 0) kept or DUE else kept).toByte()
        }
    }

    /** Whether [node] was touched before or during this pass of trials. */
    fun isDue(node: Int): Boolean = node >= flags.size || flags[node].toInt() and (TRIAL or DUE) != 0

    companion object {
        const val SMOOTHING: Int = 1
        const val SURGERY: Int = 2
        const val WORST: Int = 4
        const val FLIPS: Int = 32
        private const val TRIAL: Int = 8
        private const val DUE: Int = 16
    }
}
