package org.trigrid.cli

import java.nio.file.Path

/** Names of output files where one input holds several domains: OUT-1.msh, OUT-2.msh, … */
object NumberedFiles {
    /** [file] itself for the only one of [count], else with the number [index] + 1 before its extension. */
    fun name(file: Path, index: Int, count: Int): Path {
        if (count == 1) return file
        val name = file.fileName.toString()
        val dot = name.lastIndexOf('.').let { if (it <= 0) name.length else it }
        return file.resolveSibling(name.substring(0, dot) + "-" + (index + 1) + name.substring(dot))
    }
}
