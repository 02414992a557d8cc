package org.trigrid.editor.files

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.domain.DomainCheck
import org.trigrid.domain.Path as ShapePath
import org.trigrid.MeshOptions
import org.trigrid.editor.document.EditorDocument
import org.trigrid.front.Strategy
import org.trigrid.project.Project
import org.trigrid.project.ProjectFile
import org.trigrid.shape.Circle
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.writeText

class FilesTest {
    @TempDir
    lateinit var folder: Path

    private val document = EditorDocument(Project.of(ShapePath.of(Circle(0.0, 0.0, 2.0, 0.5))))

    @Test
    fun `a document is read back as it was written`() {
        val file = folder.resolve("a.trigrid.json")
        DocumentFile.write(file, document)
        val read = DocumentFile.read(file)
        assertTrue(read.isProject)
        assertEquals(ProjectFile.format(document.project), ProjectFile.format(read.document.project))
    }

    @Test
    fun `polygons become loops, and new shapes get their spacing`() {
        val file = folder.resolve("a.wkt")
        file.writeText("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0), (0.4 0.4, 0.6 0.4, 0.6 0.6, 0.4 0.6, 0.4 0.4))")
        val read = DocumentFile.read(file)
        assertFalse(read.isProject)
        assertEquals(2, read.document.loops.size)
        assertEquals(0.6, read.document.project.defaults.spacing)
    }

    @Test
    fun `names get the ending of a project once`() {
        assertEquals("a.trigrid.json", DocumentFile.withEnding(Path.of("a")).fileName.toString())
        assertEquals("a.trigrid.json", DocumentFile.withEnding(Path.of("a.json")).fileName.toString())
        assertEquals("a.trigrid.json", DocumentFile.withEnding(Path.of("a.trigrid.json")).fileName.toString())
    }

    @Test
    fun `what a killed editor had not saved is recovered`() {
        val file = folder.resolve("a.trigrid.json")
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val process = ProcessBuilder(java, "-cp", System.getProperty("java.class.path"), KilledEditor::class.java.name, file.toString())
            .redirectErrorStream(true).start()
        val line = process.inputStream.bufferedReader().readLine()
        process.destroyForcibly().waitFor()
        assertEquals("copied", line)
        assertFalse(file.exists())
        val autosave = Autosave(folder)
        val recovered = autosave.recovered(file)
        assertNotNull(recovered)
        assertEquals(1, recovered!!.path.shapeCount)
        autosave.discard(file)
        assertNull(autosave.recovered(file))
    }

    @Test
    fun `a copy older than the file is not offered, nor half a copy`() {
        val file = folder.resolve("a.trigrid.json")
        val autosave = Autosave(folder)
        autosave.write(file, document)
        DocumentFile.write(file, document)
        Files.setLastModifiedTime(autosave.copyOf(file), java.nio.file.attribute.FileTime.fromMillis(0))
        assertNull(autosave.recovered(file))
        Autosave(folder, NO_PROCESS).copyOf(null).writeText("{\"format\": \"trigrid\", \"ver")
        assertNull(autosave.adoptUntitled())
    }

    @Test
    fun `preferences and recent files are remembered, the last first`() {
        val preferences = Preferences(folder)
        preferences["theme"] = "DARK"
        for (i in 0..12) preferences.remember(folder.resolve("f$i"))
        preferences.remember(folder.resolve("f9"))
        val again = Preferences(folder)
        assertEquals("DARK", again["theme"])
        assertEquals(Preferences.MOST_RECENT, again.recent.size)
        assertEquals(listOf("f9", "f12", "f11"), again.recent.take(3).map { it.fileName.toString() })
        again.forget(again.recent[0])
        assertEquals("f12", Preferences(folder).recent[0].fileName.toString())
    }

    @Test
    fun `preferences that are broken or cannot be kept do not stop work`() {
        folder.resolve("editor.properties").writeText("\\u00zz = x")
        assertNull(Preferences(folder)["theme"])
        folder.resolve("plain").writeText("")
        val unkept = Preferences(folder.resolve("plain"))
        unkept["theme"] = "DARK"
        assertEquals("DARK", unkept["theme"])
    }

    @Test
    fun `a drawing without a file is offered once its window is gone, and no other window's`() {
        val gone = Autosave(folder, NO_PROCESS)
        gone.write(null, document)
        val mine = Autosave(folder)
        assertEquals(1, mine.adoptUntitled()!!.path.shapeCount)
        assertFalse(gone.copyOf(null).exists())
        assertTrue(mine.copyOf(null).exists())
        assertNull(Autosave(folder, NO_PROCESS).adoptUntitled())
        mine.discard(null)
        assertFalse(mine.copyOf(null).exists())
    }

    @Test
    fun `a copy that comes late is not written`() {
        val file = folder.resolve("late.trigrid.json")
        val autosave = Autosave(folder)
        val ticket = autosave.ticket
        autosave.discard(file)
        autosave.write(file, document, ticket)
        assertFalse(autosave.copyOf(file).exists())
        autosave.write(file, document, autosave.ticket)
        assertTrue(autosave.copyOf(file).exists())
    }

    @Test
    fun `how meshes are made is remembered, but not how small`() {
        val preferences = Preferences(folder)
        val chosen = MeshOptions.builder().strategy(Strategy.CLASSIC).gradation(0.4).improve(false).maxSize(0.01).build()
        OptionMemory(preferences).remember(chosen)
        val next = OptionMemory(Preferences(folder)).options()
        assertEquals(Strategy.CLASSIC, next.strategy)
        assertEquals(0.4, next.gradation)
        assertFalse(next.improve)
        assertEquals(Double.POSITIVE_INFINITY, next.maxSize)
        preferences["mesh.gradation"] = "-3"
        preferences["mesh.strategy"] = "no such"
        assertEquals(MeshOptions.DEFAULT.gradation, OptionMemory(preferences).options().gradation)
    }

    @Test
    fun `lists of points are loops`() {
        val loops = PointList.parse("0 0\n1, 0\n1;1\n\n5 5\n6 5\n6 6\n5 5\n")!!
        assertEquals(2, loops.size)
        assertArrayEquals(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0), loops[0])
        assertArrayEquals(doubleArrayOf(5.0, 5.0, 6.0, 5.0, 6.0, 6.0), loops[1])
        for (text in listOf("", "hello", "1 2\n3 4", "1\n2\n3")) assertNull(PointList.parse(text), text)
    }

    @Test
    fun `lists of points may have headings and decimal commas`() {
        val wanted = doubleArrayOf(0.5, 0.0, 1.5, -0.25, 1.0, 1.0)
        for (text in listOf("x y\n0.5 0\n1.5 -0.25\n1 1", "x;y\n0,5;0\n1,5;-0,25\n1;1", "0,5\t0\n1,5\t-0,25\n1\t1", "0,5 0,0\n1,5 -0,25\n1,0 1,0")) {
            assertArrayEquals(wanted, PointList.parse(text)!!.single(), text)
        }
        assertNull(PointList.parse("0 0\n1 0\nwords\n1 1"))
    }

    @Test
    fun `every case of the gallery is a valid domain`() {
        for (case in Gallery.entries) assertEquals(0, DomainCheck.check(case.document().project.toDomain()).size, case.label)
    }

    private companion object {
        /** Larger than any number of a process. */
        const val NO_PROCESS = 1L shl 40
    }
}
