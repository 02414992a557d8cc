package org.trigrid.benchmarks;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.trigrid.MeshGenerator;
import org.trigrid.MeshOptions;
import org.trigrid.MeshReport;
import org.trigrid.cli.bench.BenchmarkDomains;
import org.trigrid.cli.bench.BenchmarkFamily;
import org.trigrid.diagnostics.ProgressMonitor;
import org.trigrid.diagnostics.Stage;
import org.trigrid.domain.Domain;
import org.trigrid.spacing.Sizes;

/**
 * Measures how long a run goes on without asking its monitor, and between which places: what it takes to cancel it at the
 * worst moment.
 *
 * <p>Two times are told: the clock's, with all that the machine and the garbage collector do meanwhile, and the
 * thread's own processor time, which is what the program can be blamed for.
 */
public final class CancelGaps {
    /** Gaps of the thread's own time above this are told with the places that they lie between, in nanoseconds. */
    private static final long LONG = 15_000_000L;
    private static final int MOST_TOLD = 12;

    private CancelGaps() {
    }

    /** {@code CancelGaps FAMILY|RING COUNT [RUNS]}: COUNT elements of a family, or a wavy ring of COUNT boundary nodes. */
    public static void main(String[] args) {
        boolean isRing = args[0].equals("RING");
        double count = Double.parseDouble(args[1]);
        Domain domain = isRing ? ring((int) count) : BenchmarkDomains.create(BenchmarkFamily.valueOf(args[0]), count);
        MeshOptions.Builder options = MeshOptions.builder();
        if (isRing) {
            options.sizes(Sizes.GRADE).gradation(1.0);
        }
        for (int run = args.length > 2 ? Integer.parseInt(args[2]) : 1; run > 0; run--) {
            Meter meter = new Meter();
            MeshReport report = MeshGenerator.generate(domain, options.build(), meter).report();
            System.out.printf(Locale.ROOT, "%s %s: %d boundary nodes, %d elements, %.1f s; progress fell: %s%n",
                args[0], args[1], report.boundaryNodeCount(), report.elementCount(), report.totalSeconds(), meter.hasFallen);
            meter.print();
        }
    }

    /** A wavy ring of {@code n} nodes. */
    private static Domain ring(int n) {
        double[] xy = new double[2 * n];
        for (int i = 0; i < n; i++) {
            double angle = 2 * Math.PI * i / n;
            double radius = 1 + 0.3 * StrictMath.sin(9 * angle) + 0.01 * StrictMath.sin(1001 * angle);
            xy[2 * i] = radius * StrictMath.cos(angle);
            xy[2 * i + 1] = radius * StrictMath.sin(angle);
        }
        return Domain.of(xy);
    }

    private static final class Meter implements ProgressMonitor {
        private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        private final long[] longest = new long[Stage.values().length];
        private final long[] longestOwn = new long[longest.length];
        private final int[] calls = new int[longest.length];
        private final List<String> told = new ArrayList<>();
        private String place = "the start";
        private double before;
        private boolean hasFallen;
        private long at = System.nanoTime();
        private long ownAt = threads.getCurrentThreadCpuTime();

        @Override
        public boolean update(Stage stage, double fraction) {
            long gap = System.nanoTime() - at;
            long own = threads.getCurrentThreadCpuTime() - ownAt;
            int i = stage.ordinal();
            calls[i]++;
            longest[i] = Math.max(longest[i], gap);
            longestOwn[i] = Math.max(longestOwn[i], own);
            hasFallen = hasFallen || fraction < before;
            before = fraction;
            String here = here();
            if (own > LONG) {
                told.add(String.format(Locale.ROOT, "    %3d ms (%d by the clock) from %s%n        to %s", own / 1_000_000, gap / 1_000_000, place, here));
            }
            place = here;
            at = System.nanoTime();
            ownAt = threads.getCurrentThreadCpuTime();
            return true;
        }

        private static String here() {
            return StackWalker.getInstance().walk(frames -> frames
                .filter(f -> !f.getClassName().matches(".*(CancelGaps|StageClock|Checkpoint|ImproveProgress|FrontTicker|MeshGenerator).*"))
                .limit(3).map(f -> f.getClassName().replaceAll(".*\\.", "") + "." + f.getMethodName() + ":" + f.getLineNumber())
                .collect(Collectors.joining(" < ")));
        }

        void print() {
            for (Stage stage : Stage.values()) {
                int i = stage.ordinal();
                System.out.printf(Locale.ROOT, "  %-9s asked %5d times, longest gap %3d ms by the clock, %3d ms of the thread's own%n",
                    stage, calls[i], longest[i] / 1_000_000, longestOwn[i] / 1_000_000);
            }
            told.stream().limit(MOST_TOLD).forEach(System.out::println);
        }
    }
}
