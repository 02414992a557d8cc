#!/usr/bin/env python3
"""Checks mesh files with the readers that users have.

    python interop.py FOLDER

For every NAME.msh or NAME.VERSION.msh of the folder: Gmsh and meshio open it and agree on nodes, elements and named
groups; every element is in exactly one group; the order of nodes is kept; lines have the domain on their left, and part
the regions from each other. Where
there is a NAME.json, the report that `trigrid mesh --report` wrote, counts and quality are computed again and compared.

Needs the packages gmsh, meshio and numpy. Exit status 1 when a file fails, 2 when there is none.
"""
import contextlib
import glob
import io
import json
import math
import os
import sys

import numpy as np

TOLERANCE = 1e-9
KINDS = {0: 15, 1: 1, 2: 2}  # Gmsh's numbers of points, lines and triangles


def by_meshio(path):
    import meshio
    with contextlib.redirect_stdout(io.StringIO()):  # it prints empty lines
        mesh = meshio.read(path)
    names = {(int(dim), int(tag)): name for name, (tag, dim) in mesh.field_data.items()}
    cells = {"vertex": [], "line": [], "triangle": []}
    groups = {}
    for block, tags in zip(mesh.cells, mesh.cell_data["gmsh:physical"]):
        if block.type not in cells:
            raise ValueError(f"unexpected cells of type {block.type}")
        cells[block.type].append(block.data)
        for nodes, tag in zip(block.data.tolist(), tags.tolist()):
            dim = list(cells).index(block.type)
            groups.setdefault((dim, names[dim, tag]), []).append(tuple(nodes))
    stacked = {kind: np.vstack(data).astype(int) for kind, data in cells.items() if data}
    return np.asarray(mesh.points, float), stacked["line"], stacked["triangle"], groups


