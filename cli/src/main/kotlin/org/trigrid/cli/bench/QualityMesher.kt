package org.trigrid.cli.bench

import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.domain.Domain
import org.trigrid.io.MeshFormats
import org.trigrid.mesh.TriMesh
import org.trigrid.spacing.Sizes
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.deleteIfExists

/** A way to mesh a domain whose quality is measured. */
internal class QualityMesher private constructor(val title: String, private val make: (Domain) -> TriMesh?) {
    /** Null where a peer fails. */
    fun mesh(domain: Domain): TriMesh? = make(domain)

    companion object {
        fun ours(sizes: Sizes): QualityMesher {
            val builder = MeshOptions.builder().sizes(sizes)
            if (sizes == Sizes.GRADE) builder.gradation(NETGEN_GRADING)
            val options = builder.build()
            val title = if (sizes == Sizes.SMOOTH) "TriGrid smooth" else "TriGrid grade"
            return QualityMesher(title) { MeshGenerator.generate(it, options).mesh }
        }

        fun of(peer: Peer, program: PeerProgram) = QualityMesher(peer.title) { domain ->
            val file = Files.createTempFile("trigrid-peer", ".msh")
            try {
                program.run(peer, domain, 1, file)?.let { MeshFormats.read(file) }
            } finally {
                file.deleteIfExists()
            }
        }

        /** As the peers' script sets it. */
        const val NETGEN_GRADING = 0.3
    }
}
