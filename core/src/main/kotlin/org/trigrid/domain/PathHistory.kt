package org.trigrid.domain

/** Rewrites the history of a path when one of its shapes changes. */
internal object PathHistory {
    /** [steps] without the edits of a shape's nodes, and with some steps replaced. */
    fun withoutEdits(
        steps: List<PathStep>,
        replay: PathReplay,
        shape: Int,
        replaced: Map<Int, PathStep>,
    ): List<PathStep> {
        val kept = steps.indices.filter { shape !in replay.touched[it] }.map { replaced[it] ?: respread(steps[it], shape, steps, replaced) }
        return withoutUndone(kept)
    }

    /** A connector at a node of a replaced shape goes to the node about as far along the new one. */
    private fun respread(step: PathStep, shape: Int, steps: List<PathStep>, replaced: Map<Int, PathStep>): PathStep {
        if (step !is ConnectStep) return step
        val (index, by) = replaced.entries.firstOrNull() ?: return step
        val old = steps[index] as? AppendStep ?: return step
        val before = old.nodes.size / 2 - 1
        val now = (by as AppendStep).nodes.size / 2 - 1
        return step.mapped { key ->
            if (key.shape == shape) NodeKey(shape, Math.round(key.ordinal.toDouble() * now / before).toInt()) else key
        }
    }

    fun withoutShape(steps: List<PathStep>, replay: PathReplay, shape: Int): List<PathStep> {
        val ending = shapeSteps(steps).indexOfLast { index ->
            (steps[index] as? ConnectStep)?.keys().orEmpty().any { it.shape == shape }
        }
        if (ending >= 0) return withoutShape(withoutShape(steps, replay, ending), shape)
        val append = shapeSteps(steps)[shape]
        val back = wayBack(steps, append)
        val kept = ArrayList<PathStep>()
        for ((i, step) in steps.withIndex()) {
            if (i == append || i == back || shape in replay.touched[i]) continue
            if (step is KeyedStep && step.keys().any { it.shape == shape }) continue
            kept.add(if (step is KeyedStep) step.mapped { lowered(it, shape) } else step)
        }
        return withoutUndone(kept)
    }

    private fun withoutShape(steps: List<PathStep>, shape: Int): List<PathStep> = withoutShape(steps, PathReplay(steps), shape)

    /** Indices of the steps that add shapes. */
    private fun shapeSteps(steps: List<PathStep>): List<Int> = steps.indices.filter { steps[it] is ShapeStep }

    private fun lowered(key: NodeKey, removed: Int): NodeKey =
        if (key.shape > removed) NodeKey(key.shape - 1, key.ordinal) else key

    /** Index of the step that travels the connector at [append] back, or -1. */
    private fun wayBack(steps: List<PathStep>, append: Int): Int {
        val open = ArrayList<Int>()
        for ((i, step) in steps.withIndex()) {
            when {
                step is AppendStep && step.isConnector -> open.add(i)
                step is NewLoopStep -> open.clear()
                step is BackStep && open.isNotEmpty() -> if (open.removeAt(open.size - 1) == append) return i
            }
        }
        return -1
    }

    /** Edits of nodes and connectors at nodes that have gone are dropped, until all that is left can be done. */
    private fun withoutUndone(steps: List<PathStep>): List<PathStep> {
        var kept = steps
        while (true) {
            val replay = PathReplay(kept)
            val connector = replay.undone.firstOrNull { kept[it] is ConnectStep }
            if (connector != null) return withoutShape(kept, replay, shapeSteps(kept).indexOf(connector))
            val undone = replay.undone.filter { kept[it] is EditStep }.toSet()
            if (undone.isEmpty()) return kept
            kept = kept.filterIndexed { i, _ -> i !in undone }
        }
    }
}
