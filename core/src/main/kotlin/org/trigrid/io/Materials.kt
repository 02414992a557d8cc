package org.trigrid.io

import org.trigrid.domain.Region

/** Numbers from 1 on that are not among [taken]. */
internal class FreeNumbers(private val taken: List<Int>) {
    private var last = 0

    fun next(): Int {
        do last++ while (last in taken)
        return last
    }
}

/** Numbers of materials in files. */
internal object Materials {
    /** Per region the number of its material, or else one that no other has. */
    fun of(regions: List<Region>): IntArray {
        val free = FreeNumbers(regions.map { it.material })
        return IntArray(regions.size) { if (regions[it].material > 0) regions[it].material else free.next() }
    }
}
