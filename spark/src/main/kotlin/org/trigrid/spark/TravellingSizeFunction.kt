package org.trigrid.spark

import org.trigrid.spacing.SizeFunction
import java.io.Serializable

/**
 * A size function that can be sent to other machines; a lambda in its place must only hold what is serializable.
 *
 * ```java
 * TravellingSizeFunction sizes = (x, y) -> 20 + 0.1 * Math.hypot(x - 500, y - 400);
 * MeshOptions.builder().sizeFunction(sizes)
 * ```
 */
public fun interface TravellingSizeFunction : SizeFunction, Serializable
