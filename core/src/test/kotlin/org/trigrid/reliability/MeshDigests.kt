package org.trigrid.reliability

import org.trigrid.MeshGenerator
import org.trigrid.RandomDomains
import org.trigrid.diagnostics.TooManyElementsException
import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import java.io.ByteArrayOutputStream
import java.security.MessageDigest

/** Digests of the mesh files of random domains: what must be the same on every machine and every Java version. */
internal object MeshDigests {
    fun of(family: RandomDomains.Family, seed: Long): String {
        val out = ByteArrayOutputStream()
        try {
            val mesh = MeshGenerator.generate(family.make(seed), FuzzRun.options(seed)).mesh
            for (format in listOf(MeshFormat.MSH_22, MeshFormat.MSH_41)) MeshFormats.write(mesh, out, format)
        } catch (e: TooManyElementsException) {
            out.write(e.message!!.toByteArray())
        }
        return MessageDigest.getInstance("SHA-256").digest(out.toByteArray()).joinToString("") { "%02x".format(it) }
    }

    fun lines(from: Long, to: Long): List<String> = RandomDomains.families.filter { it.every < 10 }.flatMap { family ->
        (from until to).filter { it % family.every == 0L }.map { "${family.name} $it ${of(family, it)}" }
    }

    /** `MeshDigests FROM TO`: a line for each family and seed. */
    @JvmStatic
    fun main(args: Array<String>) = lines(args[0].toLong(), args[1].toLong()).forEach { println(it) }
}
