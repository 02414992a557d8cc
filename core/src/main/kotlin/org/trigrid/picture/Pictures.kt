package org.trigrid.picture

import org.trigrid.domain.Domain
import org.trigrid.mesh.TriMesh

/** Draws meshes, domains and coefficient matrices. */
public object Pictures {
    /** The mesh with thin lines and a strong boundary. */
    @JvmStatic
    public fun mesh(mesh: TriMesh): Picture = mesh(mesh, PictureOptions.DEFAULT)

    /** The mesh with what [options] ask for; numbers are left out where they would not fit. */
    @JvmStatic
    public fun mesh(mesh: TriMesh, options: PictureOptions): Picture = Picture(MeshPicture(mesh, options).draw())

    /** The domain with its nodes as small donuts and its boundary groups in colours. */
    @JvmStatic
    public fun domain(domain: Domain): Picture = domain(domain, PictureOptions.DEFAULT)

    /** The domain with what [options] ask for; it may be a faulty one. */
    @JvmStatic
    public fun domain(domain: Domain, options: PictureOptions): Picture = Picture(DomainPicture(domain, options).draw())

    /** The structure of the coefficient matrix of a mesh. */
    @JvmStatic
    public fun matrix(mesh: TriMesh): Picture = Picture(MatrixPicture.draw(listOf("" to mesh)))

    /** The structure of the coefficient matrix before and after renumbering, side by side. */
    @JvmStatic
    public fun matrix(before: TriMesh, after: TriMesh): Picture =
        Picture(MatrixPicture.draw(listOf("Before renumbering" to before, "After renumbering" to after)))
}
