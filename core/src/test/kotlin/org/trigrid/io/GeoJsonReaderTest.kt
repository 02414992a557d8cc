package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.DomainCheck
import kotlin.random.Random

class GeoJsonReaderTest {
    private val ring = "[[0,0],[4,0],[4,4],[0,4],[0,0]]"
    private val hole = "[[1,1],[2,1],[2,2],[1,2],[1,1]]"

    @Test
    fun `bare polygon with a hole in either direction`() {
        val domain = read("""{"type":"Polygon","coordinates":[$ring,$hole]}""").single()
        assertEquals("file", domain.name)
        assertEquals(15.0, domain.domain.area)
        assertEquals(listOf("outer", "hole_1"), domain.domain.tags)
        assertEquals(8, domain.domain.nodeCount)
    }

    @Test
    fun `each polygon of a collection is a domain of its own`() {
        val text = """{"type":"FeatureCollection","features":[
            {"type":"Feature","properties":{"name":"a"},"geometry":{"type":"Polygon","coordinates":[$ring]}},
            {"type":"Feature","properties":{"name":"b"},"geometry":{"type":"MultiPolygon","coordinates":[[$ring,$hole],[$hole]]}},
            {"type":"Feature","properties":null,"geometry":{"type":"GeometryCollection","geometries":[
                {"type":"Point","coordinates":[1,2]},{"type":"Polygon","coordinates":[$ring]}]}},
            {"type":"Feature","properties":{"name":7},"geometry":null}]}"""
        val domains = read(text)
        assertEquals(listOf("a", "b_1", "b_2", "file"), domains.map { it.name })
        assertEquals(listOf(16.0, 15.0, 1.0, 16.0), domains.map { it.domain.area })
        assertEquals("b_2", domains[2].domain.regionName)
    }

    @Test
    fun `loops find their roles`() {
        val text = """{"name":"plate","loops":[[[1,1],[2,1],[2,2]],[[0,0],[4,0],[4,4],[0,4]]]}"""
        val plate = read(text).single()
        assertEquals("plate", plate.name)
        assertEquals(15.5, plate.domain.area)
    }

    @Test
    fun `numbers are the nearest doubles and third ones are left out`() {
        val random = Random(3)
        val values = DoubleArray(400) { generateSequence { Double.fromBits(random.nextLong()) }.first { it.isFinite() } }
        values[0] = 0.1
        values[1] = 5e-324
        val positions = (0 until 200).joinToString(",") { "[${values[2 * it]},${values[2 * it + 1]},7]" }
        val domain = read("""{"type":"Polygon","coordinates":[[$positions]]}""").single().domain
        assertArrayEquals(values, domain.nodeCoordinates())
        val long = read("""{"type":"Polygon","coordinates":[[[0.1000000000000000055511151231257827021181583404541015625,1E2],[2,0],[3,3]]]}""")
        assertEquals(0.1, long.single().domain.x(0))
    }

    @Test
    fun `only the repeated end is dropped`() {
        val doubled = read("""{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,0],[4,4],[0,0]]]}""").single().domain
        assertEquals(setOf(FaultKind.ZERO_LENGTH), DomainCheck.check(doubled).map { it.kind }.toSet())
        assertEquals(3, read("""{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4]]]}""").single().domain.segmentCount)
    }

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        value = [
            "{'type':'Polygon','coordinates':[[[0,0],~[4,x],[4,4]]]} | 2 | 4 | must be a number",
            "{'type':'Polygon','coordinates':[[[0,0],~  [4],[4,4]]]} | 2 | 3 | two numbers",
            "{'type':'Polygon','coordinates':[[[0,0],[4,NaN],[4,4]]]} | 1 | 44 | must be a number",
            "{'type':'Polygon','coordinates':[[[0,0],[4,1e999],[4,4]]]} | 1 | 44 | must be a number",
            "{'type':'Polygon','coordinates':[[[0,0],[4,'1'],[4,4]]]} | 1 | 44 | must be a number",
            "{'type':'Polygon'} | 1 | 1 | 'coordinates' is missing",
            "{'type':'Feature'} | 1 | 1 | geometry",
            "{'type':'Point','coordinates':[1,2]} | 1 | 1 | no polygon",
            "{'type':~'Polygone'} | 2 | 1 | Polygone",
            "{'a':[1,{'b':2}],'coordinates':~7,'type':'Polygon'} | 2 | 1 | array",
            "{'type':'Polygon',~'coordinates':[[[0,0],[1,0] | 2 | 28 | not JSON",
            "[1] | 1 | 1 | object",
            "{'loops':[]} | 1 | 10 | loop",
        ],
    )
    fun `errors tell line and column`(text: String, line: Int, column: Int, reason: String) {
        val error = assertThrows(FileFormatException::class.java) { read(text.replace('\'', '"').replace('~', '\n')) }
        assertEquals("$line:$column", "${error.line}:${error.column}", error.message)
        assertTrue(error.message!!.contains(reason.replace('\'', '"'))) { error.message }
        assertTrue(error.message!!.startsWith("dir/file.json:$line:$column: "))
    }

    private fun read(text: String) = GeoJsonReader.read(text, "dir/file.json", "file")
}
