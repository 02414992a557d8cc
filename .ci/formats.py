#!/usr/bin/env python3
"""Has the programs that users have read what `trigrid convert` writes, and TriGrid what they write.

    python formats.py TRIGRID FOLDER

Makes a plate of two by one with named sides in FOLDER, converts its mesh to every format, and compares what each reader
finds with the mesh: Gmsh, meshio, VTK and Triangle; CalculiX solves the plate in tension, of one material and of two, MFEM Laplace's equation on it. Of a disc of six-node elements Gmsh
finds the area, whose error must fall with the fourth power of the spacing. A reader that is not installed is a failure.
Exit status 1 when something fails.
"""
import contextlib
import io
import json
import os
import re
import subprocess
import sys

import numpy as np

PLATE = {
    "format": "trigrid", "version": 1, "region": "steel", "defaults": {"spacing": 0.1},
    "path": [
        {"type": "line", "name": name, "begin": begin, "end": end}
        for name, begin, end in (
            ("bottom", [0, 0], [2, 0]), ("right", [2, 0], [2, 1]), ("top", [2, 1], [0, 1]), ("left", [0, 1], [0, 0]))
    ],
}
TENSION = """*INCLUDE, INPUT=plate.inp
*MATERIAL, NAME=M
*ELASTIC
2., 0.3
*SOLID SECTION, ELSET=steel, MATERIAL=M
1.
*BOUNDARY
left, 1, 1
bottom, 2, 2
*STEP
*STATIC
*DSLOAD
right, P, -1.
*NODE PRINT, NSET=right
U
*END STEP
"""

TWO_MATERIALS = """*INCLUDE, INPUT=joint.inp
*MATERIAL, NAME=S
*ELASTIC
2., 0.
*MATERIAL, NAME=H
*ELASTIC
4., 0.
*SOLID SECTION, ELSET=soft, MATERIAL=S
1.
*SOLID SECTION, ELSET=hard, MATERIAL=H
1.
"""


class Plate:
    def __init__(self, trigrid, folder):
        self.trigrid, self.folder = trigrid, folder
        os.makedirs(folder, exist_ok=True)
        with open(self.path("plate.trigrid.json"), "w", encoding="utf-8") as file:
            json.dump(PLATE, file)
        self.run("mesh", self.path("plate.trigrid.json"), "-o", self.path("plate.json"))
        with open(self.path("plate.json"), encoding="utf-8") as file:
            self.mesh = json.load(file)
        self.run("mesh", self.path("plate.trigrid.json"), "-o", self.path("plate.msh"))
        self.points = np.array(self.mesh["nodes"], float)
        self.triangles = np.array(self.mesh["elements"], int)
        self.sides = {name: {frozenset(edge) for edge in edges} for name, edges in self.mesh["edges"].items()}

    def path(self, name):
        return os.path.join(self.folder, name)

    def run(self, *arguments):
        done = subprocess.run([self.trigrid, *arguments], capture_output=True, text=True)
        if done.returncode != 0:
            raise ValueError(f"trigrid {' '.join(arguments)}: {done.stderr.strip()}")
        return done.stdout

    def convert(self, name, *more):
        self.run("convert", self.path("plate.msh"), self.path(name), *more)
        return self.path(name)

    def require_points(self, points, tolerance=0.0):
        if not np.all(np.abs(np.asarray(points)[:, :2] - self.points) <= tolerance):
            raise ValueError("other nodes")

    def require_triangles(self, triangles):
        if not np.array_equal(np.asarray(triangles, int), self.triangles):
            raise ValueError("other triangles")

    def require_sides(self, sides):
        if {frozenset(s) for s in sides} != {frozenset(s) for s in self.sides.values()}:
            raise ValueError("other groups of edges")

    def require_same(self, name):
        """TriGrid itself reads a file that another program has written, perhaps with its nodes in another order."""
        self.run("convert", self.path(name), self.path("back.json"))
        with open(self.path("back.json"), encoding="utf-8") as file:
            back = json.load(file)
        if triangles_by_place(back["nodes"], back["elements"]) != triangles_by_place(self.points, self.triangles.tolist()):
            raise ValueError(f"TriGrid reads another mesh from {name}")


def triangles_by_place(points, triangles):
    # Gmsh writes 16 digits.
    points = np.round(points, 12).tolist()
    return {frozenset(tuple(points[node]) for node in triangle) for triangle in triangles}


