package org.trigrid.benchmarks;

import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.trigrid.cli.bench.BenchmarkDomains;
import org.trigrid.cli.bench.BenchmarkFamily;
import org.trigrid.domain.Domain;

/** The domain of a measurement. */
@State(Scope.Benchmark)
public class DomainState {
    @Param({"SQUARE", "CIRCLE", "ANNULUS", "AIRFOIL", "PLATE", "COAST"})
    public BenchmarkFamily family;

    /** About so many elements; a plate of 200 holes has at least 18,000. */
    @Param({"1e3", "1e4", "1e5", "1e6"})
    public double elements;

    public Domain domain;

    @Setup(Level.Trial)
    public void createDomain() {
        domain = BenchmarkDomains.create(family, elements);
    }
}
