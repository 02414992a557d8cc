package org.trigrid.reliability

import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.RandomDomains
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.diagnostics.TooManyElementsException
import org.trigrid.domain.Domain
import org.trigrid.front.Strategy
import org.trigrid.mesh.MeshCheck
import org.trigrid.spacing.Sizes
import java.util.Random

/** How a run over many random domains went; a domain counts once, whatever is wrong with its mesh. */
internal class FuzzTally(val family: String) {
    var domains = 0
    var tooMany = 0
    var elements = 0L
    var slowest = 0.0
    var slowestSeed = 0L
    var seconds = 0.0
    val failures = ArrayList<String>()

    fun line(): String = "%-32s %7d domains %11d elements %6d too large %4d failures %8.1f s, slowest %.2f s (seed %d)".format(
        java.util.Locale.ROOT, family, domains, elements, tooMany, failures.size, seconds, slowest, slowestSeed,
    )
}

/**
 * Meshes random domains and proves each mesh. The seed chooses the options too, so that all of them come into play.
 *
 * A domain fails if it is refused as invalid, if anything else is thrown, if `MeshCheck` finds anything, if the work was above
 * the budget ([mostElements]) or took out of all proportion to it.
 */
internal object FuzzRun {
    /** Elements that a mesh may have: four for each expected one, and the boundary's own, which do not depend on sizes. */
    fun mostElements(expected: Double, boundaryNodes: Int): Double = 4 * expected + 8.0 * boundaryNodes + 16

    /** Seconds that a mesh may take on a machine that has other things to do. */
    private fun mostSeconds(elements: Int, nodes: Int) = 5 + 200e-6 * (elements + nodes)

    /** Default options for every third seed. */
    fun options(seed: Long): MeshOptions {
        val builder = MeshOptions.builder().maxElements(MAX_ELEMENTS)
        val r = Random(seed * 31 + 7)
        if (seed % 3 == 0L) return builder.build()
        builder.strategy(Strategy.entries[r.nextInt(2)]).sizes(Sizes.entries[r.nextInt(2)])
        builder.gradation(StrictMath.pow(10.0, -1.3 + 1.6 * r.nextDouble()))
        builder.improve(r.nextInt(4) > 0)
        return builder.build()
    }

    fun run(family: RandomDomains.Family, seed: Long, tally: FuzzTally) {
        val since = System.nanoTime()
        try {
            meshAndProve(family, seed, tally)
        } catch (_: TooManyElementsException) {
            tally.tooMany++
        } catch (e: InvalidDomainException) {
            fail(tally, family, seed, "refused: ${e.message}")
        } catch (e: Exception) {
            fail(tally, family, seed, "threw $e at ${e.stackTrace.firstOrNull()}")
        } catch (e: StackOverflowError) {
            fail(tally, family, seed, "threw $e at ${e.stackTrace.firstOrNull()}")
        }
        tally.domains++
        tally.seconds += (System.nanoTime() - since) / 1e9
    }

    private fun meshAndProve(family: RandomDomains.Family, seed: Long, tally: FuzzTally) {
        val domain: Domain = family.make(seed)
        val since = System.nanoTime()
        // The large domains, few as they are, are meshed whatever they ask for.
        val limit = if (family.every < 20) MAX_ELEMENTS else LARGE_MAX_ELEMENTS
        val result = MeshGenerator.generate(domain, options(seed).toBuilder().maxElements(limit).build())
        val seconds = (System.nanoTime() - since) / 1e9
        if (seconds > tally.slowest) {
            tally.slowest = seconds
            tally.slowestSeed = seed
        }
        val mesh = result.mesh
        tally.elements += mesh.elementCount
        val violations = MeshCheck.check(mesh, domain)
        val most = mostElements(result.report.expectedElements, domain.nodeCount)
        when {
            violations.isNotEmpty() -> fail(tally, family, seed, "invalid: ${violations.first()}")
            mesh.elementCount > most -> fail(tally, family, seed, "${mesh.elementCount} elements, the budget is $most")
            seconds > mostSeconds(mesh.elementCount, mesh.nodeCount) -> fail(tally, family, seed, "took $seconds s")
        }
    }

    private fun fail(tally: FuzzTally, family: RandomDomains.Family, seed: Long, what: String) {
        tally.failures.add("${family.name} $seed: $what")
    }

    private const val MAX_ELEMENTS = 400_000
    private const val LARGE_MAX_ELEMENTS = 6_000_000

    /**
     * `FuzzRun FROM TO [SECONDS] [FAMILY,...]`: the seeds FROM until TO of every family, or of those named, until the time is
     * up. Prints a line a family and each failure; the exit code is 1 if there is one.
     */
    @JvmStatic
    fun main(args: Array<String>) {
        val from = args[0].toLong()
        val to = args[1].toLong()
        val end = System.nanoTime() + (args.getOrNull(2)?.toLong() ?: Long.MAX_VALUE / 2_000_000_000L) * 1_000_000_000L
        val names = args.getOrNull(3)?.split(',')
        val families = RandomDomains.families.filter { names == null || it.name in names }
        val tallies = families.map { FuzzTally(it.name) }
        var seed = from
        while (seed < to && System.nanoTime() < end) {
            for ((i, family) in families.withIndex()) {
                if (seed % family.every != 0L) continue
                val before = tallies[i].failures.size
                run(family, seed, tallies[i])
                if (tallies[i].failures.size > before) println("FAILED " + tallies[i].failures.last())
            }
            seed++
        }
        for (tally in tallies) println(tally.line())
        val failures = tallies.sumOf { it.failures.size }
        println("seeds $from until $seed: ${tallies.sumOf { it.domains }} domains, $failures failures")
        if (failures > 0) System.exit(1)
    }
}
