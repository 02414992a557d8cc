package org.trigrid.project

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.MeshOptions
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.DomainCheck
import org.trigrid.domain.Path
import org.trigrid.front.Strategy
import org.trigrid.numbering.NumberingMethod
import org.trigrid.shape.Circle
import org.trigrid.shape.Direction
import org.trigrid.shape.Distribution
import org.trigrid.shape.Line
import org.trigrid.shape.Rectangle
import org.trigrid.shape.Rounding
import org.trigrid.shape.randomShapes
import org.trigrid.spacing.SizeSources
import org.trigrid.spacing.Sizes
import java.nio.file.Files
import java.util.Random

class ProjectFileTest {
    private val example = """
        {
          "format": "trigrid",
          "version": 1,
          "defaults": {"spacing": 0.5},
          "path": [
            {"type": "rectangle", "begin": [0, 0], "end": [4, 3]},
            {"type": "connector", "begin": [0, 0], "end": [1, 1]},
            {"type": "circle", "firstPoint": [1, 1], "centre": [2, 1], "direction": "clockwise"},
            {"type": "back"},
            {"type": "move", "node": "2:3", "to": [1.5, 2]}
          ]
        }
    """.trimIndent()

    @Test
    fun `random projects are read back exactly`() {
        val random = Random(10)
        repeat(40) {
            var path = Path.EMPTY
            for (shape in randomShapes(random)) path = path.append(shape)
            path = path.newLoop().append(Rectangle(0.0, 0.0, 4.0, 4.0, 1.0))
                .appendOpening(Line(0.0, 0.0, 1.0, 1.0, 0.5), Circle(1.5, 1.0, 0.1, 0.3))
            repeat(10) {
                val node = random.nextInt(path.nodeCount)
                path = if (random.nextBoolean()) path.deleteNode(node) else path.moveNode(node, random.nextGaussian(), 1e-300)
            }
            val walk = path.walks()[0].nodes()
            path = path.insertNode(walk[0], walk[1], -0.0, 1.0 / 3).moveNode(walk[0], 1e22, Double.MIN_VALUE)
            val options = MeshOptions.builder().gradation(random.nextDouble() + 0.01).sizes(Sizes.GRADE).improve(false)
                .minSize(random.nextDouble()).maxSize(1 + random.nextDouble()).strategy(Strategy.CLASSIC)
                .numbering(NumberingMethod.CUTHILL_MCKEE).smoothingTolerance(random.nextDouble() + 0.001).maxElements(7)
                .sizeSources(SizeSources.NONE.withPoint(random.nextDouble() + 0.01, 1.0 / 3, -2.5).withLine(0.5, 0.0, 1.0, random.nextDouble(), 3.0))
            val closed = path.walks().lastOrNull { it.isClosed }?.nodes()
            if (closed != null) path = path.turnWalk(closed[0]).moveNodes(intArrayOf(closed[0], closed[1]), doubleArrayOf(5.0, 6.0, 7.0, 8.0))
            val project = Project.builder().path(path).options(options.build()).regionName("ring \"é\" \\ \uD83D\uDE00")
                .keepConnectors(true).defaults(ShapeDefaults(0.3, 2.0, Distribution.GEOMETRIC, Rounding.CEILING))
                .loops(listOf(NodeLoop(doubleArrayOf(0.0, 0.0, random.nextDouble(), 0.0, 0.0, 1.0), listOf("a", "b", "c")))).build()
            val text = ProjectFile.format(project)
            val read = ProjectFile.parse(text, "x")
            assertEquals(text, ProjectFile.format(read))
            assertArrayEquals(path.nodeCoordinates(), read.path.nodeCoordinates())
            for (i in 0 until path.shapeCount) {
                assertEquals(path.shape(i), read.path.shape(i))
                assertEquals(path.isLinked(i), read.path.isLinked(i))
            }
            assertArrayEquals(project.loops[0].coordinates(), read.loops[0].coordinates())
            assertEquals(project.options.gradation, read.options.gradation)
            for (i in 0..1) assertArrayEquals(project.options.sizeSources.placeOf(i), read.options.sizeSources.placeOf(i))
            assertEquals(project.options.sizeSources.sizeOf(0), read.options.sizeSources.sizeOf(0))
            assertEquals(project.regionName, read.regionName)
        }
    }

