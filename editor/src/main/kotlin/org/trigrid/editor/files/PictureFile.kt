package org.trigrid.editor.files

import org.trigrid.project.Project
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * Where the picture behind a drawing lies. A project file names it relative to its own folder, so that both can be moved
 * or handed on together; while a project is edited the name is absolute.
 */
internal object PictureFile {
    /** [project] as read from [file], its picture found from there. */
    fun absolute(project: Project, file: Path): Project {
        val picture = project.background ?: return project
        val folder = file.toAbsolutePath().parent ?: return project
        val found = try {
            folder.resolve(picture.file).normalize()
        } catch (_: InvalidPathException) {
            return project
        }
        return project.toBuilder().background(picture.withFile(found.toString())).build()
    }

    /** [project] as it is written to [file]. A picture on another drive keeps its absolute name. */
    fun relative(project: Project, file: Path): Project {
        val picture = project.background ?: return project
        val folder = file.toAbsolutePath().normalize().parent ?: return project
        val name = try {
            folder.relativize(Path.of(picture.file).toAbsolutePath().normalize()).joinToString("/")
        } catch (_: IllegalArgumentException) {
            return project
        }
        return project.toBuilder().background(picture.withFile(name)).build()
    }
}
