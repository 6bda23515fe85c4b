# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths, areas and vectors are in the units of the user: results scale as the surface does, and in
the plane they are what Euclid says. Surfaces are turned at random and have scales from 1e-3 to 1e3,
also powers of two, since the library computes in units that are powers of two."""

import math
import unittest
from fractions import Fraction

import numpy as np

import intrinsic as it
from support import bumpy

SCALES = 1e-3, 2.0**-9, 0.02, 0.5, 2.0, 7.0, 64.0, 1e3


def rotation(random):
    q, _ = np.linalg.qr(random.normal(size=(3, 3)))
    return q * np.sign(np.linalg.det(q))


def plane(random, n=6):
    """A grid in the plane z = 0, of n by n vertices, of which those inside are moved."""
    y, x = np.divmod(np.arange(n * n), n)
    V = np.column_stack([x, y, 0 * x]).astype(float)
    is_inside = (np.minimum(x, y) > 0) & (np.maximum(x, y) < n - 1)
    V[is_inside, :2] += random.uniform(-0.2, 0.2, (is_inside.sum(), 2))
    i = np.arange(n * n).reshape(n, n)[:-1, :-1].ravel()
    return V, np.vstack([np.column_stack([i, i + 1, i + n + 1]),
                         np.column_stack([i, i + n + 1, i + n])])


def random_point(F, random):
    return it.Point(int(random.integers(len(F))), tuple(random.dirichlet([1, 1, 1]).tolist()))


def exact_area(a, b, c):
    """The area of a triangle, of which rational numbers are rounded once."""
    a, b, c = ([Fraction(float(x)) for x in p] for p in (a, b, c))
    u, v = ([y - x for x, y in zip(a, p)] for p in (b, c))
    squared = sum((u[i] * v[j] - u[j] * v[i])**2 for i, j in ((0, 1), (1, 2), (2, 0)))
    return math.sqrt(squared) / 2


class Units(unittest.TestCase):
    def expect_near(self, a, b, error, what=""):
        a, b = np.asarray(a), np.asarray(b)
        self.assertEqual(a.shape, b.shape, what)
        self.assertLessEqual(np.abs(a - b).max(), error * np.abs(b).max(), what)

    def test_are_those_of_the_user_in_the_plane(self):
        """A plane in space, in which vectors are transported as they are."""
        for seed, scale in enumerate(SCALES):
            random = np.random.default_rng(seed)
            V, F = plane(random)
            turn = rotation(random)
            V = scale * V @ turn
            s = it.Surface(V, F)
            frames = s.frames()
            p = random_point(F, random)
            f, k = int(random.integers(len(F))), int(random.integers(3))
            corner, inside = it.Point(f, tuple(np.eye(3)[k])), 14  # a vertex that is not on the border
            for at, where in ((p, p.barycentric @ V[F[p.face]]), (inside, V[inside]),
                              (it.Point(int(np.argwhere(F == inside)[0, 0]),
                                        tuple(map(float, F[np.argwhere(F == inside)[0, 0]] == inside))),
                               V[inside])):
                with self.subTest(scale=scale, at=at):
                    offsets = V - where
                    self.expect_near(s.distance(at), np.linalg.norm(offsets, axis=1), 1e-12)
                    vector = scale * random.normal(size=2) @ turn[:2]
                    moved = s.transport(at, vector).vectors
                    self.expect_near(moved, np.tile(vector, (len(V), 1)), 1e-8, "transport in space")
                    axes = frames.faces[at.face] if isinstance(at, it.Point) else \
                        frames.vertices[at]
                    z = axes @ vector
                    self.expect_near(s.transport(at, z).vectors, moved, 1e-8, "transport")
                    log = s.log_map(at)
                    self.expect_near(log @ axes, offsets, 1e-10, "exact logarithms")
                    step = 0.3 * scale
                    for direction in vector, complex(*z):
                        end = s.trace(at, direction, step).points[-1]
                        self.expect_near(end - where, step * vector / np.linalg.norm(vector), 1e-9,
                                         "trace")
            self.expect_near(s.distance(corner), s.distance(int(F[f][k])), 1e-14)

    def numbers(self, s, scale, turn, points):
        """Results, and the power of the scale that they have."""
        p, q, v, w = points
        yield "lengths", 1, np.sort(s.lengths.ravel())
        yield "mass", 2, s.mass().diagonal()
        for kind in "galerkin", "voronoi":
            yield kind, 2, s.mass(kind).diagonal()
        yield "trace of the Laplacian", 0, [s.laplacian().trace()]
        for method in "exact", "heat":
            yield method, 1, s.distance([p, v], method=method)
            yield method + " at targets", 1, s.distance([p, v], method=method, targets=[q, w])
        yield "distances", 1, s.distances([[p], [v]])
        yield "heat of pairs", 1, s.pair_distances([v], [w], method="heat")
        yield "pairs", 1, s.pair_distances([p, v], [q, w])
        yield "up to", 1, np.nan_to_num(s.distance(p, max_distance=2.2 * scale), posinf=0)
        cells = s.voronoi([p, q], cell_tolerance=0.01 * scale)
        yield "cells", 2, cells.areas
        yield "boundaries", 1, [sum(b.length for b in cells.boundaries)]
        yield "farthest points", 1, [s.farthest_points(4).radius]
        curve = s.path(p, q)
        yield "path", 1, [curve.length, curve.initial_length, *curve.bounds]
        yield "network", 1, [s.network(paths=[[v, w], [p, q]]).length]
        yield "isolines", 1, [sum(line.length for line in s.isolines(s.distance(v), [scale]))]
        yield "cut", 2, [it.Surface(*self.cut(s, [curve])).mass().sum()]
        for method in "exact", "affine", "polar":
            yield "logarithms " + method, 1, s.log_map(p, method=method)
            yield "logarithms of a vertex " + method, 1, s.log_map(v, method=method)
        yield "transport", 1, s.transport([p, v], scale * np.array([[1, 2], [3, -1.]])).coordinates
        in_space = scale * np.array([[1, 2, -1], [0.5, -1., 2]]) @ turn
        yield "transport in space", 1, s.transport([p, v], in_space).lengths
        yield "extend", 0, s.extend([p, v], [1, 2])
        yield "signed distance", 1, s.signed_distance([[0, 5, 20]])
        yield "eigenvalues", -2, s.eigen(3)[0][1:]
        yield "common subdivision", 2, [it.Surface(*self.drawn(s.delaunay())).mass().sum()]
        moved = scale * np.array([[0.3, 0, 1.], [0, 0, 0]]) @ turn
        yield "deformed", 1, (s.deform([v, w], moved)) @ turn.T

    def drawn(self, s):
        c = s.common_subdivision()
        return c.points, c.triangles()[0]

    def cut(self, s, curves):
        pieces = s.cut(curves)
        return pieces.points, pieces.faces

    def test_scale_as_the_surface(self):
        random = np.random.default_rng(3)
        V, F = bumpy(6, seed=4)
        points = random_point(F, random), random_point(F, random), 8, 27
        expected = list(self.numbers(it.Surface(V, F), 1, np.eye(3), points))
        for scale in SCALES:
            turn = rotation(random)
            s = it.Surface(scale * V @ turn, F)
            for (name, power, x), (_, _, y) in zip(
                    expected, self.numbers(s, scale, turn, points), strict=True):
                with self.subTest(scale=scale, name=name):
                    self.expect_near(np.asarray(y) / scale**power, x, 1e-7, name)

    def test_of_criteria_bound_refined_faces(self):
        random = np.random.default_rng(5)
        V, F = bumpy(6, seed=4)
        for scale in SCALES:
            s = it.Surface(scale * V @ rotation(random), F)
            count = s.number_of_vertices
            sizes = np.full(count, scale)
            for t, longest in ((s.refine(max_edge_length=0.6 * scale), 0.6), (s.refine(max_edge_length=sizes), 1)):
                # the longest edges of faces are bounded, and not far below
                self.assertLessEqual(t.lengths.max(), longest * scale * (1 + 1e-12))
                self.assertGreater(t.lengths.max(), longest * scale / 2)
            a, b, c = s.refine(max_circumradius=0.6 * scale).lengths.T
            area = np.sqrt((a + b + c) * (a + b - c) * (b + c - a) * (c + a - b)) / 4
            radius = (a * b * c / (4 * area)).max()
            self.assertLessEqual(radius, 0.6 * scale * (1 + 1e-9))
            self.assertGreater(radius, 0.3 * scale)
            adapted = s.adapt(8, tolerance=0.05).number_of_vertices
            self.assertTrue(count < adapted < 10 * count, adapted)

    def test_areas_that_doubles_spoil_are_an_error(self):
        """A vertex far away: flips with doubles lose the lengths of the other edges."""
        spoilt = 0
        for seed in range(12):
            random = np.random.default_rng(seed)
            V, F = bumpy(6, seed=seed)
            V[14] *= 10.0 ** random.integers(4, 120)
            area = sum(exact_area(*V[f]) for f in F)
            try:
                t = it.Surface(V, F, arithmetic="double").delaunay()
            except (ValueError, RuntimeError) as e:
                spoilt += 1
                self.assertRegex(str(e), "rounding has spoilt.*exact")
            else:
                self.assertLess(abs(t.mass().sum() / area - 1), 1e-5)
            t = it.Surface(V, F).delaunay()
            self.assertLess(abs(t.mass().sum() / area - 1), 1e-9)
        self.assertGreater(spoilt, 0)


if __name__ == "__main__":
    unittest.main()