def grouped(lines, tags):
    groups = {}
    for line, tag in zip(np.asarray(lines).tolist(), np.asarray(tags).tolist()):
        groups.setdefault(tag, set()).add(frozenset(line))
    return groups


def by_meshio(path, kind=None):
    import meshio
    with contextlib.redirect_stdout(io.StringIO()) as told, contextlib.redirect_stderr(io.StringIO()):
        try:
            return meshio.read(path, kind)
        except SystemExit:
            raise ValueError(f"meshio: {told.getvalue().strip()}") from None


def check_msh(plate):
    import meshio
    for kind in ("msh22", "msh41", "msh22-binary", "msh41-binary"):
        path = plate.convert(kind + ".msh", "--format", kind)
        mesh = by_meshio(path)
        plate.require_points(mesh.points)
        plate.require_triangles(mesh.cells_dict["triangle"])
        plate.require_sides(grouped(mesh.cells_dict["line"], mesh.cell_data_dict["gmsh:physical"]["line"]).values())
        import gmsh
        gmsh.initialize(["-noenv"], readConfigFiles=False)
        try:
            gmsh.option.setNumber("General.Terminal", 0)
            gmsh.open(path)
            names = {gmsh.model.getPhysicalName(d, t) for d, t in gmsh.model.getPhysicalGroups()}
            if names != set(plate.sides) | {"steel"}:
                raise ValueError(f"{kind}: Gmsh finds the groups {names}")
            tags, xyz, _ = gmsh.model.mesh.getNodes()
            plate.require_points(np.reshape(xyz, (-1, 3))[np.argsort(tags)])
            for version, binary in ((2.2, 0), (2.2, 1), (4.1, 0), (4.1, 1)):
                gmsh.option.setNumber("Mesh.MshFileVersion", version)
                gmsh.option.setNumber("Mesh.Binary", binary)
                gmsh.write(plate.path("gmsh.msh"))
                plate.require_same("gmsh.msh")
        finally:
            gmsh.finalize()


def check_vtu(plate):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter
    path = plate.convert("plate.vtu")
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    plate.require_points(vtk_to_numpy(grid.GetPoints().GetData()))
    tags = vtk_to_numpy(grid.GetCellData().GetArray("tag"))
    cells = [[grid.GetCell(i).GetPointId(k) for k in range(grid.GetCell(i).GetNumberOfPoints())] for i in range(grid.GetNumberOfCells())]
    plate.require_triangles([c for c in cells if len(c) == 3])
    lines = [(c, t) for c, t in zip(cells, tags) if len(c) == 2]
    plate.require_sides(grouped([c for c, _ in lines], [t for _, t in lines]).values())
    names = vtk_to_numpy(grid.GetFieldData().GetArray("tag_names")).astype(np.uint8).tobytes().decode().split("\n")
    if set(names) != set(plate.sides):
        raise ValueError(f"VTK finds the names {names}")
    mesh = by_meshio(path)
    plate.require_points(mesh.points)
    plate.require_triangles(mesh.cells_dict["triangle"])
    for mode in ("SetDataModeToAscii", "SetDataModeToBinary", "SetDataModeToAppended"):
        for compressor in (0, 1):
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetInputData(grid)
            writer.SetFileName(plate.path("vtk.vtu"))
            getattr(writer, mode)()
            (writer.SetCompressorTypeToZLib if compressor else writer.SetCompressorTypeToNone)()
            writer.Write()
            if mode != "SetDataModeToAscii":  # VTK's ASCII has fewer digits
                plate.require_same("vtk.vtu")
            plate.run("info", plate.path("vtk.vtu"))


def check_medit(plate):
    mesh = by_meshio(plate.convert("plate.mesh"))
    plate.require_points(mesh.points)
    plate.require_triangles(mesh.cells_dict["triangle"])
    plate.require_sides(grouped(mesh.cells_dict["line"], mesh.cell_data_dict["medit:ref"]["line"]).values())
    mesh.write(plate.path("meshio.mesh"), float_fmt=".17g")
    plate.require_same("meshio.mesh")


