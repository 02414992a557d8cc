package org.trigrid.front

/**
 * Hears of each element that the front has made, in their order, to show how it advances; most often when the mesh is done, as
 * it may have to be made again.
 *
 * Called in the thread that meshes, so it should only take notes; [FrontTrace] does.
 */
public fun interface FrontListener {
    /**
     * An element has been made over the front's side from node [a] to node [b].
     *
     * Nodes are numbered as the front does it: those of the domain first, as in the domain, then new ones in the order
     * in which they are made. The numbers of the finished mesh differ.
     *
     * @param c the element's third node, one of the front or the next new one.
     * @param x where [c] lies now; improvement may move it later. In the domain's unit, as [y].
     */
    public fun elementMade(a: Int, b: Int, c: Int, x: Double, y: Double)
}
