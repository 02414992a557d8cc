package org.trigrid.spark

import org.apache.spark.Partitioner
import org.apache.spark.TaskContext
import org.apache.spark.api.java.function.FlatMapFunction
import org.apache.spark.api.java.function.Function
import org.apache.spark.api.java.function.Function2
import org.trigrid.MeshGenerator
import scala.Tuple2
import java.io.IOException
import java.io.Serializable

/** An outline with the work that each of its domains will make, in elements; empty if it cannot be read. */
internal class WeighedOutline(val outline: Outline, val weights: DoubleArray) : Serializable {
    val total: Double get() = if (weights.isEmpty()) ElementBalance.LEAST else weights.sum()

    private companion object {
        private const val serialVersionUID = 1L
    }
}

/** Some domains of an outline, that of number [from] to the one before [until]; none of one that cannot be read. */
internal class OutlinePiece(val outline: Outline, val from: Int, val until: Int) : Serializable {
    private companion object {
        private const val serialVersionUID = 1L
    }
}

/**
 * Deals domains out to partitions of about equal work: their weights laid end to end, partition k gets those whose middles lie in
 * the k-th of equal parts. What a partition gets above its part is less than its largest domain.
 */
internal object ElementBalance {
    /** What the smallest domain costs besides its elements. */
    const val LEAST = 200.0

    /** How many partitions: enough for [elementsPerPartition], and so many that no core of the cluster is idle for long. */
    fun partitions(total: Double, elementsPerPartition: Long, cores: Int): Int =
        Math.max(Math.ceil(total / elementsPerPartition), PER_CORE * cores.toDouble()).coerceIn(1.0, MOST_PARTITIONS).toInt()

    private const val PER_CORE = 3
    private const val MOST_PARTITIONS = 1e6
}

/** Reads outlines and estimates the elements of their domains. */
internal class Weighing(private val plan: MeshPlan) : Function<Outline, WeighedOutline> {
    override fun call(outline: Outline): WeighedOutline {
        val domains = try {
            OutlineDomains(plan).of(outline)
        } catch (_: IOException) {
            emptyList()
        } catch (_: RuntimeException) {
            // Told when it is meshed.
            emptyList()
        }
        return WeighedOutline(outline, DoubleArray(domains.size) { weightOf(domains[it]) })
    }

    private fun weightOf(given: OutlineDomain): Double {
        val least = ElementBalance.LEAST + given.domain.nodeCount
        val expected = try {
            MeshGenerator.expectedElements(given.domain, given.options, DomainMeshing.MONITOR)
        } catch (_: RuntimeException) {
            // Told when it is meshed.
            TaskContext.get()?.killTaskIfInterrupted()
            return least
        }
        // More than allowed is refused, which is no work.
        return if (expected <= given.options.maxElements) least + expected else least
    }

    private companion object {
        private const val serialVersionUID = 1L
    }
}

/** The sum of the weights of a partition. */
internal class WeightSum : FlatMapFunction<Iterator<WeighedOutline>, Double> {
    override fun call(outlines: Iterator<WeighedOutline>): Iterator<Double> {
        var sum = 0.0
        for (it in outlines) sum += it.total
        return listOf(sum).iterator()
    }

    private companion object {
        private const val serialVersionUID = 1L
    }
}

/**
 * Cuts outlines into pieces that go to one partition each.
 *
 * @param starts sum of the weights before each partition.
 * @param part weight of a partition of the result.
 */
internal class Dealing(private val starts: DoubleArray, private val part: Double, private val partitions: Int) :
    Function2<Int, Iterator<WeighedOutline>, Iterator<Tuple2<PieceKey, OutlinePiece>>> {
    override fun call(partition: Int, outlines: Iterator<WeighedOutline>): Iterator<Tuple2<PieceKey, OutlinePiece>> {
        var before = starts[partition]
        var number = 0L
        return outlines.asSequence().flatMap { weighed ->
            val pieces = ArrayList<Tuple2<PieceKey, OutlinePiece>>()
            fun add(target: Int, from: Int, until: Int) {
                pieces.add(Tuple2(PieceKey(target, partition, number++), OutlinePiece(weighed.outline, from, until)))
            }
            if (weighed.weights.isEmpty()) add(target(before, ElementBalance.LEAST), 0, 0)
            var from = 0
            while (from < weighed.weights.size) {
                val target = target(before, weighed.weights[from])
                var until = from
                while (until < weighed.weights.size && target(before, weighed.weights[until]) == target) before += weighed.weights[until++]
                add(target, from, until)
                from = until
            }
            if (weighed.weights.isEmpty()) before += ElementBalance.LEAST
            pieces
        }.iterator()
    }

    private fun target(before: Double, weight: Double): Int =
        ((before + weight / 2) / part).toInt().coerceIn(0, partitions - 1)

    private companion object {
        private const val serialVersionUID = 1L
    }
}

/** Where a piece goes, and its place among all. */
internal class PieceKey(val target: Int, private val partition: Int, private val number: Long) : Serializable, Comparable<PieceKey> {
    override fun compareTo(other: PieceKey): Int = compareValuesBy(this, other, { it.target }, { it.partition }, { it.number })

    override fun equals(other: Any?): Boolean = other is PieceKey && compareTo(other) == 0

    override fun hashCode(): Int = target + 31 * (partition + 31 * number.hashCode())

    private companion object {
        private const val serialVersionUID = 1L
    }
}

/** Each piece goes where its key says. */
internal class PiecePartitioner(private val partitions: Int) : Partitioner() {
    override fun numPartitions(): Int = partitions

    override fun getPartition(key: Any?): Int = (key as PieceKey).target

    private companion object {
        private const val serialVersionUID = 1L
    }
}
