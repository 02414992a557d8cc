package org.trigrid.reliability

import org.trigrid.MeshGenerator
import org.trigrid.RandomDomains
import org.trigrid.mesh.MeshCheck

internal object Dbg {
    @JvmStatic
    fun main(args: Array<String>) {
        val family = RandomDomains.families.first { it.name == args[0] }
        val seed = args[1].toLong()
        val o = FuzzRun.options(seed)
        println("${o.strategy} ${o.sizes} g=${o.gradation} improve=${o.improve}")
        val d = family.make(seed)
        println("nodes ${d.nodeCount} loops ${d.loopCount}")
        if (args.size > 2) {
            repeat(args[2].toInt()) { MeshGenerator.generate(d, o).report.let { r -> println(org.trigrid.diagnostics.Stage.entries.map { s -> "$s " + r.seconds(s) }) } }
            return
        }
        for (improve in listOf(false, true)) for (num in listOf(org.trigrid.numbering.NumberingMethod.NONE, org.trigrid.numbering.NumberingMethod.BEST)) {
            try {
                val r = MeshGenerator.generate(d, o.toBuilder().improve(improve && o.improve).numbering(num).build())
                println("improve $improve $num: expected ${r.report.expectedElements} elements ${r.report.elementCount} fallbacks ${r.report.fallbacks} minAngle ${r.report.quality.minAngle}")
                if (!improve) density(d, r.mesh, o)
                MeshCheck.check(r.mesh, d).take(3).forEach { println(it) }
            } catch (e: Throwable) { e.printStackTrace(System.out) }
        }
    }

    fun crowd(d: org.trigrid.domain.Domain, m: org.trigrid.mesh.TriMesh) {
        val xs = (0 until d.nodeCount).map { d.x(it) }
        val ys = (0 until d.nodeCount).map { d.y(it) }
        var x0 = xs.min(); var x1 = xs.max(); var y0 = ys.min(); var y1 = ys.max()
        repeat(6) {
            val counts = IntArray(64)
            for (t in 0 until m.elementCount) {
                val cx = (0..2).sumOf { k -> m.x(m.nodeOf(t, k)) } / 3
                val cy = (0..2).sumOf { k -> m.y(m.nodeOf(t, k)) } / 3
                if (cx < x0 || cx > x1 || cy < y0 || cy > y1) continue
                val i = Math.min(7, ((cx - x0) / (x1 - x0) * 8).toInt())
                val j = Math.min(7, ((cy - y0) / (y1 - y0) * 8).toInt())
                counts[8 * j + i]++
            }
            val b = counts.indices.maxBy { counts[it] }
            val w = (x1 - x0) / 8; val h = (y1 - y0) / 8
            x0 += b % 8 * w; y0 += b / 8 * h; x1 = x0 + w; y1 = y0 + h
            println("  crowd ${counts[b]} of ${counts.sum()} in [$x0,$x1]x[$y0,$y1]")
        }
        val near = (0 until d.nodeCount).filter { d.x(it) in x0 - 2*(x1-x0)..x1 + 2*(x1-x0) && d.y(it) in y0 - 2*(y1-y0)..y1 + 2*(y1-y0)}
        println("  boundary nodes near: " + near.map { Triple(it, d.x(it), d.y(it)) })
        val all = (0 until m.elementCount).filter { t -> val cx = (0..2).sumOf { k -> m.x(m.nodeOf(t, k)) } / 3; val cy = (0..2).sumOf { k -> m.y(m.nodeOf(t, k)) } / 3; cx in x0..x1 && cy in y0..y1 }.take(5)
        for (t in all) println("  el " + (0..2).map { k -> "" + m.x(m.nodeOf(t, k)) + " " + m.y(m.nodeOf(t, k)) })
    }

    fun density(d: org.trigrid.domain.Domain, m: org.trigrid.mesh.TriMesh, o: org.trigrid.MeshOptions) {
        val cdt = org.trigrid.spacing.ConstrainedDelaunay.of(d)
        val f = org.trigrid.spacing.SizeFields.create(d, o, cdt)
        var lost = 0
        fun locate(x: Double, y: Double): Int {
            for (t in 0 until cdt.triangleCount) {
                var ok = true
                for (k in 0..2) {
                    val a = cdt.nodes[3 * t + k]; val b = cdt.nodes[3 * t + (k + 1) % 3]
                    if (org.trigrid.geometry.Predicates.orient(cdt.xy[2*a], cdt.xy[2*a+1], cdt.xy[2*b], cdt.xy[2*b+1], x, y) < 0) ok = false
                }
                if (ok) return t
            }
            lost++
            return 0
        }
        var sum = 0.0
        var hist = IntArray(20)
        for (t in 0 until m.elementCount) {
            val cx = (0..2).sumOf { k -> m.x(m.nodeOf(t, k)) } / 3
            val cy = (0..2).sumOf { k -> m.y(m.nodeOf(t, k)) } / 3
            val h = f.sizeAt(cx, cy, locate(cx, cy))
            val e = 2.309401 * m.area(t) / h / h
            sum += e
            hist[(10 + Math.round(StrictMath.log(e) / StrictMath.log(2.0)).toInt()).coerceIn(0, 19)]++
        }
        println("  density over mesh $sum; log2 of area against wanted, -10..: ${hist.toList()} lost $lost")
    }
}
