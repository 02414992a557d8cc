package org.trigrid

import org.trigrid.mesh.TriMesh

/** A valid mesh and the report on how it came to be. */
public class MeshResult internal constructor(
    @get:JvmName("mesh") public val mesh: TriMesh,
    @get:JvmName("report") public val report: MeshReport,
)
