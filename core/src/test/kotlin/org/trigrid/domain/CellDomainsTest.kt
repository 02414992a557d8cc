package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.FaultKind
import kotlin.random.Random

/** Random sets of unit cells: holes, islands, and loops that touch in nodes, in every way. */
class CellDomainsTest {
    @Test
    fun `cells walked one by one join to a valid domain`() {
        forRandomCells(21) { cells, _ ->
            val domain = walked(cells, keepConnectors = false)
            assertEquals(emptyList<Any>(), DomainCheck.check(domain))
            assertEquals(cells.size.toDouble(), domain.area)
            for (loop in 0 until domain.loopCount) {
                val nodes = domain.loopNodes(loop)
                assertEquals(nodes.size, nodes.distinct().size)
            }
        }
    }

    @Test
    fun `common sides are kept as embedded segments when asked`() {
        forRandomCells(22) { cells, _ ->
            val domain = walked(cells, keepConnectors = true)
            assertEquals(emptyList<Any>(), DomainCheck.check(domain))
            val common = cells.sumOf { c -> listOf(c + 1, c + WIDTH).count { it in cells } }
            assertEquals(common, (0 until domain.segmentCount).count { domain.isEmbedded(it) })
        }
    }

    @Test
    fun `the same sides as line work give the same domain`() {
        forRandomCells(23) { cells, _ ->
            val segments = ArrayList<Int>()
            for (c in cells) for (side in 0..3) {
                val (a, b) = corners(c)[side] to corners(c)[(side + 1) % 4]
                val isNew = (0 until segments.size / 2).none { setOf(segments[2 * it], segments[2 * it + 1]) == setOf(a, b) }
                if (isNew) segments.addAll(if (segments.size % 4 == 0) listOf(a, b) else listOf(b, a))
            }
            val holes = ALL.filter { it !in cells }.flatMap { listOf(it % WIDTH + 0.5, it / WIDTH + 0.5) }.toDoubleArray()
            val count = segments.size / 2
            val domain = Domain.fromLineWork(GRID, segments.toIntArray(), IntArray(count), IntArray(GRID.size / 2), listOf("b"), "r", holes)
            val expected = walked(cells, keepConnectors = true)
            assertEquals(emptyList<Any>(), DomainCheck.check(domain))
            assertEquals(expected.area, domain.area)
            assertEquals(expected.boundaryCount, domain.boundaryCount)
            assertEquals(expected.segmentCount, domain.segmentCount)
        }
    }

    @Test
    fun `a cell taken twice, and a hole in the void, are told`() {
        forRandomCells(24) { cells, random ->
            val twice = cells.toList()[random.nextInt(cells.size)]
            val overlap = DomainCheck.check(Domain.fromWalks(GRID, cells.map { corners(it) } + listOf(corners(twice)), tags(cells.size + 1), TAGS, "r", false))
            assertTrue(overlap.any { it.kind == FaultKind.OVERLAP }) { "$overlap" }
            val empty = ALL.firstOrNull { it !in cells } ?: return@forRandomCells
            val walks = cells.map { corners(it) } + listOf(corners(empty).reversedArray())
            val faults = DomainCheck.check(Domain.fromWalks(GRID, walks, tags(walks.size), TAGS, "r", false))
            assertTrue(faults.isNotEmpty())
        }
    }

    private fun forRandomCells(seed: Int, action: (Set<Int>, Random) -> Unit) {
        val random = Random(seed)
        repeat(150) {
            val share = random.nextDouble(0.1, 0.9)
            val cells = ALL.filter { random.nextDouble() < share }.shuffled(random).toCollection(LinkedHashSet())
            if (cells.isNotEmpty()) action(cells, random)
        }
    }

    private fun walked(cells: Set<Int>, keepConnectors: Boolean) =
        Domain.fromWalks(GRID, cells.map { corners(it) }, tags(cells.size), TAGS, "r", keepConnectors)

    private fun tags(count: Int) = List(count) { IntArray(4) }

    private fun corners(cell: Int): IntArray {
        val first = cell % WIDTH + cell / WIDTH * (WIDTH + 1)
        return intArrayOf(first, first + 1, first + WIDTH + 2, first + WIDTH + 1)
    }

    private companion object {
        const val WIDTH = 7
        val TAGS = listOf("b")

        /** Cells of all rows but the last column, so that a cell's right neighbour never wraps to the next row. */
        val ALL = (0 until WIDTH * WIDTH).filter { it % WIDTH < WIDTH - 1 }
        val GRID = DoubleArray(2 * (WIDTH + 1) * (WIDTH + 1)) { if (it % 2 == 0) (it / 2 % (WIDTH + 1)).toDouble() else (it / 2 / (WIDTH + 1)).toDouble() }
    }
}
