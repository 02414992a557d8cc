package org.trigrid.editor.app

import javafx.scene.Group
import javafx.scene.Node
import javafx.scene.layout.StackPane
import javafx.scene.shape.SVGPath

/** Icons as paths in a square of 20 units, drawn with lines of the text's colour. */
internal enum class Icons(private val lines: String, private val solid: String = "") {
    SELECT("M5 3 L5 16 L8.6 12.6 L11 17.5 L13 16.5 L10.7 11.8 L15.5 11.4 Z"),
    LASSO("M10 3.5 C14.5 3.5 17 5.8 17 8.3 C17 11 14 13 10 13 C6 13 3 11 3 8.3 C3 5.8 5.5 3.5 10 3.5 M6.5 12.5 C5 14 7 15 6 17"),
    LINE("M5 15 L15 5", dots(4.0, 16.0, 16.0, 4.0)),
    LINES("M3.5 15 L8 6 L12.5 13 L16.5 5", dots(3.5, 15.5, 8.0, 5.5, 12.5, 13.5, 16.5, 4.5)),
    CURVE("M3.5 14 C6 2 12 18 16.5 6", dots(3.5, 14.5, 16.5, 5.5)),
    ARC("M4 15 A7.2 7.2 0 0 1 16 15", dots(4.0, 15.0, 16.0, 15.0)),
    RECTANGLE("M3.5 5 H16.5 V15 H3.5 Z"),
    POLYGON("M4 8 L10 3.5 L16.5 7 L14 15.5 L5.5 14.5 Z", dots(4.0, 8.0, 10.0, 3.5, 16.5, 7.0, 14.0, 15.5, 5.5, 14.5)),
    REGULAR("M10 3 L16.1 6.5 V13.5 L10 17 L3.9 13.5 V6.5 Z"),
    CIRCLE("M10 3.5 A6.5 6.5 0 1 1 9.99 3.5 Z", dots(10.0, 10.0)),
    ELLIPSE("M10 5.5 A7 4.5 0 1 1 9.99 5.5 Z", dots(10.0, 10.0)),
    CONNECTOR("M4 16 L6 14 M8 12 L10 10 M12 8 L14 6", dots(3.5, 16.5, 15.5, 4.5)),
    NEW("M5.5 3 H12 L15 6 V17 H5.5 Z M12 3 V6 H15"),
    OPEN("M3 15.5 V5 H8 L9.5 7 H16 V9 M3 15.5 L5.5 9 H18 L15.5 15.5 Z"),
    SAVE("M4 4 H14 L16.5 6.5 V16.5 H4 Z M7 4 V8 H13 V4 M7 16.5 V11.5 H13.5 V16.5"),
    UNDO("M8 4.5 L4 8.5 L8 12.5 M4 8.5 H12 A4 4 0 0 1 12 16.5 H9"),
    REDO("M12 4.5 L16 8.5 L12 12.5 M16 8.5 H8 A4 4 0 0 0 8 16.5 H11"),
    FIT("M3.5 7.5 V3.5 H7.5 M12.5 3.5 H16.5 V7.5 M16.5 12.5 V16.5 H12.5 M7.5 16.5 H3.5 V12.5"),
    ZOOM_IN("M8.5 3.5 A5 5 0 1 1 8.49 3.5 Z M12.2 12.2 L17 17 M8.5 6 V11 M6 8.5 H11"),
    ZOOM_OUT("M8.5 3.5 A5 5 0 1 1 8.49 3.5 Z M12.2 12.2 L17 17 M6 8.5 H11"),
    MESH("M3 16.5 L10 3.5 L17 16.5 Z M6.5 10 H13.5 L10 16.5 Z"),
    LIVE("M11.5 2.5 L5 11.5 H10 L8.5 17.5 L15 8.5 H10 Z"),
    CLOSE_LOOP("M15.5 6.5 A6.5 6.5 0 1 0 16.5 11", dots(15.5, 6.0, 16.5, 11.5)),
    REVERSE("M4 7 H15 L12 4 M16 13 H5 L8 16"),
    GRID("M3.5 3.5 H16.5 V16.5 H3.5 Z M3.5 8 H16.5 M3.5 12 H16.5 M8 3.5 V16.5 M12 3.5 V16.5"),
    MAGNET("M5 3.5 V10 A5 5 0 0 0 15 10 V3.5 H11.5 V10 A1.5 1.5 0 0 1 8.5 10 V3.5 Z M5 6.5 H8.5 M11.5 6.5 H15"),
    PLAY("M6 4 L15.5 10 L6 16 Z"),
    PAUSE("M7 4.5 V15.5 M13 4.5 V15.5"),
    STEP("M6 4.5 L12.5 10 L6 15.5 Z M15 4.5 V15.5"),
    STEP_BACK("M14 4.5 L7.5 10 L14 15.5 Z M5 4.5 V15.5"),
    FIRST("M16 5 L10.5 10 L16 15 M10 5 L4.5 10 L10 15"),
    LAST("M4 5 L9.5 10 L4 15 M10 5 L15.5 10 L10 15"),
    CONNECT("M4 10 A3 3 0 1 0 4 9.9 M16 3 V17 M10 10 H12 M14 10 H16", dots(16.0, 10.0)),
    CANCEL("M5.5 5.5 L14.5 14.5 M14.5 5.5 L5.5 14.5"),
    ;

    /** The icon, [size] pixels square. */
    fun node(size: Double = 18.0): Node {
        val stroke = SVGPath()
        stroke.content = lines
        stroke.styleClass.add("icon-lines")
        val frame = SVGPath()
        frame.content = "M0 0 H20 V20 H0 Z"
        frame.opacity = 0.0
        val group = Group(frame, stroke)
        if (solid.isNotEmpty()) {
            val dots = SVGPath()
            dots.content = solid
            dots.styleClass.add("icon-solid")
            group.children.add(dots)
        }
        group.scaleX = size / SQUARE
        group.scaleY = size / SQUARE
        val pane = StackPane(Group(group))
        pane.styleClass.add("icon")
        return pane
    }

    private companion object {
        const val SQUARE = 20.0
    }
}

/** Small discs about the given places, as one path. */
private fun dots(vararg xy: Double): String = buildString {
    for (i in xy.indices step 2) append("M${xy[i] - 1.7} ${xy[i + 1]} a1.7 1.7 0 1 0 3.4 0 a1.7 1.7 0 1 0 -3.4 0 Z ")
}