def check_su2(plate):
    mesh = by_meshio(plate.convert("plate.su2"))
    plate.require_points(mesh.points)
    plate.require_triangles(mesh.cells_dict["triangle"])
    plate.require_sides(grouped(mesh.cells_dict["line"], mesh.cell_data_dict["su2:tag"]["line"]).values())


def check_nastran(plate):
    mesh = by_meshio(plate.convert("plate.bdf"))
    plate.require_points(mesh.points, 5e-15)
    plate.require_triangles(mesh.cells_dict["triangle"])


def check_triangle(plate):
    import triangle
    plate.convert("plate.ele")
    read = {}
    for kind in ("node", "ele", "poly"):
        with open(plate.path("plate." + kind), encoding="utf-8") as file:
            text = "\n".join(line for line in file.read().splitlines() if not line.startswith("#"))
        read[kind] = text
    data = triangle.loads(**read) if hasattr(triangle, "loads") else triangle_parts(read)
    plate.require_points(data["vertices"])
    plate.require_triangles(data["triangles"])
    again = triangle.triangulate({k: data[k] for k in ("vertices", "segments")}, "p")
    if len(again["triangles"]) == 0:
        raise ValueError("Triangle makes no mesh of the .poly")


def triangle_parts(read):
    def rows(text, skip=0):
        return [line.split() for line in text.splitlines()[skip:] if line.strip()]
    nodes = rows(read["node"])[1:]
    elements = rows(read["ele"])[1:]
    segments = rows(read["poly"])[2:]
    segments = segments[:int(rows(read["poly"])[1][0])]
    return {
        "vertices": np.array([[float(r[1]), float(r[2])] for r in nodes]),
        "triangles": np.array([[int(v) - 1 for v in r[1:4]] for r in elements]),
        "segments": np.array([[int(v) - 1 for v in r[1:3]] for r in segments]),
    }


def check_abaqus(plate):
    mesh = by_meshio(plate.convert("plate.inp"))
    plate.require_points(mesh.points, 5e-16)
    plate.require_triangles(mesh.cells_dict["triangle"])
    for name, edges in plate.sides.items():
        if set(mesh.point_sets[name].tolist()) != {node for edge in edges for node in edge}:
            raise ValueError(f"meshio finds another node set {name}")
    require_tension(plate, 11)


def require_tension(plate, nodes, materials=TENSION.split("*BOUNDARY")[0], growth=1.0):
    with open(plate.path("tension.inp"), "w", encoding="ascii") as file:
        file.write(materials + "*BOUNDARY" + TENSION.split("*BOUNDARY")[1])
    done = subprocess.run(["ccx", "tension"], cwd=plate.folder, capture_output=True, text=True, timeout=120)
    if "*ERROR" in done.stdout or done.returncode != 0:
        raise ValueError("ccx: " + " ".join(re.findall(r"\*ERROR.*", done.stdout)))
    with open(plate.path("tension.dat"), encoding="ascii") as file:
        moves = [float(line.split()[1]) for line in file if re.match(r"\s*\d+\s+[-\d.]", line)]
    # Stress 1, Young's modulus 2: a length of 2 grows by 1.
    if len(moves) < nodes or max(abs(m - growth) for m in moves) > 1e-5:
        raise ValueError(f"CalculiX moves the right side by {moves}")


