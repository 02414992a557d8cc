package org.trigrid.cli

import org.trigrid.diagnostics.FileFormatException
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.diagnostics.TriGridException
import org.trigrid.diagnostics.TooManyElementsException
import java.io.IOException
import java.io.PrintStream
import java.nio.file.AccessDeniedException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.NotDirectoryException
import java.nio.file.Path

/** Turns failures into lines on [err] and an exit code. */
internal class Failures(private val err: PrintStream) {
    /** Prints what went wrong with [subject], a file where that is known. */
    fun report(error: Exception, subject: String): Int = when (error) {
        is InputFailure -> report(error.reason, error.file)
        is InvalidDomainException -> {
            FaultLines(err, subject).print(error.faults)
            ExitCodes.INVALID_DOMAIN
        }
        is InvalidShapeException, is TooManyElementsException -> line(subject, error.message, ExitCodes.INVALID_DOMAIN)
        is MeshingCancelledException -> line(subject, "cancelled", ExitCodes.CANCELLED)
        is FileFormatException -> {
            err.println(error.message)
            ExitCodes.FILE_TROUBLE
        }
        is FileSystemException -> line(error.file ?: subject, explain(error), ExitCodes.FILE_TROUBLE)
        is IOException -> line(subject, error.message ?: error.toString(), ExitCodes.FILE_TROUBLE)
        else -> {
            line(subject, "a defect of TriGrid, please report it: $error", ExitCodes.DEFECT)
            error.printStackTrace(err)
            ExitCodes.DEFECT
        }
    }

    private fun line(subject: String, message: String?, code: Int): Int {
        err.println("$subject: $message")
        return code
    }

    private fun explain(error: FileSystemException): String = when (error) {
        is NoSuchFileException -> "no such file or folder"
        is AccessDeniedException -> "access denied"
        is NotDirectoryException, is FileAlreadyExistsException -> "not a folder"
        else -> error.reason ?: "cannot be read or written"
    }
}

/** What went wrong with one of the files of the command line, which a folder cannot be. */
internal class InputFailure(val file: String, val reason: Exception) : RuntimeException(reason) {
    companion object {
        /** Does [work] and lets what TriGrid throws in it know which [file] it is about. */
        fun <T> naming(file: Path, work: () -> T): T {
            if (file.toString().isEmpty()) throw FileSystemException("''", null, "an empty name is that of no file")
            if (Files.isDirectory(file)) throw FileSystemException(file.toString(), null, OutputPlace.A_FOLDER)
            return try {
                work()
            } catch (error: TriGridException) {
                throw InputFailure(file.toString(), error)
            }
        }
    }
}
