package org.trigrid.cli.batch

import org.trigrid.MeshOptions
import org.trigrid.cli.TriGridCommand
import org.trigrid.io.MeshFormat
import org.trigrid.project.InputOptions
import java.io.IOException
import java.io.ObjectOutputStream
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.security.MessageDigest
import kotlin.io.path.name

/**
 * What a mesh is made of: the input's bytes, all options, the format, the order and the version of TriGrid, as one short word.
 * Meshes of one word are the same bytes.
 *
 * @param order asked for, 0 for that of the file.
 */
internal class Fingerprint(private val inputOptions: InputOptions, private val format: MeshFormat, private val order: Int) {
    /** The word for a domain of [input] with the [options] of the domain. */
    fun of(input: InputDigest, options: MeshOptions): String {
        val digest = MessageDigest.getInstance(ALGORITHM)
        // Serialized, so that an option that is added later is in it.
        ObjectOutputStream(DigestOutput(digest)).use {
            it.writeObject(TriGridCommand.Version().version.joinToString())
            it.write(input.bytes)
            it.writeObject(inputOptions.division)
            it.writeBoolean(inputOptions.keepConnectors)
            it.writeObject(inputOptions.inner)
            it.writeBoolean(inputOptions.join)
            it.writeObject(format.name)
            it.writeInt(order)
            // A limit only says whether there is a mesh.
            it.writeObject(options.toBuilder().maxElements(MeshOptions.DEFAULT.maxElements).build())
        }
        return digest.digest().take(LENGTH).joinToString("") { "%02x".format(it) }
    }

    private companion object {
        const val LENGTH = 16
    }
}

/** The digest of a file's bytes. */
internal class InputDigest private constructor(val bytes: ByteArray) {
    companion object {
        /** Of [file], and of the nodes that a `.poly` may have beside it. */
        @Throws(IOException::class)
        fun of(file: Path): InputDigest {
            val digest = MessageDigest.getInstance(ALGORITHM)
            val nodes = if (file.name.endsWith(POLY, ignoreCase = true)) file.resolveSibling(file.name.dropLast(POLY.length) + ".node") else null
            for (part in listOfNotNull(file, nodes?.takeIf { Files.isRegularFile(it) })) {
                Files.newInputStream(part).use { it.transferTo(DigestOutput(digest)) }
            }
            return InputDigest(digest.digest())
        }

        private const val POLY = ".poly"
    }
}

private const val ALGORITHM = "SHA-256"

private class DigestOutput(private val digest: MessageDigest) : OutputStream() {
    override fun write(byte: Int) = digest.update(byte.toByte())

    override fun write(bytes: ByteArray, start: Int, count: Int) = digest.update(bytes, start, count)
}
