package org.trigrid.editor.document

import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import org.trigrid.project.DomainInputs
import java.nio.file.Path

/** The domain that the window shows, and the file it came from. */
internal class OpenDomain(val file: Path, val domain: Domain) {
    /** One line for the foot of the window. */
    fun summary(): String {
        val faults = DomainCheck.check(domain)
        val found = if (faults.isEmpty()) "no faults" else "${faults.size} faults, the first: ${faults[0]}"
        return "${domain.nodeCount} nodes, ${domain.loopCount} loops, $found"
    }

    companion object {
        /** Reads [file]; of several polygons in it, the first. */
        fun read(file: Path): OpenDomain = OpenDomain(file, DomainInputs.read(file).first().domain)
    }
}
