package org.trigrid.editor.inspector

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.editor.document.Selection
import org.trigrid.editor.session.drawWith
import org.trigrid.editor.session.newSession
import org.trigrid.editor.tool.ShapeKind
import org.trigrid.shape.Circle
import org.trigrid.shape.Distribution
import org.trigrid.shape.Direction

class InspectorViewModelTest {
    private val session = newSession()
    private val model = InspectorViewModel(session)

    private fun field(label: String) = model.sections.flatMap { it.fields }.first { it.label == label }

    private fun circle(): Circle = session.document.path.shape(0) as Circle

    private fun drawCircle() {
        session.drawWith(ShapeKind.CIRCLE, 1.0, 2.0, 3.0, 2.0)
        session.select(Selection.ofShape(0))
    }

    @Test
    fun `every property of a circle can be set and explodes it anew`() {
        drawCircle()
        assertEquals("Circle 1", model.title)
        assertNull(model.commit(field("Radius"), "4"))
        assertNull(model.commit(field("Centre x"), "-1,5"))
        assertNull(model.commit(field("Spacing"), "0.25"))
        assertNull(model.commit(field("Ratio"), "2"))
        assertNull(model.commit(field("Distribution"), "Symmetric"))
        assertNull(model.commit(field("Direction"), "Clockwise"))
        assertNull(model.commit(field("Name"), "hole"))
        assertEquals(4.0, circle().radius)
        assertEquals(-1.5, circle().centre.x)
        assertEquals(0.25, circle().spacing)
        assertEquals(2.0, circle().ratio)
        assertEquals(Distribution.SYMMETRIC, circle().distribution)
        assertEquals(Direction.CLOCKWISE, circle().direction)
        assertEquals("hole", circle().name)
        assertEquals(Math.round(8 * Math.PI / 0.25).toInt(), session.document.nodes.count)
    }

    @Test
    fun `long numbers are shown with seven digits, names as they are`() {
        assertEquals("3.416659", InspectorField("x", "3.4166586791234", "length") { error("not asked") }.shown)
        assertEquals("0.25", InspectorField("x", "0.25", "length").shown)
        assertEquals("12345678901234", InspectorField("Name", "12345678901234").shown)
    }

    @Test
    fun `what is no number, or none that makes sense, is refused with words`() {
        drawCircle()
        val before = session.document
        assertTrue("number" in model.commit(field("Spacing"), "abc")!!)
        assertTrue("above 0" in model.commit(field("Ratio"), "0")!!)
        assertNotNull(model.commit(field("Radius"), "-1"))
        assertNotNull(model.commit(field("Name"), "a\"b"))
        assertNotNull(model.commit(field("Spacing"), "1e-9"))
        assertEquals(before, session.document)
    }

    @Test
    fun `the same value is no step`() {
        drawCircle()
        val name = session.undoName
        assertNull(model.commit(field("Radius"), field("Radius").value))
        assertEquals(name, session.undoName)
    }

    @Test
    fun `every kind of shape has fields, and each field takes its own value back`() {
        for (kind in ShapeKind.entries) {
            val session = newSession()
            val model = InspectorViewModel(session)
            session.drawWith(kind, 0.0, 0.0, 4.0, 1.0, 2.0, 3.0)
            session.tool.enter()
            session.select(Selection.ofShape(0))
            assertTrue(model.sections.size >= 2, kind.label)
            for (section in model.sections) for (field in section.fields) assertNull(model.commit(field, field.value), "${kind.label} ${field.label}")
            val before = session.document
            for (section in model.sections) {
                for (field in section.fields) {
                    val change = field.change ?: continue
                    if (field.choices.isEmpty()) session.execute(change(field.value))
                }
            }
            assertEquals(before.nodes.count, session.document.nodes.count, kind.label)
        }
    }

    @Test
    fun `several shapes are changed at once and show what they share`() {
        drawCircle()
        session.drawWith(ShapeKind.CIRCLE, 9.0, 2.0, 12.0, 2.0)
        session.select(Selection(shapes = setOf(0, 1)))
        assertEquals("2 shapes", model.title)
        assertNull(model.commit(field("Spacing"), "0.5"))
        assertEquals(listOf(0.5, 0.5), (0..1).map { session.document.path.shape(it).spacing })
        session.select(Selection.ofShape(0))
        model.commit(field("Ratio"), "3")
        session.select(Selection(shapes = setOf(0, 1)))
        assertEquals("", field("Ratio").value)
    }

    @Test
    fun `with nothing picked the defaults of new shapes are set`() {
        assertNull(model.commit(field("Spacing"), "0.5"))
        session.drawWith(ShapeKind.CIRCLE, 0.0, 0.0, 2.0, 0.0)
        assertEquals(0.5, session.document.path.shape(0).spacing)
    }

    @Test
    fun `the picture of the spacing follows the ratio`() {
        drawCircle()
        model.commit(field("Ratio"), "4")
        val at = model.distributionPreview
        assertEquals(4.0, (at[at.size - 1] - at[at.size - 2]) / (at[1] - at[0]), 1e-9)
    }

    @Test
    fun `the options of the mesher are fields`() {
        val options = OptionsViewModel(session)
        fun set(label: String, text: String) {
            val field = options.sections.flatMap { it.fields }.first { it.label == label }
            session.execute(field.change!!(text))
        }
        set("Gradation", "0.4")
        set("Largest", "3")
        set("Strategy", "Classic")
        set("Improve", "Off")
        set("Region", "steel")
        set("Connectors", "Kept")
        val project = session.document.project
        assertEquals(0.4, project.options.gradation)
        assertEquals(3.0, project.options.maxSize)
        assertEquals(org.trigrid.front.Strategy.CLASSIC, project.options.strategy)
        assertEquals(false, project.options.improve)
        assertEquals("steel", project.regionName)
        assertTrue(project.keepsConnectors)
        set("Largest", "")
        assertEquals(Double.POSITIVE_INFINITY, session.document.project.options.maxSize)
    }
}
