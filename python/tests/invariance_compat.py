# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of the functions with the names of other packages: see `invariance`."""

import tempfile
from pathlib import Path

import numpy as np

import invariance as m
from intrinsic.compat import potpourri3d as pp3d
from intrinsic.compat import robust_laplacian
from intrinsic.compat.pygeodesic import geodesic
from invariance import combinatorial, discrete, intrinsic, vertices
from written import base, place

SOME = "sphere", "disk"  # what they call is checked on all
CLOUD = ("cloud",)


def at(x, *ks):
    return [int(x.vertex[place(x.name, k)]) for k in ks]


def rows_of(call):
    """The measure of a call that returns distances at vertices."""
    return lambda x: [x.rows(call(x)) / x.scale]


def in_a_file(write, read, name):
    def measure(x):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / name
            write(x, path)
            found = read(path)
        V, F = found if isinstance(found, tuple) else (found, None)
        return [x.space(x.rows(V)), F if F is None else m.triangles(x, F)]
    return measure


def write_plain(x, path):
    rows = [f"{len(x.V)} {len(x.F)}", *(" ".join(map(repr, p)) for p in x.V.tolist()),
            *(" ".join(map(str, f)) for f in x.F.tolist())]
    path.write_text("\n".join(rows))


def line_of_level(x):
    """The places of a line on edges and at vertices."""
    V, edges = x.V, pp3d.edges(x.V, x.F)
    found = []
    for line in pp3d.marching_triangles(x.V, x.F, m.function(x), 0.1):
        P = np.array([V[e] if not t else (1 - t[0]) * V[edges[e][0]] + t[0] * V[edges[e][1]]
                      for e, t in line])
        found.append(np.linalg.norm(np.diff(P, axis=0), axis=1).sum() / x.scale)
    return [np.sort(found)]


def line_of_solver(x):
    lines = pp3d.MarchingTrianglesSolver(x.V, x.F).marching_triangles(m.function(x), 0.1)
    return [sorted(map(len, lines))]


def edges(x):
    return [sorted(sorted(e) for e in x.base_vertex[pp3d.edges(x.V, x.F)].tolist())]


def edge(x):
    """The ends of an edge."""
    return [int(x.vertex[v]) for v in base(x.name).F[3][:2]]


def curve_elements(x):
    return [[(v, []) for v in at(x, 0, 1)]]


def vectors(solver):
    """Lengths of what is transported, which is the same by both functions, and the frames."""
    def measure(x):
        s = solver(x)
        v = at(x, 0)[0]
        X, Y, N = s.get_tangent_frames()
        field = s.transport_tangent_vectors(at(x, 0, 1), [[2., 0.], [0., 3.]])
        one = s.transport_tangent_vector(v, [2., 0.])
        again = s.transport_tangent_vectors([v], [[2., 0.]])
        return [np.linalg.norm(x.rows(one), axis=1), np.abs(one - again).max(),
                np.isfinite(field).all(), np.linalg.det(np.stack([X, Y, N], axis=1))]
    return measure


def logarithms(solver):
    def measure(x):
        z = m.complexes(x.rows(solver(x).compute_log_map(at(x, 0)[0]))) / x.scale
        return [abs(z), *m.up_to_turns(z, place(x.name, 3), x.name != "cloud")]
    return measure


def mesh(kind):
    return lambda x: kind(x.V, x.F)


def cloud(x):
    return pp3d.PointCloudHeatSolver(x.V)


def length_of(call):
    def measure(x):
        P = x.space(call(x))
        return [P[[0, -1]], np.linalg.norm(np.diff(P, axis=0), axis=1).sum()]
    return measure


def solver_of_heat(name, kind, on=SOME):
    """The checks of a solver of distances and vectors by heat."""
    p = f"potpourri3d.{name}."
    return {
        p + "compute_distance": [discrete(rows_of(lambda x: kind(x).compute_distance(at(x, 0)[0])),
                                          on=on)],
        p + "compute_distance_multisource": [discrete(rows_of(
            lambda x: kind(x).compute_distance_multisource(at(x, 0, 1))), on=on)]}


