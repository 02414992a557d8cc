package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import org.trigrid.diagnostics.FileFormatException
import java.io.RandomAccessFile
import java.nio.file.Path

class ReadingMemoryTest {
    @Test
    fun `a file that fits is read, a larger one is refused with what to do`() {
        assertNull(ReadingMemory.refusal(1_000_000, 60e6, 100_000_000))
        val refusal = ReadingMemory.refusal(10_000_000, 600e6, 100_000_000)!!
        for (part in listOf("10 MB", "600 MB", "100 MB", "-Xmx")) assertTrue(part in refusal) { refusal }
    }

    @Test
    fun `files of gigabytes are refused at once, whatever they hold`(@TempDir folder: Path) {
        for (name in listOf("a.msh", "a.wkt", "a.poly", "a.geojson")) {
            val file = folder.resolve(name)
            // A hole of a file: it has the size and no blocks.
            RandomAccessFile(file.toFile(), "rw").use { it.setLength(3L shl 30) }
            val error = assertThrows<FileFormatException> { if (name.endsWith("msh")) MeshFormats.read(file) else DomainFormats.read(file) }
            assertTrue("3221 MB" in error.message!!) { error.message!! }
        }
    }
}
