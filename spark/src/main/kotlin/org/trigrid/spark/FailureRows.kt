package org.trigrid.spark

import org.apache.spark.sql.Row
import org.apache.spark.sql.RowFactory
import org.apache.spark.sql.types.DataType
import org.apache.spark.sql.types.DataTypes
import org.apache.spark.sql.types.StructType
import org.trigrid.diagnostics.Fault
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.diagnostics.InvalidSizeException
import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.diagnostics.TooManyElementsException
import java.io.IOException

/** Puts what went wrong into the row of an outline or a domain. */
internal object FailureRows {
    fun put(row: MeshRow, error: Exception) {
        row.set(MeshColumns.ERROR, messageOf(error))
        row.set(MeshColumns.ERROR_KIND, kindOf(error).name)
        if (error is FileFormatException) {
            if (error.line > 0) row.set(MeshColumns.LINE, error.line)
            if (error.line > 0 && error.column > 0) row.set(MeshColumns.COLUMN, error.column)
        }
        if (error is InvalidDomainException) row.set(MeshColumns.FAULTS, FaultRows.of(error.faults))
    }

    private fun kindOf(error: Exception): OutlineError = when (error) {
        is FileFormatException -> OutlineError.FORMAT
        is InvalidDomainException -> OutlineError.DOMAIN
        is InvalidShapeException, is IllegalArgumentException -> OutlineError.SHAPE
        is InvalidSizeException -> OutlineError.SIZE
        is TooManyElementsException -> OutlineError.TOO_LARGE
        is MeshingCancelledException -> throw error
        is IOException -> OutlineError.FILE
        else -> OutlineError.DEFECT
    }

    /** Without the name of the text, which has columns of its own. */
    private fun messageOf(error: Exception): String = when (error) {
        is FileFormatException -> error.message.orEmpty().removePrefix(error.source).removePrefix(":")
        is InvalidDomainException -> error.faults.joinToString("\n") { it.toString() }
        else -> error.message?.takeIf { kindOf(error) != OutlineError.DEFECT } ?: error.stackTraceToString()
    }
}

/** The faults of a domain as rows in a row. */
internal object FaultRows {
    /** Stands alone: [MeshColumns] is made with it, and either may be the first that a machine needs. */
    val TYPE: StructType = DataTypes.createStructType(
        listOf(
            field("kind", DataTypes.StringType), field("message", DataTypes.StringType), field("x", DataTypes.DoubleType),
            field("y", DataTypes.DoubleType), field("nodes", DataTypes.createArrayType(DataTypes.IntegerType, false)),
        ),
    )

    private fun field(name: String, type: DataType) = DataTypes.createStructField(name, type, true)

    fun of(faults: List<Fault>): Array<Row> =
        Array(faults.size) { i -> faults[i].let { RowFactory.create(it.kind.name, it.message, it.x, it.y, it.nodes()) } }
}
