# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Coarse surfaces: exact distances are within the proven bounds, flat ones stay the same."""

import pickle
import unittest

import numpy as np

import intrinsic as it
from support import CUBE, PART, grid


def torus(n=40, m=16):
    i, j = (x.ravel() for x in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    u, v = 2 * np.pi * i / n, 2 * np.pi * j / m
    r = 1 + .1 * np.sin(3 * u + v)
    V = np.column_stack([(3 + r * np.cos(v)) * np.cos(u), (3 + r * np.cos(v)) * np.sin(u),
                         r * np.sin(v)])
    a, b, c, d = ((i + k) % n * m + (j + l) % m for k, l in ((0, 0), (1, 0), (1, 1), (0, 1)))
    return V, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def subdivided(V, F):
    """Four triangles for each."""
    points, middle, faces = [tuple(p) for p in V], {}, []

    def between(a, b):
        key = min(a, b), max(a, b)
        if key not in middle:
            middle[key] = len(points)
            points.append(tuple((x + y) / 2 for x, y in zip(points[a], points[b])))
        return middle[key]

    for a, b, c in F:
        d, e, f = between(a, b), between(b, c), between(c, a)
        faces += [(a, d, f), (b, e, d), (c, f, e), (d, e, f)]
    return np.array(points), faces


class Coarse(unittest.TestCase):
    def test_distances_are_within_the_proven_bounds(self):
        s = it.Surface(*torus())
        for cost in ("stretch", "curvature", "area", "balanced", s.points[:, 2],
                     np.abs(s.points), lambda c: c.area * (1 + abs(c.curvature))):
            t = s.simplify(100, cost=cost)
            self.assertEqual((t.status, t.number_of_vertices), ("done", 100))
            self.assertEqual(len(np.unique(t.kept)), 100)
            for i in (0, 17, 99):
                fine, coarse = s.distance(int(t.kept[i]))[t.kept], t.distance(i)
                others = np.arange(100) != i
                ratio = coarse[others] / fine[others]
                self.assertLessEqual(t.stretch.lower, ratio.min())
                self.assertLessEqual(ratio.max(), t.stretch.upper)

    def test_a_candidate_knows_its_edges(self):
        F = [(0, 1, 2), (0, 2, 3), (0, 3, 1), (1, 3, 2)]  # all edges of a tetrahedron are alike
        seen = []
        it.Surface(4, F, lengths=[[3, 3, 3]] * 4).simplify(
            3, cost=lambda c: seen.append((c.mean_length, c.squared_length)) or c.area)
        np.testing.assert_allclose(seen[:4], [(3, 9)] * 4, rtol=1e-12)

    def test_a_bound_of_the_stretch_holds(self):
        t = it.Surface(*torus()).simplify(stretch=1.1)
        self.assertLessEqual(t.stretch.upper, 1.1)
        self.assertGreaterEqual(t.stretch.lower, 1 / 1.1)
        self.assertLess(t.number_of_vertices, 640)
        self.assertTrue((t.face_stretch[:, 0] >= t.stretch.lower).all())

    def test_functions_are_prolonged(self):
        V, F = grid(9)
        s = it.Surface(V, F)
        t = s.simplify(8)
        P = t.prolongation
        self.assertEqual(P.shape, (81, t.number_of_vertices))
        self.assertGreaterEqual(P.data.min(), 0)
        np.testing.assert_allclose(P @ V[t.kept], V, atol=1e-11)
        faces, weights = t.fine_places
        np.testing.assert_allclose(np.einsum("nk,nkc->nc", weights, V[t.kept[t.faces[faces]]]), V,
                                   atol=1e-11)

    def test_masses_stay_where_they_are_dear(self):
        V, F = grid(13)
        mass = np.where(V[:, 0] < 6, 1., 1e-6)
        t = it.Surface(V, F).simplify(60, cost=mass)
        self.assertGreater((V[t.kept, 0] < 6).sum(), 45)

    def test_tangent_vectors_are_prolonged(self):
        s = it.Surface(*torus())
        t = s.simplify(100)
        P = t.vector_prolongation
        self.assertEqual((P.shape, P.dtype), ((640, 100), np.dtype(complex)))
        np.testing.assert_allclose(abs(P).toarray(), t.prolongation.toarray(), atol=1e-12)
        # a field that is smooth on the coarse surface is smooth on the fine one
        quotients = []
        for surface in s, t:
            L, M = surface.connection_laplacian().toarray(), surface.mass().diagonal()
            values, fields = np.linalg.eigh(L / np.sqrt(np.outer(M, M)))
            quotients.append(values[0])
            field = fields[:, 0] / np.sqrt(M)
        z = P @ field
        found = (z.conj() @ (s.connection_laplacian() @ z)).real / (abs(z)**2 @ s.mass().diagonal())
        self.assertLess(quotients[0] * (1 - 1e-9), found)
        self.assertLess(found, 2 * quotients[0])

    def test_flat_vertices_go(self):
        V, F = subdivided(*subdivided(*CUBE))
        turn = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
        for within, points in (0, V), (1e-9, V), (1e-9, V @ turn):
            t = it.Surface(points, F).remove_flat_vertices(within)
            self.assertEqual((t.number_of_vertices, t.number_of_faces), (8, 12))
            self.assertLess(max(t.stretch.upper - 1, 1 - t.stretch.lower), 1e-9)

    def test_what_is_kept_stays(self):
        s = it.Surface(*torus())
        t = s.simplify(1, keep=[5, 80, 600])
        self.assertLessEqual({5, 80, 600}, set(t.kept))
        part = it.read(PART)
        t = part.simplify(1, keep=30.)
        self.assertGreater(t.number_of_vertices, 1)

    def test_hierarchies_become_coarser(self):
        s = it.Surface(*torus())
        levels = s.hierarchy(3)
        sizes = [640, *(t.number_of_vertices for t in levels)]
        self.assertEqual(sizes, [640, 160, 40, 10])
        for t in levels:
            self.assertEqual(t.prolongation.shape, (640, t.number_of_vertices))
            np.testing.assert_array_equal(t.kept, s.simplify(t.number_of_vertices).kept)
        for finer, t in zip(levels, levels[1:]):
            step = t.prolongation[finer.kept]
            self.assertEqual(step.shape, (finer.number_of_vertices, t.number_of_vertices))
            product = finer.prolongation @ step
            self.assertEqual(abs(product - t.prolongation)[finer.kept].max(), 0)
        for t in s.hierarchy(2, keep=[3, 99]):
            self.assertLessEqual({3, 99}, set(t.kept))

    def test_it_is_a_surface_as_any_other(self):
        t = it.Surface(*torus()).simplify(60)
        self.assertEqual(t.certificate, "exact")
        self.assertGreaterEqual(-t.laplacian().min(), 0)
        self.assertLess(len(repr(t)), 160)
        u = pickle.loads(pickle.dumps(t))
        np.testing.assert_array_equal(u.kept, t.kept)
        self.assertEqual(u.stretch, t.stretch)
        np.testing.assert_array_equal(u.lengths, t.lengths)
        np.testing.assert_array_equal(u.vector_prolongation.data, t.vector_prolongation.data)
        path, distance = t.path(0, 30), t.distance(0, targets=30)
        self.assertAlmostEqual(path.length, distance, delta=1e-12 * distance)
        self.assertGreaterEqual(t.path(0, 30, method="flips").length, distance * (1 - 1e-12))
        self.assertTrue(t.loop([0, 20, 40]).length > 0)

    def test_bad_arguments_are_refused(self):
        s = it.Surface(*torus())
        for arguments in ({"vertices": 0}, {"vertices": "x"}, {"vertices": "200%"},
                          {"stretch": .5}, {"cost": "x"}, {"keep": [4711]},
                          {"cost": [1, 2]}, {"cost": np.full(640, np.nan)}):
            with self.assertRaises(ValueError, msg=str(arguments)):
                s.simplify(**arguments)
        with self.assertRaises(ZeroDivisionError):
            s.simplify(cost=lambda c: 1 / 0)
        with self.assertRaises(ValueError):
            s.remove_flat_vertices(-1)
        with self.assertRaisesRegex(ValueError, "levels is 0; give a positive whole number"):
            s.hierarchy(0)


if __name__ == "__main__":
    unittest.main()
