package org.trigrid.editor.canvas

import javafx.scene.canvas.GraphicsContext
import javafx.scene.paint.Color

/** Numbers that can be read on any colour: with a rim of the sheet's. */
internal object NumberText {
    private const val RIM = 2.6

    fun draw(g: GraphicsContext, text: String, x: Double, y: Double, ink: Color, sheet: Color) {
        g.stroke = sheet.deriveColor(0.0, 1.0, 1.0, 0.85)
        g.lineWidth = RIM
        g.strokeText(text, x, y)
        g.fill = ink
        g.fillText(text, x, y)
    }
}
