package org.trigrid.shape

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.geometry.Point2
import java.util.Random

class PaperTextTest {
    @Test
    fun `a line is written in the order of the listing`() {
        val line = Line(1.0, 2.5, 3.0, -4.0, 0.1).withRatio(2.0)
        assertEquals("1.0\n2.5\n3.0\n-4.0\n0.1\n2.0\n", PaperText.write(line))
        assertEquals(line, PaperText.read(PaperShape.LINE, "1\r\n2,5\r\n3\r\n-4\r\n0,1\r\n2", "x"))
    }

    @Test
    fun `what is written is read back`() {
        val random = Random(9)
        var read = 0
        repeat(100) {
            for (shape in randomShapes(random)) {
                val paper = shape.withDistribution(Distribution.LINEAR).withRounding(Rounding.NEAREST).withName("")
                val text = try {
                    PaperText.write(paper)
                } catch (e: InvalidShapeException) {
                    continue
                }
                assertEquals(paper, PaperText.read(PaperShape.valueOf(paper.traits.kind.uppercase()), text, "x"))
                read++
            }
        }
        assertTrue(read >= 700)
    }

    @Test
    fun `an ellipse is read back`() {
        val ellipse = Ellipse(Point2(0.0, 1.0), Point2(0.0, 0.0), 3.0, 1.0, 0.2).withDirection(Direction.CLOCKWISE)
        assertEquals(ellipse, PaperText.read(PaperShape.ELLIPSE, PaperText.write(ellipse), "x"))
    }

    @Test
    fun `what the paper cannot say is refused`() {
        val ellipse = Ellipse(0.0, 0.0, 3.0, 1.0, 0.2)
        for (shape in listOf(
            ellipse.withRotationDegrees(1.0),
            ellipse.withDistribution(Distribution.GEOMETRIC),
            ellipse.withRounding(Rounding.CEILING),
            Curve.of(0.1, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0).closed(),
            Arc(Point2(0.0, 0.0), Point2(1.0, 0.0), 90.0, 0.1),
        )) assertThrows(InvalidShapeException::class.java) { PaperText.write(shape) }
    }

    @Test
    fun `errors name the line`() {
        fun fails(kind: PaperShape, line: Int, text: String) {
            val e = assertThrows(FileFormatException::class.java) { PaperText.read(kind, text, "shape.txt") }
            assertEquals(line, e.line, e.message)
        }
        fails(PaperShape.LINE, 3, "1\n2\nthree\n4\n5\n6\n")
        fails(PaperShape.LINE, 6, "1\n2\n3\n4\n5\n")
        fails(PaperShape.LINE, 7, "1\n2\n3\n4\n5\n6\n7\n")
        fails(PaperShape.LINE, 1, "1\n2\n1\n2\n5\n6\n")
        fails(PaperShape.CIRCLE, 5, "1\n0\n0\n0\n2\n0.1\n1\nClockwise\n")
        fails(PaperShape.CIRCLE, 8, "1\n0\n0\n0\n1\n0.1\n1\nleft\n")
        fails(PaperShape.LINES, 3, "0.1\n1\n99\n0\n0\n1\n1\n")
    }
}
