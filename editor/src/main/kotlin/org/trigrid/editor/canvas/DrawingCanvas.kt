package org.trigrid.editor.canvas

import java.nio.file.Path
import javafx.animation.AnimationTimer
import javafx.scene.Cursor
import javafx.scene.SnapshotParameters
import javafx.scene.canvas.Canvas
import javafx.scene.image.Image
import javafx.scene.image.WritableImage
import javafx.scene.input.MouseButton
import javafx.scene.input.MouseEvent
import javafx.scene.input.ScrollEvent
import javafx.scene.layout.Region
import javafx.scene.paint.Color
import javafx.scene.shape.Rectangle
import javafx.scene.transform.Transform
import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.document.ShapeHandles
import org.trigrid.editor.meshing.Colouring
import org.trigrid.editor.meshing.Problem
import org.trigrid.editor.session.Change
import org.trigrid.editor.session.EditorSession
import org.trigrid.editor.tool.PointerInput
import org.trigrid.editor.tool.SelectTool
import org.trigrid.geometry.Point2
import org.trigrid.project.Background

/** The sheet on which people draw: grid and picture, the mesh, the boundary, the tool's preview, one over the other. */
internal class DrawingCanvas(private val session: EditorSession) : Region() {
    private val below = Canvas()
    private val above = Canvas()
    private val meshLayer = MeshLayer()
    private val film = FrontPainter()
    private var image: Pair<String, Image>? = null
    private var isStale = true
    private var panFrom: MouseEvent? = null
    private var wantsFit = true

    /** Whether all is shown and should stay so when the sheet gets another size. */
    private var isFitted = true
    private var fittedWidth = 0.0
    private var fittedHeight = 0.0
    private var hasFilm = false

    /** Hears where the mouse is, in the domain's coordinates, and over which element, or -1. */
    var pointed: (Double, Double, Int) -> Unit = { _, _, _ -> }

    /** Whether dragging with the left button moves the sheet, as while the space bar is held. */
    var isPanning: Boolean = false
        set(value) {
            field = value
            cursor = if (value) Cursor.OPEN_HAND else toolCursor()
        }

    var colours: CanvasColours = CanvasColours.LIGHT
        set(value) {
            field = value
            redraw()
        }

    var transform: ViewTransform = ViewTransform(40.0, -2.0, 12.0)
        private set(value) {
            field = value
            isFitted = false
            redraw()
        }

    var emphasised: Problem? = null
        set(value) {
            field = value
            redraw()
        }

    /** Elements that are outlined. */
    var markedElements: List<Int> = emptyList()
        set(value) {
            field = value
            redraw()
        }

    private val painter = object : AnimationTimer() {
        override fun handle(now: Long) {
            if (isStale) paint()
        }
    }

    init {
        styleClass.add("drawing-canvas")
        above.isMouseTransparent = true
        below.isMouseTransparent = true
        children.addAll(below, meshLayer.node, above)
        isFocusTraversable = true
        accessibleText = "Drawing"
        clip = Rectangle().also {
            it.widthProperty().bind(widthProperty())
            it.heightProperty().bind(heightProperty())
        }
        setMinSize(100.0, 100.0)
        setPrefSize(900.0, 650.0)
        setOnMousePressed(::pressed)
        setOnMouseDragged(::dragged)
        setOnMouseReleased(::released)
        setOnMouseMoved { point(it); session.move(input(it)) }
        setOnScroll(::scrolled)
        session.listen(::changed)
        painter.start()
    }

    override fun layoutChildren() {
        for (canvas in listOf(below, above)) {
            canvas.width = width
            canvas.height = height
        }
        if (wantsFit && width > 1 && height > 1) {
            wantsFit = false
            fit()
        } else if (isFitted && (width != fittedWidth || height != fittedHeight)) {
            fit()
        }
        redraw()
    }

    // View

    /** Shows all there is. */
    fun fit() {
        if (width < 2 || height < 2) {
            wantsFit = true
            return
        }
        val box = Box.of(session.document.nodes.bounds()) ?: Box(0.0, 0.0, EMPTY_WIDTH, EMPTY_HEIGHT)
        fit(box)
        isFitted = true
        fittedWidth = width
        fittedHeight = height
    }

