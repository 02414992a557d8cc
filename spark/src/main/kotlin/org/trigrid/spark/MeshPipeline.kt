package org.trigrid.spark

import org.apache.spark.api.java.JavaPairRDD
import org.apache.spark.api.java.JavaRDD
import org.apache.spark.api.java.function.FlatMapFunction
import org.apache.spark.sql.Dataset
import org.apache.spark.sql.Row
import org.apache.spark.sql.SparkSession
import org.apache.spark.sql.types.DataTypes
import org.apache.spark.sql.types.StructType
import org.apache.spark.storage.StorageLevel
import scala.Tuple2

/** From outlines to rows of meshes. */
internal class MeshPipeline(private val session: SparkSession, private val plan: MeshPlan, private val sink: MeshSink) {
    private val schema: StructType = DataTypes.createStructType(MeshColumns.FIGURES + sink.columns)

    /** Runs a job at once, that estimates the work; another makes the meshes when they are asked for. */
    fun mesh(outlines: JavaRDD<Outline>): Dataset<Row> {
        val rows = if (plan.elementsPerPartition == 0L) outlines.mapPartitions(WholeOutlines(plan, sink, schema))
        else balanced(outlines).mapPartitions(Pieces(plan, sink, schema))
        return session.createDataFrame(rows, schema)
    }

    private fun balanced(outlines: JavaRDD<Outline>): JavaRDD<Tuple2<PieceKey, OutlinePiece>> {
        // Spark drops what was kept when the result is no longer referred to.
        val weighed = outlines.map(Weighing(plan)).persist(StorageLevel.MEMORY_AND_DISK())
        val sums = weighed.mapPartitions(WeightSum()).collect()
        val starts = DoubleArray(sums.size + 1)
        for ((i, sum) in sums.withIndex()) starts[i + 1] = starts[i] + sum
        val total = starts.last()
        val cores = session.sparkContext().defaultParallelism()
        val partitions = ElementBalance.partitions(total, plan.elementsPerPartition, cores)
        val dealing = Dealing(starts, Math.max(total, 1.0) / partitions, partitions)
        val pairs = JavaPairRDD.fromJavaRDD(weighed.mapPartitionsWithIndex(dealing, true))
        return JavaRDD.fromRDD(pairs.repartitionAndSortWithinPartitions(PiecePartitioner(partitions)).rdd(), pairs.classTag())
    }
}

/** Meshes all domains of each outline. */
internal class WholeOutlines(private val plan: MeshPlan, private val sink: MeshSink, private val schema: StructType) :
    FlatMapFunction<Iterator<Outline>, Row> {
    override fun call(outlines: Iterator<Outline>): Iterator<Row> =
        outlines.asSequence().flatMap { outline -> PieceRows(plan, sink, schema).of(outline, 0, Int.MAX_VALUE) }.iterator()

    private companion object {
        private const val serialVersionUID = 1L
    }
}

/** Meshes the domains of each piece. */
internal class Pieces(private val plan: MeshPlan, private val sink: MeshSink, private val schema: StructType) :
    FlatMapFunction<Iterator<Tuple2<PieceKey, OutlinePiece>>, Row> {
    override fun call(pieces: Iterator<Tuple2<PieceKey, OutlinePiece>>): Iterator<Row> =
        pieces.asSequence().flatMap { pair ->
            val piece = pair._2()
            PieceRows(plan, sink, schema).of(piece.outline, piece.from, piece.until)
        }.iterator()

    private companion object {
        private const val serialVersionUID = 1L
    }
}

/** One mesh after the other, so that only one is in memory. */
private class PieceRows(private val plan: MeshPlan, sink: MeshSink, schema: StructType) {
    private val meshing = DomainMeshing(plan, sink, schema)

    fun of(outline: Outline, from: Int, until: Int): Sequence<Row> {
        val domains = try {
            OutlineDomains(plan).of(outline)
        } catch (error: Exception) {
            return sequenceOf(meshing.unread(outline, error))
        }
        return (from until Math.min(until, domains.size)).asSequence().map { meshing.mesh(outline, domains, it) }
    }
}
