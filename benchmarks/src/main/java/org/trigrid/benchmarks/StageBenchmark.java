package org.trigrid.benchmarks;

import java.util.List;
import java.util.concurrent.TimeUnit;
import kotlin.Unit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.trigrid.MeshGenerator;
import org.trigrid.MeshOptions;
import org.trigrid.MeshResult;
import org.trigrid.diagnostics.Fault;
import org.trigrid.diagnostics.ProgressMonitor;
import org.trigrid.domain.DomainCheck;
import org.trigrid.front.FrontMesher;
import org.trigrid.front.FrontResult;
import org.trigrid.improve.MeshImprovement;
import org.trigrid.mesh.MutableMesh;
import org.trigrid.mesh.TriMesh;
import org.trigrid.numbering.Numbering;
import org.trigrid.numbering.NumberingMethod;
import org.trigrid.spacing.ConstrainedDelaunay;
import org.trigrid.spacing.SizeField;
import org.trigrid.spacing.SizeFields;
import org.trigrid.spacing.SizeRules;

/** Each stage of the mesher by itself, on what the stage before hands it, and the whole. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 5, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class StageBenchmark {
    private static final MeshOptions OPTIONS = MeshOptions.DEFAULT;
    private static final SizeRules RULES = new SizeRules(
        OPTIONS.sizes(), OPTIONS.gradation(), OPTIONS.minSize(), OPTIONS.maxSize(), OPTIONS.sizeFunction());

    /** What the stages between the sizes and the mesh start from. */
    @State(Scope.Benchmark)
    public static class StageState {
        private ConstrainedDelaunay triangulation;
        private TriMesh mesh;
        private SizeField sizes;

        @Setup(Level.Trial)
        public void createMesh(DomainState given) {
            triangulation = ConstrainedDelaunay.of(given.domain);
            sizes = SizeFields.create(given.domain, RULES, triangulation);
            MeshOptions unnumbered = OPTIONS.toBuilder().numbering(NumberingMethod.NONE).build();
            mesh = MeshGenerator.generate(given.domain, unnumbered).mesh();
        }
    }

    /** A raw mesh for each call of the improvement, which changes it. */
    @State(Scope.Benchmark)
    public static class RawMeshState {
        private MutableMesh raw;

        @Setup(Level.Invocation)
        public void createRawMesh(DomainState given, StageState state) {
            raw = front(given, state).getMesh();
        }
    }

    @Benchmark
    public List<Fault> validation(DomainState given) {
        return DomainCheck.check(given.domain);
    }

    @Benchmark
    public double sizes(DomainState given) {
        ConstrainedDelaunay triangulation = ConstrainedDelaunay.of(given.domain);
        SizeField sizes = SizeFields.create(given.domain, RULES, triangulation);
        return SizeFields.estimateElements(triangulation, sizes);
    }

    @Benchmark
    public FrontResult advanceFront(DomainState given, StageState state) {
        return front(given, state);
    }

    @Benchmark
    public MutableMesh improvement(RawMeshState state) {
        MeshImprovement.improve(state.raw, OPTIONS.strategy(), OPTIONS.smoothingTolerance(), progress -> Unit.INSTANCE);
        return state.raw;
    }

    @Benchmark
    public TriMesh renumbering(DomainState given, StageState state) {
        return Numbering.renumber(state.mesh, OPTIONS.numbering());
    }

    @Benchmark
    public MeshResult whole(DomainState given) {
        return MeshGenerator.generate(given.domain, OPTIONS);
    }

    private static FrontResult front(DomainState given, StageState state) {
        double expected = SizeFields.estimateElements(state.triangulation, state.sizes);
        return FrontMesher.INSTANCE.mesh(given.domain, state.sizes, OPTIONS.strategy(), expected, ProgressMonitor.NONE);
    }
}
