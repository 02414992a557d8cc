package org.trigrid.project

import org.trigrid.MeshOptions
import org.trigrid.domain.Domain
import org.trigrid.domain.Region
import org.trigrid.domain.withBase
import org.trigrid.io.DomainFormats
import org.trigrid.io.NamedDomain
import java.io.IOException
import java.nio.file.Path
import org.trigrid.domain.Path as ShapePath

/** Reads domains from any file that TriGrid knows: projects, and the formats of [DomainFormats]. */
public object DomainInputs {
    /** As the other, with the nodes that the file has. */
    @JvmStatic
    @Throws(IOException::class)
    public fun read(file: Path): List<DomainInput> = read(file, InputOptions.DEFAULT)

    /**
     * All domains of [file], in its order; at least one. A spacing asked for undoes the edits of a project's nodes.
     *
     * @throws org.trigrid.diagnostics.FileFormatException if the text is not what its format asks for.
     * @throws org.trigrid.diagnostics.InvalidShapeException if a shape cannot be exploded with the spacing.
     * @throws IOException if the file cannot be read.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun read(file: Path, options: InputOptions): List<DomainInput> {
        val read = if (isProject(file)) listOf(fromProject(file, options)) else fromFormats(file, options)
        return read.map { it.with(options.inner) }
    }

    /** Whether the name of [file] is that of a project. */
    @JvmStatic
    public fun isProject(file: Path): Boolean = file.fileName.toString().endsWith(PROJECT_ENDING, ignoreCase = true)

    private fun fromProject(file: Path, options: InputOptions): DomainInput {
        val given = ProjectFile.read(file)
        val asked = given.toBuilder().keepConnectors(given.keepsConnectors || options.keepConnectors)
        if (options.hasSpacing()) asked.path(respaced(given.path, options))
        val project = asked.build()
        val name = file.fileName.toString().dropLast(PROJECT_ENDING.length)
        return DomainInput(name, project.toDomain(), project.options, project.order, project.path)
    }

    private fun fromFormats(file: Path, options: InputOptions): List<DomainInput> {
        val read = DomainFormats.read(file, options.division)
        val domains = if (options.join) listOf(NamedDomain(DomainFormats.baseName(file), joined(read))) else read
        return domains.map { DomainInput(it.name, it.domain, MeshOptions.DEFAULT, 1, ShapePath.EMPTY) }
    }

    /** One domain of all, each a region called after it; of regions that a file has within a domain the names stay. */
    private fun joined(domains: List<NamedDomain>): Domain {
        val builder = Domain.builder()
        for (named in domains) builder.add(if (named.domain.regions.size > 1) named.domain else named.domain.withBase(Region.of(named.name)))
        return builder.build()
    }

    /** Every shape with the spacing and ratio asked for, as if its nodes had never been edited. */
    private fun respaced(path: ShapePath, options: InputOptions): ShapePath =
        (0 until path.shapeCount).fold(path) { changed, shape ->
            changed.replaceShape(shape, changed.shape(shape).withSpacing(options.spacing).withRatio(options.ratio))
        }

    private const val PROJECT_ENDING = ".trigrid.json"
}
