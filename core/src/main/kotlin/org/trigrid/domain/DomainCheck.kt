package org.trigrid.domain

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.diagnostics.Fault
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.InvalidDomainException

/**
 * Finds everything that keeps a domain from being meshed.
 *
 * A domain without faults has finite coordinates, closed loops that meet in nodes only, and a winding number of 1 on the
 * left and 0 on the right of each boundary segment. Loops that touch in a node, several outer loops, and islands in holes
 * are no faults. Every decision is exact; time is O((n + k) log n) for n segments and k pairs that touch.
 */
public object DomainCheck {
    /**
     * All faults, by their first nodes; empty if the domain can be meshed.
     *
     * No more than about a thousand are listed. Each kind that occurs is among them, and where a kind was cut short its
     * last fault says how many are missing. Where a fault makes others meaningless (what is inside of an open walk?) those
     * are not looked for.
     */
    @JvmStatic
    public fun check(domain: Domain): List<Fault> = check(domain, Checkpoint.unheard())

    /** As the other, in a run that may be cancelled. */
    internal fun check(domain: Domain, checkpoint: Checkpoint): List<Fault> {
        val faults = FaultList()
        val checked = CheckedDomain(domain, checkpoint)
        checkpoint.reach(0.5)
        val pairs = lineFaults(checked, faults)
        if (!domain.regionMap.isPlanar) return faults.toList()
        val parts = BoundaryParts(checked)
        openWalks(checked, parts, faults)
        degenerateLoops(checked, faults)
        val windings = WindingFaults(checked, parts, pairs.isFaulty, faults)
        windings.find()
        val embedded = EmbeddedFaults(checked, windings, pairs.isFaulty, faults)
        embedded.find()
        embedded.findPoints()
        for (fault in domain.regionMap.faults) if (faults.count(fault.kind)) faults.keep(fault)
        return faults.toList()
    }

    /** @throws InvalidDomainException if [check] finds faults; it carries them all. */
    @JvmStatic
    public fun requireValid(domain: Domain) {
        val faults = check(domain)
        if (faults.isNotEmpty()) throw InvalidDomainException(faults)
    }

    /** What [check] lets pass but will cost element quality; made for valid domains. */
    @JvmStatic
    public fun warnings(domain: Domain): List<DomainWarning> = WarningSearch(CheckedDomain(domain)).find()

    /** Whether nodes and segments are such that what is inside of what cannot be told. */
    internal fun hasLineFaults(domain: Domain): Boolean {
        val faults = FaultList()
        lineFaults(CheckedDomain(domain), faults)
        return faults.toList().isNotEmpty()
    }

    private fun lineFaults(checked: CheckedDomain, faults: FaultList): PairFaults {
        nodeFaults(checked, faults)
        zeroLengths(checked, faults)
        return PairFaults(checked, faults).also { it.find() }
    }

    private fun nodeFaults(checked: CheckedDomain, faults: FaultList) {
        val xy = checked.xy
        for (node in 0 until checked.domain.nodeCount) {
            checked.checkpoint.pass()
            val first = checked.place[node]
            if (!checked.isFinite(node)) {
                faults.add(FaultKind.NOT_A_NUMBER, xy[2 * node], xy[2 * node + 1], intArrayOf(node)) {
                    val isNumber = xy[2 * node].isFinite() && xy[2 * node + 1].isFinite()
                    "node ${checked.nodeText(node)} has a coordinate that is " + if (isNumber) "beyond 1e60" else "not a number"
                }
            } else if (first != node) {
                faults.add(FaultKind.DUPLICATE_NODE, xy[2 * node], xy[2 * node + 1], intArrayOf(first, node)) {
                    "nodes $first and ${checked.nodeText(node)} lie at the same place"
                }
            }
        }
    }

    private fun zeroLengths(checked: CheckedDomain, faults: FaultList) {
        val domain = checked.domain
        for (s in 0 until domain.segmentCount) {
            checked.checkpoint.pass()
            val a = domain.segmentStart(s)
            val b = domain.segmentEnd(s)
            if (!checked.isWithoutLength(s)) continue
            faults.add(FaultKind.ZERO_LENGTH, domain.x(a), domain.y(a), intArrayOf(a, b)) {
                val what = if (checked.place[a] == checked.place[b]) "has no length" else "is shorter than 1e-60"
                "segment $a-$b at (${domain.x(a)}, ${domain.y(a)}) $what"
            }
        }
    }

    private fun openWalks(checked: CheckedDomain, parts: BoundaryParts, faults: FaultList) {
        for (node in 0 until checked.domain.nodeCount) {
            checked.checkpoint.pass()
            val balance = parts.balanceAt(node)
            if (balance == 0) continue
            faults.add(FaultKind.OPEN_WALK, checked.domain.x(node), checked.domain.y(node), intArrayOf(node)) {
                val what = if (balance > 0) "begins" else "ends"
                "a walk $what at node ${checked.nodeText(node)} and is not closed"
            }
        }
    }

    private fun degenerateLoops(checked: CheckedDomain, faults: FaultList) {
        val domain = checked.domain
        if (domain.boundaryCount == 0) {
            faults.add(FaultKind.DEGENERATE_LOOP, 0.0, 0.0, IntArray(0)) { "the domain has no boundary" }
        }
        for (loop in 0 until domain.loopCount) {
            checked.checkpoint.pass()
            val from = domain.loopStart(loop)
            val to = domain.loopStart(loop + 1)
            if (!isDegenerate(checked, from, to)) continue
            val nodes = domain.loopNodes(loop)
            faults.add(FaultKind.DEGENERATE_LOOP, domain.x(nodes[0]), domain.y(nodes[0]), nodes) {
                "the loop of ${nodes.size} nodes at node ${checked.nodeText(nodes[0])} encloses no area"
            }
        }
    }

    /** A piece of one or two segments within a longer loop is left to the faults of those segments. */
    private fun isDegenerate(checked: CheckedDomain, from: Int, to: Int): Boolean {
        val domain = checked.domain
        val isClosed = checked.place[domain.segmentEnd(to - 1)] == checked.place[domain.segmentStart(from)]
        if (!isClosed || SignedArea.sign(checked.xy, domain.segments, from, to) != 0) return false
        val places = (from until to).map { checked.place[domain.segmentStart(it)] }.distinct()
        if (places.any { !checked.isFinite(it) }) return false
        val most = places.size - 1
        return most >= 2 || places.all { checked.leaving.countAt(it) <= most && checked.arriving.countAt(it) <= most }
    }
}
