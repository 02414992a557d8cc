package org.trigrid.editor.canvas

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.domain.Domain
import org.trigrid.editor.meshing.Colouring
import org.trigrid.editor.meshing.MeshView
import org.trigrid.mesh.TriMesh

class MeshRasterTest {
    private val square = doubleArrayOf(0.0, 0.0, 8.0, 0.0, 8.0, 8.0, 0.0, 8.0)
    private val mesh = MeshView(null, MeshGenerator.generate(Domain.of(square).respaced(0.5, 1.0)).mesh, null)
    private val ink = MeshInk(0xFF112233.toInt(), 0xFF445566.toInt(), 0xFF000000.toInt())

    @Test
    fun `triangles that share edges fill each pixel once and leave none out`() {
        val raster = PixelRaster(100, 100)
        raster.triangle(10.3, 10.2, 80.1, 20.7, 30.9, 77.4, 1)
        raster.triangle(80.1, 20.7, 90.2, 88.8, 30.9, 77.4, 2)
        val inner = (0 until 100).count { raster.pixels[50 * 100 + it] != 0 }
        val row = (0 until 100).map { raster.pixels[50 * 100 + it] }
        val first = row.indexOfFirst { it != 0 }
        assertTrue(row.subList(first, first + inner).all { it != 0 })
        assertEquals(triangleArea(10.3, 10.2, 80.1, 20.7, 30.9, 77.4), raster.pixels.count { it == 1 }.toDouble(), 30.0)
    }

    @Test
    fun `lines off the raster are cut off`() {
        val raster = PixelRaster(50, 40)
        raster.line(-1e6, 20.5, 1e6, 20.5, 0xFFFFFF, 256)
        assertEquals(50, raster.pixels.count { it != 0 })
        raster.line(-10.0, -10.0, -5.0, -90.0, 0xFFFFFF, 256)
        raster.line(20.0, -1e5, 20.2, 1e5, 0xFFFFFF, 256)
        assertTrue(raster.pixels.count { it != 0 } >= 89)
    }

    @Test
    fun `a mesh covers the pixels of its domain`() {
        val raster = PixelRaster(200, 200)
        val view = ViewTransform.fit(Box(0.0, 0.0, 8.0, 8.0), 200.0, 200.0, 20.0)
        MeshRaster(mesh).draw(raster, view, Colouring.NONE, ink)
        val covered = raster.pixels.count { it ushr 24 == 255 }
        assertEquals(160.0 * 160, covered.toDouble(), 4 * 160.0)
        assertEquals(0, raster.pixels[5 * 200 + 5])
    }

    @Test
    fun `from far away every element is still there`() {
        val raster = PixelRaster(60, 60)
        val view = ViewTransform.fit(Box(0.0, 0.0, 8.0, 8.0), 60.0, 60.0, 26.0)
        MeshRaster(mesh).draw(raster, view, Colouring.QUALITY, ink)
        assertTrue((27 until 33).all { y -> (27 until 33).all { x -> raster.pixels[y * 60 + x] ushr 24 == 255 } })
    }

    @Test
    fun `a picture that is moved and drawn at its rims is the picture drawn anew`() {
        val raster = MeshRaster(mesh)
        for (scale in listOf(0.83, 4.1, 30.7)) {
            val before = ViewTransform(scale, -3.0123, 9.0456)
            val old = PixelRaster(120, 90).also { raster.draw(it, before, Colouring.QUALITY, ink) }
            for ((dx, dy) in listOf(7 to 0, 0 to -11, -13 to 5, 90 to 60, -119 to -89)) {
                val now = before.panned(dx.toDouble(), dy.toDouble())
                val anew = PixelRaster(120, 90).also { raster.draw(it, now, Colouring.QUALITY, ink) }
                val moved = PixelRaster(120, 90)
                moved.copyMoved(old, dx, dy)
                for ((x0, y0, x1, y1) in rims(dx, dy)) {
                    moved.clip(x0, y0, x1, y1)
                    raster.draw(moved, now, Colouring.QUALITY, ink)
                }
                val differing = anew.pixels.indices.count { !isAlike(anew.pixels[it], moved.pixels[it]) }
                assertTrue(differing <= 2, "$differing pixels differ at scale $scale, moved by $dx, $dy")
            }
        }
    }

