package org.trigrid.domain

/** One walk of a [Path]: node after node along its shapes. A connector's nodes occur twice in it. Immutable. */
public class PathWalk internal constructor(
    private val nodeArray: IntArray,
    private val stepTags: List<String>,
    private val stepShapes: IntArray,
    /** Whether the last node is followed by the first. */
    @get:JvmName("isClosed") public val isClosed: Boolean,
    /** The loop of the path that the walk belongs to; walks that come off one walk share its group. */
    internal val group: Int,
) {
    /** Node numbers in the order of travel; the first is not repeated at the end of a closed walk. A copy. */
    public fun nodes(): IntArray = nodeArray.copyOf()

    /** As many as nodes where the walk is closed, one less where it is open. */
    @get:JvmName("stepCount")
    public val stepCount: Int get() = stepShapes.size

    /** The tag of the step from the [step]-th node to the next. */
    public fun tag(step: Int): String = stepTags[step]

    /** The shape that the step came from, by its number in the path; -1 for a straight step that bridges a gap. */
    public fun shape(step: Int): Int = stepShapes[step]
}
