package org.trigrid.spark

import org.trigrid.MeshOptions
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.Domain
import org.trigrid.io.DomainFormats
import org.trigrid.mesh.EdgeMiddles
import org.trigrid.project.DomainInputs
import org.trigrid.project.InputOptions
import java.io.IOException
import java.nio.file.Files

/** A domain of an outline, ready to be meshed. */
internal class OutlineDomain(val name: String, val domain: Domain, val options: MeshOptions, val middles: () -> EdgeMiddles)

/** Reads outlines as the command line reads files. */
internal class OutlineDomains(private val plan: MeshPlan) {
    @Throws(IOException::class)
    fun of(outline: Outline): List<OutlineDomain> {
        if (outline.trouble != null) throw IOException(outline.trouble)
        if (outline.format.equals(PROJECT, ignoreCase = true)) return ofProject(outline)
        val format = outline.format?.let {
            DomainFormats.named(it) ?: throw FileFormatException(outline.name, 0, 0, "there is no format \"$it\" of outlines")
        }
        return DomainFormats.parse(outline.content, outline.name, format, plan.division).map {
            OutlineDomain(it.name, it.domain, plan.options.over(MeshOptions.DEFAULT)) { EdgeMiddles.STRAIGHT }
        }
    }

    /** A project is only read from a file. */
    private fun ofProject(outline: Outline): List<OutlineDomain> {
        val folder = Files.createTempDirectory("trigrid")
        val file = folder.resolve(PROJECT_FILE)
        try {
            Files.write(file, outline.content)
            return DomainInputs.read(file, InputOptions.DEFAULT.withDivision(plan.division).withKeepConnectors(plan.keepConnectors)).map {
                OutlineDomain(outline.name, it.domain, plan.options.over(it.options), it::middles)
            }
        } finally {
            Files.deleteIfExists(file)
            Files.delete(folder)
        }
    }

    companion object {
        /** Takes the place of a format's name. */
        const val PROJECT = "project"
        private const val PROJECT_FILE = "project.trigrid.json"
    }
}
