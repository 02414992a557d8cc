package org.trigrid.samples;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.ejml.data.DMatrixRMaj;
import org.ejml.data.DMatrixSparseCSC;
import org.ejml.interfaces.decomposition.CholeskySparseDecomposition_F64;
import org.ejml.interfaces.linsol.LinearSolverSparse;
import org.ejml.sparse.FillReducing;
import org.ejml.sparse.csc.factory.LinearSolverFactory_DSCC;
import org.trigrid.MeshGenerator;
import org.trigrid.MeshOptions;
import org.trigrid.MeshRework;
import org.trigrid.domain.Domain;
import org.trigrid.fem.LinearElements;
import org.trigrid.fem.SparsityPattern;
import org.trigrid.interop.EjmlMatrices;
import org.trigrid.mesh.TriMesh;
import org.trigrid.numbering.Numbering;
import org.trigrid.numbering.NumberingMethod;
import org.trigrid.project.ProjectFile;

/**
 * Poisson's equation -Δu = f on the hand of the paper, u given on the boundary, f chosen so that u = sin x sin y.
 *
 * <p>Prints how the error falls when every element is divided into four, and what renumbering the nodes saves the solver.
 */
public final class PoissonOnHand {
    /** Nodal values, entries of the matrix' Cholesky factor, and time of factorizing and solving. */
    public record Solution(double[] u, int factorEntries, double seconds) {}

    public static double exact(double x, double y) {
        return Math.sin(x) * Math.sin(y);
    }

    private static double source(double x, double y) {
        return 2 * Math.sin(x) * Math.sin(y);
    }

    public static void main(String[] arguments) throws IOException {
        Path file = Path.of(arguments.length > 0 ? arguments[0] : "src-test-data/paper/hand.trigrid.json");
        Domain hand = ProjectFile.read(file).toDomain();
        System.out.println("   nodes    L2 error   order");
        TriMesh mesh = MeshGenerator.generate(hand).mesh();
        double before = Double.NaN;
        for (int level = 0; level < 4; level++) {
            // A refined mesh has its new nodes last, far from their neighbours' numbers.
            if (level > 0) mesh = Numbering.renumber(MeshRework.refine(mesh), NumberingMethod.BEST);
            double error = error(mesh, solve(mesh).u());
            System.out.printf(Locale.ROOT, "%8d  %.4e  %6.2f%n", mesh.nodeCount(), error, Math.log(before / error) / Math.log(2));
            before = error;
        }

        MeshOptions unsorted = MeshOptions.builder().numbering(NumberingMethod.NONE).build();
        mesh = MeshGenerator.generate(hand.respaced(0.1, 1), unsorted).mesh();
        System.out.println("              bandwidth  factor entries  seconds");
        print("unsorted", mesh);
        print("renumbered", Numbering.renumber(mesh, NumberingMethod.BEST));
    }

    public static Solution solve(TriMesh mesh) {
        SparsityPattern pattern = SparsityPattern.of(mesh);
        double[] matrix = new double[pattern.entryCount()];
        double[] right = new double[mesh.nodeCount()];

        LinearElements elements = LinearElements.of(mesh);
        int[] entries = pattern.elementEntries();     // nine an element: where its 3 x 3 matrix goes
        double[] g = elements.gradients();            // six an element: gradients of its three shape functions
        for (int e = 0; e < mesh.elementCount(); e++) {
            for (int i = 0; i < 3; i++) {
                for (int j = 0; j < 3; j++) {
                    double dot = g[6 * e + 2 * i] * g[6 * e + 2 * j] + g[6 * e + 2 * i + 1] * g[6 * e + 2 * j + 1];
                    matrix[entries[9 * e + 3 * i + j]] += elements.area(e) * dot;
                }
            }
        }
        double[] nodeAreas = elements.nodeAreas();
        for (int n = 0; n < right.length; n++) right[n] = nodeAreas[n] * source(mesh.x(n), mesh.y(n));

        for (String tag : List.of("skin", "wrist")) {
            for (int n : mesh.nodesOn(tag)) fix(pattern, matrix, right, n, exact(mesh.x(n), mesh.y(n)));
        }

        long start = System.nanoTime();
        LinearSolverSparse<DMatrixSparseCSC, DMatrixRMaj> solver = LinearSolverFactory_DSCC.cholesky(FillReducing.NONE);
        if (!solver.setA(EjmlMatrices.matrix(pattern, matrix))) throw new IllegalStateException("the matrix is singular");
        DMatrixRMaj u = new DMatrixRMaj(right.length, 1);
        solver.solve(DMatrixRMaj.wrap(right.length, 1, right), u);
        double seconds = 1e-9 * (System.nanoTime() - start);
        CholeskySparseDecomposition_F64<DMatrixSparseCSC> factors = solver.getDecomposition();
        return new Solution(u.data, factors.getT(null).nz_length, seconds);
    }

    /** Puts a known value in place of a row's equation, and its part in the others on the right, so that all stays symmetric. */
    private static void fix(SparsityPattern pattern, double[] matrix, double[] right, int row, double value) {
        for (int k = pattern.rowStart(row); k < pattern.rowStart(row + 1); k++) {
            int mirrored = pattern.entryOf(pattern.column(k), row);
            right[pattern.column(k)] -= matrix[mirrored] * value;
            matrix[k] = 0;
            matrix[mirrored] = 0;
        }
        matrix[pattern.entryOf(row, row)] = 1;
        right[row] = value;
    }

    /** Norm of the error in L2, by the values at the middles of the edges: exact where the error is linear. */
    public static double error(TriMesh mesh, double[] u) {
        double sum = 0;
        for (int e = 0; e < mesh.elementCount(); e++) {
            for (int k = 0; k < 3; k++) {
                int a = mesh.nodeOf(e, k);
                int b = mesh.nodeOf(e, (k + 1) % 3);
                double there = exact((mesh.x(a) + mesh.x(b)) / 2, (mesh.y(a) + mesh.y(b)) / 2);
                double difference = (u[a] + u[b]) / 2 - there;
                sum += mesh.area(e) / 3 * difference * difference;
            }
        }
        return Math.sqrt(sum);
    }

    private static void print(String name, TriMesh mesh) {
        Solution solution = solve(mesh);
        System.out.printf(Locale.ROOT, "%-12s %10d  %14d  %7.3f%n", name, mesh.bandwidth(), solution.factorEntries(), solution.seconds());
    }
}
