package org.trigrid.cli

import org.trigrid.domain.Domain
import org.trigrid.mesh.TriMesh
import org.trigrid.picture.Picture
import org.trigrid.picture.PictureOptions
import org.trigrid.picture.Pictures

/** What `trigrid picture --show` can be asked for. */
internal enum class PictureContent {
    MESH,
    DOMAIN,
    NUMBERS,
    QUALITY,
    MATRIX,
    ;

    /** @param before the mesh as the front numbered it, or null where that is not known. */
    fun of(mesh: TriMesh, before: TriMesh?): Picture = when (this) {
        MESH -> Pictures.mesh(mesh)
        NUMBERS -> Pictures.mesh(mesh, PictureOptions.builder().nodeNumbers(true).elementNumbers(true).build())
        QUALITY -> Pictures.mesh(mesh, PictureOptions.builder().quality(true).build())
        MATRIX -> if (before == null) Pictures.matrix(mesh) else Pictures.matrix(before, mesh)
        DOMAIN -> throw IllegalArgumentException("a mesh has no picture of its domain")
    }

    companion object {
        /** The domain with the node numbers that `trigrid check` names, which count from 0. */
        fun ofDomain(domain: Domain): Picture =
            Pictures.domain(domain, PictureOptions.builder().nodeNumbers(true).firstNumber(0).build())
    }
}
