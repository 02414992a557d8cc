package org.trigrid.samples;

import java.util.Locale;
import org.ejml.data.DMatrixRMaj;
import org.ejml.interfaces.linsol.LinearSolverSparse;
import org.ejml.data.DMatrixSparseCSC;
import org.ejml.sparse.FillReducing;
import org.ejml.sparse.csc.factory.LinearSolverFactory_DSCC;
import org.trigrid.MeshGenerator;
import org.trigrid.domain.Domain;
import org.trigrid.domain.Region;
import org.trigrid.fem.LinearElements;
import org.trigrid.fem.SparsityPattern;
import org.trigrid.interop.EjmlMatrices;
import org.trigrid.mesh.TriMesh;

/**
 * Steady heat of a coil in a block of iron, wrapped in insulation: three regions, of which one makes heat. The block's
 * outside is kept at a temperature of 0, and a thermometer sits in the iron.
 *
 * <p>Lengths are in centimetres, heat is in watts per centimetre of thickness.
 */
public final class CoilInIron {
    /** By the number of the material: none, iron, insulation, copper; in W/(cm K). */
    private static final double[] CONDUCTIVITY = {0, 0.5, 0.002, 4};
    private static final double LOSS = 0.5; // W/cm³, in the copper

    public static void main(String[] arguments) {
        TriMesh mesh = MeshGenerator.generate(domain()).mesh();
        for (Region region : mesh.regions()) {
            System.out.printf(Locale.ROOT, "%-10s material %d, %4d elements%n",
                region.name(), region.material(), mesh.elementsIn(region.name()).length);
        }
        double[] temperature = temperature(mesh);
        double hottest = 0;
        for (double t : temperature) hottest = Math.max(hottest, t);
        System.out.printf(Locale.ROOT, "hottest %.2f K, at the thermometer %.2f K above the outside%n",
            hottest, temperature[mesh.nodesOn("thermometer")[0]]);
    }

    /** Outlines one in the other: the smallest one round a place says its region. */
    public static Domain domain() {
        return Domain.builder()
            .region(rectangle(0, 0, 6, 6, 0.25), Region.of("iron").withMaterial(1), "outside")
            .region(rectangle(2, 2, 4, 4, 0.1), Region.of("insulation").withMaterial(2), "slot")
            .region(rectangle(2.2, 2.2, 3.8, 3.8, 0.1), Region.of("copper").withMaterial(3).withMaxSize(0.15), "coil")
            .embedPoint(1, 3, "thermometer")
            .build();
    }

    /** Nodes about a spacing apart; x0, y0, x1, y1 and so on. */
    private static double[] rectangle(double left, double bottom, double right, double top, double spacing) {
        double[] x = {left, right, right, left};
        double[] y = {bottom, bottom, top, top};
        int pieces = (int) Math.round((right - left) / spacing);
        double[] nodes = new double[8 * pieces];
        for (int i = 0; i < 4 * pieces; i++) {
            int side = i / pieces;
            double part = (double) (i % pieces) / pieces;
            nodes[2 * i] = x[side] + part * (x[(side + 1) % 4] - x[side]);
            nodes[2 * i + 1] = y[side] + part * (y[(side + 1) % 4] - y[side]);
        }
        return nodes;
    }

    /** Temperature at each node. */
    public static double[] temperature(TriMesh mesh) {
        SparsityPattern pattern = SparsityPattern.of(mesh);
        double[] matrix = new double[pattern.entryCount()];
        double[] load = new double[mesh.nodeCount()];
        addConduction(mesh, pattern, matrix);
        for (int e : mesh.elementsIn("copper")) {
            for (int i = 0; i < 3; i++) load[mesh.nodeOf(e, i)] += LOSS * mesh.area(e) / 3;
        }
        for (int node : mesh.nodesOn("outside")) {
            for (int entry = pattern.rowStart(node); entry < pattern.rowStart(node + 1); entry++) {
                matrix[entry] = 0;
                matrix[pattern.entryOf(pattern.column(entry), node)] = 0;
            }
            matrix[pattern.entryOf(node, node)] = 1;
            load[node] = 0;
        }
        LinearSolverSparse<DMatrixSparseCSC, DMatrixRMaj> solver = LinearSolverFactory_DSCC.cholesky(FillReducing.NONE);
        if (!solver.setA(EjmlMatrices.matrix(pattern, matrix))) throw new IllegalStateException("the matrix is singular");
        DMatrixRMaj solution = new DMatrixRMaj(mesh.nodeCount(), 1);
        solver.solve(DMatrixRMaj.wrap(mesh.nodeCount(), 1, load), solution);
        return solution.data;
    }

    private static void addConduction(TriMesh mesh, SparsityPattern pattern, double[] matrix) {
        LinearElements elements = LinearElements.of(mesh);
        int[] entries = pattern.elementEntries();
        for (int e = 0; e < mesh.elementCount(); e++) {
            double weight = CONDUCTIVITY[mesh.regions().get(mesh.regionOf(e)).material()] * elements.area(e);
            for (int i = 0; i < 3; i++) {
                for (int j = 0; j < 3; j++) {
                    matrix[entries[9 * e + 3 * i + j]] += weight * (elements.gradientX(e, i) * elements.gradientX(e, j)
                        + elements.gradientY(e, i) * elements.gradientY(e, j));
                }
            }
        }
    }

    /** Heat that flows out over an interface or the boundary, from the elements on the side of a region. */
    public static double heatOut(TriMesh mesh, double[] temperature, String tag, String region) {
        LinearElements elements = LinearElements.of(mesh);
        double heat = 0;
        for (int e : mesh.elementsIn(region)) {
            for (int k = 0; k < 3; k++) {
                int a = mesh.nodeOf(e, k);
                int b = mesh.nodeOf(e, (k + 1) % 3);
                if (!isOn(mesh, tag, a, b)) continue;
                double gx = 0;
                double gy = 0;
                for (int i = 0; i < 3; i++) {
                    gx += temperature[mesh.nodeOf(e, i)] * elements.gradientX(e, i);
                    gy += temperature[mesh.nodeOf(e, i)] * elements.gradientY(e, i);
                }
                double conductivity = CONDUCTIVITY[mesh.regions().get(mesh.regionOf(e)).material()];
                heat -= conductivity * (gx * (mesh.y(b) - mesh.y(a)) - gy * (mesh.x(b) - mesh.x(a)));
            }
        }
        return heat;
    }

    private static boolean isOn(TriMesh mesh, String tag, int a, int b) {
        for (int edge : mesh.edgesOn(tag)) {
            if (mesh.edgeStart(edge) == a && mesh.edgeEnd(edge) == b) return true;
            if (mesh.edgeStart(edge) == b && mesh.edgeEnd(edge) == a) return true;
        }
        return false;
    }

    private CoilInIron() {
    }
}
