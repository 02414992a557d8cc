package org.trigrid.project

import org.trigrid.MeshOptions
import org.trigrid.domain.EdgeExploder
import org.trigrid.io.DomainFormats
import java.io.IOException
import java.nio.file.Path

/** Reads domains from any file that TriGrid knows: projects, and the polygon files of [DomainFormats]. */
public object DomainInputs {
    /** As the other, with the nodes that the file has. */
    @JvmStatic
    @Throws(IOException::class)
    public fun read(file: Path): List<DomainInput> = read(file, InputOptions.DEFAULT)

    /**
     * All domains of [file], in its order; at least one.
     *
     * @throws org.trigrid.diagnostics.FileFormatException if the text is not what its format asks for.
     * @throws org.trigrid.diagnostics.InvalidShapeException if a shape cannot be exploded with the spacing.
     * @throws IOException if the file cannot be read.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun read(file: Path, options: InputOptions): List<DomainInput> =
        DomainFormats.read(file).map {
            val domain = if (options.hasSpacing()) EdgeExploder.explode(it.domain, options.spacing, options.ratio) else it.domain
            DomainInput(it.name, domain, MeshOptions.DEFAULT)
        }
}
