package org.trigrid.editor.files

import org.trigrid.domain.Domain
import org.trigrid.editor.command.ProjectCommands
import org.trigrid.editor.document.EditorDocument
import org.trigrid.io.DomainFormats
import org.trigrid.project.DomainInputs
import org.trigrid.project.Project
import org.trigrid.project.ProjectFile
import org.trigrid.project.ShapeDefaults
import java.io.IOException
import java.nio.file.Path

/** What a file held, and whether saving goes back into it. */
internal class OpenedFile(val document: EditorDocument, val file: Path, val isProject: Boolean)

/** Reads and writes documents. */
internal object DocumentFile {
    const val ENDING = ".trigrid.json"

    /** Endings of all files that can be opened. */
    val patterns = listOf("*$ENDING") + DomainFormats.all().filter { it.canRead }.flatMap { it.endings }.distinct().map { "*$it" }

    /**
     * Reads a project, or the loops of a polygon file; of several domains in one, all.
     *
     * @throws org.trigrid.diagnostics.TriGridException if the file is not what it should be.
     */
    @Throws(IOException::class)
    fun read(file: Path): OpenedFile {
        if (DomainInputs.isProject(file)) return OpenedFile(EditorDocument(PictureFile.absolute(ProjectFile.read(file), file)), file, true)
        val domains = DomainFormats.read(file).map { it.domain }
        val project = Project.builder().loops(domains.flatMap { ProjectCommands.loopsOf(it) })
            .defaults(defaultsFor(domains)).build()
        return OpenedFile(EditorDocument(project), file, false)
    }

    @Throws(IOException::class)
    fun write(file: Path, document: EditorDocument) = ProjectFile.write(file, PictureFile.relative(document.project, file))

    /** [file] with the ending of a project. */
    fun withEnding(file: Path): Path {
        val name = file.fileName.toString()
        return if (name.endsWith(ENDING)) file else file.resolveSibling(name.removeSuffix(".json").removeSuffix(".trigrid") + ENDING)
    }

    /** Name of a project's file made from that of another file. */
    fun projectName(file: Path): String = file.fileName.toString().removeSuffix(ENDING).substringBeforeLast('.') + ENDING

    /** New shapes get about the mean length of the segments that are there. */
    private fun defaultsFor(domains: List<Domain>): ShapeDefaults {
        val lengths = domains.flatMap { domain ->
            (0 until domain.segmentCount).map { segment ->
                val a = domain.segmentStart(segment)
                val b = domain.segmentEnd(segment)
                Math.hypot(domain.x(a) - domain.x(b), domain.y(a) - domain.y(b))
            }
        }
        val mean = lengths.average()
        val standard = ShapeDefaults.STANDARD
        if (!(mean > 0 && mean < Double.POSITIVE_INFINITY)) return standard
        val rounded = java.math.BigDecimal(mean).round(java.math.MathContext(2)).toDouble()
        return ShapeDefaults(rounded, standard.ratio, standard.distribution, standard.rounding)
    }
}
