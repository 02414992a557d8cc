package org.trigrid.editor.inspector

import org.trigrid.MeshOptions
import org.trigrid.editor.command.EditCommand
import org.trigrid.editor.command.ProjectCommands
import org.trigrid.editor.command.SourceCommands
import org.trigrid.editor.document.GroupPalette
import org.trigrid.editor.session.EditorSession
import org.trigrid.editor.tool.Figures
import org.trigrid.front.Strategy
import org.trigrid.numbering.NumberingMethod
import org.trigrid.spacing.Sizes

/** What can be asked of the mesher, as fields. No controls. */
internal class OptionsViewModel(private val session: EditorSession) {
    /** Colours that groups have by themselves in the theme that is shown. */
    var palette: GroupPalette = GroupPalette.ON_LIGHT

    private val options: MeshOptions get() = session.document.project.options

    val sections: List<InspectorSection>
        get() = listOfNotNull(
            InspectorSection("Element sizes", sizeFields()),
            InspectorSection("Sizes at places", sourceFields()).takeIf { it.fields.isNotEmpty() },
            InspectorSection("Method", methodFields()),
            InspectorSection("Names", nameFields()),
        )

    private fun sizeFields(): List<InspectorField> = listOf(
        choice("Sizes", options.sizes, Sizes.entries, "How sizes vary away from the boundary") { sizes(it) },
        number("Gradation", Figures.exact(options.gradation), "per length", "Largest slope of the size; small for even sizes, 0.25 by default") {
            gradation(FieldNumbers.positive(it))
        },
        number("Smallest", if (options.minSize == 0.0) "" else Figures.exact(options.minSize), "length", "Empty for no limit") {
            minSize(if (it.isBlank()) 0.0 else FieldNumbers.notNegative(it))
        },
        number("Largest", if (options.maxSize.isInfinite()) "" else Figures.exact(options.maxSize), "length", "Empty for no limit") {
            maxSize(FieldNumbers.positiveOrNone(it))
        },
    )

    private fun sourceFields(): List<InspectorField> = (0 until options.sizeSources.count).map { source ->
        val place = options.sizeSources.placeOf(source)
        val what = if (place.size == 2) "Point" else "Line"
        InspectorField(
            "$what ${source + 1}", Figures.exact(options.sizeSources.sizeOf(source)), "length",
            help = "Edge length at ${Figures.length(place[0])}, ${Figures.length(place[1])}; empty removes it",
        ) { SourceCommands.resize(source, if (it.isBlank()) null else FieldNumbers.positive(it)) }
    }

    private fun methodFields(): List<InspectorField> = listOf(
        choice("Strategy", options.strategy, Strategy.entries, "Robust makes the better mesh; Classic follows the paper") { strategy(it) },
        InspectorField("Improve", if (options.improve) ON else OFF, choices = listOf(ON, OFF), help = "Smooth and flip after the front") { text ->
            change("improving") { improve(text == ON) }
        },
        number("Tolerance", Figures.exact(options.smoothingTolerance), "of a size", "Smoothing stops when no node moves further") {
            smoothingTolerance(FieldNumbers.positive(it))
        },
        choice("Numbering", options.numbering, NumberingMethod.entries, "Order of the nodes; Best gives the smallest bandwidth") { numbering(it) },
        number("At most", options.maxElements.toString(), "elements", "A larger mesh is refused before it is begun") {
            maxElements(FieldNumbers.whole(it, 1..Int.MAX_VALUE))
        },
    )

    private fun nameFields(): List<InspectorField> {
        val project = session.document.project
        val region = InspectorField(
            "Region", project.regionName, help = "Physical group of the elements in the mesh file",
            colour = colour(project.regionName, project.colours[project.regionName] ?: REGION),
        ) { ProjectCommands.regionName(named(it)) }
        val connectors = InspectorField(
            "Connectors", if (project.keepsConnectors) KEPT else DROPPED, choices = listOf(DROPPED, KEPT),
            help = "Kept connectors become edges of the mesh",
        ) { ProjectCommands.keepConnectors(it == KEPT) }
        val all = session.document.groups
        val groups = all.map { group ->
            InspectorField(
                "Group", group, help = "Physical group of this boundary in the mesh file; renamed everywhere",
                colour = colour(group, palette.colourOf(group, all, project.colours)),
            ) { ProjectCommands.renameGroup(group, named(it)) }
        }
        return listOf(region, connectors) + groups
    }

    private fun colour(name: String, value: String) = InspectorColour(value) { ProjectCommands.colour(name, it) }

    private fun named(text: String): String = text.trim().ifEmpty { throw IllegalArgumentException("Type a name") }

    private fun number(label: String, value: String, unit: String, help: String, set: MeshOptions.Builder.(String) -> MeshOptions.Builder) =
        InspectorField(label, value, unit, help = help) { text -> change(label.lowercase()) { set(text) } }

    private fun <E : Enum<E>> choice(
        label: String,
        value: E,
        all: List<E>,
        help: String,
        set: MeshOptions.Builder.(E) -> MeshOptions.Builder,
    ) = InspectorField(label, word(value), choices = all.map(::word), help = help) { text ->
        change(label.lowercase()) { set(all.first { word(it) == text }) }
    }

    private fun change(what: String, set: MeshOptions.Builder.() -> MeshOptions.Builder): EditCommand =
        ProjectCommands.options(what, options.toBuilder().set().build())

    private fun word(value: Enum<*>): String = when (value) {
        NumberingMethod.CUTHILL_MCKEE -> "Cuthill–McKee"
        else -> value.name.lowercase().replaceFirstChar { it.uppercase() }
    }

    private companion object {
        /** The region's colour before one is chosen. */
        const val REGION = "#b9c9d8"
        const val ON = "On"
        const val OFF = "Off"
        const val KEPT = "Kept"
        const val DROPPED = "Dropped"
    }
}
