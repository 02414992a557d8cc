package org.trigrid.editor.document

import org.trigrid.geometry.Point2
import org.trigrid.shape.Similarity
import java.nio.file.Path

/**
 * A picture to trace over and where it lies. Immutable.
 *
 * @param placement takes the picture's pixels, x to the right and y upwards from its lower left corner, to the domain.
 * @param opacity 0..1.
 * @param isLocked whether the mouse leaves it where it is.
 */
internal class BackgroundPicture(
    val file: Path,
    val placement: Similarity,
    val opacity: Double = 0.5,
    val isLocked: Boolean = true,
) {
    fun withPlacement(value: Similarity): BackgroundPicture = BackgroundPicture(file, value, opacity, isLocked)

    fun withOpacity(value: Double): BackgroundPicture = BackgroundPicture(file, placement, value.coerceIn(0.0, 1.0), isLocked)

    fun withLock(value: Boolean): BackgroundPicture = BackgroundPicture(file, placement, opacity, value)

    /** Scaled about [a] so that [a] and [b], which lie on it, are [distance] apart. */
    fun scaledTo(a: Point2, b: Point2, distance: Double): BackgroundPicture =
        withPlacement(placement.then(Similarity.scaling(a, distance / a.distanceTo(b))))
}
