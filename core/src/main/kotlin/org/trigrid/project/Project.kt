package org.trigrid.project

import org.trigrid.MeshOptions
import org.trigrid.diagnostics.Fault
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import org.trigrid.domain.InnerParts
import org.trigrid.domain.OpeningConnection
import org.trigrid.domain.Path
import org.trigrid.domain.PathDomain
import org.trigrid.domain.PathWalk
import org.trigrid.domain.PlaceIndex
import org.trigrid.domain.Region
import org.trigrid.domain.withBase

/** What a project file holds: a path of shapes, loops of plain nodes, and how to mesh what they bound. Immutable. */
public class Project private constructor(builder: Builder) {
    /** The shapes and the edits of their nodes. */
    @get:JvmName("path")
    public val path: Path = builder.path

    /** Loops of given nodes, beside the path's or in its place. */
    @get:JvmName("loops")
    public val loops: List<NodeLoop> = java.util.List.copyOf(builder.loops)

    /** A size function is not kept in the file. */
    @get:JvmName("options")
    public val options: MeshOptions = builder.options

    /** Order of the elements: 1 for three nodes an element, 2 for six. Default 1. */
    @get:JvmName("order")
    public val order: Int = builder.order

    /** Settings that shapes have unless they say otherwise. */
    @get:JvmName("defaults")
    public val defaults: ShapeDefaults = builder.defaults

    /** The region that elements belong to unless [inner] says otherwise. Default: one called "domain". */
    @get:JvmName("region")
    public val region: Region = builder.region

    /** Name of [region]. */
    @get:JvmName("regionName")
    public val regionName: String get() = region.name

    /** Lines and points that the mesh keeps, and places that tell regions. */
    @get:JvmName("inner")
    public val inner: InnerParts = builder.inner

    /** Whether connectors become edges of the mesh; else they only join the walk. Default false. */
    @get:JvmName("keepsConnectors")
    public val keepsConnectors: Boolean = builder.keepsConnectors

    /** The picture that the drawing is traced from, or null; it does not bear upon the mesh. */
    @get:JvmName("background")
    public val background: Background? = builder.background

    /** Colours of boundary groups and the region by name, `#rrggbb`, in the order in which they were given. */
    @get:JvmName("colours")
    public val colours: Map<String, String> = java.util.Collections.unmodifiableMap(LinkedHashMap(builder.colours))

    /**
     * The domain that path and loops bound, with what lies inside of it. A loop with the place of a region in it is no hole.
     *
     * @throws org.trigrid.diagnostics.InvalidDomainException if a walk of the path is not closed.
     */
    public fun toDomain(): Domain = outline().make(keepsConnectors, regionName).withBase(region).with(inner)

    /**
     * All that is wrong, while a drawing is not finished as well: walks that are not closed, and with them lines that cross,
     * touch or lie on one another; else the faults of the domain.
     */
    public fun faults(): List<Fault> {
        val outline = outline()
        if (inner.isEmpty() || outline.walks.any { !it.isClosed }) return outline.faults(keepsConnectors)
        return DomainCheck.check(outline.make(keepsConnectors, regionName).withBase(region).with(inner))
    }

    /** Numbers of the path's walks that are openings and stand by themselves, joined to nothing by a connector; ascending. */
    public fun openings(): IntArray {
        val outline = outline()
        return OpeningConnection(outline.xy, outline.walks, path.walks().size).openings()
    }

    /**
     * Joins an opening to the path by a connector along the shortest line between their nodes that meets nothing else.
     *
     * @param walk one of [openings].
     * @param spacing wanted distance of the connector's nodes.
     * @throws IllegalArgumentException if the walk is no opening of its own, or every line to the path meets something.
     * @throws org.trigrid.diagnostics.InvalidShapeException if the connector cannot be exploded.
     */
    public fun connectOpening(walk: Int, spacing: Double): Project {
        val outline = outline()
        val connection = OpeningConnection(outline.xy, outline.walks, path.walks().size)
        require(walk in connection.openings()) { "walk $walk is no opening that stands by itself" }
        val line = requireNotNull(connection.lineTo(walk)) { "no straight line from the path to opening $walk is free" }
        return toBuilder().path(path.connect(line[0], line[1], spacing, outline.turnedGroups())).build()
    }

