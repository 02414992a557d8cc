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
        val kept = steps.indices.filter { shape !in replay.touched[it] }.map { replaced[it] ?: steps[it] }
        return withoutUndone(kept)
    }

    fun withoutShape(steps: List<PathStep>, replay: PathReplay, shape: Int): List<PathStep> {
        val append = steps.indices.filter { steps[it] is AppendStep }[shape]
        val back = wayBack(steps, append)
        val kept = ArrayList<PathStep>()
        for ((i, step) in steps.withIndex()) {
            if (i == append || i == back || shape in replay.touched[i]) continue
            if (step is EditStep && step.keys().any { it.shape == shape }) continue
            kept.add(if (step is EditStep) step.mapped { lowered(it, shape) } else step)
        }
        return withoutUndone(kept)
    }

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

    /** Edits of nodes that have gone with others are dropped, until all that is left can be done. */
    private fun withoutUndone(steps: List<PathStep>): List<PathStep> {
        var kept = steps
        while (true) {
            val undone = PathReplay(kept).undone.filter { kept[it] is EditStep }.toSet()
            if (undone.isEmpty()) return kept
            kept = kept.filterIndexed { i, _ -> i !in undone }
        }
    }
}