    /** Shows a part, clear of the legend and of the buttons of the film. */
    fun fit(box: Box) {
        val hasLegend = session.mesh != null && session.view.colouring != Colouring.NONE
        hasFilm = session.playback != null
        val room = if (hasFilm || hasLegend) OverlayPainter.LEGEND_ROOM else 0.0
        transform = ViewTransform.fit(box, width, height - room, FIT_MARGIN)
    }

    /** Shows what is picked, or all if nothing is. */
    fun fitSelection() {
        val nodes = pickedNodes(session.document)
        if (nodes.isEmpty()) return fit()
        val all = session.document.nodes
        val box = Box(nodes.minOf { all.x(it) }, nodes.minOf { all.y(it) }, nodes.maxOf { all.x(it) }, nodes.maxOf { all.y(it) })
        if (box.width == 0.0 && box.height == 0.0) lookAt(box.minX, box.minY) else fit(box)
    }

    /** Brings a place to the middle, close enough to see it well. */
    fun lookAt(x: Double, y: Double, reach: Double = nearScale(x, y)) {
        transform = ViewTransform.fit(Box(x - reach, y - reach, x + reach, y + reach), width, height, FIT_MARGIN)
    }

    fun zoom(factor: Double) {
        transform = transform.zoomed(factor, width / 2, height / 2)
    }

    /** What is shown, with [density] pixels to one of the window's. */
    fun picture(density: Double): WritableImage {
        paint()
        meshLayer.sharpen(density)
        val parameters = SnapshotParameters()
        parameters.transform = Transform.scale(density, density)
        return snapshot(parameters, null).also { redraw() }
    }

    fun redraw() {
        isStale = true
    }

    fun close() {
        painter.stop()
        meshLayer.close()
    }

    /** Eight times the segments about the place. */
    private fun nearScale(x: Double, y: Double): Double {
        val document = session.document
        var best = Double.POSITIVE_INFINITY
        var length = 1.0
        for (outline in document.outlines) {
            for (step in 0 until outline.stepCount) {
                val a = document.nodes.point(outline.nodes[step])
                val b = document.nodes.point(outline.stepEnd(step))
                val distance = Math.hypot((a.x + b.x) / 2 - x, (a.y + b.y) / 2 - y)
                if (distance < best) {
                    best = distance
                    length = a.distanceTo(b)
                }
            }
        }
        return if (length > 0) NEAR * length else 1.0
    }

    private fun pickedNodes(document: EditorDocument): Set<Int> {
        val found = LinkedHashSet(session.selection.nodes)
        for (shape in session.selection.shapes) for (node in document.path.nodesOf(shape)) found.add(node)
        for (outline in document.outlines) if (outline.loop in session.selection.loops) for (node in outline.nodes) found.add(node)
        return found
    }

    // Mouse

    private fun input(event: MouseEvent): PointerInput = PointerInput(
        transform.domainX(event.x), transform.domainY(event.y), transform.pixel,
        event.isShiftDown, event.isAltDown, event.isShortcutDown, event.clickCount,
    )

    private fun pressed(event: MouseEvent) {
        requestFocus()
        if (event.button == MouseButton.MIDDLE || event.button == MouseButton.SECONDARY || isPanning) {
            panFrom = event
            cursor = Cursor.CLOSED_HAND
        } else {
            session.press(input(event))
        }
    }

    private fun dragged(event: MouseEvent) {
        val from = panFrom
        if (from != null) {
            transform = transform.panned(event.x - from.x, event.y - from.y)
            panFrom = event
        } else {
            point(event)
            session.drag(input(event))
        }
    }

    private fun released(event: MouseEvent) {
        if (panFrom != null) {
            panFrom = null
            cursor = if (isPanning) Cursor.OPEN_HAND else toolCursor()
        } else {
            session.release(input(event))
        }
    }

    private fun scrolled(event: ScrollEvent) {
        if (event.deltaY == 0.0) return
        transform = transform.zoomed(Math.exp(event.deltaY * WHEEL), event.x, event.y)
        event.consume()
    }

