package org.trigrid.cli

import org.trigrid.picture.Picture
import picocli.CommandLine
import picocli.CommandLine.ParameterException
import java.nio.file.Path

/** Writes a picture in the form that its file's name asks for. */
internal object PictureOutput {
    /** Longer side of a PNG, unless another is asked for. */
    const val DEFAULT_PIXELS = 1600

    /** Refuses names of other forms, as a usage error. */
    fun checkName(file: Path, commandLine: CommandLine) {
        if (!isSvg(file) && !isPng(file)) throw ParameterException(commandLine, "a picture is .svg or .png, not $file")
    }

    fun write(picture: Picture, file: Path, pixels: Int) {
        if (isSvg(file)) picture.writeSvg(file) else picture.writePng(file, pixels)
    }

    private fun isSvg(file: Path) = file.toString().endsWith(".svg", ignoreCase = true)

    private fun isPng(file: Path) = file.toString().endsWith(".png", ignoreCase = true)
}
