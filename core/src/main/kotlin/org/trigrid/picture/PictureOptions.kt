package org.trigrid.picture

/** What a picture of a mesh or a domain shows. Immutable; made by [builder]. */
public class PictureOptions private constructor(builder: Builder) {
    /** Elements coloured by their quality, with a legend. Default false. */
    @get:JvmName("quality")
    public val quality: Boolean = builder.quality

    /** Given nodes as small donuts. Default true for domains; a mesh shows them only if asked. */
    @get:JvmName("nodes")
    public val nodes: Boolean? = builder.nodes

    /** Node numbers, where they fit. Default false. */
    @get:JvmName("nodeNumbers")
    public val nodeNumbers: Boolean = builder.nodeNumbers

    /** Element numbers, where they fit. Default false. */
    @get:JvmName("elementNumbers")
    public val elementNumbers: Boolean = builder.elementNumbers

    /** Number of the first node and the first element. Default 1, as in mesh files and in the paper; memory has 0. */
    @get:JvmName("firstNumber")
    public val firstNumber: Int = builder.firstNumber

    /** Longer side of the drawing without its margins and legend, in units of the picture. Default 1000. */
    @get:JvmName("size")
    public val size: Int = builder.size

    /** Colour of each group that has one of its own, as `0xRRGGBB`, by name, in pictures of domains, and of each region in those of meshes; unmodifiable. Default none. */
    @get:JvmName("groupColours")
    public val groupColours: Map<String, Int> = java.util.Map.copyOf(builder.groupColours)

    /** Collects options; the same builder may build several times. */
    public class Builder internal constructor() {
        internal var quality = false
        internal var nodes: Boolean? = null
        internal var nodeNumbers = false
        internal var elementNumbers = false
        internal var firstNumber = 1
        internal var size = 1000
        internal var groupColours: Map<String, Int> = emptyMap()

        /** Sets [PictureOptions.quality]. */
        public fun quality(value: Boolean): Builder = apply { quality = value }

        /** Sets [PictureOptions.nodes]. */
        public fun nodes(value: Boolean): Builder = apply { nodes = value }

        /** Sets [PictureOptions.nodeNumbers]. */
        public fun nodeNumbers(value: Boolean): Builder = apply { nodeNumbers = value }

        /** Sets [PictureOptions.elementNumbers]. */
        public fun elementNumbers(value: Boolean): Builder = apply { elementNumbers = value }

        /** Sets [PictureOptions.firstNumber]. */
        public fun firstNumber(value: Int): Builder = apply { firstNumber = value }

        /** @throws IllegalArgumentException unless from 100 to 20000. */
        public fun size(value: Int): Builder = apply {
            require(value in 100..20_000) { "size must be from 100 to 20000, not $value" }
            size = value
        }

        /**
         * Sets [PictureOptions.groupColours].
         *
         * @throws IllegalArgumentException if one is not from 0 to `0xFFFFFF`.
         */
        public fun groupColours(value: Map<String, Int>): Builder = apply {
            for ((name, colour) in value) {
                require(colour in 0..0xFFFFFF) { "the colour of \"$name\" must be from 0 to 0xFFFFFF, not $colour" }
            }
            groupColours = value
        }

        /** The options as they are now. */
        public fun build(): PictureOptions = PictureOptions(this)
    }

    public companion object {
        /** Lines only. */
        @JvmField
        public val DEFAULT: PictureOptions = Builder().build()

        /** Starts from the default options. */
        @JvmStatic
        public fun builder(): Builder = Builder()
    }
}
