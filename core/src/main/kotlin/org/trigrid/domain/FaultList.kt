package org.trigrid.domain

import org.trigrid.diagnostics.Fault
import org.trigrid.diagnostics.FaultKind
import java.util.Arrays
import java.util.EnumMap

/** Collects faults; a flood of one kind neither fills the memory nor hides the other kinds. */
internal class FaultList {
    private val listed = EnumMap<FaultKind, MutableList<Fault>>(FaultKind::class.java)
    private val counts = IntArray(FaultKind.entries.size)

    inline fun add(kind: FaultKind, x: Double, y: Double, nodes: IntArray, message: () -> String) {
        if (count(kind)) keep(Fault(kind, message(), x, y, nodes))
    }

    /** Counts a fault of this kind. @return whether there is room to list it. */
    fun count(kind: FaultKind): Boolean = counts[kind.ordinal]++ < LIMIT

    fun keep(fault: Fault) {
        listed.getOrPut(fault.kind) { ArrayList() }.add(fault)
    }

    /** The faults by their first nodes; at most [LIMIT], and for each kind cut short one that tells how many are missing. */
    fun toList(): List<Fault> {
        val quota = fairQuota()
        val faults = ArrayList<Fault>()
        val cut = ArrayList<Fault>()
        for ((kind, list) in listed) {
            list.sortWith(ORDER)
            faults.addAll(list.take(quota))
            val missing = counts[kind.ordinal] - Math.min(quota, list.size)
            if (missing > 0) cut.add(notListed(list[Math.min(quota, list.size - 1)], missing))
        }
        faults.sortWith(ORDER)
        return faults + cut
    }

    private fun fairQuota(): Int {
        val sizes = listed.values.map { it.size }
        var quota = LIMIT
        while (sizes.sumOf { Math.min(it, quota) } > LIMIT) quota--
        return quota
    }

    private fun notListed(next: Fault, missing: Int): Fault {
        val message = "$missing more faults of this kind are not listed; one of them: ${next.message}"
        return Fault(next.kind, message, next.x, next.y, next.nodes())
    }

    private companion object {
        const val LIMIT = 1000

        val ORDER: Comparator<Fault> = Comparator { a, b ->
            val byNodes = Arrays.compare(a.nodes(), b.nodes())
            if (byNodes != 0) byNodes else a.kind.compareTo(b.kind)
        }
    }
}