def by_gmsh(path):
    import gmsh
    gmsh.initialize(["-noenv"], readConfigFiles=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.logger.start()
        gmsh.open(path)
        complaints = [text for text in gmsh.logger.get() if text.startswith(("Warning", "Error"))]
        if complaints:
            raise ValueError("gmsh: " + "; ".join(complaints))
        tags, coordinates, _ = gmsh.model.mesh.getNodes()
        order = np.argsort(tags)
        points = np.asarray(coordinates).reshape(-1, 3)[order]
        tags = np.asarray(tags)[order]
        groups = {}
        found = {0: [], 1: [], 2: []}
        for dim, physical in gmsh.model.getPhysicalGroups():
            name = gmsh.model.getPhysicalName(dim, physical)
            for entity in gmsh.model.getEntitiesForPhysicalGroup(dim, physical):
                types, _, nodes = gmsh.model.mesh.getElements(dim, entity)
                for kind, flat in zip(types, nodes):
                    if kind != KINDS[dim]:
                        raise ValueError(f"unexpected elements of type {kind}")
                    cells = np.searchsorted(tags, np.asarray(flat)).reshape(-1, dim + 1)
                    found[dim].append(cells)
                    groups.setdefault((dim, name), []).extend(map(tuple, cells.tolist()))
        everything = [len(t) for t in gmsh.model.mesh.getElements()[1]]
        if sum(everything) != sum(len(c) for dim in found for c in found[dim]):
            raise ValueError("an element is in no group or in several")
        return points, np.vstack(found[1]), np.vstack(found[2]), groups
    finally:
        gmsh.logger.stop()
        gmsh.finalize()


def measures(points, triangles):
    """Counts and quality, by the definitions of docs/cli.md."""
    a, b, c = (points[triangles[:, k], :2] for k in range(3))
    area = 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    squares = sum(np.sum((q - p) ** 2, 1) for p, q in ((a, b), (b, c), (c, a)))
    quality = 4 * math.sqrt(3) * area / squares
    angles = np.degrees(np.stack([
        np.arctan2(2 * area, np.sum((q - p) * (r - p), 1)) for p, q, r in ((a, b, c), (b, c, a), (c, a, b))], 1))
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    edges, uses = np.unique(edges, axis=0, return_counts=True)
    boundary = np.unique(edges[uses == 1])
    interior = np.setdiff1d(np.unique(triangles), boundary)
    degrees = np.bincount(edges.ravel(), minlength=len(points))[interior]
    return {
        "nodes": len(points), "elements": len(triangles), "boundaryNodes": len(boundary),
        "quality.min": quality.min(), "quality.mean": quality.mean(), "quality.p05": np.percentile(quality, 5),
        "quality.minAngle": angles.min(), "quality.meanMinAngle": angles.min(1).mean(), "quality.maxAngle": angles.max(),
        "degree6": float(np.mean(degrees == 6)) if len(degrees) else None,
        "bandwidth.after": 2 * int(np.max(triangles.max(1) - triangles.min(1))) + 1,
    }, area


def require(condition, what):
    if not condition:
        raise ValueError(what)


def value_of(report, key):
    for part in key.split("."):
        report = report.get(part) if isinstance(report, dict) else None
    return report


def check(path):
    points, lines, triangles, groups = by_meshio(path)
    points2, lines2, triangles2, groups2 = by_gmsh(path)
    require(np.array_equal(points, points2), "gmsh and meshio read different nodes or another order of nodes")
    require(sorted(triangles.tolist()) == sorted(triangles2.tolist()), "gmsh and meshio read different triangles")
    require(len(lines) == len(lines2), "gmsh and meshio read different lines")
    require({k: sorted(v) for k, v in groups.items()} == {k: sorted(v) for k, v in groups2.items()}, "groups differ")
    require(len(np.unique(triangles)) == len(points), "a node is in no triangle")
    ours, area = measures(points, triangles)
    require(bool(np.all(area > 0)), "a triangle is not anticlockwise")
    directed = {}
    for t in triangles.tolist():
        for k in range(3):
            directed[t[k], t[(k + 1) % 3]] = True
    for a, b in lines.tolist():
        require((a, b) in directed or (b, a) in directed, f"the line {a}-{b} is no edge")
        require((a, b) in directed, f"the line {a}-{b} has the domain on its right")
    on_lines = {(min(a, b), max(a, b)) for a, b in lines.tolist()}
    bare = [e for e in directed if (e[1], e[0]) not in directed and (min(e), max(e)) not in on_lines]
    require(not bare, "a boundary edge is in no group")
    region = {tuple(t): name for (dim, name), cells in groups.items() if dim == 2 for t in cells}
    beside = {}
    for t in triangles.tolist():
        for k in range(3):
            a, b = t[k], t[(k + 1) % 3]
            beside.setdefault((min(a, b), max(a, b)), set()).add(region[tuple(t)])
    require(all(e in on_lines for e, names in beside.items() if len(names) > 1), "two regions meet at an edge of no group")
    require(len(on_lines) == len(lines), "an edge is in two groups")
    report_path = os.path.join(os.path.dirname(path), os.path.basename(path).split(".")[0] + ".json")
    if os.path.exists(report_path):
        with open(report_path, encoding="utf-8") as file:
            report = json.load(file)
        for key, ours_value in ours.items():
            theirs = value_of(report, key)
            same = theirs == ours_value or (
                theirs is not None and ours_value is not None
                and abs(theirs - ours_value) <= TOLERANCE * max(1.0, abs(ours_value)))
            require(same, f"{key} is {theirs} in the report and {ours_value} in the file")
    return f"{len(points)} nodes, {len(triangles)} triangles, {len(lines)} lines, {len(groups)} groups" + (
        ", report agrees" if os.path.exists(report_path) else "")


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    files = sorted(glob.glob(os.path.join(sys.argv[1], "*.msh")))
    if not files:
        print("no .msh files in " + sys.argv[1], file=sys.stderr)
        return 2
    failed = 0
    for path in files:
        try:
            print(f"{path}: {check(path)}")
        except Exception as error:  # each file gets its line, whatever a reader throws
            failed += 1
            print(f"{path}: FAILED: {error}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
