# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Modules with the names of other packages: shapes, closed forms, and our own results."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import intrinsic as it
from intrinsic.compat import potpourri3d as pp3d
from intrinsic.compat import robust_laplacian
from intrinsic.compat.pygeodesic import geodesic
from support import CUBE, grid


def sphere(n=12):
    """Rings of vertices between two poles."""
    t, p = np.meshgrid(np.pi * np.arange(1, n) / n, np.pi * np.arange(2 * n) / n, indexing="ij")
    V = np.stack([np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)], axis=-1).reshape(-1, 3)
    i = np.arange(len(V)).reshape(n - 1, 2 * n)
    a, b, c, d = i[:-1], i[1:], np.roll(i[1:], -1, 1), np.roll(i[:-1], -1, 1)
    north, south = np.full(2 * n, len(V)), np.full(2 * n, len(V) + 1)
    F = [(a, b, c), (a, c, d), (north, i[0], np.roll(i[0], -1)),
         (south, np.roll(i[-1], -1), i[-1])]
    F = np.concatenate([np.stack([np.ravel(x) for x in f], axis=1) for f in F])
    return np.concatenate([V, [[0, 0, 1], [0, 0, -1]]]), F


class Robust_laplacian(unittest.TestCase):
    def test_laplacian_of_a_mesh(self):
        rng = np.random.default_rng(3)
        V, F = rng.random((30, 3)), rng.integers(0, 30, (60, 3))
        F = F[(F[:, 0] != F[:, 1]) & (F[:, 1] != F[:, 2]) & (F[:, 2] != F[:, 0])]  # any soup
        L, M = robust_laplacian.mesh_laplacian(V, F)
        self.assertEqual((L.format, M.format), ("csc", "csc"))
        self.assertEqual((L.shape, M.shape), ((30, 30), (30, 30)))
        self.assertLess(abs(L - L.T).max(), 1e-12)
        off = L - np.diag(L.diagonal())
        self.assertLessEqual(off.max(), 0)
        self.assertAlmostEqual(M.diagonal().sum(), pp3d.face_areas(V, F).sum(), 12)
        np.testing.assert_allclose(L @ np.ones(30), 0, atol=1e-9)

    def test_laplacian_of_a_grid_is_the_stencil(self):
        V, F = grid()
        L, M = robust_laplacian.mesh_laplacian(V, F)
        row = np.asarray((L - np.diag(L.diagonal()))[40]).ravel()
        np.testing.assert_allclose([L[40, 40], *row[[31, 39, 41, 49]]], [4, -1, -1, -1, -1],
                                   atol=1e-12)
        self.assertAlmostEqual(M[40, 40], 1, 12)

    def test_laplacian_of_points(self):
        V, _ = grid()
        L, M = robust_laplacian.point_cloud_laplacian(V, n_neighbors=12)
        np.testing.assert_allclose((L @ V)[40], 0, atol=1e-12)
        self.assertAlmostEqual(M[40, 40], 1, 1)
        for factor in (-1, np.nan):
            self.assertRaises(ValueError, robust_laplacian.mesh_laplacian, *CUBE, factor)


class Pygeodesic(unittest.TestCase):
    def test_distances_and_paths_in_a_square(self):
        V, F = grid()
        g = geodesic.PyGeodesicAlgorithmExact(V, F)
        distance, path = g.geodesicDistance(10, 70)
        self.assertAlmostEqual(distance, np.linalg.norm(V[10] - V[70]), 12)
        np.testing.assert_allclose(path[[0, -1]], V[[70, 10]])
        distances, best = g.geodesicDistances(np.array([0, 80]))
        expected = np.linalg.norm(V[:, None] - V[[0, 80]], axis=2)
        np.testing.assert_allclose(distances, expected.min(axis=1), atol=1e-12)
        clear = np.abs(expected[:, 0] - expected[:, 1]) > 1e-9
        np.testing.assert_array_equal(best[clear], expected.argmin(axis=1)[clear])
        distances, best = g.geodesicDistances([3], [4, 5])
        np.testing.assert_allclose(distances, [1, 2])
        np.testing.assert_array_equal(best, [0, 0])
        for sources in None, [0, 80]:
            distances, best = g.geodesicDistances(sources, max_distance=2.5)
            far = np.abs(expected[:, 0] if sources is None else expected.min(axis=1)) > 2.5
            np.testing.assert_array_equal(np.isinf(distances), far)
            np.testing.assert_array_equal(best == -1, far)
            self.assertEqual(best.dtype, np.int32)

    def test_a_vertex_on_a_path_is_one_point(self):
        V, F = grid(5)
        along = geodesic.PyGeodesicAlgorithmExact(V, F).geodesicDistance(20, 4)[1]
        self.assertEqual(len(along), 9)  # across four squares, and four of their diagonals
        V, F = CUBE
        path = geodesic.PyGeodesicAlgorithmExact(V, F).geodesicDistance(0, 3)[1]
        self.assertEqual(len(path), 2)

    def test_reads_its_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "m.txt"
            path.write_text("3 1\n0 0 0\n1 0 0\n0 1 0\n0 1 2\n")
            points, faces = geodesic.read_mesh_from_file(path)
            np.testing.assert_array_equal(faces, [[0, 1, 2]])
            self.assertEqual(points.shape, (3, 3))
            path.write_text("3 2\n0 0 0\n")
            self.assertRaises(ValueError, geodesic.read_mesh_from_file, path)