def check_regions(plate):
    """The plate of two materials, and a point in each."""
    joint = dict(PLATE, version=2, lines=[{"name": "joint", "nodes": [[1, i / 10] for i in range(11)]}], points=[
        {"name": "probe", "at": [0.52, 0.47]}, {"name": "probe", "at": [1.53, 0.48]}], regions=[
        {"name": "soft", "material": 7, "at": [[0.5, 0.5]]}, {"name": "hard", "material": 3, "at": [[1.5, 0.5]]}])
    with open(plate.path("joint.trigrid.json"), "w", encoding="utf-8") as file:
        json.dump(joint, file)
    counts = {}
    for name in ("joint.msh", "joint.vtu", "joint.mesh", "joint.bdf", "joint.inp", "joint.ele"):
        plate.run("mesh", plate.path("joint.trigrid.json"), "-o", plate.path(name))
        if name == "joint.ele":
            with open(plate.path(name), encoding="ascii") as file:
                found = [line.split()[4] for line in file if len(line.split()) == 5]
            counts[name] = {int(a): found.count(a) for a in set(found)}
            continue
        mesh = by_meshio(plate.path(name))
        if name == "joint.inp":
            counts[name] = {m: sum(len(c) for c in mesh.cell_sets[r]) for r, m in (("soft", 7), ("hard", 3))}
            if len(mesh.point_sets["probe"]) != 2 or len(mesh.point_sets["joint"]) != 11:
                raise ValueError("joint.inp: other node sets")
            continue
        key = {"joint.msh": "gmsh:physical", "joint.vtu": "region", "joint.mesh": "medit:ref", "joint.bdf": "nastran:ref"}[name]
        numbers = np.concatenate([np.ravel(n) for c, n in zip(mesh.cells, mesh.cell_data[key]) if c.type == "triangle"])
        materials = {1: 7, 2: 3} if name == "joint.vtu" else {}
        counts[name] = {materials.get(int(n), int(n)): int(np.sum(numbers == n)) for n in np.unique(numbers)}
        if name == "joint.msh" and not {"soft": [7, 2], "hard": [3, 2]}.items() <= {k: v.tolist() for k, v in mesh.field_data.items()}.items():
            raise ValueError(f"joint.msh: the groups {mesh.field_data}")
    if len({tuple(sorted(c.items())) for c in counts.values()}) != 1 or set(counts["joint.msh"]) != {3, 7}:
        raise ValueError(f"elements of the materials: {counts}")
    require_tension(plate, 11, TWO_MATERIALS, 0.75)


def check_second_order(plate):
    errors = {}
    for spacing in (0.4, 0.2, 0.1):
        with open(plate.path("disc.trigrid.json"), "w", encoding="utf-8") as file:
            json.dump({"format": "trigrid", "version": 1, "path": [
                {"type": "circle", "name": "rim", "firstPoint": [1, 0], "centre": [0, 0], "spacing": spacing}]}, file)
        for kind in ("msh22", "msh41", "msh22-binary", "msh41-binary", "medit"):
            path = plate.path(f"disc.{'mesh' if kind == 'medit' else 'msh'}")
            plate.run("mesh", plate.path("disc.trigrid.json"), "-o", path, "--format", kind, "--order", "2")
            errors.setdefault(kind, []).append(disc_errors(path))
    for kind, found in errors.items():
        for what, values in (("area", [e[0] for e in found]), ("rim", [e[1] for e in found])):
            if not (values[0] > 12 * values[1] > 144 * values[2]):
                raise ValueError(f"{kind}: Gmsh finds errors of the {what} {values}")
    for name in ("disc.vtu", "disc.msh"):
        plate.run("mesh", plate.path("disc.trigrid.json"), "-o", plate.path(name), "--order", "2")
        mesh = by_meshio(plate.path(name))
        for kind in ("triangle6", "line3"):
            require_middles(np.asarray(mesh.points)[:, :2], mesh.cells_dict[kind])
    require_read_again(plate, plate.path("disc.msh"))
    # meshio knows neither CTRIA6 nor CPS6.
    plate.convert("second.vtu", "--order", "2")
    triangles = by_meshio(plate.path("second.vtu")).cells_dict["triangle6"]
    plate.convert("plate.bdf", "--order", "2")
    with open(plate.path("plate.bdf"), encoding="ascii") as file:
        fields = [[int(line[i:i + 8]) for i in range(24, 72, 8)] for line in file if line.startswith("CTRIA6")]
    if not np.array_equal(np.array(fields) - 1, triangles):
        raise ValueError("plate.bdf: other elements")
    plate.convert("plate.inp", "--order", "2")
    require_tension(plate, 21)


def require_read_again(plate, path):
    """TriGrid reads the six-node elements that Gmsh writes, and writes them so that Gmsh finds the same disc."""
    import gmsh
    for version, binary in ((2.2, 0), (2.2, 1), (4.1, 0), (4.1, 1)):
        gmsh.initialize(["-noenv"], readConfigFiles=False)
        try:
            gmsh.option.setNumber("General.Terminal", 0)
            gmsh.open(path)
            gmsh.option.setNumber("Mesh.MshFileVersion", version)
            gmsh.option.setNumber("Mesh.Binary", binary)
            gmsh.write(plate.path("gmsh.msh"))
        finally:
            gmsh.finalize()
        plate.run("info", plate.path("gmsh.msh"))
        plate.run("convert", plate.path("gmsh.msh"), plate.path("again.msh"))
        if not np.allclose(disc_errors(plate.path("again.msh")), disc_errors(path), rtol=0, atol=1e-12):
            raise ValueError(f"TriGrid reads another disc from MSH {version}, binary {binary}")


