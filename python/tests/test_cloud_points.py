# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Clouds in which points are repeated, turned, isolated or inserted."""

import unittest

import numpy as np

import intrinsic as it


def turned(random, P):
    """A rotation of points at random."""
    Q, R = np.linalg.qr(random.normal(size=(3, 3)))
    Q *= np.sign(np.diag(R))
    if np.linalg.det(Q) < 0:
        Q[:, 0] *= -1
    return P @ Q.T


def clouds(random):
    """Names and points of clouds, lattices with ties among them."""
    x, y = np.divmod(np.arange(20 * 20), 20)
    square = np.column_stack([x, y, 0 * x]) / 20.0
    yield "lattice", square
    yield "lattice in another order", square[random.permutation(400)]
    yield "bent lattice", np.column_stack([np.sin(x / 9), y / 9, np.cos(x / 9)])
    hexagons = np.column_stack([x + y % 2 / 2, y * np.sqrt(3) / 2, 0 * x])
    yield "hexagons", hexagons
    yield "square at random", np.column_stack([random.random((400, 2)), np.zeros(400)])
    sphere = random.normal(size=(400, 3))
    yield "sphere", sphere / np.linalg.norm(sphere, axis=1)[:, None]
    side = np.arange(6)
    cube = np.array([(i, j, k) for i in side for j in side for k in side
                     if {i, j, k} & {0, 5}]) / 5.0
    yield "cube", cube


def with_twins(random, P, count):
    """Repeats some points at random places. Returns the points, and for each its first one."""
    first = np.concatenate([np.arange(len(P)), random.integers(0, len(P), count)])
    order = random.permutation(len(first))
    Q, numbers = P[first[order]], first[order]
    firsts = {}
    return Q, np.array([firsts.setdefault(v, i) for i, v in enumerate(numbers)])


class Turned_clouds(unittest.TestCase):
    def test_triangles_stay(self):
        random = np.random.default_rng(7)
        for name, P in clouds(random):
            triangles = it._core.triangles_at_points(P, 30)
            self.assertGreater(len(triangles), 4 * len(P))
            for k in range(3):
                with self.subTest(name, k=k):
                    np.testing.assert_array_equal(
                        it._core.triangles_at_points(turned(random, P) + (k - 1), 30), triangles)

    def test_masses_and_distances_stay(self):
        random = np.random.default_rng(8)
        P = random.normal(size=(300, 3))
        P /= np.linalg.norm(P, axis=1)[:, None]
        mass, d = it.points(P).mass().diagonal(), it.points(P).distance(3)
        for k in range(3):
            s = it.points(turned(random, P))
            # rounding of coordinates moves triangles by 1e-15
            np.testing.assert_allclose(s.mass().diagonal(), mass, rtol=0, atol=1e-9 * mass.max())
            np.testing.assert_allclose(s.distance(3), d, rtol=0, atol=1e-9)


class Twins(unittest.TestCase):
    def test_values_are_those_of_the_first_point(self):
        random = np.random.default_rng(3)
        for seed in range(3):
            P = np.column_stack([random.random((80, 2)), np.zeros(80)])
            Q, first = with_twins(random, P, 20)
            s, there = it.points(Q), np.unique(first)
            alone = it.points(Q[there])  # without twins: the oracle
            number = np.searchsorted(there, first)
            twin = int(np.flatnonzero(first != np.arange(len(Q)))[seed])
            of = number[twin]
            with self.subTest(seed=seed):
                values, modes = s.eigen(4)
                np.testing.assert_allclose(values, alone.eigen(4)[0], rtol=1e-9, atol=1e-9)
                np.testing.assert_array_equal(modes, modes[first])
                for method in "exact", "heat":
                    found = s.distance(twin, method=method)
                    np.testing.assert_allclose(found, alone.distance(of, method=method)[number],
                                               rtol=1e-9, atol=1e-12)
                    np.testing.assert_array_equal(s.distances([twin], method=method)[0], found)
                np.testing.assert_allclose(s.pair_distances([0], [twin]),
                                           alone.pair_distances([number[0]], [of]), rtol=1e-12)
                np.testing.assert_allclose(s.log_map(twin), alone.log_map(of)[number], atol=1e-8)
                np.testing.assert_allclose(s.transport(twin, [1, 0]).vectors,
                                           alone.transport(of, [1, 0]).vectors[number], atol=1e-8)
                np.testing.assert_allclose(s.extend([0, twin], [1, 2]),
                                           alone.extend([number[0], of], [1, 2])[number],
                                           atol=1e-8)
                field = s.direction_field(2).vectors[0]
                self.assertTrue(np.isfinite(field).all())
                uv, other = s.parametrize("spectral").uv, alone.parametrize("spectral").uv[number]
                np.testing.assert_allclose(np.linalg.norm(uv - uv[0], axis=1),
                                           np.linalg.norm(other - other[0], axis=1), atol=1e-6)
                labels = s.voronoi([0, twin]).labels
                np.testing.assert_array_equal(labels, labels[first])

    def test_points_without_faces_have_no_eigenvalue(self):
        random = np.random.default_rng(4)
        V = np.column_stack([random.random((30, 2)), np.zeros(30)])
        F = [[i, i + 1, i + 2] for i in range(0, 20)]
        s = it.Surface(np.vstack([V, random.random((5, 3))]), F)
        values, modes = s.eigen(40)
        self.assertEqual(len(values), 22)
        self.assertEqual(np.sum(np.abs(values) < 1e-9), 1)
        self.assertTrue((modes[22:] == 0).all())


class Refined_clouds(unittest.TestCase):
    def test_vectors_are_known_everywhere(self):
        random = np.random.default_rng(5)
        P = np.column_stack([random.random((60, 2)), np.zeros(60)])
        s = it.points(P).refine(min_angle=25)
        n = s.number_of_vertices
        self.assertGreater(n, 60)
        log = s.log_map(3)
        self.assertEqual(np.isfinite(log).sum(), 2 * n)
        np.testing.assert_allclose(np.linalg.norm(log[:60], axis=1),
                                   np.linalg.norm(P - P[3], axis=1), atol=1e-6)
        vectors = s.transport(3, [1, 2, 0]).vectors
        np.testing.assert_allclose(vectors, np.tile([1, 2, 0], (n, 1)), atol=1e-6)
        self.assertTrue(np.isfinite(s.direction_field(2).vectors).all())
        self.assertTrue(np.isfinite(s.extend([0, 9], [1, 2])).all())


if __name__ == "__main__":
    unittest.main()
