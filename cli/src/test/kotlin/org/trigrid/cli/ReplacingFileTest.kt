package org.trigrid.cli

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.IOException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.NotDirectoryException
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.exists
import kotlin.io.path.isSymbolicLink
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText

class ReplacingFileTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun `the file appears whole, beside nothing else`() {
        val target = folder.resolve("out.msh")
        ReplacingFile.write(target) { beside ->
            assertEquals(folder.toRealPath(), beside.toAbsolutePath().parent.toRealPath())
            assertTrue(beside.name.endsWith(".msh"))
            beside.writeText("new")
            assertFalse(target.exists())
        }
        assertEquals("new", target.readText())
        assertEquals(listOf("out.msh"), folder.listDirectoryEntries().map { it.name })
    }

    @Test
    fun `a failure leaves the old file and nothing else`() {
        val target = folder.resolve("out.msh")
        target.writeText("old")
        assertThrows(IOException::class.java) {
            ReplacingFile.write(target) {
                it.writeText("half")
                throw IOException("disk full")
            }
        }
        assertEquals("old", target.readText())
        assertEquals(listOf("out.msh"), folder.listDirectoryEntries().map { it.name })
    }

    @Test
    fun `a link stays a link and what it points to is replaced`() {
        val real = folder.resolve("real.msh")
        real.writeText("old")
        val link = folder.resolve("link.msh").createSymbolicLinkPointingTo(real)
        ReplacingFile.write(link) { it.writeText("new") }
        assertTrue(link.isSymbolicLink())
        assertEquals("new", real.readText())
    }

    @Test
    fun `places that cannot be written are told early`() {
        val file = folder.resolve("a.txt")
        file.writeText("")
        assertThrows(NoSuchFileException::class.java) { ReplacingFile.checkPlace(folder.resolve("no/out.msh")) }
        assertThrows(NotDirectoryException::class.java) { ReplacingFile.checkPlace(file.resolve("out.msh")) }
        assertThrows(IOException::class.java) { ReplacingFile.checkPlace(folder.resolve("dir").createDirectory()) }
        assertTrue(Files.isReadable(file))
    }
}
