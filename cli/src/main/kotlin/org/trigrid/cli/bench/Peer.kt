package org.trigrid.cli.bench

/** The mesh generators that ours is compared with, each run through its own Python package. */
internal enum class Peer(val title: String) {
    GMSH("Gmsh Frontal-Delaunay"),
    NETGEN("Netgen"),
    TRIANGLE("Triangle with sizes"),
    ;

    /** As `peers.py` calls it. */
    val id: String = name.lowercase()
}
