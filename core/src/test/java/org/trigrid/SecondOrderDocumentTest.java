package org.trigrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.trigrid.domain.Path;
import org.trigrid.io.MeshFormats;
import org.trigrid.mesh.QuadraticMesh;
import org.trigrid.project.ShapeMiddles;
import org.trigrid.shape.Circle;

/** The lines that docs/formats.md shows for meshes of second order. */
class SecondOrderDocumentTest {
    @Test
    void aDiscIsWrittenWithItsMiddlesOnTheCircle(@TempDir java.nio.file.Path folder) throws IOException {
        Path path = Path.of(new Circle(0, 0, 1, 0.3));
        MeshResult result = MeshGenerator.generate(path.toDomain());
        java.nio.file.Path file = folder.resolve("disc.inp");
        QuadraticMesh mesh = MeshRework.secondOrder(result.mesh(), new ShapeMiddles(path));
        MeshFormats.write(mesh, file);                // the ending says: .msh, .vtu, .inp, …
        assertEquals(0, mesh.straightenedEdgeCount());
        assertTrue(Files.readString(file).contains("CPS6"));
    }
}
