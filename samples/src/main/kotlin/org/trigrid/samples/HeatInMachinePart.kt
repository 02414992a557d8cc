package org.trigrid.samples

import org.ejml.data.DMatrixRMaj
import org.ejml.sparse.FillReducing
import org.ejml.sparse.csc.factory.LinearSolverFactory_DSCC
import org.trigrid.MeshGenerator
import org.trigrid.MeshRework
import org.trigrid.fem.LinearElements
import org.trigrid.fem.NodeInterpolation
import org.trigrid.fem.SparsityPattern
import org.trigrid.interop.EjmlMatrices
import org.trigrid.mesh.TriMesh
import org.trigrid.numbering.Numbering
import org.trigrid.numbering.NumberingMethod
import org.trigrid.project.ProjectFile
import org.trigrid.project.ShapeMiddles
import java.nio.file.Path
import java.util.Locale

/**
 * Steady heat in the machine part: hot oil in the slot, cooling by the air along the outline, the hexagonal opening insulated.
 * Lengths are in centimetres, heat is in watts per centimetre of thickness.
 */
object HeatInMachinePart {
    private const val CONDUCTIVITY = 0.5 // W/(cm K), steel
    private const val FILM = 0.02 // W/(cm² K), air blown past
    private const val OIL = 90.0 // °C
    private const val AIR = 20.0 // °C

    /** Temperature at each node, heat that enters by the slot, and heat that the air takes away. */
    class Heat(val temperature: DoubleArray, val entering: Double, val leaving: Double)

    @JvmStatic
    fun main(arguments: Array<String>) {
        val file = Path.of(arguments.firstOrNull() ?: "src-test-data/paper/machine-part.trigrid.json")
        val project = ProjectFile.read(file)
        var mesh = MeshGenerator.generate(project.toDomain(), project.options).mesh
        println("   nodes  heat in, W/cm  heat out, W/cm  coldest, °C  at the spike's root, °C")
        for (level in 0..2) {
            // New nodes on the boundary lie on the true curves of the slot.
            if (level > 0) mesh = Numbering.renumber(MeshRework.refine(mesh, ShapeMiddles(project.path)), NumberingMethod.BEST)
            val heat = solve(mesh)
            val root = NodeInterpolation.of(mesh).valueAt(heat.temperature, 3.05, 4.5)
            println(
                "%8d  %13.4f  %14.4f  %11.3f  %23.3f".format(
                    Locale.ROOT, mesh.nodeCount, heat.entering, heat.leaving, heat.temperature.min(), root,
                ),
            )
        }
    }

    fun solve(mesh: TriMesh): Heat {
        val pattern = SparsityPattern.of(mesh)
        val matrix = DoubleArray(pattern.entryCount)
        val load = DoubleArray(mesh.nodeCount)
        addConduction(mesh, pattern, matrix)
        addFilm(mesh, pattern, matrix, load)

        val fixedMatrix = matrix.copyOf()
        val right = load.copyOf()
        val slot = mesh.nodesOn("slot")
        for (node in slot) fix(pattern, fixedMatrix, right, node)
        val solver = LinearSolverFactory_DSCC.cholesky(FillReducing.NONE)
        check(solver.setA(EjmlMatrices.matrix(pattern, fixedMatrix))) { "the matrix is singular" }
        val solution = DMatrixRMaj(mesh.nodeCount, 1)
        solver.solve(DMatrixRMaj.wrap(mesh.nodeCount, 1, right), solution)
        val temperature = solution.data

        // What the equations of the slot's nodes lack, as they were before their temperature was fixed, is the heat from the oil.
        val entering = slot.sumOf { row ->
            (pattern.rowStart(row) until pattern.rowStart(row + 1)).sumOf { matrix[it] * temperature[pattern.column(it)] } - load[row]
        }
        val leaving = mesh.edgesOn("outline").sumOf { edge ->
            FILM * length(mesh, edge) * ((temperature[mesh.edgeStart(edge)] + temperature[mesh.edgeEnd(edge)]) / 2 - AIR)
        }
        return Heat(temperature, entering, leaving)
    }

    private fun addConduction(mesh: TriMesh, pattern: SparsityPattern, matrix: DoubleArray) {
        val elements = LinearElements.of(mesh)
        val entries = pattern.elementEntries() // nine an element: where its 3 x 3 matrix goes
        for (e in 0 until mesh.elementCount) for (i in 0..2) for (j in 0..2) {
            val dot = elements.gradientX(e, i) * elements.gradientX(e, j) + elements.gradientY(e, i) * elements.gradientY(e, j)
            matrix[entries[9 * e + 3 * i + j]] += CONDUCTIVITY * elements.area(e) * dot
        }
    }

    /** The air takes FILM * (temperature - AIR) from each centimetre of the outline. */
    private fun addFilm(mesh: TriMesh, pattern: SparsityPattern, matrix: DoubleArray, load: DoubleArray) {
        for (edge in mesh.edgesOn("outline")) {
            val ends = intArrayOf(mesh.edgeStart(edge), mesh.edgeEnd(edge))
            val taken = FILM * length(mesh, edge)
            for (a in ends) {
                load[a] += taken * AIR / 2
                for (b in ends) matrix[pattern.entryOf(a, b)] += if (a == b) taken / 3 else taken / 6
            }
        }
    }

    /** Puts the oil's temperature in place of a row's equation, and its part in the others on the right. */
    private fun fix(pattern: SparsityPattern, matrix: DoubleArray, right: DoubleArray, row: Int) {
        for (entry in pattern.rowStart(row) until pattern.rowStart(row + 1)) {
            val mirrored = pattern.entryOf(pattern.column(entry), row)
            right[pattern.column(entry)] -= matrix[mirrored] * OIL
            matrix[entry] = 0.0
            matrix[mirrored] = 0.0
        }
        matrix[pattern.entryOf(row, row)] = 1.0
        right[row] = OIL
    }

    private fun length(mesh: TriMesh, edge: Int): Double {
        val a = mesh.edgeStart(edge)
        val b = mesh.edgeEnd(edge)
        return Math.hypot(mesh.x(b) - mesh.x(a), mesh.y(b) - mesh.y(a))
    }
}
