package org.trigrid.project

import org.trigrid.diagnostics.FileFormatException
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption

/** Reads and writes project files, `*.trigrid.json`; docs/formats.md describes them. */
public object ProjectFile {
    /** The version that is written; versions 1 to this one are read. */
    public const val VERSION: Int = 1

    /**
     * Reads a file.
     *
     * @throws FileFormatException if it is not a project file, with the line and column of what is wrong.
     * @throws IOException if it cannot be read.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun read(file: Path): Project {
        val text = try {
            Charsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(Files.readAllBytes(file))).toString()
        } catch (e: CharacterCodingException) {
            throw FileFormatException(file.toString(), 0, 0, "the file is not UTF-8 text", e)
        }
        return parse(text, file.toString())
    }

    /**
     * Writes a file beside its place and moves it over what is there, so that no half file is ever seen.
     *
     * @throws IOException if it cannot be written; what was there before is then untouched.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(file: Path, project: Project) {
        val target = if (Files.exists(file)) file.toRealPath() else file.toAbsolutePath()
        val beside = target.resolveSibling(".${target.fileName}.tmp")
        try {
            Files.write(beside, format(project).toByteArray(Charsets.UTF_8))
            Files.move(beside, target, StandardCopyOption.REPLACE_EXISTING)
        } finally {
            Files.deleteIfExists(beside)
        }
    }

    /**
     * The project that [text] describes.
     *
     * @param sourceName what messages call the text: a file's name.
     * @throws FileFormatException as [read] does.
     */
    @JvmStatic
    public fun parse(text: String, sourceName: String): Project = ProjectReader(JsonSource(text, sourceName)).read()

    /** The text of a project file. Equal projects give equal texts; every number is read back exactly. */
    @JvmStatic
    public fun format(project: Project): String = JsonPrinter.print(ProjectWriter(project).write())
}
