"""Meshes one domain with another mesh generator and tells what it cost; run by `trigrid bench --compare`.

    python3 peers.py list                          versions of those installed, as JSON
    python3 peers.py PEER DOMAIN.json RUNS [OUT.msh]

DOMAIN.json is {"loops": [[x0, y0, x1, y1, ...], ...]}: boundary nodes, all of which are kept; outer loops run
anticlockwise, holes clockwise. Prints {"elements": n, "seconds": [CPU of each meshing call], "segmentsMissing": m}.
Only the meshing call itself is timed, in CPU time of its thread: loading the library and handing the boundary over are not.
"""
import json
import resource
import sys
import time

import numpy as np

CPU_LIMIT = 3600


def timed(call):
    start = time.thread_time()
    result = call()
    return result, time.thread_time() - start


def twice_area(loop):
    x, y = (loop - loop[0]).T
    return float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


# Each peer is a generator: it hands its input over, then yields (nodes, triangles, seconds) for each run.

def gmsh_frontal(loops):
    """Algorithm 6, sizes interpolated from the boundary, one thread."""
    import gmsh
    gmsh.initialize(["-noenv"], readConfigFiles=False)
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    gmsh.option.setNumber("Mesh.Algorithm", 6)
    geo = gmsh.model.geo
    curves = []
    for loop in loops:
        points = [geo.addPoint(x, y, 0) for x, y in loop.tolist()]
        lines = [geo.addLine(p, points[(i + 1) % len(points)]) for i, p in enumerate(points)]
        for line in lines:
            geo.mesh.setTransfiniteCurve(line, 2)
        curves.append(geo.addCurveLoop(lines))
    geo.addPlaneSurface(curves)
    geo.synchronize()
    while True:
        gmsh.model.mesh.clear()
        gmsh.model.mesh.generate(1)
        _, seconds = timed(lambda: gmsh.model.mesh.generate(2))
        tags, places, _ = gmsh.model.mesh.getNodes()
        _, corners = gmsh.model.mesh.getElementsByType(2)
        tags = np.asarray(tags)
        order = np.argsort(tags)
        nodes = np.asarray(places).reshape(-1, 3)[order, :2]
        yield nodes, np.searchsorted(tags[order], np.asarray(corners)).reshape(-1, 3), seconds


def netgen_front(loops):
    """Advancing front, grading 0.3, three optimisation steps; every given segment stays one element."""
    import netgen.meshing
    from netgen.geom2d import SplineGeometry
    netgen.meshing.SetMessageImportance(0)
    # Near size 10, which its tolerances are made for; by a power of two, which changes no digit.
    scale = 2.0 ** np.floor(np.log2(10 / max(np.ptp(loop, axis=0).max() for loop in loops)))
    geometry = SplineGeometry()
    longest = 0.0
    for loop in loops:
        points = [geometry.AppendPoint(float(x), float(y)) for x, y in loop * scale]
        for i, p in enumerate(points):
            geometry.Append(["line", p, points[(i + 1) % len(points)]], leftdomain=1, rightdomain=0)
        longest = max(longest, np.linalg.norm(np.roll(loop, -1, axis=0) - loop, axis=1).max())
    largest = float(longest) * scale * 1.0001
    while True:
        mesh, seconds = timed(lambda: geometry.GenerateMesh(
            maxh=largest, grading=0.3, delaunay2d=False, optsteps2d=3, segmentsperedge=1e-4))
        nodes = np.array([p.p for p in mesh.Points()])[:, :2] / scale
        yield nodes, np.array([[v.nr - 1 for v in e.vertices] for e in mesh.Elements2D()]), seconds


def triangle_sized(loops):
    """Quality angle 30, areas by the boundary's sizes, reached in rounds of at most four times smaller areas."""
    import triangle
    starts = np.cumsum([0] + [len(loop) for loop in loops])
    segments = np.vstack([np.c_[np.arange(a, b), np.r_[np.arange(a + 1, b), a]] for a, b in zip(starts, starts[1:])])
    given = {"vertices": np.vstack(loops), "segments": segments}
    holes = [place_inside(loop) for loop in loops if twice_area(loop) < 0]
    if holes:
        given["holes"] = np.array(holes)
    size_at = boundary_sizes(given, loops)
    while True:
        mesh, total = timed(lambda: triangle.triangulate(given, "pYYq30"))
        for _ in range(14):
            nodes, corners = mesh["vertices"], mesh["triangles"]
            a, b, c = (nodes[corners[:, k]] for k in range(3))
            u, v = b - a, c - a
            areas = 0.5 * np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
            wanted = 0.7 * size_at((a + b + c) / 3) ** 2
            if np.mean(areas > wanted) < 1e-3:
                break
            mesh["triangle_max_area"] = np.maximum(wanted, areas / 4).reshape(-1, 1)
            for key in ("neighbors", "edges", "holes"):
                mesh.pop(key, None)
            mesh, seconds = timed(lambda: triangle.triangulate(mesh, "rpYYq30a"))
            total += seconds
        yield mesh["vertices"], mesh["triangles"], total