    private fun outline(): PathDomain {
        val places = PlaceIndex(path.nodeCount)
        for (node in path.nodes()) places.numberOf(node.x, node.y)
        val walks = ArrayList(path.walks())
        for ((k, loop) in loops.withIndex()) {
            val numbers = IntArray(loop.nodeCount) { places.numberOf(loop.x(it), loop.y(it)) }
            walks.add(PathWalk(numbers, loop.segmentTags, IntArray(numbers.size) { -1 }, true, -1 - k))
        }
        return PathDomain(places.toArray(), walks)
    }

    /** A builder that starts from this project. */
    public fun toBuilder(): Builder = Builder().path(path).loops(loops).options(options).order(order).defaults(defaults)
        .region(region).inner(inner).keepConnectors(keepsConnectors).background(background).colours(colours)

    /** Collects the parts of a project; the same builder may build several times. */
    public class Builder internal constructor() {
        internal var path = Path.EMPTY
        internal var loops: List<NodeLoop> = emptyList()
        internal var options = MeshOptions.DEFAULT
        internal var order = 1
        internal var defaults = ShapeDefaults.STANDARD
        internal var region = Region.of(Region.DEFAULT_NAME)
        internal var inner = InnerParts.NONE
        internal var keepsConnectors = false
        internal var background: Background? = null
        internal var colours: Map<String, String> = emptyMap()

        /** Sets [Project.path]. */
        public fun path(value: Path): Builder = apply { path = value }

        /** Sets [Project.loops]. */
        public fun loops(value: List<NodeLoop>): Builder = apply { loops = value }

        /** Sets [Project.options]. */
        public fun options(value: MeshOptions): Builder = apply { options = value }

        /**
         * Sets [Project.order].
         *
         * @throws IllegalArgumentException unless 1 or 2.
         */
        public fun order(value: Int): Builder = apply {
            require(value in 1..2) { "the order of elements must be 1 or 2, not $value" }
            order = value
        }

        /** Sets [Project.defaults]. */
        public fun defaults(value: ShapeDefaults): Builder = apply { defaults = value }

        /** Sets [Project.region]. */
        public fun region(value: Region): Builder = apply { region = value }

        /** Sets [Project.regionName]; the region keeps its material and largest size. */
        public fun regionName(value: String): Builder = apply { region = region.withName(value) }

        /** Sets [Project.inner]. */
        public fun inner(value: InnerParts): Builder = apply { inner = value }

        /** Sets [Project.keepsConnectors]. */
        public fun keepConnectors(value: Boolean): Builder = apply { keepsConnectors = value }

        /** Sets [Project.background]; null for none. */
        public fun background(value: Background?): Builder = apply { background = value }

        /**
         * Sets [Project.colours].
         *
         * @throws IllegalArgumentException if one is not of the form `#rrggbb`.
         */
        public fun colours(value: Map<String, String>): Builder = apply {
            for ((name, colour) in value) {
                require(COLOUR.matches(colour)) { "the colour of \"$name\" must be of the form #rrggbb, not $colour" }
            }
            colours = value
        }

        /** The project as it is now. */
        public fun build(): Project = Project(this)
    }

    public companion object {
        private val COLOUR = Regex("#[0-9a-fA-F]{6}")

        /** Starts from an empty project. */
        @JvmStatic
        public fun builder(): Builder = Builder()

        /** A project with everything but the path at its default. */
        @JvmStatic
        public fun of(path: Path): Project = Builder().path(path).build()
    }
}
