package org.trigrid.cli

import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.MeshResult
import org.trigrid.domain.Domain
import java.nio.file.Path

/** Meshes the domains of a file with a bar on the terminal, open to Ctrl-C. */
internal class DomainMesher(private val session: Session, private val file: Path) {
    fun mesh(domain: Domain, options: MeshOptions): MeshResult =
        ProgressBar(session.terminal, session.cancellation).use { bar ->
            InputFailure.naming(file) { MeshGenerator.generate(domain, options, bar) }
        }
}