    private fun point(event: MouseEvent) {
        val x = transform.domainX(event.x)
        val y = transform.domainY(event.y)
        val mesh = session.mesh
        val element = if (mesh == null || !session.view.showMesh) -1 else meshLayer.elementAt(mesh, x, y)
        pointed(x, y, element)
    }

    private fun toolCursor(): Cursor = if (session.tool is SelectTool) Cursor.DEFAULT else Cursor.CROSSHAIR

    // Drawing

    private fun changed(change: Change) {
        when (change) {
            Change.FILE -> emphasised = null
            Change.MESH -> markedElements = emptyList()
            Change.TOOL -> cursor = toolCursor()
            Change.PLAYBACK -> if (isFitted && hasFilm != (session.playback != null)) fit()
            Change.PROBLEMS -> if (emphasised !in session.problems) emphasised = null
            Change.MESSAGE, Change.PROGRESS -> return
            else -> Unit
        }
        redraw()
    }

    private fun paint() {
        if (width < 1 || height < 1) return
        isStale = false
        val mesh = session.mesh.takeIf { session.view.showMesh && session.playback == null }
        val density = scene?.window?.outputScaleX ?: 1.0
        meshLayer.show(mesh, transform, width, height, density, session.view.colouring, colours.meshIn(region()))
        meshLayer.node.opacity = if (session.isMeshCurrent) 1.0 else STALE
        paintBelow()
        paintAbove()
    }

    private fun paintBelow() {
        val sheet = SheetPainter(below.graphicsContext2D, transform, width, height, colours)
        sheet.sheet()
        if (session.view.showGrid) sheet.grid()
        session.document.picture?.let { picture(it, sheet) }
        val hasMesh = session.mesh != null && session.view.showMesh || session.playback != null
        val domain = session.domain.takeIf { !hasMesh }
        if (domain != null) sheet.region(domain, region() ?: colours.accent)
    }

    private fun picture(picture: Background, sheet: SheetPainter) {
        if (image?.first != picture.file) {
            val loaded = Image(Path.of(picture.file).toUri().toString())
            image = picture.file to loaded
            session.pictureSize = if (loaded.isError) null else Point2(loaded.width, loaded.height)
            if (loaded.isError) session.say("The picture ${picture.file} cannot be shown; choose another one, or remove it", true)
        }
        image?.second?.takeIf { !it.isError }?.let { sheet.picture(it, picture) }
    }

    /** The colour that the region was given, or null. */
    private fun region(): Color? = session.document.project.let { it.colours[it.regionName] }?.let { Color.web(it) }

    private fun paintAbove() {
        val g = above.graphicsContext2D
        g.clearRect(0.0, 0.0, width, height)
        val settings = session.view
        val playback = session.playback
        if (playback != null) {
            return film.draw(g, playback, transform, width, height, scene?.window?.outputScaleX ?: 1.0, colours)
        }
        val outline = OutlinePainter(g, transform, width, height, colours, session.document, session.selection)
        outline.segments()
        if (settings.showDirections) outline.directions()
        outline.nodes(settings)
        val overlay = OverlayPainter(g, transform, width, height, colours)
        val mesh = session.mesh.takeIf { settings.showMesh }
        if (mesh != null) {
            meshLayer.index(mesh)?.let { MeshNumbers(g, transform, width, height, colours).draw(it, settings) }
            overlay.elements(mesh, markedElements)
        }
        val only = session.selection.onlyShape
        if (only >= 0 && session.tool is SelectTool) overlay.handles(ShapeHandles.of(session.document.path, only))
        overlay.sources(session.document.project.options.sizeSources)
        overlay.problems(session.problems, emphasised)
        overlay.preview(session.tool.preview)
        if (mesh != null) overlay.legend(settings.colouring, mesh)
    }

    private companion object {
        const val FIT_MARGIN = 48.0
        const val EMPTY_WIDTH = 20.0
        const val EMPTY_HEIGHT = 14.0
        const val NEAR = 8.0
        const val WHEEL = 0.0025

        /** How strongly a mesh is shown that the drawing has gone beyond. */
        const val STALE = 0.35
    }
}
