package org.trigrid.samples;

import java.util.Locale;
import org.ejml.data.DMatrixRMaj;
import org.ejml.data.DMatrixSparseCSC;
import org.ejml.interfaces.linsol.LinearSolverSparse;
import org.ejml.sparse.FillReducing;
import org.ejml.sparse.csc.factory.LinearSolverFactory_DSCC;
import org.trigrid.MeshGenerator;
import org.trigrid.domain.Path;
import org.trigrid.fem.LinearElements;
import org.trigrid.fem.PointLocator;
import org.trigrid.fem.SparsityPattern;
import org.trigrid.geometry.Point2;
import org.trigrid.interop.EjmlMatrices;
import org.trigrid.mesh.TriMesh;
import org.trigrid.shape.Arc;
import org.trigrid.shape.Distribution;
import org.trigrid.shape.Line;

/**
 * Plane stress of a strip with a round hole, a tenth as wide as the strip, pulled at both ends by a stress of 1. Where the
 * hole's rim is parallel to the pull, the stress is about three times as high: 3 in an infinite plate (Kirsch 1898), 3.03 in
 * a strip this wide (Howland 1930).
 *
 * <p>By symmetry a quarter is enough; along its cut edges no node leaves the cut.
 */
public final class PlateWithHole {
    private static final double HOLE_RADIUS = 1;
    private static final double HALF_WIDTH = 10;
    private static final double HALF_LENGTH = 20;
    private static final double POISSON_RATIO = 0.3;

    public static void main(String[] arguments) {
        System.out.println("spacing   nodes  stress");
        for (double spacing : new double[] {0.08, 0.04, 0.02, 0.01}) {
            TriMesh mesh = mesh(spacing);
            double stress = stressAtTop(mesh, displacements(mesh));
            // The stress is that of the middle of an element, which comes nearer to the rim as the elements shrink.
            System.out.printf(Locale.ROOT, "%7.3f %7d %7.3f%n", spacing, mesh.nodeCount(), stress);
        }
    }

    /** The quarter to the upper right, with elements of the given size at the hole and ten times as large far off. */
    public static TriMesh mesh(double spacing) {
        double fine = HOLE_RADIUS * spacing;
        double coarse = 10 * fine;
        // Intervals grow from 1 to 10, at a constant rate: their mean is 9 / ln 10.
        double mean = 9 / Math.log(10) * fine;
        Path outline = Path.of(
            graded(new Line(HOLE_RADIUS, 0, HALF_LENGTH, 0, mean)).withName("bottom"),
            new Line(HALF_LENGTH, 0, HALF_LENGTH, HALF_WIDTH, coarse).withName("right"),
            new Line(HALF_LENGTH, HALF_WIDTH, 0, HALF_WIDTH, coarse).withName("top"),
            graded(new Line(0, HOLE_RADIUS, 0, HALF_WIDTH, mean)).reversed().withName("left"),
            new Arc(new Point2(0, HOLE_RADIUS), new Point2(HOLE_RADIUS, 0), -90, fine).withName("hole"));
        return MeshGenerator.generate(outline.toDomain()).mesh();
    }

    private static Line graded(Line line) {
        return line.withDistribution(Distribution.GEOMETRIC).withRatio(10);
    }

    /** Displacements by x and y at node 0, then node 1 and so on, for a modulus of elasticity of 1. */
    public static double[] displacements(TriMesh mesh) {
        SparsityPattern pattern = SparsityPattern.of(mesh, 2);
        double[] matrix = new double[pattern.entryCount()];
        int[] entries = pattern.elementEntries();     // 36 an element: where its 6 x 6 matrix goes
        double[] load = new double[pattern.rowCount()];

        LinearElements elements = LinearElements.of(mesh);
        double factor = 1 / (1 - POISSON_RATIO * POISSON_RATIO);
        double shear = (1 - POISSON_RATIO) / 2;
        for (int e = 0; e < mesh.elementCount(); e++) {
            double weight = factor * elements.area(e);
            for (int i = 0; i < 3; i++) {
                for (int j = 0; j < 3; j++) {
                    double xx = elements.gradientX(e, i) * elements.gradientX(e, j);
                    double xy = elements.gradientX(e, i) * elements.gradientY(e, j);
                    double yx = elements.gradientY(e, i) * elements.gradientX(e, j);
                    double yy = elements.gradientY(e, i) * elements.gradientY(e, j);
                    int at = 36 * e + 12 * i + 2 * j;
                    matrix[entries[at]] += weight * (xx + shear * yy);
                    matrix[entries[at + 1]] += weight * (POISSON_RATIO * xy + shear * yx);
                    matrix[entries[at + 6]] += weight * (POISSON_RATIO * yx + shear * xy);
                    matrix[entries[at + 7]] += weight * (yy + shear * xx);
                }
            }
        }
        for (int edge : mesh.edgesOn("right")) {
            int a = mesh.edgeStart(edge);
            int b = mesh.edgeEnd(edge);
            double half = Math.abs(mesh.y(b) - mesh.y(a)) / 2;
            load[2 * a] += half;
            load[2 * b] += half;
        }
        for (int node : mesh.nodesOn("left")) hold(pattern, matrix, load, 2 * node);
        for (int node : mesh.nodesOn("bottom")) hold(pattern, matrix, load, 2 * node + 1);

        LinearSolverSparse<DMatrixSparseCSC, DMatrixRMaj> solver = LinearSolverFactory_DSCC.cholesky(FillReducing.NONE);
        if (!solver.setA(EjmlMatrices.matrix(pattern, matrix))) throw new IllegalStateException("the plate is not held");
        DMatrixRMaj u = new DMatrixRMaj(load.length, 1);
        solver.solve(DMatrixRMaj.wrap(load.length, 1, load), u);
        return u.data;
    }

    /** Holds an unknown at 0. */
    private static void hold(SparsityPattern pattern, double[] matrix, double[] load, int row) {
        for (int k = pattern.rowStart(row); k < pattern.rowStart(row + 1); k++) {
            matrix[k] = 0;
            matrix[pattern.entryOf(pattern.column(k), row)] = 0;
        }
        matrix[pattern.entryOf(row, row)] = 1;
        load[row] = 0;
    }

    /** The stress along x in the element at the top of the hole. */
    public static double stressAtTop(TriMesh mesh, double[] u) {
        LinearElements elements = LinearElements.of(mesh);
        int e = PointLocator.of(mesh).nearest(0, HOLE_RADIUS).element();
        double strainX = 0;
        double strainY = 0;
        for (int corner = 0; corner < 3; corner++) {
            int node = mesh.nodeOf(e, corner);
            strainX += u[2 * node] * elements.gradientX(e, corner);
            strainY += u[2 * node + 1] * elements.gradientY(e, corner);
        }
        return (strainX + POISSON_RATIO * strainY) / (1 - POISSON_RATIO * POISSON_RATIO);
    }
}
