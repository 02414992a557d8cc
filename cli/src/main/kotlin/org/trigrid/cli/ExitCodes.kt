package org.trigrid.cli

/** What the process tells its caller; documented in `docs/cli.md`. */
object ExitCodes {
    const val DONE = 0

    /** A defect of TriGrid itself, or too little memory. */
    const val DEFECT = 1

    /** The command line makes no sense. */
    const val USAGE = 2

    /** The domain, a shape of it or a mesh has faults. */
    const val INVALID_DOMAIN = 3

    /** A file is missing, cannot be written, or its text is not what its format asks for. */
    const val FILE_TROUBLE = 4

    /** Interrupted from the keyboard: 128 + SIGINT. */
    const val CANCELLED = 130
}
