package org.trigrid.spark

import org.apache.spark.api.java.function.Function
import org.apache.spark.sql.Row
import org.apache.spark.sql.types.DataTypes
import org.apache.spark.sql.types.StructType
import java.io.Serializable

/** An outline on its way: a text, or the content of a file, with what is known of it. */
internal class Outline(
    val id: String,
    /** Names the domains that have no name of their own. */
    val name: String,
    /** Short name of the format; null to tell it by the text. */
    val format: String?,
    val content: ByteArray,
    /** Why there is no content, or null. */
    val trouble: String? = null,
) : Serializable {
    private companion object {
        private const val serialVersionUID = 1L
    }
}

/** Where a row has the parts of an outline; -1 for a column that is not there. */
internal class OutlineColumns private constructor(
    private val id: Int, private val outline: Int, private val name: Int, private val format: Int,
) : Function<Row, Outline> {
    override fun call(row: Row): Outline {
        val id = text(row, id).orEmpty()
        val content = text(row, outline)
        val trouble = if (content == null) "there is no outline" else null
        return Outline(id, text(row, name) ?: id, text(row, format), content.orEmpty().toByteArray(), trouble)
    }

    private fun text(row: Row, column: Int): String? = if (column < 0 || row.isNullAt(column)) null else row.getString(column)

    companion object {
        private const val serialVersionUID = 1L

        fun of(schema: StructType): OutlineColumns = OutlineColumns(
            place(schema, MeshColumns.ID, true), place(schema, MeshColumns.OUTLINE, true),
            place(schema, MeshColumns.NAME, false), place(schema, MeshColumns.FORMAT, false),
        )

        private fun place(schema: StructType, column: String, isNeeded: Boolean): Int {
            val place = schema.fieldNames().indexOf(column)
            require(place >= 0 || !isNeeded) { "outlines need a column \"$column\"; there are ${schema.fieldNames().joinToString()}" }
            if (place >= 0) {
                val type = schema.fields()[place].dataType()
                require(type == DataTypes.StringType) { "the column \"$column\" of outlines must hold strings, not ${type.simpleString()}" }
            }
            return place
        }
    }
}
