package org.trigrid.front;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.trigrid.MeshGenerator;
import org.trigrid.MeshOptions;
import org.trigrid.diagnostics.ProgressMonitor;
import org.trigrid.domain.Domain;
import org.trigrid.domain.Path;
import org.trigrid.geometry.Point2;
import org.trigrid.project.Background;
import org.trigrid.project.Project;
import org.trigrid.shape.Circle;
import org.trigrid.shape.Rectangle;

/** The front's listener, openings and what a project keeps beside, as Java sees them. */
class FrontJavaTest {
    @Test
    void theFrontIsHeardAndTraced() {
        Domain domain = Path.of(new Rectangle(0, 0, 4, 3, 0.5)).toDomain();
        int[] heard = {0};
        MeshGenerator.generate(domain, MeshOptions.DEFAULT, ProgressMonitor.NONE, (a, b, c, x, y) -> heard[0]++);
        FrontTrace trace = new FrontTrace(domain);
        MeshGenerator.generate(domain, MeshOptions.DEFAULT, ProgressMonitor.NONE, trace);
        assertEquals(heard[0], trace.elementCount());
        assertEquals(2 * domain.segmentCount(), trace.frontAfter(0).length);
        assertEquals(0, trace.frontAfter(trace.elementCount()).length);
    }

    @Test
    void openingsAreConnectedAndColoursKept() {
        Path path = Path.of(new Rectangle(0, 0, 4, 3, 0.5)).newLoop().append(new Circle(2, 1.5, 0.5, 0.3));
        Project project = Project.builder().path(path).colours(Map.of("boundary", "#d55e00"))
            .background(new Background("plan.png", new Point2(0, 0), 0.01, 0, 0.5, true)).build();
        Project joined = project.connectOpening(project.openings()[0], 0.5);
        assertEquals(1, joined.path().walks().size());
        assertEquals(project.toDomain().area(), joined.toDomain().area(), 1e-9);
        assertEquals("#d55e00", joined.colours().get("boundary"));
        assertEquals("plan.png", joined.background().file());
    }
}