class Potpourri3d(unittest.TestCase):
    def test_areas_and_laplacians(self):
        V, F = sphere()
        self.assertEqual(pp3d.face_areas(V, F).shape, (len(F),))
        self.assertAlmostEqual(pp3d.vertex_areas(V, F).sum(), pp3d.face_areas(V, F).sum(), 12)
        L = pp3d.cotan_laplacian(V, F)
        np.testing.assert_allclose(L.sum(axis=1), 0, atol=1e-12)
        D, G = it.Surface(*grid()).laplacian(), pp3d.cotan_laplacian(*grid())
        np.testing.assert_allclose((D - G).toarray(), 0, atol=1e-12)  # a grid is Delaunay
        self.assertEqual(len(pp3d.edges(V, F)), 3 * len(F) // 2)
        np.testing.assert_array_equal(pp3d.edges(np.eye(4, 3), [[2, 0, 1], [3, 1, 0]]),
                                      [[2, 0], [0, 1], [1, 2], [3, 1], [0, 3]])

    def test_arrays_are_checked(self):
        V, F = grid()
        pp3d.validate_mesh(V, F, force_triangular=True, test_indices=True)
        pp3d.validate_mesh(V, F + 1)
        for call in (lambda: pp3d.validate_mesh(V, F + 1, test_indices=True),
                     lambda: pp3d.validate_mesh(V, [[0, 1, 2, 3]], force_triangular=True),
                     lambda: pp3d.validate_mesh(V, [[0, 1]]), lambda: pp3d.validate_points(V[0])):
            self.assertRaises(ValueError, call)

    def test_distances(self):
        V, F = sphere()
        solver = pp3d.MeshHeatMethodDistanceSolver(V, F, t_coef=2.0)
        d = solver.compute_distance(7)
        np.testing.assert_array_equal(d, it.Surface(V, F).distance(7, method="heat", time_factor=2))
        exact = np.arccos(np.clip(V @ V[7], -1, 1))
        self.assertLess(np.abs(d - exact).max(), 0.25)
        d = pp3d.compute_distance_multisource(V, F, [1, 3, 4])
        np.testing.assert_array_equal(d[[1, 3, 4]], 0)
        self.assertEqual(pp3d.compute_distance(V, F, 7).shape, (len(V),))
        V, F = grid()
        d = pp3d.MeshSignedHeatSolver(V, F).compute_distance([[(36, []), (44, [])]])
        np.testing.assert_allclose(d, V[:, 1] - 4, atol=1e-9)  # positive on the left
        np.testing.assert_allclose(pp3d.MeshSignedHeatSolver(V, F).compute_distance(
            [[(36, []), (44, [])]], [True], [(0, [])])[:3], [0, 1, 2], atol=0.3)
        poly = pp3d.PolygonMeshHeatSolver(V, [list(f) for f in F])
        self.assertEqual(poly.compute_distance([12, 17])[17], 0)
        np.testing.assert_allclose(poly.compute_signed_distance([[36, 44]]), -d, atol=1e-12)
        self.assertEqual(poly.transport_tangent_vectors([3], [[1, 0]]).shape, (81, 2))

    def test_points_by_elements(self):
        V, F = grid()
        edges, elements = pp3d.edges(V, F), []
        for line in pp3d.marching_triangles(V, F, V[:, 0] - 0.3 * V[:, 1], 2.5):
            for i, t in line:
                at = (1 - t[0]) * V[edges[i][0]] + t[0] * V[edges[i][1]] if t else V[i]
                self.assertAlmostEqual(at[0] - 0.3 * at[1], 2.5, 12)
            elements.append(line)
        line = (V[:, 0] - 0.3 * V[:, 1] - 2.5) / np.hypot(1, 0.3)  # smaller on the left
        for solve in (lambda c: -pp3d.MeshSignedHeatSolver(V, F).compute_distance(c),
                      lambda c: pp3d.MeshFastMarchingDistanceSolver(V, F).compute_distance(
                          c, sign=True)):
            d = solve(elements)
            near = np.abs(line) < 2
            np.testing.assert_allclose(d[near], line[near], atol=0.1)
        closed, = pp3d.marching_triangles(V, F, np.hypot(*(V[:, :2] - 4).T), 2.7)
        self.assertEqual(closed[0], closed[-1])

    def test_exact_distances_from_elements(self):
        V, F = grid()
        solver = pp3d.MeshFastMarchingDistanceSolver(V, F)
        edges = pp3d.edges(V, F)
        places = [V[12], 0.25 * V[edges[5][0]] + 0.75 * V[edges[5][1]],
                  np.array([0.2, 0.3, 0.5]) @ V[F[60]]]
        expected = np.linalg.norm(V[:, None] - places, axis=2)
        curves = [[(12, []), (5, [0.75])], [(60, [0.2, 0.3])]]
        np.testing.assert_allclose(solver.compute_distance(curves), expected.min(axis=1),
                                   atol=1e-12)
        np.testing.assert_allclose(solver.compute_distance(curves, [[2.0], [-1.0]]),
                                   (expected + [2, 0, -1]).min(axis=1), atol=1e-12)
        self.assertRaises(ValueError, solver.compute_distance, curves, [[2.0]], True)

    def test_vectors(self):
        V, F = sphere()
        solver = pp3d.MeshVectorHeatSolver(V, F)
        values = solver.extend_scalar([1, 22], [0.0, 6.0])
        self.assertTrue(0 <= values.min() and values.max() <= 6)
        x, y, normal = solver.get_tangent_frames()
        self.assertIs(solver.get_tangent_frames()[0], x)
        for a, b, product in ((x, x, 1), (y, y, 1), (normal, normal, 1), (x, y, 0), (x, normal, 0)):
            np.testing.assert_allclose((a * b).sum(axis=1), product, atol=1e-12)
        np.testing.assert_allclose((normal * V).sum(axis=1), 1, atol=0.02)  # outward
        z = solver.transport_tangent_vector(22, [6.0, 6.0])
        self.assertEqual(z.shape, (len(V), 2))
        np.testing.assert_allclose(np.hypot(*z.T), np.hypot(6, 6), rtol=1e-9)
        in_space = z[:, :1] * x + z[:, 1:] * y
        mine = it.Surface(V, F).transport(22, [6, 6]).vectors
        self.assertLess(np.linalg.norm(in_space - mine, axis=1).max(), 0.35 * np.hypot(6, 6))
        self.assertEqual(solver.transport_tangent_vectors([1, 22], [[6, 6], [3, 4]]).shape,
                         (len(V), 2))
        for strategy in ("VectorHeat", "AffineLocal", "AffineAdaptive"):
            self.assertEqual(solver.compute_log_map(1, strategy).shape, (len(V), 2))
        C = solver.get_connection_laplacian()
        self.assertEqual(C.format, "csc")
        self.assertEqual(C.shape, (len(V), len(V)))
        self.assertLess(abs(C - C.getH()).max(), 1e-12)

    def test_geodesics(self):
        V, F = grid()
        solver = pp3d.EdgeFlipGeodesicSolver(V, F)
        path = solver.find_geodesic_path(v_start=14, v_end=66)
        np.testing.assert_allclose(path[[0, -1]], V[[14, 66]])
        length = np.linalg.norm(np.diff(path, axis=0), axis=1).sum()
        self.assertAlmostEqual(length, np.linalg.norm(V[14] - V[66]), 12)
        self.assertEqual(solver.find_geodesic_path_poly([0, 8, 80]).shape[1], 3)
        V, F = CUBE
        loop = pp3d.EdgeFlipGeodesicSolver(V, F).find_geodesic_loop([0, 4, 6, 2])
        np.testing.assert_allclose(loop[0], loop[-1])
        tracer = pp3d.GeodesicTracer(*grid())
        way = tracer.trace_geodesic_from_vertex(40, np.array([0.3, 0.5, 0.4]))
        np.testing.assert_allclose(way[-1], [4.3, 4.5, 0], atol=1e-12)
        way = tracer.trace_geodesic_from_face(3, [0.2, 0.3, 0.5], [0, 1, 0])
        start = np.array([0.2, 0.3, 0.5]) @ grid()[0][grid()[1][3]]
        np.testing.assert_allclose(way[[0, -1]], [start, start + [0, 1, 0]], atol=1e-12)

    def test_files(self):
        V, F = grid()
        with tempfile.TemporaryDirectory() as folder:
            for name in ("m.obj", "m.off", "m.ply"):
                path = str(Path(folder) / name)
                pp3d.write_mesh(V, F, path)
                points, faces = pp3d.read_mesh(path)
                np.testing.assert_array_equal(points, V)
                np.testing.assert_array_equal(faces, F)
                pp3d.write_point_cloud(V, path)
                np.testing.assert_array_equal(pp3d.read_point_cloud(path), V)
            squares = [[0, 1, 10, 9], [1, 2, 11], [1, 11, 10]]
            pp3d.write_mesh(V, squares, path)
            faces = [f[f.index(min(f)):] + f[:f.index(min(f))]
                     for f in pp3d.read_polygon_mesh(path)[1]]
            self.assertEqual(faces, squares)
            self.assertRaises(ValueError, pp3d.read_mesh, path)
            path = path[:-3] + "obj"
            soup = np.array([[2, 1, 0], [0, 1, 2], [3, 3, 4]])
            pp3d.write_mesh(V, soup, path)
            np.testing.assert_array_equal(pp3d.read_mesh(path)[1], soup)
            for kind, size in ("per-vertex", 81), ("per-face", 128), ("per-corner", 384):
                pp3d.write_mesh(V, F, path[:-3] + "obj", np.zeros((size, 2)), kind)
            self.assertRaises(ValueError, pp3d.write_mesh, V, F, path[:-3] + "stl")

    def test_what_is_not_there_says_what_to_use(self):
        V, F = grid()
        curves = [[(i, []) for i in range(4 * 9, 5 * 9)]]
        cloud = pp3d.PointCloudHeatSolver(V)
        signed = pp3d.MeshSignedHeatSolver(V, F)
        for call in (lambda: cloud.compute_signed_distance([[0, 1]], V),
                     lambda: signed.compute_distance(curves, level_set_constraint="Multiple"),
                     lambda: signed.compute_distance(curves, soft_level_set_weight=1),
                     lambda: signed.compute_distance(curves, preserve_source_normals=True),
                     lambda: signed.compute_distance(curves, curve_signs=[False]),
                     lambda: pp3d.PolygonMeshHeatSolver(V, F).compute_signed_distance(
                         [[0, 1]], "None")):
            with self.assertRaisesRegex(NotImplementedError, "; (give|leave|make) "):
                call()

    def test_points(self):
        P = np.random.default_rng(7).random((200, 3)) * [1, 1, 0]
        solver = pp3d.PointCloudHeatSolver(P)
        self.assertEqual(solver.compute_distance(7)[7], 0)
        d = solver.compute_distance_multisource([1, 2, 3])
        chord = np.linalg.norm(P[:, None] - P[[1, 2, 3]], axis=2).min(axis=1)
        self.assertTrue((d >= chord * (1 - 1e-12)).all())
        x, y, normal = solver.get_tangent_frames()
        np.testing.assert_allclose(np.abs(normal), np.tile([0, 0, 1], (200, 1)), atol=1e-12)
        z = solver.transport_tangent_vector(1, [6.0, 6.0])
        in_space = z[:, :1] * x + z[:, 1:] * y
        np.testing.assert_allclose(in_space, np.tile(in_space[1], (200, 1)), atol=1e-5)
        log = solver.compute_log_map(1)
        np.testing.assert_allclose(np.hypot(*log.T), np.linalg.norm(P - P[1], axis=1), atol=1e-9)
        self.assertEqual(solver.extend_scalar([1, 22], [0.0, 6.0]).shape, (200,))

    def test_triangles_at_points(self):
        P = np.random.default_rng(7).random((200, 3)) * [1, 1, 0]
        triangles = pp3d.PointCloudLocalTriangulation(P).get_local_triangulation()
        self.assertEqual(triangles.shape[::2], (200, 3))
        has_points = triangles[:, :, 0] >= 0
        self.assertTrue((np.diff(has_points.astype(int), axis=1) <= 0).all())  # -1 at the end
        i, j, k = (P[triangles[has_points][:, c]] for c in range(3))
        self.assertTrue((np.cross(j - i, k - i)[:, 2] > 0).all())
        number = np.broadcast_to(np.arange(200)[:, None], has_points.shape)
        np.testing.assert_array_equal(triangles[:, :, 0][has_points], number[has_points])
        inside = (np.abs(P[:, :2] - 0.5) < 0.3).all(axis=1)  # Delaunay: empty circles
        for t in triangles[inside].reshape(-1, 3)[::7]:
            if t[0] >= 0:
                a, b, c = P[t, :2]
                center = np.linalg.solve([b - a, c - a], [(b @ b - a @ a) / 2, (c @ c - a @ a) / 2])
                distances = np.linalg.norm(P[:, :2] - center, axis=1)
                self.assertGreater(distances.min(), np.linalg.norm(a - center) * (1 - 1e-9))


if __name__ == "__main__":
    unittest.main()
