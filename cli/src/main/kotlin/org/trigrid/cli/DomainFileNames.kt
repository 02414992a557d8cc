package org.trigrid.cli

import org.trigrid.io.DomainFormats
import java.util.Locale

/** What the names of files say about the domains in them. */
object DomainFileNames {
    /** Files with these endings hold other things as often; a folder's are not taken, unless a pattern asks for them. */
    private val GENERAL = setOf(".json", ".csv", ".xy", ".dat")

    private val ENDINGS = listOf(".trigrid.json") + DomainFormats.all().flatMap { it.endings }.distinct()

    /** Whether a file of a folder is taken for one with domains. */
    fun isDomain(name: String): Boolean = endingOf(name)?.let { it !in GENERAL } ?: false

    /** The name, with its folders if it has them, without the ending of a file with domains. */
    fun withoutEnding(name: String): String = name.dropLast(endingOf(name)?.length ?: 0)

    private fun endingOf(name: String): String? = ENDINGS.filter { name.lowercase(Locale.ROOT).endsWith(it) }.maxByOrNull { it.length }
}