    /** But for what the last digits do to the strength of a line. */
    private fun isAlike(p: Int, q: Int): Boolean = (0..24 step 8).all { Math.abs((p ushr it and 255) - (q ushr it and 255)) <= 3 }

    private fun rims(dx: Int, dy: Int): List<IntArray> = listOf(
        if (dx > 0) intArrayOf(0, 0, dx, 90) else intArrayOf(120 + dx, 0, 120, 90),
        intArrayOf(maxOf(0, dx), if (dy > 0) 0 else 90 + dy, minOf(120, 120 + dx), if (dy > 0) dy else 90),
    )

    @Test
    fun `the index finds all elements that are seen`() {
        val raster = MeshRaster(mesh)
        val view = ViewTransform(40.0, 2.0, 6.0)
        val found = HashSet<Int>()
        raster.forEachVisible(view, 120.0, 90.0) { found.add(it) }
        assertTrue(found.size < mesh.mesh.elementCount)
        for (x in 0 until 120 step 3) for (y in 0 until 90 step 3) {
            assertTrue(raster.elementAt(view.domainX(x.toDouble()), view.domainY(y.toDouble())) in found)
        }
    }

    @Test
    fun `the element under the mouse is the one that holds the place`() {
        val raster = MeshRaster(mesh)
        for (element in 0 until mesh.mesh.elementCount) {
            val x = (0..2).sumOf { mesh.mesh.x(mesh.mesh.nodeOf(element, it)) } / 3
            val y = (0..2).sumOf { mesh.mesh.y(mesh.mesh.nodeOf(element, it)) } / 3
            assertEquals(element, raster.elementAt(x, y))
        }
        assertEquals(-1, raster.elementAt(9.0, 4.0))
    }

    @Test
    fun `worst and best have the ends of the scale`() {
        assertEquals(0xFFA50026.toInt(), ColourScale.of(Colouring.QUALITY).colour(0.0))
        assertEquals(0xFF4575B4.toInt(), ColourScale.of(Colouring.QUALITY).colour(1.0))
        for (colouring in Colouring.entries) {
            val scale = ColourScale.of(colouring)
            assertEquals(scale.colours.size, scale.ends.size + 1)
            assertEquals(scale.ends.sorted(), scale.ends.toList())
        }
    }

    /** 1,000,000 elements at 1000 by 800 pixels, 30 frames a second: the median of nine pictures, with room for a busy machine. */
    @Test
    @Tag("corpus")
    fun `a million elements are drawn fast enough to pan and zoom`() {
        val raster = MeshRaster(MeshView(null, grid(708), null))
        val pixels = PixelRaster(1000, 800)
        for (factor in listOf(1.0, 2.0, 3.0, 4.0, 6.0, 10.0, 30.0)) {
            val view = ViewTransform.fit(Box(0.0, 0.0, 708.0, 708.0), 1000.0, 800.0, 10.0).zoomed(factor, 500.0, 400.0)
            val millis = (0 until 15).map {
                val begin = System.nanoTime()
                raster.draw(pixels, view, Colouring.NONE, ink)
                (System.nanoTime() - begin) / 1e6
            }.drop(6).sorted()
            println("zoom $factor: ${millis[4]} ms")
            assertTrue(millis[4] < 100, "zoom $factor took ${millis[4]} ms")
        }
    }

    private fun grid(n: Int): TriMesh {
        val xy = DoubleArray(2 * (n + 1) * (n + 1)) { if (it % 2 == 0) (it / 2 % (n + 1)).toDouble() else (it / 2 / (n + 1)).toDouble() }
        val elements = IntArray(6 * n * n)
        for (cell in 0 until n * n) {
            val a = cell / n * (n + 1) + cell % n
            val corners = intArrayOf(a, a + 1, a + n + 2, a, a + n + 2, a + n + 1)
            corners.copyInto(elements, 6 * cell)
        }
        return TriMesh.of(xy, elements)
    }

    private fun triangleArea(ax: Double, ay: Double, bx: Double, by: Double, cx: Double, cy: Double): Double =
        Math.abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2
}