def place_inside(loop):
    """The middle of the largest triangle of the loop's own triangulation."""
    import triangle
    ring = np.arange(len(loop))
    corners = triangle.triangulate({"vertices": loop, "segments": np.c_[ring, np.roll(ring, -1)]}, "p")["triangles"]
    a, b, c = (loop[corners[:, k]] for k in range(3))
    u, v = b - a, c - a
    return ((a + b + c) / 3)[np.argmax(np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]))]


def boundary_sizes(given, loops):
    """Sizes linear on the constrained Delaunay triangulation of the boundary nodes; outside, of the nearest node."""
    import matplotlib.tri
    import scipy.spatial
    import triangle
    at_nodes = []
    for loop in loops:
        lengths = np.linalg.norm(np.roll(loop, -1, axis=0) - loop, axis=1)
        at_nodes.append(0.5 * (lengths + np.roll(lengths, 1)))
    at_nodes = np.concatenate(at_nodes)
    places = given["vertices"]
    corners = np.asarray(triangle.triangulate(given, "p")["triangles"])
    linear = matplotlib.tri.LinearTriInterpolator(
        matplotlib.tri.Triangulation(places[:, 0], places[:, 1], corners), at_nodes)
    nearest = scipy.spatial.cKDTree(places)

    def size_at(where):
        sizes = linear(where[:, 0], where[:, 1])
        outside = np.ma.getmaskarray(sizes)
        result = np.asarray(sizes.filled(0.0))
        if outside.any():
            result[outside] = at_nodes[nearest.query(where[outside])[1]]
        return result

    return size_at


PEERS = {
    "gmsh": (gmsh_frontal, ["gmsh"]),
    "netgen": (netgen_front, ["netgen.geom2d"]),
    "triangle": (triangle_sized, ["triangle", "matplotlib.tri", "scipy.spatial"]),
}
DISTRIBUTIONS = {"gmsh": "gmsh", "netgen": "netgen-mesher", "triangle": "triangle"}


def installed():
    import importlib
    import importlib.metadata
    found = {}
    for peer, (_, modules) in PEERS.items():
        try:
            for module in modules:
                importlib.import_module(module)
            found[peer] = importlib.metadata.version(DISTRIBUTIONS[peer])
        except Exception:  # an installation that does not load is none
            pass
    return found


def segments_missing(nodes, triangles, loops):
    """Given segments that are no edge between two nodes at their very ends; 0 when the boundary is kept."""
    number = {place: i for i, place in enumerate(map(tuple, nodes.tolist()))}
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    keys = np.unique(edges[:, 0].astype(np.int64) * len(nodes) + edges[:, 1])
    missing = 0
    for loop in loops:
        ids = np.array([number.get(place, -1) for place in map(tuple, loop.tolist())])
        ends = np.sort(np.c_[ids, np.roll(ids, -1)], axis=1)
        wanted = ends[:, 0] * len(nodes) + ends[:, 1]
        at = np.minimum(np.searchsorted(keys, wanted), len(keys) - 1)
        missing += int(np.sum((keys[at] != wanted) | (ends[:, 0] < 0)))
    return missing


def write_msh(path, nodes, triangles):
    with open(path, "w") as out:
        out.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(nodes)}\n")
        for i, (x, y) in enumerate(nodes.tolist(), 1):
            out.write(f"{i} {x!r} {y!r} 0\n")
        out.write(f"$EndNodes\n$Elements\n{len(triangles)}\n")
        for i, (a, b, c) in enumerate(triangles.tolist(), 1):
            out.write(f"{i} 2 2 0 1 {a + 1} {b + 1} {c + 1}\n")
        out.write("$EndElements\n")


def main(arguments):
    if arguments == ["list"]:
        print(json.dumps(installed()))
        return
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_LIMIT, CPU_LIMIT))
    with open(arguments[1]) as file:
        loops = [np.asarray(loop, float).reshape(-1, 2) for loop in json.load(file)["loops"]]
    mesher, modules = PEERS[arguments[0]]
    for module in modules:
        __import__(module)
    seconds = []
    for nodes, triangles, spent in mesher(loops):
        seconds.append(spent)
        if len(seconds) >= int(arguments[2]):
            break
    if len(arguments) > 3:
        write_msh(arguments[3], nodes, triangles)
    missing = segments_missing(nodes, np.asarray(triangles, np.int64), loops)
    print(json.dumps({"elements": len(triangles), "seconds": seconds, "segmentsMissing": missing}))


if __name__ == "__main__":
    main(sys.argv[1:])
