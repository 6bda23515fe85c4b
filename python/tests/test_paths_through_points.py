# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A path that stays at all of its points is as long as the exact distances between them: on
surfaces with many equally short paths, and on others."""

import unittest

import numpy as np

import intrinsic as it
from ten_surfaces import ball, grid, sheet


def torus(chance):
    """A symmetric torus with random diagonals, on which shortest paths pass through vertices that
    have a straight angle on one side."""
    m, k = int(chance.integers(3, 8)), int(chance.integers(3, 6))
    i, j = grid(m, k)
    t, q = 2 * np.pi * i / m, 2 * np.pi * j / k
    V = np.column_stack([(2 + np.cos(q)) * np.cos(t), (2 + np.cos(q)) * np.sin(t), np.sin(q)])
    return V, np.array(sheet(chance, m, k, True, True))


def sphere(chance):
    V, F = ball(chance, 12)
    return V, np.array(F)


def plane(chance):
    """A grid with random diagonals and holes: paths run along its border."""
    V = np.column_stack([*grid(6, 6), np.zeros(36)])
    F = np.array(sheet(chance, 6, 6))
    used, F = np.unique(F[chance.random(len(F)) < .8], return_inverse=True)
    return V[used], F.reshape(-1, 3)


class Through(unittest.TestCase):
    def random_point(self, chance, V, F):
        kind = chance.integers(4)
        if kind == 0:
            return int(chance.integers(len(V)))
        weights = chance.dirichlet([1, 1, 1] if kind == 1 else [.1, .1, .1])  # near corners
        if kind == 3:
            weights = np.array([weights[0], 1 - weights[0], 0])[chance.permutation(3)]  # an edge
        return it.Point(int(chance.integers(len(F))), tuple(weights))

    def moved(self, chance, V, F, points):
        """The same surface, turned and with other numbers, and the same points on it."""
        turn, _ = np.linalg.qr(chance.standard_normal((3, 3)))
        turn[:, 0] *= np.sign(np.linalg.det(turn))
        vertices, faces = chance.permutation(len(V)), chance.permutation(len(F))
        moved = np.empty_like(V)
        moved[vertices] = V @ turn.T
        renamed = np.empty_like(F)
        renamed[faces] = vertices[F]
        return moved, renamed, [
            it.Point(int(faces[p.face]), p.barycentric) if isinstance(p, it.Point)
            else int(vertices[p]) for p in points]

    def expect_sum_of_distances(self, V, F, points):
        """Returns whether the path is certain; else it may be longer, and says so."""
        s = it.Surface(V, F)
        distances = s.pair_distances(points[:-1], points[1:])
        if not np.isfinite(distances).all() or distances.min() < 1e-9:
            return True
        curve = s.path(points[0], points[-1], through=points[1:-1], waypoints=True)
        self.assertIn(curve.status, ("done", "inaccurate"))
        if curve.status == "done":
            self.assertAlmostEqual(curve.length, distances.sum(), 9)
            self.assertAlmostEqual(curve.initial_length, distances.sum(), 9)
        return curve.status == "done"

    def points_on_surface(self, seed, number):
        """The points that `test_waypoints()` draws in so many steps, on the moved surface."""
        chance = np.random.default_rng(seed)
        V, F = [torus, torus, sphere, plane][seed % 4](chance)
        for _ in range(number):
            points = [self.random_point(chance, V, F) for _ in range(chance.integers(2, 5))]
            moved = self.moved(chance, V, F, points)
        return moved

    def test_curve_that_crosses_itself(self):
        """Sides of a curve meet at a vertex, and one of them cannot be inserted where they cross."""
        V, F, points = self.points_on_surface(45, 2)
        s = it.Surface(V, F).delaunay()
        curve = s.path(points[0], points[-1], through=points[1:-1], waypoints=True)
        self.assertIn(curve.status, ("done", "inaccurate"))
        shortest = s.pair_distances(points[:-1], points[1:]).sum()
        self.assertTrue(shortest - 1e-9 < curve.length < np.inf)

    def test_waypoints(self):
        certain = []
        for seed in range(60):
            chance = np.random.default_rng(seed)
            V, F = [torus, torus, sphere, plane][seed % 4](chance)
            for _ in range(6):
                points = [self.random_point(chance, V, F) for _ in range(chance.integers(2, 5))]
                with self.subTest(seed=seed, points=points):
                    certain += [self.expect_sum_of_distances(V, F, points),
                                self.expect_sum_of_distances(*self.moved(chance, V, F, points))]
        self.assertLessEqual(certain.count(False), 0.005 * len(certain))


if __name__ == "__main__":
    unittest.main()
