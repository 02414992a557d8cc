package org.trigrid.io

/** The attribute `d` of a path: all commands, absolute and relative (SVG 1.1, section 8.3). */
internal class SvgPath(text: String, private val contours: SvgContours, private val complaint: Complaint) {
    private val numbers = SvgNumbers(text, complaint)
    private var x = 0.0
    private var y = 0.0
    private var startX = 0.0
    private var startY = 0.0

    /** Last control point of the curve before, for the commands that go on smoothly. */
    private var controlX = 0.0
    private var controlY = 0.0
    private var last = ' '

    fun read() {
        if (numbers.atEnd()) return
        var command = ' '
        while (!numbers.atEnd()) {
            if (numbers.hasNumber()) {
                if (command == ' ' || command.uppercaseChar() == 'Z') complaint.fail("a path must begin with M, and Z takes no numbers")
                // More pairs after a move are lines.
                if (command == 'M') command = 'L'
                if (command == 'm') command = 'l'
            } else {
                command = numbers.letter()
                if (last == ' ' && command.uppercaseChar() != 'M') complaint.fail("a path must begin with M, not '$command'")
            }
            step(command)
            last = command.uppercaseChar()
        }
    }

    private fun step(command: Char) {
        val isRelative = command.isLowerCase()
        val baseX = if (isRelative) x else 0.0
        val baseY = if (isRelative) y else 0.0
        when (command.uppercaseChar()) {
            'M' -> {
                moveTo(baseX + numbers.number(), baseY + numbers.number())
                startX = x
                startY = y
                contours.begin(x, y)
            }
            'Z' -> {
                contours.close(x, y, startX, startY)
                moveTo(startX, startY)
                contours.begin(x, y)
            }
            'L' -> lineTo(baseX + numbers.number(), baseY + numbers.number())
            'H' -> lineTo(baseX + numbers.number(), y)
            'V' -> lineTo(x, baseY + numbers.number())
            'C' -> cubicTo(baseX + numbers.number(), baseY + numbers.number(), baseX, baseY)
            'S' -> {
                val smooth = last == 'C' || last == 'S'
                cubicTo(if (smooth) 2 * x - controlX else x, if (smooth) 2 * y - controlY else y, baseX, baseY)
            }
            'Q' -> quadraticTo(baseX + numbers.number(), baseY + numbers.number(), baseX, baseY)
            'T' -> {
                val smooth = last == 'Q' || last == 'T'
                quadraticTo(if (smooth) 2 * x - controlX else x, if (smooth) 2 * y - controlY else y, baseX, baseY)
            }
            'A' -> {
                val rx = numbers.number()
                val ry = numbers.number()
                val degrees = numbers.number()
                val large = numbers.flag()
                val sweep = numbers.flag()
                arcTo(SvgArc(rx, ry, degrees, large, sweep), baseX + numbers.number(), baseY + numbers.number())
            }
            else -> complaint.fail("the path command '$command' is unknown")
        }
    }

    private fun moveTo(toX: Double, toY: Double) {
        x = toX
        y = toY
    }

    private fun lineTo(toX: Double, toY: Double) {
        contours.line(x, y, toX, toY)
        moveTo(toX, toY)
    }

    private fun cubicTo(c1x: Double, c1y: Double, baseX: Double, baseY: Double) {
        controlX = baseX + numbers.number()
        controlY = baseY + numbers.number()
        val toX = baseX + numbers.number()
        val toY = baseY + numbers.number()
        contours.cubic(doubleArrayOf(x, y, c1x, c1y, controlX, controlY, toX, toY))
        moveTo(toX, toY)
    }

    private fun quadraticTo(cx: Double, cy: Double, baseX: Double, baseY: Double) {
        controlX = cx
        controlY = cy
        val toX = baseX + numbers.number()
        val toY = baseY + numbers.number()
        contours.quadratic(x, y, cx, cy, toX, toY)
        moveTo(toX, toY)
    }

    private fun arcTo(arc: SvgArc, toX: Double, toY: Double) {
        contours.arc(arc, x, y, toX, toY)
        moveTo(toX, toY)
    }
}

/** Radii, turn of the axes in degrees and flags of the path command A. */
internal class SvgArc(val rx: Double, val ry: Double, val degrees: Double, val isLarge: Boolean, val isSweep: Boolean)
