package org.trigrid.editor.document

import org.trigrid.domain.Path
import org.trigrid.project.Background
import org.trigrid.project.NodeLoop
import org.trigrid.project.Project

/**
 * All that is edited and undone: the project, the picture behind it among the rest; the picture's file is absolute here.
 * Immutable, so an earlier document is kept by keeping it, and other threads read one without being asked to wait.
 */
internal class EditorDocument(val project: Project) {
    val path: Path get() = project.path
    val loops: List<NodeLoop> get() = project.loops
    val picture: Background? get() = project.background

    /** The nodes of the path, then those of the loops. */
    val nodes: DocumentNodes by lazy(LazyThreadSafetyMode.PUBLICATION) { DocumentNodes(project) }

    /** What is drawn: the walks of the path and the loops. */
    val outlines: List<Outline> by lazy(LazyThreadSafetyMode.PUBLICATION) { Outline.of(project, nodes) }

    val arrows: List<DirectionArrow> by lazy(LazyThreadSafetyMode.PUBLICATION) { DirectionArrow.of(this) }

    /** Nodes that only connectors have, which are no nodes of the domain. */
    val onConnectorsOnly: Set<Int> by lazy(LazyThreadSafetyMode.PUBLICATION) {
        val connectors = (0 until path.shapeCount).filter { path.isConnector(it) }
        val found = LinkedHashSet<Int>()
        for (shape in connectors) for (node in path.nodesOf(shape)) found.add(node)
        if (found.isNotEmpty()) {
            for (outline in outlines) {
                for (step in 0 until outline.stepCount) {
                    if (outline.shapes[step] in connectors) continue
                    found.remove(outline.nodes[step])
                    found.remove(outline.stepEnd(step))
                }
            }
        }
        found
    }

    val isEmpty: Boolean get() = path.shapeCount == 0 && loops.isEmpty()

    /** Names of the boundary groups in use, in order of first use. */
    val groups: List<String> by lazy(LazyThreadSafetyMode.PUBLICATION) { outlines.flatMapTo(LinkedHashSet()) { it.tags }.toList() }

    /** Whether both have the same mesh: they differ at most in colours and the picture behind. */
    fun isMeshedAs(other: EditorDocument): Boolean {
        val a = project
        val b = other.project
        return a.path === b.path && a.options === b.options && a.keepsConnectors == b.keepsConnectors &&
            a.regionName == b.regionName && (a.loops === b.loops || a.loops == b.loops)
    }

    fun with(change: Project.Builder.() -> Project.Builder): EditorDocument = EditorDocument(project.toBuilder().change().build())

    fun withPath(value: Path): EditorDocument = with { path(value) }

    fun withLoops(value: List<NodeLoop>): EditorDocument = with { loops(value) }

    fun withPicture(value: Background?): EditorDocument = with { background(value) }

    companion object {
        val EMPTY: EditorDocument = EditorDocument(Project.builder().build())
    }
}
