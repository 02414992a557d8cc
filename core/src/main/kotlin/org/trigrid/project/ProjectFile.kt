package org.trigrid.project

import org.trigrid.diagnostics.FileFormatException
import org.trigrid.io.AtomicFile
import org.trigrid.io.DomainFormats
import org.trigrid.io.JsonDocument
import java.io.IOException
import java.nio.CharBuffer
import java.nio.channels.Channels
import java.nio.file.Path

/** Reads and writes project files, `*.trigrid.json`; docs/formats.md describes them. */
public object ProjectFile {
    /** The newest version: 1 to this one are read, and the oldest that has all that a project needs is written. */
    public const val VERSION: Int = 2

    /**
     * Reads a file.
     *
     * @throws FileFormatException if it is not a project file, with the line and column of what is wrong.
     * @throws IOException if it cannot be read.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun read(file: Path): Project = parse(DomainFormats.textOf(file), file.toString())

    /**
     * Writes a file beside its place and moves it over what is there, so that no half file is ever seen.
     *
     * @throws IOException if it cannot be written; what was there before is then untouched.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(file: Path, project: Project) {
        val text = Charsets.UTF_8.newEncoder().encode(CharBuffer.wrap(format(project)))
        AtomicFile.write(file) { Channels.newChannel(it).write(text) }
    }

    /**
     * The project that [text] describes.
     *
     * @param sourceName what messages call the text: a file's name.
     * @throws FileFormatException as [read] does.
     */
    @JvmStatic
    public fun parse(text: String, sourceName: String): Project =
        ProjectReader.read(JsonDocument(text, sourceName, uniqueKeys = true))

    /** The text of a project file. Equal projects give equal texts; every number is read back exactly. */
    @JvmStatic
    public fun format(project: Project): String = JsonPrinter.print(ProjectWriter(project).write())
}
