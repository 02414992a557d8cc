package org.trigrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.trigrid.domain.Path;
import org.trigrid.io.MeshFormats;
import org.trigrid.mesh.TriMesh;
import org.trigrid.shape.Circle;
import org.trigrid.shape.Rectangle;

/** The Java lines of the README, as they stand there, do what they say. */
class ReadmeTest {
    @Test
    void theProgramMakesAMeshWithNamedBoundaries(@TempDir java.nio.file.Path folder) throws IOException {
        java.nio.file.Path file = folder.resolve("plate.msh");
        // README begins
        Path outline = Path.of(
            new Rectangle(0, 0, 2, 1, 0.1).withName("edge"),
            new Circle(0.7, 0.5, 0.25, 0.04).withName("hole"));
        MeshResult result = MeshGenerator.generate(outline.toDomain());
        TriMesh mesh = result.mesh();
        double[] xy = mesh.nodeCoordinates();     // x0, y0, x1, y1, …
        int[] elements = mesh.elementNodes();     // three per element, anticlockwise, 0-based
        int[] fixed = mesh.nodesOn("hole");       // for boundary conditions
        double worst = result.report().quality().minAngle();
        MeshFormats.write(mesh, file);            // Gmsh .msh, with "edge" and "hole" as physical groups
        // README ends
        assertEquals(mesh.nodeCount(), xy.length / 2);
        assertEquals(mesh.elementCount(), elements.length / 3);
        assertEquals((int) Math.round(2 * Math.PI * 0.25 / 0.04), fixed.length);
        for (int node : fixed) assertEquals(0.25, Math.hypot(mesh.x(node) - 0.7, mesh.y(node) - 0.5), 1e-12);
        assertTrue(worst > 25, "smallest angle " + worst);
        assertEquals(mesh.elementCount(), MeshFormats.read(file).elementCount());
    }

    @Test
    void theReadmeHasTheSameLines() throws IOException {
        List<String> tested = between("src/test/java/org/trigrid/ReadmeTest.java", "// README begins", "// README ends");
        assertTrue(tested.size() >= 8);
        assertEquals(tested, between("../README.md", "```java", "```"));
    }

    private static List<String> between(String file, String first, String last) throws IOException {
        List<String> found = new ArrayList<>();
        boolean inside = false;
        for (String line : Files.readAllLines(java.nio.file.Path.of(file))) {
            String text = line.strip();
            if (inside && text.equals(last)) return found;
            if (inside) found.add(text);
            if (text.equals(first)) inside = true;
        }
        throw new IOException(file + " lacks " + first + " or " + last);
    }
}
