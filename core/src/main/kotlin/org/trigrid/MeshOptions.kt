package org.trigrid

import org.trigrid.front.Strategy
import org.trigrid.geometry.Pose
import org.trigrid.numbering.NumberingMethod
import org.trigrid.parallel.Crew
import org.trigrid.spacing.SizeFunction
import org.trigrid.spacing.SizeRules
import org.trigrid.spacing.SizeSources
import org.trigrid.spacing.Sizes
import java.io.Serializable
import java.util.concurrent.Executor
import java.util.concurrent.ForkJoinPool

/**
 * All that can be asked of the mesher. Immutable; made by [builder]. Serializable if [sizeFunction] is, to travel to other machines.
 */
public class MeshOptions private constructor(builder: Builder) : Serializable {
    /** How element sizes vary away from the boundary. Default [Sizes.SMOOTH]. */
    @get:JvmName("sizes")
    public val sizes: Sizes = builder.sizes

    /**
     * Gradation: largest slope of the element size, size per length, > 0. Default 0.25.
     * Small values give nearly uniform sizes and many elements; above 0.5 the quality suffers.
     */
    @get:JvmName("gradation")
    public val gradation: Double = builder.gradation

    /** Smallest size asked of an inner edge, in the domain's unit; 0 for none. Boundary segments may be shorter. */
    @get:JvmName("minSize")
    public val minSize: Double = builder.minSize

    /** Largest size asked of an inner edge, in the domain's unit; infinity for none. */
    @get:JvmName("maxSize")
    public val maxSize: Double = builder.maxSize

    /** The user's sizes, or null; the smaller of it and the boundary's sizes rules. */
    @get:JvmName("sizeFunction")
    public val sizeFunction: SizeFunction? = builder.sizeFunction

    /** Points and lines with small elements round them; the smallest of all sizes rules. Default none. */
    @get:JvmName("sizeSources")
    public val sizeSources: SizeSources = builder.sizeSources

    /** Default [Strategy.ROBUST]. */
    @get:JvmName("strategy")
    public val strategy: Strategy = builder.strategy

    /** Whether the mesh is improved after the front. Default true. */
    @get:JvmName("improve")
    public val improve: Boolean = builder.improve

    /** Smoothing stops when no node moves by more than this part of its size (eq. (5), relative). Default 0.01. */
    @get:JvmName("smoothingTolerance")
    public val smoothingTolerance: Double = builder.smoothingTolerance

    /** How nodes are renumbered. Default [NumberingMethod.BEST]. */
    @get:JvmName("numbering")
    public val numbering: NumberingMethod = builder.numbering

    /** Largest number of elements that may be made. Default 20 million. */
    @get:JvmName("maxElements")
    public val maxElements: Int = builder.maxElements

    /**
     * Threads that share the work on a large mesh, the caller's among them. Default 1. The mesh does not depend on it.
     * What can be shared is the improvement of meshes from 150,000 elements on, and the figures of their quality.
     */
    @get:JvmName("threads")
    public val threads: Int = builder.threads

    /** Lends the other [threads]; Java's common pool by default. Work that it never begins is done by the caller. */
    @get:JvmName("executor")
    public val executor: Executor get() = lent ?: ForkJoinPool.commonPool()

    /** Does not travel to other machines. */
    @Transient
    private val lent: Executor? = builder.executor

    internal fun crew(): Crew = if (threads == 1) Crew.CALLER else Crew(threads, executor)

    /** What the options say about sizes, for a domain that lies in a [pose]. */
    internal fun sizeRules(pose: Pose): SizeRules =
        SizeRules(sizes, gradation, minSize, maxSize, sizeFunction, sizeSources, pose)

    /** Collects options; the same builder may build several times. */
    public class Builder internal constructor() {
        internal var sizes = Sizes.SMOOTH
        internal var gradation = 0.25
        internal var minSize = 0.0
        internal var maxSize = Double.POSITIVE_INFINITY
        internal var sizeFunction: SizeFunction? = null
        internal var sizeSources = SizeSources.NONE
        internal var strategy = Strategy.ROBUST
        internal var improve = true
        internal var smoothingTolerance = 0.01
        internal var numbering = NumberingMethod.BEST
        internal var maxElements = 20_000_000
        internal var threads = 1
        internal var executor: Executor? = null

        /** Sets [MeshOptions.sizes]. */
        public fun sizes(value: Sizes): Builder = apply { sizes = value }

        /** @throws IllegalArgumentException unless finite and > 0. */
        public fun gradation(value: Double): Builder = apply {
            require(value > 0 && value < Double.POSITIVE_INFINITY) { "gradation must be a number above 0, not $value" }
            gradation = value
        }

        /** @throws IllegalArgumentException unless finite and >= 0. */
        public fun minSize(value: Double): Builder = apply {
            require(value >= 0 && value < Double.POSITIVE_INFINITY) { "minSize must be 0 or a number above, not $value" }
            minSize = value
        }

        /** @throws IllegalArgumentException unless > 0; infinity means none. */
        public fun maxSize(value: Double): Builder = apply {
            require(value > 0) { "maxSize must be above 0, not $value" }
            maxSize = value
        }

        /** Sets [MeshOptions.sizeFunction]; null for none. */
        public fun sizeFunction(value: SizeFunction?): Builder = apply { sizeFunction = value }

        /** Sets [MeshOptions.sizeSources]. */
        public fun sizeSources(value: SizeSources): Builder = apply { sizeSources = value }

        /** Sets [MeshOptions.strategy]. */
        public fun strategy(value: Strategy): Builder = apply { strategy = value }

        /** Sets [MeshOptions.improve]. */
        public fun improve(value: Boolean): Builder = apply { improve = value }

        /** @throws IllegalArgumentException unless finite and > 0. */
        public fun smoothingTolerance(value: Double): Builder = apply {
            require(value > 0 && value < Double.POSITIVE_INFINITY) { "smoothingTolerance must be a number above 0, not $value" }
            smoothingTolerance = value
        }

        /** Sets [MeshOptions.numbering]. */
        public fun numbering(value: NumberingMethod): Builder = apply { numbering = value }

        /** @throws IllegalArgumentException unless > 0. */
        public fun maxElements(value: Int): Builder = apply {
            require(value > 0) { "maxElements must be above 0, not $value" }
            maxElements = value
        }

        /** @throws IllegalArgumentException unless > 0. */
        public fun threads(value: Int): Builder = apply {
            require(value > 0) { "threads must be above 0, not $value" }
            threads = value
        }

        /** Sets [MeshOptions.executor]. */
        public fun executor(value: Executor): Builder = apply { executor = value }

        /** @throws IllegalArgumentException if [minSize] is above [maxSize]. */
        public fun build(): MeshOptions {
            require(minSize <= maxSize) { "minSize $minSize is above maxSize $maxSize" }
            return MeshOptions(this)
        }
    }

    /** A builder that starts from these options. */
    public fun toBuilder(): Builder = Builder().also {
        it.sizes = sizes
        it.gradation = gradation
        it.minSize = minSize
        it.maxSize = maxSize
        it.sizeFunction = sizeFunction
        it.sizeSources = sizeSources
        it.strategy = strategy
        it.improve = improve
        it.smoothingTolerance = smoothingTolerance
        it.numbering = numbering
        it.maxElements = maxElements
        it.threads = threads
        it.executor = lent
    }

    public companion object {
        /** Every option at its default. */
        @JvmField
        public val DEFAULT: MeshOptions = Builder().build()

        /** Starts from the default options. */
        @JvmStatic
        public fun builder(): Builder = Builder()

        private const val serialVersionUID = 1L
    }
}
