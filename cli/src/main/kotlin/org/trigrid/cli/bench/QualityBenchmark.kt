package org.trigrid.cli.bench

import org.trigrid.project.DomainInput
import org.trigrid.spacing.Sizes

/** Meshes domains in all ways and keeps the figures. */
internal class QualityBenchmark(peers: PeerProgram?, private val tell: (String) -> Unit) {
    private val meshers = listOf(QualityMesher.ours(Sizes.SMOOTH), QualityMesher.ours(Sizes.GRADE)) +
        peers?.versions?.keys.orEmpty().map { QualityMesher.of(it, peers!!) }

    /** Title of each way to its meshes' figures, in the order of the domains; those that failed are left out. */
    fun measure(domains: List<DomainInput>): Map<String, List<QualityCase>> {
        val result = meshers.associate { it.title to ArrayList<QualityCase>() }
        for (given in domains) {
            tell(given.name)
            for (mesher in meshers) {
                val mesh = mesher.mesh(given.domain) ?: continue
                result.getValue(mesher.title).add(QualityCase(given.name, mesh, given.domain))
            }
        }
        return result
    }
}
