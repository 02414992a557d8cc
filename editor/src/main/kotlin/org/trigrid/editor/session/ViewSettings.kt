package org.trigrid.editor.session

import org.trigrid.editor.meshing.Colouring

/** What is shown. Immutable. */
internal class ViewSettings(
    val showMesh: Boolean = true,
    val showNodes: Boolean = true,
    val showNumbers: Boolean = true,
    val showDirections: Boolean = true,
    val showGrid: Boolean = true,
    val colouring: Colouring = Colouring.NONE,
) {
    fun copy(
        showMesh: Boolean = this.showMesh,
        showNodes: Boolean = this.showNodes,
        showNumbers: Boolean = this.showNumbers,
        showDirections: Boolean = this.showDirections,
        showGrid: Boolean = this.showGrid,
        colouring: Colouring = this.colouring,
    ): ViewSettings = ViewSettings(showMesh, showNodes, showNumbers, showDirections, showGrid, colouring)
}
