# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How many statements and how much time do tasks take here, and in potpourri3d, robust-laplacians,
pygeodesic and libigl as their documentation writes them, and how far are the results apart?

    PYTHONPATH=build/release/python side_by_side.py MESH.off [REPETITIONS] > table.md

A package that cannot be imported is left out, and named. Statements are those after imports, from
arrays V and F. The packages take turns; times are medians, in milliseconds of the processor, so
that other work on the machine matters little: of all statements, and where a solver or a surface
serves again, of the last ones anew with another vertex. The difference is the largest one of two
results, divided by the largest value; of logarithmic maps, it is that of lengths in the nearer
half. Maps need a mesh that is a disk.
"""

import importlib
import statistics
import sys
import time
from dataclasses import dataclass

import numpy as np

from distance_tasks import read

PACKAGES = {"intrinsic": "it", "robust_laplacian": "rl", "potpourri3d": "pp3d",
            "pygeodesic.geodesic": "geodesic", "igl": "igl"}


@dataclass
class Way:
    """What a package does for a task: statements once, statements for each call, and what is
    compared. Lines are statements."""
    once: str
    each: str
    value: str


HEAT = "solver = pp3d.MeshHeatMethodDistanceSolver(V, F)"
MESH, CLOUD = "s = it.Surface(V, F)", "s = it.points(V)"
VECTORS = "solver = pp3d.MeshVectorHeatSolver(V, F)"
IN_SPACE = ("X, Y, N = solver.get_tangent_frames()\n"
            "z = solver.transport_tangent_vector(a, [1, 0])\n"
            "z3 = z[:, 0, None] * X + z[:, 1, None] * Y")
ENERGY = "[(L @ V * V).sum(), M.sum()]"
LENGTH = "[np.linalg.norm(np.diff(p, axis=0), axis=1).sum()]"

NEAR = "np.hypot(*z.T)[near]"

TASKS = {
    "Laplacian and mass matrix": {
        "intrinsic": Way(MESH + "\nL, M = s.laplacian(), s.mass()", "", ENERGY),
        "robust_laplacian": Way("L, M = rl.mesh_laplacian(V, F)", "", ENERGY),
        "igl": Way("L, _, _ = igl.intrinsic_delaunay_cotmatrix(V, F)\nM = igl.massmatrix(V, F)", "",
                   "[-(L @ V * V).sum(), M.sum()]")},
    "the same of a cloud of points": {
        "intrinsic": Way(CLOUD + "\nL, M = s.laplacian(), s.mass()", "", ENERGY),
        "robust_laplacian": Way("L, M = rl.point_cloud_laplacian(V)", "", ENERGY)},
    "distances by heat": {
        "intrinsic": Way(MESH, 'd = s.distance(a, method="heat")', "d"),
        "potpourri3d": Way(HEAT, "d = solver.compute_distance(a)", "d"),
        "igl": Way("data = igl.HeatGeodesicsData()\ndata.use_intrinsic_delaunay = True\n"
                   "igl.heat_geodesics_precompute(V, F, data)",
                   "d = igl.heat_geodesics_solve(data, np.array([a]))", "d")},
    "exact distances of all vertices": {
        "intrinsic": Way(MESH, "d = s.distance(a)", "d"),
        "pygeodesic.geodesic": Way("solver = geodesic.PyGeodesicAlgorithmExact(V, F)",
                                   "d, best = solver.geodesicDistances([a])", "d"),
        "igl": Way("", "d = igl.exact_geodesic(V, F, np.array([a]), none, np.arange(len(V)), none)",
                   "d")},
    "shortest path of two vertices": {
        "intrinsic": Way(MESH, "p = s.path(a, b).points", LENGTH),
        "pygeodesic.geodesic": Way("solver = geodesic.PyGeodesicAlgorithmExact(V, F)",
                                   "d, p = solver.geodesicDistance(a, b)", LENGTH)},
    "geodesic by flips": {
        "intrinsic": Way(MESH, 'p = s.path(a, b, method="flips").points', LENGTH),
        "potpourri3d": Way("solver = pp3d.EdgeFlipGeodesicSolver(V, F)",
                           "p = solver.find_geodesic_path(a, b)", LENGTH)},
    "geodesic from a point in a direction": {
        "intrinsic": Way(MESH, "p = s.trace(it.Point(f, (0.2, 0.3, 0.5)), side, far).points",
                         "p[-1]"),
        "potpourri3d": Way("solver = pp3d.GeodesicTracer(V, F)",
                           "p = solver.trace_geodesic_from_face(f, (0.2, 0.3, 0.5), far * side)",
                           "p[-1]")},
    "transported vector at each vertex, in space": {
        "intrinsic": Way(MESH, "z3 = s.transport(a, [1, 0]).vectors", ""),
        "potpourri3d": Way(VECTORS, IN_SPACE, "")},  # frames begin at other edges
    "logarithmic map by heat": {
        "intrinsic": Way(MESH, 'z = s.log_map(a, method="affine")', NEAR),
        "potpourri3d": Way(VECTORS, "z = solver.compute_log_map(a)", NEAR)},
    "signed distances from a curve": {
        "intrinsic": Way(MESH, "d = s.signed_distance(curve)", "-d"),
        "potpourri3d": Way("solver = pp3d.MeshSignedHeatSolver(V, F)",
                           "d = solver.compute_distance([elements])", "d")},
    "distances by heat in a cloud of points": {
        "intrinsic": Way(CLOUD, 'd = s.distance(a, method="heat")', "d"),
        "potpourri3d": Way("solver = pp3d.PointCloudHeatSolver(V)",
                           "d = solver.compute_distance(a)", "d")},
    "harmonic map to a disk": {
        "intrinsic": Way(MESH, "uv = s.parametrize().uv", ""),
        "igl": Way("border = igl.boundary_loop(F)\nplaces = igl.map_vertices_to_circle(V, border)\n"
                   "uv = igl.harmonic(V, F, border, places, 1)", "", "")},
    "least squares conformal map": {
        "intrinsic": Way(MESH, 'uv = s.parametrize("lscm").uv', ""),
        "igl": Way("border = igl.boundary_loop(F)\n"
                   "uv, _ = igl.lscm(V, F, border[[0, len(border) // 2]], places)", "", "")},
}


def names_of(V, F):
    """Returns the names that statements use, and the packages that can be imported."""
    ends = np.sort(np.concatenate([F[:, [c, (c + 1) % 3]] for c in range(3)]), axis=1)
    n, f = len(V), len(F) // 3
    side = V[F[f, 1]] - V[F[f, 0]]
    names = {"np": np, "V": V, "F": F, "a": 0, "b": n // 2, "f": f, "none": np.zeros(0, dtype=int),
             "side": side / np.linalg.norm(side), "far": np.ptp(V, axis=0).max() / 2,
             "places": np.array([[0., 0.], [1., 0.]])}
    found = []
    for package, name in PACKAGES.items():
        try:
            names[name] = importlib.import_module(package)
            found.append(package)
        except ImportError:
            print(f"{package} is not installed", file=sys.stderr)
    from intrinsic.compat.potpourri3d import marching_triangles

    u = V[:, 1]
    lines = names["it"].Surface(V, F).isolines(u, [np.median(u) + 1e-5 * np.ptp(u)])
    longest = max(range(len(lines)), key=lambda i: len(lines[i]))
    places = lines[longest].places()[::-1]
    names["curve"] = places + places[:1] if lines[longest].is_closed else places
    exact = names["it"].Surface(V, F).distance(0)
    names["near"] = exact < np.median(exact)
    names["elements"] = marching_triangles(V, F, u, np.median(u) + 1e-5 * np.ptp(u))[longest]
    borders = (np.unique(ends, axis=0, return_counts=True)[1] == 1).sum()
    return names, found, borders > 0


def seconds(statements, names):
    code = compile(statements, "statements", "exec")  # takes as long as a short trace
    begin = time.process_time()
    exec(code, names)
    return time.process_time() - begin


def measure(ways, names, repetitions):
    """Returns the times of all statements, and of the last ones anew, and the results."""
    all_of, again, values = ({p: [] for p in ways} for _ in range(3))
    for _ in range(repetitions):
        for package, way in ways.items():
            local = dict(names)
            all_of[package].append(seconds(way.once + "\n" + way.each, local))
            values[package] = np.array(eval(way.value, local)) if way.value else None
            if way.each and way.once:
                local["a"] = len(local["V"]) // 3
                again[package].append(seconds(way.each, local))
    return all_of, again, values


def difference(x, y):
    both = np.isfinite(x) & np.isfinite(y)
    return np.abs(x - y)[both].max() / np.abs(y[both]).max()


def main(path, repetitions="5"):
    V, F = read(path)
    names, found, is_open = names_of(V, F)
    print(f"{len(V)} vertices, {len(F)} faces\n")
    print("| task | package | statements | ms | again | times longer | again | difference |")
    print("|---|---|---|---|---|---|---|---|")
    for task, code in TASKS.items():
        if " map" in task and "log" not in task and not is_open:
            continue
        ways = {p: way for p, way in code.items() if p in found}
        try:
            times, again, values = measure(ways, names, int(repetitions))
        except Exception as error:
            print(f"| {task} | {type(error).__name__}: {error} |")
            continue
        middle = {p: 1e3 * statistics.median(x) for p, x in times.items()}
        later = {p: 1e3 * statistics.median(x) for p, x in again.items() if x}
        for p, way in ways.items():
            ours = p == "intrinsic"
            cells = [task, p, len(f"{way.once}\n{way.each}".strip().splitlines()),
                     f"{middle[p]:.2f}", f"{later[p]:.2f}" if p in later else "",
                     "" if ours else f"{middle[p] / middle['intrinsic']:.2f}",
                     "" if ours or p not in later else f"{later[p] / later['intrinsic']:.2f}",
                     "" if ours or values[p] is None else
                     f"{difference(values['intrinsic'], values[p]):.1e}"]
            print("|", " | ".join(map(str, cells)), "|", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
