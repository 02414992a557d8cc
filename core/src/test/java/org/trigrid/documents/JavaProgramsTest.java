package org.trigrid.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.trigrid.MeshGenerator;
import org.trigrid.MeshOptions;
import org.trigrid.domain.Domain;
import org.trigrid.domain.Path;
import org.trigrid.domain.Region;
import org.trigrid.geometry.Point2;
import org.trigrid.mesh.MeshCheck;
import org.trigrid.mesh.TriMesh;
import org.trigrid.shape.Circle;
import org.trigrid.shape.Curve;
import org.trigrid.shape.Direction;
import org.trigrid.shape.Line;
import org.trigrid.shape.Lines;
import org.trigrid.shape.Rectangle;

/** The Java programs of the documents, run; {@code DocumentProgramsTest} holds the two together. */
class JavaProgramsTest {
    @Test
    void theDomainOfTheQuickStart() {
        // docs/quick-start.md
        Path plate = Path.of(
                new Rectangle(0, 0, 10, 4, 0.4).withName("edge"),
                new Circle(3, 2, 1, 0.15).withName("hole"),
                Lines.of(0.2, 6, 1, 8, 1, 8, 3, 6, 1).withName("slot"));
        MeshOptions options = MeshOptions.builder().maxSize(0.5).build();
        TriMesh mesh = MeshGenerator.generate(plate.toDomain(), options).mesh();
        // end
        assertTrue(MeshCheck.check(mesh, plate.toDomain()).isEmpty());
        assertEquals(List.of("edge", "hole", "slot"), mesh.tags());
    }

    @Test
    void thePathOfShapes() {
        // docs/shapes.md
        Path path = Path.of(
                Lines.of(0.5, 0, 0, 6, 0, 6, 4).withName("wall"),
                Curve.of(0.5, 6, 4, 3, 5, 0, 4, 0, 0).withName("roof"))
            .appendOpening(new Line(0, 0, 1, 1, 0.5),
                new Circle(new Point2(1, 1), new Point2(2, 1), 0.3).withDirection(Direction.CLOCKWISE));
        Domain domain = path.toDomain();
        // end
        assertEquals(2, domain.loopCount());
        assertTrue(MeshCheck.check(MeshGenerator.generate(domain).mesh(), domain).isEmpty());
    }

    @Test
    void theDomainOfTwoRegions() {
        double[] plate = {0, 0, 60, 0, 60, 60, 0, 60};
        double[] slot = {20, 30, 40, 30, 40, 50, 20, 50};
        double[] bore = {5, 5, 15, 5, 15, 15, 5, 15};
        int element = 0;
        // docs/regions.md
        Domain domain = Domain.builder()
            .outer(plate, "rim").hole(slot, "slot").hole(bore, "bore")
            .regionName("iron")
            .region(30, 40, Region.of("copper").withMaterial(2).withMaxSize(0.5))   // in the slot, which it fills
            .build();
        TriMesh mesh = MeshGenerator.generate(domain).mesh();
        int[] copper = mesh.elementsIn("copper");
        int[] between = mesh.nodesOn("slot");
        int region = mesh.regionOf(element);              // index into mesh.regions()
        // end
        assertTrue(MeshCheck.check(mesh, domain).isEmpty());
        assertEquals(4, between.length);
        assertTrue(copper.length > 0 && region < mesh.regions().size());
        assertEquals(2, domain.loopCount());
    }
}