def check_mfem(plate):
    """MFEM finds sides and region, and solves Laplace's equation for a quadratic, which elements of second order have exactly."""
    import mfem.ser as mfem

    class Quadratic(mfem.PyCoefficient):
        def EvalValue(self, place):
            return place[0] * place[0] - place[1] * place[1]

    for order in ("1", "2"):
        path = plate.convert("mfem.msh", "--order", order)
        with contextlib.redirect_stdout(io.StringIO()):
            mesh = mfem.Mesh(path, 1, 1)
        found = mesh.GetNE(), len(mesh.attributes.ToList()), len(mesh.bdr_attributes.ToList())
        if found != (len(plate.triangles), 1, len(plate.sides)):
            raise ValueError(f"order {order}: MFEM finds {found} elements, regions and sides")
        space = mfem.FiniteElementSpace(mesh, mfem.H1_FECollection(2, 2))
        stiffness, load, found = mfem.BilinearForm(space), mfem.LinearForm(space), mfem.GridFunction(space)
        stiffness.AddDomainIntegrator(mfem.DiffusionIntegrator())
        stiffness.Assemble()
        load.Assemble()
        found.Assign(0.0)
        sides, given = mfem.intArray([1] * mesh.bdr_attributes.Max()), mfem.intArray()
        exact = Quadratic()
        found.ProjectBdrCoefficient(exact, sides)
        space.GetEssentialTrueDofs(sides, given)
        matrix, known, unknown = mfem.SparseMatrix(), mfem.Vector(), mfem.Vector()
        stiffness.FormLinearSystem(given, found, load, matrix, unknown, known)
        mfem.PCG(matrix, mfem.GSSmoother(matrix), known, unknown, 0, 2000, 1e-26, 0.0)
        stiffness.RecoverFEMSolution(unknown, load, found)
        if not found.ComputeL2Error(exact) < 1e-8:
            raise ValueError(f"order {order}: MFEM's solution is off by {found.ComputeL2Error(exact)}")


def require_middles(points, cells):
    """The nodes after the corners are in the middles of the edges, to within the bulge of the circle."""
    corners = {6: 3, 3: 2}[cells.shape[1]]
    for k in range(cells.shape[1] - corners):
        halfway = (points[cells[:, k]] + points[cells[:, (k + 1) % corners]]) / 2
        if np.max(np.abs(points[cells[:, corners + k]] - halfway)) > 0.01:
            raise ValueError("a middle is not between its corners")


def disc_errors(path):
    """What Gmsh finds of the area and the rim of a disc, less the exact values; all Jacobians must be positive."""
    import gmsh
    gmsh.initialize(["-noenv"], readConfigFiles=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(path)
        sums = {}
        for kind in (8, 9):
            places, weights = gmsh.model.mesh.getIntegrationPoints(kind, "Gauss6")
            _, determinants, _ = gmsh.model.mesh.getJacobians(kind, places)
            sums[kind] = float(np.sum(np.reshape(determinants, (-1, len(weights))) @ weights))
        elements, _ = gmsh.model.mesh.getElementsByType(9)
        if min(gmsh.model.mesh.getElementQualities(elements, "minDetJac")) <= 0:
            raise ValueError(f"{path}: Gmsh finds a folded element")
        if gmsh.model.mesh.getElementsByType(2)[0].size:
            raise ValueError(f"{path}: Gmsh finds elements of three nodes")
        return abs(sums[9] - np.pi), abs(sums[8] - 2 * np.pi)
    finally:
        gmsh.finalize()


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    plate = Plate(os.path.abspath(sys.argv[1]), sys.argv[2])
    failed = 0
    for check in (check_msh, check_vtu, check_medit, check_su2, check_nastran, check_triangle, check_abaqus, check_regions, check_second_order,
                  check_mfem):
        name = check.__name__.removeprefix("check_")
        try:
            check(plate)
            print(f"{name}: read alike")
        except Exception as error:  # each format gets its line, whatever a reader throws
            failed += 1
            print(f"{name}: FAILED: {type(error).__name__}: {error}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
