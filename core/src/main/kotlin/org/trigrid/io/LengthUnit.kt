package org.trigrid.io

/** Units of length that drawings are made in. */
public enum class LengthUnit(
    /** As users write it: `mm`. */
    @get:JvmName("symbol") public val symbol: String,
    /** How many metres it is. */
    @get:JvmName("metres") public val metres: Double,
    /** The number of `$INSUNITS` in DXF. */
    private val dxf: Int,
) {
    MICROMETRE("um", 1e-6, 13),
    MILLIMETRE("mm", 1e-3, 4),
    CENTIMETRE("cm", 1e-2, 5),
    DECIMETRE("dm", 1e-1, 14),
    METRE("m", 1.0, 6),
    KILOMETRE("km", 1e3, 7),
    INCH("in", 0.0254, 1),
    FOOT("ft", 0.3048, 2),
    MILE("mi", 1609.344, 3),
    ;

    public companion object {
        /** The unit with this [symbol]; null if there is none. */
        @JvmStatic
        public fun ofSymbol(symbol: String): LengthUnit? = entries.firstOrNull { it.symbol == symbol }

        /** The unit of a DXF file's `$INSUNITS`; null for none and for those that are not here. */
        internal fun ofDxf(number: Int): LengthUnit? = entries.firstOrNull { it.dxf == number }
    }
}
