package org.trigrid.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.trigrid.domain.Domain;
import org.trigrid.domain.Path;
import org.trigrid.domain.PathWalk;
import org.trigrid.geometry.Point2;
import org.trigrid.project.Project;
import org.trigrid.project.ProjectFile;

/** A Java program that builds a path of all shapes: the contract with Java users. */
class PathJavaTest {
    private static Path path() {
        return Path.of(
                new Line(0, 0, 10, 0, 1).withName("bottom"),
                Lines.of(1, 10, 0, 12, 4, 10, 8).withRatio(2).withDistribution(Distribution.GEOMETRIC),
                Curve.of(0.5, 10, 8, 7, 9, 5, 7, 2, 8.5, 0, 8).withName("top"),
                new Arc(new Point2(0, 8), new Point2(0, 0), 40, 0.5).withRounding(Rounding.CEILING))
            .appendOpening(new Line(0, 0, 1.5, 1.5, 0.7), new Rectangle(1.5, 1.5, 3, 3, 0.5).withDirection(Direction.CLOCKWISE))
            .newLoop()
            .append(new Circle(6, 4, 1, 0.4).withName("bore"))
            .append(new Polygon(new Point2(9, 4), new Point2(9, 3), 6, 0.4))
            .append(new Ellipse(3, 5.5, 1, 0.5, 0.3).withRotationDegrees(30));
    }

    @Test
    void aPathOfAllShapesBoundsADomain() {
        Domain domain = path().toDomain();
        assertEquals(5, domain.loopCount());
        assertTrue(domain.tags().containsAll(List.of("bottom", "top", "bore", "boundary")));
    }

    @Test
    void nodesAreEditedByNumber() {
        Path path = path();
        int node = path.nodesOf(0)[3];
        Path edited = path.moveNode(node, path.x(node), -0.5).deleteNode(node + 1).insertNode(node, node + 1, 4, -0.4);
        assertEquals(path.nodeCount(), edited.nodeCount());
        assertFalse(edited.isLinked(0));
        assertTrue(edited.rebuild(0).isLinked(0));
        for (PathWalk walk : edited.walks()) assertTrue(walk.isClosed());
    }

    @Test
    void shapesExplodeInThreeWays() {
        Line line = new Line(0, 0, 1, 0, 0.25).withRatio(2);
        assertEquals(10, line.explode().length);
        assertEquals(6, line.explode(0.5, 1).length);
        assertEquals(6, Line.explode(new Point2(0, 0), new Point2(1, 0), 0.5, 1).length);
    }

    @Test
    void aProjectGoesToAFileAndBack() {
        Project project = Project.builder().path(path()).regionName("plate").build();
        Project read = ProjectFile.parse(ProjectFile.format(project), "plate.trigrid.json");
        assertEquals("plate", read.regionName());
        assertEquals(project.toDomain().segmentCount(), read.toDomain().segmentCount());
    }
}
