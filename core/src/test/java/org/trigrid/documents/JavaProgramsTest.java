package org.trigrid.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.trigrid.MeshGenerator;
import org.trigrid.MeshOptions;
import org.trigrid.domain.Domain;
import org.trigrid.domain.Path;
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
}
