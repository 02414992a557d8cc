package org.trigrid.improve

import org.trigrid.mesh.MutableMesh

/** Which nodes have a changed star: those to look at again, once for each purpose. */
internal class Changes(private val mesh: MutableMesh) {
    private var flags = ByteArray(mesh.nodeCount)

    /** The star of [node] changed. */
    fun touch(node: Int) {
        if (node >= flags.size) flags = flags.copyOf(node + node / 2 + 16)
        flags[node] = ALL
    }

    fun touchAll() {
        if (flags.size < mesh.nodeCount) flags = flags.copyOf(mesh.nodeCount)
        flags.fill(ALL)
    }

    /** A ring node moved: only [SMOOTHING] and [SURGERY] in as far as asked. */
    fun touch(node: Int, purpose: Int) {
        if (node >= flags.size) flags = flags.copyOf(node + node / 2 + 16)
        flags[node] = (flags[node].toInt() or purpose).toByte()
    }

    /** Whether [node] is to be looked at for [purpose]; afterwards it is not. */
    fun take(node: Int, purpose: Int): Boolean {
        if (node >= flags.size) return false
        val flag = flags[node].toInt()
        if (flag and purpose == 0) return false
        flags[node] = (flag and purpose.inv()).toByte()
        return true
    }

    companion object {
        const val SMOOTHING: Int = 1
        const val SURGERY: Int = 2
        const val WORST: Int = 4
        private const val ALL: Byte = 3
    }
}
