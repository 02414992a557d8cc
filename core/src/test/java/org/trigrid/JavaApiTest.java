package org.trigrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.trigrid.domain.Path;
import org.trigrid.io.MeshFormats;
import org.trigrid.mesh.MeshCheck;
import org.trigrid.mesh.NodeKind;
import org.trigrid.mesh.TriMesh;
import org.trigrid.shape.Circle;
import org.trigrid.shape.Rectangle;

/** A Java program for finite elements: the contract with Java users. The README shows its lines. */
class JavaApiTest {
    private static TriMesh plateWithHole(java.nio.file.Path file) throws IOException {
        // README begins
        Path outline = Path.of(
            new Rectangle(0, 0, 2, 1, 0.1).withName("edge"),
            new Circle(0.7, 0.5, 0.25, 0.04).withName("hole"));
        MeshResult result = MeshGenerator.generate(outline.toDomain());
        TriMesh mesh = result.mesh();
        double[] xy = mesh.nodeCoordinates();     // x0, y0, x1, y1, …
        int[] elements = mesh.elementNodes();     // three per element, anticlockwise, 0-based
        int[] fixed = mesh.nodesOn("hole");       // ascending, for boundary conditions
        double worst = result.report().quality().minAngle();
        int bandwidth = mesh.bandwidth();         // 2 B + 1, small by renumbering
        MeshFormats.write(mesh, file);            // Gmsh .msh, with "edge" and "hole" as physical groups
        // README ends
        assertEquals(2 * mesh.nodeCount(), xy.length);
        assertEquals(3 * mesh.elementCount(), elements.length);
        assertEquals((int) Math.round(2 * Math.PI * 0.25 / 0.04), fixed.length);
        for (int node : fixed) assertEquals(0.25, Math.hypot(xy[2 * node] - 0.7, xy[2 * node + 1] - 0.5), 1e-12);
        assertEquals(60, mesh.nodesOn("edge").length);
        assertTrue(worst > 25 && worst <= 60, "smallest angle " + worst);
        assertTrue(bandwidth < result.report().numberingBefore().bandwidth());
        assertTrue(MeshCheck.check(mesh, outline.toDomain()).isEmpty());
        return mesh;
    }

    @Test
    void aPlateWithAHoleIsMeshedAndWritten(@TempDir java.nio.file.Path folder) throws IOException {
        java.nio.file.Path file = folder.resolve("plate.msh");
        TriMesh mesh = plateWithHole(file);
        assertTrue(Files.readString(file).startsWith("$MeshFormat\n2.2 0 8\n"));
        TriMesh read = MeshFormats.read(file);
        assertEquals(mesh.nodeCount(), read.nodeCount());
        assertEquals(mesh.bandwidth(), read.bandwidth());
        assertEquals(List.of("edge", "hole"), read.tags());
    }

    /** Patch test of Laplace's equation: linear elements reproduce a linear solution. */
    @Test
    void aBandSolverFindsTheLinearSolution(@TempDir java.nio.file.Path folder) throws IOException {
        TriMesh mesh = plateWithHole(folder.resolve("plate.msh"));
        double[] u = solve(bandMatrix(mesh), mesh);
        for (int node = 0; node < mesh.nodeCount(); node++) assertEquals(solution(mesh, node), u[node], 1e-12);
    }

    @Test
    void theReadmeShowsThisProgram() throws IOException {
        List<String> shown = new ArrayList<>();
        boolean inside = false;
        for (String line : Files.readAllLines(Paths.get("src/test/java/org/trigrid/JavaApiTest.java"))) {
            if (line.strip().equals("// README ends")) inside = false;
            if (inside) shown.add(line.substring(8));
            if (line.strip().equals("// README begins")) inside = true;
        }
        String program = String.join("\n", shown);
        assertTrue(shown.size() >= 8, program);
        assertTrue(Files.readString(Paths.get("../README.md")).contains("```java\n" + program + "\n```"), program);
    }

    private static double solution(TriMesh mesh, int node) {
        return 1 + 2 * mesh.x(node) - 3 * mesh.y(node);
    }

    /** Lower band of the stiffness matrix: row i holds columns i - B to i. */
    private static double[][] bandMatrix(TriMesh mesh) {
        int half = mesh.halfBandwidth();
        double[][] band = new double[mesh.nodeCount()][half + 1];
        double[] b = new double[3];
        double[] c = new double[3];
        for (int element = 0; element < mesh.elementCount(); element++) {
            for (int k = 0; k < 3; k++) {
                int next = mesh.nodeOf(element, (k + 1) % 3);
                int last = mesh.nodeOf(element, (k + 2) % 3);
                b[k] = mesh.y(next) - mesh.y(last);
                c[k] = mesh.x(last) - mesh.x(next);
            }
            for (int k = 0; k < 3; k++) {
                for (int m = 0; m < 3; m++) {
                    int row = mesh.nodeOf(element, k);
                    int column = mesh.nodeOf(element, m);
                    if (column > row) continue;
                    band[row][column - row + half] += (b[k] * b[m] + c[k] * c[m]) / (4 * mesh.area(element));
                }
            }
        }
        return band;
    }

    /** Gauss-Seidel sweeps over the interior nodes, the others held at the solution. */
    private static double[] solve(double[][] band, TriMesh mesh) {
        int half = mesh.halfBandwidth();
        double[] u = new double[mesh.nodeCount()];
        for (int i = 0; i < u.length; i++) if (mesh.kindOf(i) != NodeKind.INTERIOR) u[i] = solution(mesh, i);
        double change = 1;
        for (int sweep = 0; change > 1e-15 && sweep < 5000; sweep++) {
            change = 0;
            for (int i = 0; i < u.length; i++) {
                if (mesh.kindOf(i) != NodeKind.INTERIOR) continue;
                double sum = 0;
                for (int j = Math.max(0, i - half); j <= Math.min(u.length - 1, i + half); j++) {
                    if (j < i) sum += band[i][j - i + half] * u[j];
                    if (j > i) sum += band[j][i - j + half] * u[j];
                }
                double value = -sum / band[i][half];
                change = Math.max(change, Math.abs(value - u[i]));
                u[i] = value;
            }
        }
        return u;
    }
}
