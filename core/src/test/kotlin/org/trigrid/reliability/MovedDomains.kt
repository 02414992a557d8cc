package org.trigrid.reliability

import org.trigrid.RandomDomains.Family
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import java.util.Random

/** Domains of other families, turned, scaled by 1e-9 to 1e9 and put up to 1e7 times their own size away from the origin. */
internal class MovedDomains(private val others: List<Family>) {
    val families: List<Family> = listOf(
        Family("another turned and scaled") { r -> moved(r, StrictMath.pow(10.0, -9 + 18 * r.nextDouble()), 0.0) },
        Family("another far away") { r -> moved(r, 1.0, StrictMath.pow(10.0, 7 * r.nextDouble())) },
    )

    /** Where rounding makes the moved domain invalid, as it does at a gap of one unit in the last place: the other itself. */
    private fun moved(r: Random, scale: Double, distance: Double): Domain {
        val domain = others[r.nextInt(others.size)].make(r.nextInt(1_000_000).toLong())
        val angle = 2 * Math.PI * r.nextDouble()
        val way = 2 * Math.PI * r.nextDouble()
        val cos = scale * StrictMath.cos(angle)
        val sin = scale * StrictMath.sin(angle)
        val extent = (0 until domain.nodeCount).maxOf { Math.abs(domain.x(it) - domain.x(0)) + Math.abs(domain.y(it) - domain.y(0)) }
        val x = distance * extent * StrictMath.cos(way)
        val y = distance * extent * StrictMath.sin(way)
        val xy = DoubleArray(domain.xy.size) {
            val (px, py) = listOf(domain.x(it / 2), domain.y(it / 2))
            if (it % 2 == 0) x + cos * px - sin * py else y + sin * px + cos * py
        }
        val result = Domain(xy, domain.segments, domain.segmentTags, domain.embedded, domain.tags, domain.regionMap, domain.points)
        return if (DomainCheck.check(result).isEmpty()) result else domain
    }
}
