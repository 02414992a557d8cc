package org.trigrid.reliability

import org.trigrid.RandomDomains.Family
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import org.trigrid.domain.InnerParts
import org.trigrid.domain.Region
import org.trigrid.regions.RegionDomains
import org.trigrid.spacing.ConstrainedDelaunay
import java.util.Random

/** Domains of several regions, and other families with points, lines and regions put into them. */
internal class InnerDomains(private val others: List<Family>) {
    val families: List<Family> = listOf(
        Family("regions") { r -> RegionDomains.make(r.nextInt(1_000_000)).domain },
        Family("another with points") { r -> filled(r, lines = false) },
        Family("another with lines and regions") { r -> filled(r, lines = true) },
    )

    /**
     * Points and closed or open lines in triangles between the domain's own nodes, so that none crosses another, however narrow the
     * domain is there; several points in one triangle, down to a millionth of its size from each other.
     */
    private fun filled(r: Random, lines: Boolean): Domain {
        val domain = others[r.nextInt(others.size)].make(r.nextInt(1_000_000).toLong())
        val mesh = ConstrainedDelaunay.of(domain)
        var inner = InnerParts.NONE
        for (t in List(1 + r.nextInt(6)) { r.nextInt(mesh.triangleCount) }.distinct()) {
            val first = place(domain, mesh, t, 0.1 + 0.8 * r.nextDouble(), r.nextDouble())
            val second = place(domain, mesh, t, 0.1 + 0.8 * r.nextDouble(), r.nextDouble())
            val third = place(domain, mesh, t, 0.1 + 0.8 * r.nextDouble(), r.nextDouble())
            val near = StrictMath.pow(10.0, -6 * r.nextDouble())
            val nearby = DoubleArray(2) { first[it] + near * (second[it] - first[it]) }
            inner = when {
                !lines -> inner.withPoint("p", first[0], first[1]).withPoint("p", nearby[0], nearby[1])
                r.nextBoolean() -> inner.withLine("line", first[0], first[1], second[0], second[1], third[0], third[1])
                else -> inner.withLoop("ring", first[0], first[1], second[0], second[1], third[0], third[1])
                    .withRegion(Region.of("r$t"), (first[0] + second[0] + third[0]) / 3, (first[1] + second[1] + third[1]) / 3)
            }
        }
        val result = domain.with(inner)
        return if (DomainCheck.check(result).isEmpty()) result else domain
    }

    private fun place(domain: Domain, mesh: ConstrainedDelaunay, t: Int, u: Double, v: Double): DoubleArray {
        val (a, b, c) = List(3) { mesh.nodes[3 * t + it] }
        return doubleArrayOf(
            (1 - u) * domain.x(a) + u * ((1 - v) * domain.x(b) + v * domain.x(c)),
            (1 - u) * domain.y(a) + u * ((1 - v) * domain.y(b) + v * domain.y(c)),
        )
    }
}