    @Test
    fun `numbers survive and are short`() {
        assertEquals("0.1", NumberText.of(0.1))
        assertEquals("-0", NumberText.of(-0.0))
        assertEquals("1200", NumberText.of(1200.0))
        assertEquals("1e22", NumberText.of(1e22))
        assertEquals("0.3333333333333333", NumberText.of(1.0 / 3))
        assertEquals("-1.25e-7", NumberText.of(-1.25e-7))
        val random = Random(11)
        repeat(20_000) {
            val value = Double.fromBits(random.nextLong())
            if (value.isFinite()) assertEquals(value.toRawBits(), NumberText.of(value).toDouble().toRawBits())
        }
    }

    @Test
    fun `the example is what it says`() {
        val project = ProjectFile.parse(example, "x")
        assertEquals(3, project.path.shapeCount)
        assertEquals(0.5, project.path.shape(0).spacing)
        assertFalse(project.path.isLinked(2))
        val domain = project.toDomain()
        assertEquals(2, domain.loopCount)
        assertEquals(28 + 13, domain.segmentCount)
        assertEquals(Direction.CLOCKWISE, (project.path.shape(2) as Circle).direction)
    }

    @Test
    fun `the documented example is read, makes a domain and is written again`() {
        val document = Files.readString(java.nio.file.Path.of("..", "docs", "formats.md"))
        val text = document.substringAfter("```json\n").substringBefore("```")
        val project = ProjectFile.parse(text, "formats.md")
        assertEquals(10, project.path.shapeCount)
        assertEquals(1.5, project.options.maxSize)
        val domain = project.toDomain()
        assertEquals(7, domain.loopCount)
        assertTrue(DomainCheck.check(domain).isEmpty())
        val written = ProjectFile.format(project)
        assertEquals(written, ProjectFile.format(ProjectFile.parse(written, "x")))
        assertArrayEquals(domain.nodeCoordinates(), ProjectFile.parse(written, "x").toDomain().nodeCoordinates())
    }

    @Test
    fun `plain loops bound a domain with and without a path`() {
        val outer = NodeLoop(doubleArrayOf(0.0, 0.0, 0.0, 9.0, 9.0, 9.0, 9.0, 0.0), "outer")
        val inner = NodeLoop(doubleArrayOf(1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0, 1.0), listOf("w", "n", "e", "s"))
        val domain = Project.builder().loops(listOf(inner, outer)).build().toDomain()
        assertEquals(80.0, domain.area)
        assertEquals(setOf("outer", "w", "n", "e", "s"), domain.tags.toSet())
        val path = Path.of(Rectangle(3.0, 3.0, 4.0, 4.0, 1.0))
        assertEquals(79.0, Project.builder().path(path).loops(listOf(inner, outer)).build().toDomain().area)
    }

    @Test
    fun `errors name line and column`() {
        fails("[4, 3]", "[4, 3], \"colour\": 1", "\"colour\"", "unknown key \"colour\"")
        fails("\"version\": 1", "\"version\": 3", "3,", "version 3")
        fails("\"version\": 1", "\"version\": 1.5", "1.5", "whole number")
        fails("\"trigrid\"", "\"other\"", "\"other\"", "\"format\" must be")
        fails("[0, 0], \"end\": [4", "[0, 0, 0], \"end\": [4", "[0, 0, 0]", "must be a point")
        fails("[1, 1], \"centre\"", "[1, true], \"centre\"", "true]", "a number, not true")
        fails("0.5}", "\"0.5\"}", "\"0.5\"", "a number, not a string")
        fails("0.5}", "null}", "null", "a number, not null")
        fails("0.5}", "-0.5}", "-0.5", "spacing must be")
        fails("0.5}", "1e999}", "1e999", "beyond the range")
        fails("0.5}", "0.5, \"spacing\": 1}", "\"spacing\": 1}", "stands twice")
        fails("0.5}", "05}", "05", "a number, not 05")
        fails("\"clockwise\"", "\"left\"", "\"left\"", "one of clockwise, anticlockwise")
        fails("\"centre\": [2, 1]", "\"centre\": [1, 1]", "{\"type\": \"circle", "radius must be")
        fails("\"connector\"", "\"line\"", "{\"type\": \"back\"}", "no connector")
        fails("2:3", "2:40", "{\"type\": \"move\"", "no such node at this step: 2:40")
        fails("2:3", "2-3", "\"2-3\"", "must name a node")
        fails("\"back\"", "\"spiral\"", "\"spiral\"", "no type")
        fails("[1, 1]}", "[0, 0]}", "[0, 0], \"end\": [0, 0]}", "begin and end are the same place")
        fails("{\"spacing\": 0.5}", "[]", "[]", "defaults must be an object, not an array")
    }