def solver_of_vectors(name, kind, on=SOME):
    p = f"potpourri3d.{name}."
    return solver_of_heat(name, kind, on) | {
        p + "extend_scalar": [discrete(lambda x: [x.rows(
            kind(x).extend_scalar(at(x, 0, 1), [1., 3.]))], on=on)],
        p + "get_tangent_frames": [discrete(vectors(kind), on=on)],
        p + "transport_tangent_vector": [discrete(vectors(kind), on=on)],
        p + "transport_tangent_vectors": [discrete(vectors(kind), on=on)],
        p + "compute_log_map": [discrete(logarithms(kind), on=on)]}


def refuses(x):
    try:
        cloud(x).compute_signed_distance([], None)
    except NotImplementedError as error:
        return [str(error)]


def local_triangulation(x):
    found = pp3d.PointCloudLocalTriangulation(x.V).get_local_triangulation()
    rows = x.base_vertex[found[x.vertex]]
    return [[sorted(tuple(sorted(t)) for t, f in zip(r, g) if f[0] >= 0)
             for r, g in zip(rows.tolist(), found[x.vertex].tolist())]]


COMPAT = {
    **solver_of_heat("MeshHeatMethodDistanceSolver", mesh(pp3d.MeshHeatMethodDistanceSolver)),
    **solver_of_heat("MeshSignedHeatSolver", mesh(pp3d.MeshHeatMethodDistanceSolver)),
    **solver_of_vectors("MeshVectorHeatSolver", mesh(pp3d.MeshVectorHeatSolver)),
    **solver_of_vectors("PolygonMeshHeatSolver", mesh(pp3d.PolygonMeshHeatSolver)),
    **solver_of_vectors("PointCloudHeatSolver", cloud, on=CLOUD),
    "robust_laplacian.mesh_laplacian": [discrete(lambda x: [
        m.submatrix(x, robust_laplacian.mesh_laplacian(x.V, x.F)[0])], on=SOME + ("soup",))],
    "robust_laplacian.point_cloud_laplacian": [discrete(lambda x: [
        m.submatrix(x, robust_laplacian.point_cloud_laplacian(x.V)[0])], on=CLOUD)],
    "pygeodesic.read_mesh_from_file": [vertices(in_a_file(
        write_plain, geodesic.read_mesh_from_file, "x.txt"), on=SOME)],
    "pygeodesic.PyGeodesicAlgorithmExact.geodesicDistance": [intrinsic(lambda x: [
        geodesic.PyGeodesicAlgorithmExact(x.V, x.F).geodesicDistance(*at(x, 0, 1))[0] / x.scale])],
    "pygeodesic.PyGeodesicAlgorithmExact.geodesicDistances": [intrinsic(rows_of(
        lambda x: geodesic.PyGeodesicAlgorithmExact(x.V, x.F).geodesicDistances(at(x, 0, 1))[0]))],
    "potpourri3d.validate_mesh": [combinatorial(lambda x: [pp3d.validate_mesh(x.V, x.F)], on=SOME)],
    "potpourri3d.validate_points": [combinatorial(lambda x: [pp3d.validate_points(x.V)], on=SOME)],
    "potpourri3d.read_mesh": [vertices(in_a_file(
        lambda x, path: pp3d.write_mesh(x.V, x.F, path), pp3d.read_mesh, "x.off"), on=SOME)],
    "potpourri3d.read_polygon_mesh": [vertices(in_a_file(
        lambda x, path: pp3d.write_mesh(x.V, x.F, path), pp3d.read_polygon_mesh, "x.obj"),
        on=SOME)],
    "potpourri3d.write_mesh": [vertices(in_a_file(
        lambda x, path: pp3d.write_mesh(x.V, x.F, path), pp3d.read_mesh, "x.ply"), on=SOME)],
    "potpourri3d.read_point_cloud": [vertices(in_a_file(
        lambda x, path: pp3d.write_point_cloud(x.V, path), pp3d.read_point_cloud, "x.off"),
        on=CLOUD)],
    "potpourri3d.write_point_cloud": [vertices(in_a_file(
        lambda x, path: pp3d.write_point_cloud(x.V, path), pp3d.read_point_cloud, "x.ply"),
        on=CLOUD)],
    "potpourri3d.face_areas": [vertices(lambda x: [
        np.sort(pp3d.face_areas(x.V, x.F)) / x.scale**2], on=SOME)],
    "potpourri3d.vertex_areas": [vertices(lambda x: [
        x.rows(pp3d.vertex_areas(x.V, x.F)) / x.scale**2], on=SOME)],
    "potpourri3d.cotan_laplacian": [discrete(lambda x: [
        m.submatrix(x, pp3d.cotan_laplacian(x.V, x.F))], on=SOME)],
    "potpourri3d.edges": [combinatorial(edges, on=SOME)],
    "potpourri3d.marching_triangles": [intrinsic(line_of_level, on=SOME)],
    "potpourri3d.MeshMarchingTrianglesSolver.marching_triangles": [
        combinatorial(line_of_solver, on=SOME)],
    "potpourri3d.compute_distance": [discrete(rows_of(
        lambda x: pp3d.compute_distance(x.V, x.F, at(x, 0)[0])), on=SOME)],
    "potpourri3d.compute_distance_multisource": [discrete(rows_of(
        lambda x: pp3d.compute_distance_multisource(x.V, x.F, at(x, 0, 1))), on=SOME)],
    "potpourri3d.MeshFastMarchingDistanceSolver.compute_distance": [intrinsic(rows_of(
        lambda x: pp3d.MeshFastMarchingDistanceSolver(x.V, x.F).compute_distance(
            curve_elements(x), [[0, 0.1 * x.scale]])), on=SOME)],
    "potpourri3d.MeshSignedHeatSolver.compute_distance": [discrete(rows_of(
        lambda x: pp3d.MeshSignedHeatSolver(x.V, x.F).compute_distance(
            [[(v, []) for v in edge(x)]])), on=SOME)],
    "potpourri3d.MeshVectorHeatSolver.get_connection_laplacian": [discrete(lambda x: [
        abs(m.submatrix(x, pp3d.MeshVectorHeatSolver(x.V, x.F).get_connection_laplacian()))],
        on=SOME)],
    "potpourri3d.PolygonMeshHeatSolver.compute_signed_distance": [discrete(rows_of(
        lambda x: pp3d.PolygonMeshHeatSolver(x.V, x.F).compute_signed_distance([edge(x)])),
        on=SOME)],
    "potpourri3d.EdgeFlipGeodesicSolver.find_geodesic_path": [vertices(length_of(
        lambda x: pp3d.EdgeFlipGeodesicSolver(x.V, x.F).find_geodesic_path(*at(x, 0, 1))),
        on=SOME)],
    "potpourri3d.EdgeFlipGeodesicSolver.find_geodesic_path_poly": [vertices(length_of(
        lambda x: pp3d.EdgeFlipGeodesicSolver(x.V, x.F).find_geodesic_path_poly(at(x, 0, 1, 2))),
        on=SOME)],
    "potpourri3d.EdgeFlipGeodesicSolver.find_geodesic_loop": [vertices(length_of(
        lambda x: pp3d.EdgeFlipGeodesicSolver(x.V, x.F).find_geodesic_loop(at(x, 0, 1, 2))),
        on=("torus",))],
    "potpourri3d.GeodesicTracer.trace_geodesic_from_vertex": [vertices(length_of(
        lambda x: pp3d.GeodesicTracer(x.V, x.F).trace_geodesic_from_vertex(
            at(x, 0)[0], x.vector(m.direction(1)) * x.scale)), on=SOME)],
    "potpourri3d.GeodesicTracer.trace_geodesic_from_face": [intrinsic(length_of(
        lambda x: pp3d.GeodesicTracer(x.V, x.F).trace_geodesic_from_face(
            *m.spot(x, 4), x.vector(m.direction(1)) * x.scale)), on=SOME)],
    "potpourri3d.PointCloudHeatSolver.compute_signed_distance": [combinatorial(refuses, on=CLOUD)],
    "potpourri3d.PointCloudLocalTriangulation.get_local_triangulation": [
        combinatorial(local_triangulation, on=CLOUD)],
}
