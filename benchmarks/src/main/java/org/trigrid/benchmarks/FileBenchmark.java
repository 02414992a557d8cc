package org.trigrid.benchmarks;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.trigrid.MeshGenerator;
import org.trigrid.io.MeshFormat;
import org.trigrid.io.MeshFormats;
import org.trigrid.io.MshReader;
import org.trigrid.mesh.TriMesh;

/** Mesh files of Gmsh's four kinds, written to nowhere and read from memory: the disk is not measured. */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class FileBenchmark {
    /** A mesh and its file. */
    @State(Scope.Benchmark)
    public static class FileState {
        @Param({"msh22", "msh41", "msh22-binary", "msh41-binary"})
        public String format;

        private MeshFormat chosen;
        private TriMesh mesh;
        private byte[] file;

        @Setup(Level.Trial)
        public void createFile(DomainState given) throws IOException {
            chosen = MeshFormats.named(format);
            mesh = MeshGenerator.generate(given.domain).mesh();
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            MeshFormats.write(mesh, out, chosen);
            file = out.toByteArray();
        }
    }

    /** Megabytes a second, of 1,000,000 bytes. */
    @AuxCounters(AuxCounters.Type.OPERATIONS)
    @State(Scope.Thread)
    public static class Volume {
        public double megabytes;
    }

    @Benchmark
    public void write(FileState state, Volume volume) throws IOException {
        MeshFormats.write(state.mesh, OutputStream.nullOutputStream(), state.chosen);
        volume.megabytes += state.file.length / 1e6;
    }

    @Benchmark
    public TriMesh read(FileState state, Volume volume) {
        volume.megabytes += state.file.length / 1e6;
        return MshReader.Companion.read(state.file, "benchmark.msh").corners();
    }
}
