package org.trigrid.domain

import org.trigrid.geometry.IntList

/** Where each loop begins among the boundary segments of a domain, which come loop by loop. */
internal class DomainLoops(segments: IntArray, boundaryCount: Int) {
    /** First segment of each loop, and the boundary segments' count at the end. */
    val starts: IntArray

    init {
        val found = IntList()
        var first = 0
        for (s in 0 until boundaryCount) {
            val closes = segments[2 * s + 1] == segments[2 * first]
            val breaks = s + 1 < boundaryCount && segments[2 * s + 1] != segments[2 * s + 2]
            if (closes || breaks || s + 1 == boundaryCount) {
                found.add(first)
                first = s + 1
            }
        }
        found.add(boundaryCount)
        starts = found.toArray()
    }
}
