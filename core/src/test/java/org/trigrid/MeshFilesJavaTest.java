package org.trigrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.trigrid.domain.Domain;
import org.trigrid.io.CurveDivision;
import org.trigrid.io.DomainFormat;
import org.trigrid.io.DomainFormats;
import org.trigrid.io.LengthUnit;
import org.trigrid.io.MeshFormat;
import org.trigrid.io.MeshFormats;
import org.trigrid.io.NamedDomain;
import org.trigrid.mesh.TriMesh;

/** Files, as a Java program uses them. */
class MeshFilesJavaTest {
    @TempDir
    Path folder;

    @Test
    void drawingsIn() throws IOException {
        Path drawing = Files.writeString(folder.resolve("disc.svg"), "<svg><circle id='rim' r='2'/></svg>");
        CurveDivision division = CurveDivision.DEFAULT.withSpacing(0.5, 1.0).withUnit(LengthUnit.MILLIMETRE);
        NamedDomain disc = DomainFormats.read(drawing, division).get(0);
        assertEquals("disc", disc.name());
        assertEquals(25, disc.domain().nodeCount());
        DomainFormats.write(List.of(disc), folder.resolve("disc.wkt"), DomainFormat.WKT);
        assertEquals(25, DomainFormats.read(folder.resolve("disc.wkt")).get(0).domain().nodeCount());
    }

    @Test
    void meshesOutAndIn() throws IOException {
        Domain square = Domain.builder().outer(new double[] {0, 0, 1, 0, 1, 1, 0, 1}, "rim").build().respaced(0.25, 1.0);
        TriMesh mesh = MeshRework.refine(MeshGenerator.generate(square).mesh());
        for (MeshFormat format : MeshFormats.all()) {
            Path file = folder.resolve("square" + format.endings().get(0));
            MeshFormats.write(mesh, file, format);
            for (Path part : format.filesOf(file)) assertTrue(Files.size(part) > 0, format.name());
            if (format.canRead()) assertEquals(mesh.elementCount(), MeshFormats.read(file).elementCount(), format.name());
        }
        TriMesh better = MeshRework.improve(mesh, (stage, fraction) -> true);
        assertEquals(1.0, better.outline().area(), 1e-12);
        assertFalse(MeshFormat.NASTRAN.canRead());
    }
}
