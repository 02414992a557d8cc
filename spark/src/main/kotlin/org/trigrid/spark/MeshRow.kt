package org.trigrid.spark

import org.apache.spark.sql.Row
import org.apache.spark.sql.RowFactory
import org.apache.spark.sql.types.StructType

/** A row of the result while it is filled. */
internal class MeshRow(private val schema: StructType) {
    private val values = arrayOfNulls<Any>(schema.size())

    fun set(column: String, value: Any?) {
        values[schema.fieldIndex(column)] = value
    }

    /** A figure that a mesh does not have is null. */
    fun setFigure(column: String, value: Double) = set(column, if (value.isFinite()) value else null)

    fun toRow(): Row = RowFactory.create(*values)
}
