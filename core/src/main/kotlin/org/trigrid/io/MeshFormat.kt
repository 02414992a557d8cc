package org.trigrid.io

/** Mesh file formats that can be written. */
public enum class MeshFormat(
    /** The version as users write it. */
    @get:JvmName("version") public val version: String,
) {
    /** Gmsh MSH 2.2, ASCII; read by nearly every solver. */
    MSH_22("2.2"),

    /** Gmsh MSH 4.1, ASCII. */
    MSH_41("4.1"),
    ;

    public companion object {
        /** The format with this [version], such as `2.2`; null if there is none. */
        @JvmStatic
        public fun ofVersion(version: String): MeshFormat? = entries.firstOrNull { it.version == version }
    }
}