    /** The error must stand where [place] does in the changed text. */
    private fun fails(old: String, new: String, place: String, reason: String) {
        assertTrue(old in example, old)
        val text = example.replaceFirst(old, new)
        val before = text.substring(0, text.indexOf(place).also { assertTrue(it >= 0) })
        val line = before.count { it == '\n' } + 1
        val column = before.length - before.lastIndexOf('\n')
        val e = assertThrows(FileFormatException::class.java) { ProjectFile.parse(text, "x.trigrid.json") }
        assertTrue(reason in e.message!!, e.message)
        assertTrue(e.message!!.startsWith("x.trigrid.json:$line:$column: "), "${e.message} instead of $line:$column")
    }

    @Test
    fun `a key is the same key however it is written`() {
        fails("0.5}", "0.5, \"sp\\u0061cing\": 1}", "\"sp\\u0061cing\"", "key \"spacing\" stands twice")
        fails("0.5}", "0.5, \"colo\\u0075r\": 1}", "\"colo\\u0075r\"", "unknown key \"colour\"")
    }

    @Test
    fun `deep nesting is refused where it becomes too deep`() {
        for (brackets in listOf("[", "{\"a\":")) {
            val deep = brackets.repeat(200_000)
            val e = assertThrows(FileFormatException::class.java) { ProjectFile.parse("\n$deep", "x") }
            assertEquals(2, e.line)
            assertEquals(65 * brackets.length + 1, e.column)
        }
    }

    @Test
    fun `a truncated text is refused wherever it ends`() {
        for (length in example.indices) {
            val e = assertThrows(FileFormatException::class.java) { ProjectFile.parse(example.substring(0, length), "x") }
            assertTrue(e.line > 0 && e.column > 0)
        }
    }

    @Test
    fun `a damaged text is read or refused, and nothing else`() {
        val random = Random(12)
        repeat(3000) {
            val text = StringBuilder(example)
            repeat(1 + random.nextInt(3)) {
                val at = random.nextInt(text.length)
                when (random.nextInt(3)) {
                    0 -> text.setCharAt(at, CHARACTERS[random.nextInt(CHARACTERS.length)])
                    1 -> text.deleteCharAt(at)
                    else -> text.insert(at, text[random.nextInt(text.length)])
                }
            }
            try {
                ProjectFile.parse(text.toString(), "x")
            } catch (e: FileFormatException) {
                assertTrue(e.line > 0 && e.column > 0)
            }
        }
    }

    @Test
    fun `files are written whole and read again`(@TempDir dir: java.nio.file.Path) {
        val file = dir.resolve("a.trigrid.json")
        ProjectFile.write(file, ProjectFile.parse(example, "x"))
        ProjectFile.write(file, ProjectFile.parse(example, "x"))
        assertEquals(ProjectFile.format(ProjectFile.parse(example, "x")), Files.readString(file))
        assertEquals(3, ProjectFile.read(file).path.shapeCount)
        assertEquals(1, Files.list(dir).use { it.count() })
        Files.write(file, byteArrayOf(0x7b, 0xff.toByte()))
        assertThrows(FileFormatException::class.java) { ProjectFile.read(file) }
    }

    private companion object {
        const val CHARACTERS = " {}[],:\"0123456789eE.-+truefalsnb\\"
    }
}
