# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How many statements and how much time do ten tasks on distances and curves take, here, in
potpourri3d, pygeodesic and libigl as their documentation writes them, and in the program intrinsic?

    PYTHONPATH=build/release/python distance_tasks.py MESH.off [PROGRAM] > table.md

Statements are those after the mesh is read; times are the least of three runs, with all that is
built for the task. A package that is not installed has no column. The program's time is that of its
step, without files. For the last column give the path of the program.
"""

import importlib.util
import json
import subprocess
import sys
import time

import numpy as np

# task, code for each package, and what the program does: command, options, steps that count
TASKS = [
    ("exact distances from a vertex", {
        "intrinsic": "s = it.Surface(V, F)\nd = s.distance(a)",
        "pygeodesic": "g = pg.PyGeodesicAlgorithmExact(V, F)\n"
                      "d, _ = g.geodesicDistances([a], None)",
        "igl": "n = np.arange(len(V))\nd = igl.exact_geodesic(V, F, np.array([a]), n)",
    }, ("distance", "--method exact --source {a}", "build delaunay solve")),
    ("distances by heat from a vertex", {
        "intrinsic": "s = it.Surface(V, F)\nd = s.distance(a, method='heat')",
        "potpourri3d": "h = pp3d.MeshHeatMethodDistanceSolver(V, F)\nd = h.compute_distance(a)",
        "igl": "d = igl.heat_geodesic(V, F, mean_edge ** 2, np.array([a]))",
    }, ("distance", "--method heat --source {a}", "build delaunay solve")),
    ("distances by heat from 20 vertices, each", {
        "intrinsic": "s = it.Surface(V, F)\nD = s.distances(many, method='heat')",
        "potpourri3d": "h = pp3d.MeshHeatMethodDistanceSolver(V, F)\n"
                       "D = [h.compute_distance(v) for v in many]",
    }, None),
    ("distance of two vertices", {
        "intrinsic": "s = it.Surface(V, F)\nd = s.distance(a, targets=b)",
        "pygeodesic": "g = pg.PyGeodesicAlgorithmExact(V, F)\nd, path = g.geodesicDistance(a, b)",
        "igl": "d = igl.exact_geodesic(V, F, np.array([a]), np.array([b]))",
    }, ("distance", "--method exact --source {a} --targets {b}", "build delaunay solve")),
    ("shortest path", {
        "intrinsic": "s = it.Surface(V, F)\np = s.path(a, b).points",
        "pygeodesic": "g = pg.PyGeodesicAlgorithmExact(V, F)\n_, p = g.geodesicDistance(a, b)",
    }, ("geodesic", "--path {a},{b}", "build paths shorten")),
    ("geodesic path by flips", {
        "intrinsic": "s = it.Surface(V, F)\np = s.path(a, b, method='flips').points",
        "potpourri3d": "g = pp3d.EdgeFlipGeodesicSolver(V, F)\np = g.find_geodesic_path(a, b)",
    }, ("geodesic", "--path {a},{b} --along-edges", "build paths shorten")),
    ("closed geodesic", {
        "intrinsic": "s = it.Surface(V, F)\np = s.loop([a, b, c], method='flips').points",
        "potpourri3d": "g = pp3d.EdgeFlipGeodesicSolver(V, F)\np = g.find_geodesic_loop([a, b, c])",
    }, ("geodesic", "--loop {a},{b},{c} --along-edges", "build paths shorten")),
    ("geodesic in a direction", {
        "intrinsic": "s = it.Surface(V, F)\np = s.trace(a, [1, 2, 3], far).points",
        "potpourri3d": "g = pp3d.GeodesicTracer(V, F)\n"
                       "p = g.trace_geodesic_from_vertex(a, far * np.array([1, 2, 3]) / 14 ** 0.5)",
    }, None),
    ("cells of 20 vertices, and their boundaries", {
        "intrinsic": "s = it.Surface(V, F)\ncells = s.voronoi(many)",
    }, None),
    ("pieces between ten lines of equal distance", {
        "intrinsic": "s = it.Surface(V, F)\npieces = s.cut(s.isolines(s.distance(a), 10))",
    }, ("cut", "--levels 10 --source {a}", "build curves cut")),
]
IMPORTS = {"intrinsic": "import intrinsic as it", "potpourri3d": "import potpourri3d as pp3d",
           "pygeodesic": "import pygeodesic.geodesic as pg", "igl": "import igl"}


def read(path):
    with open(path) as file:
        words = file.read().split()
    n, m = int(words[1]), int(words[2])
    V = np.array(words[4:4 + 3 * n], dtype=float).reshape(n, 3)
    return V, np.array(words[4 + 3 * n:4 + 3 * n + 4 * m], dtype=int).reshape(m, 4)[:, 1:]


def seconds(run):
    times = []
    for _ in range(3):
        begin = time.perf_counter()
        run()
        times.append(time.perf_counter() - begin)
    return min(times)


def of_program(program, path, names, command, options, steps):
    run = [program, command, path, *options.format(**names).split(), "--stats", "-"]
    found = [json.loads(subprocess.run(run, check=True, capture_output=True).stdout)["seconds"]
             for _ in range(3)]
    return min(sum(s[step] for step in steps.split()) for s in found)


def main(path, program=None):
    V, F = read(path)
    n = len(V)
    names = {"np": np, "V": V, "F": F, "a": 0, "b": n // 2, "c": n // 3,
             "many": list(range(0, n, -(-n // 20))), "far": np.ptp(V, axis=0).max(),
             "mean_edge": np.linalg.norm(V[F[:, 0]] - V[F[:, 1]], axis=1).mean()}
    packages = []
    for package, statement in IMPORTS.items():
        if importlib.util.find_spec(package):
            exec(statement, names)
            packages.append(package)
    columns = [f"{p}: statements | seconds" for p in packages] + (["program"] if program else [])
    print("| task |", " | ".join(columns), "|")
    print("|---|" + "---|" * (2 * len(packages) + bool(program)))
    for task, code, steps in TASKS:
        cells = []
        for package in packages:
            text = code.get(package)
            cells += [str(len(text.splitlines())) if text else "-",
                      f"{seconds(lambda: exec(text, names)):.4f}" if text else "-"]
        if program:
            cells.append(f"{of_program(program, path, names, *steps):.4f}" if steps else "-")
        print(f"| {task} |", " | ".join(cells), "|", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
