# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Planes, spheres, cones and tori of random size at random places: what formulas say, by exact
methods and by heat."""

import unittest

import numpy as np

import intrinsic as it


def rotation(random):
    q, r = np.linalg.qr(random.normal(size=(3, 3)))
    q *= np.sign(np.diag(r))
    q[:, 0] *= np.linalg.det(q)
    return q


def placed(V, random):
    """The vertices at a random place, and the scale, between 1e-6 and 1e6."""
    scale = 10.0 ** random.uniform(-6, 6)
    return scale * (V @ rotation(random).T + random.uniform(-3, 3, 3)), scale


def random_square(random, n):
    """A unit square with n * n random vertices inside, and others on its border."""
    from scipy.spatial import Delaunay

    side = np.linspace(0, 1, n + 1)[:-1]
    zero, one = np.zeros(n), np.ones(n)
    border = np.vstack([np.column_stack(c) for c in
                        ((side, zero), (one, side), (1 - side, one), (zero, 1 - side))])
    P = np.vstack([border, random.uniform(0.1 / n, 1 - 0.1 / n, (n * n, 2))])
    return P, Delaunay(P).simplices


def sphere(random, n):
    """The convex hull of n random points on the unit sphere, its triangles counterclockwise."""
    from scipy.spatial import ConvexHull

    V = random.normal(size=(n, 3))
    V /= np.linalg.norm(V, axis=1)[:, None]
    F = ConvexHull(V).simplices
    inward = np.einsum("fk,fk->f", np.cross(V[F[:, 0]], V[F[:, 1]]), V[F[:, 2]]) < 0
    F[inward] = F[inward][:, ::-1]
    return V, F


def cone(rings, sides, height):
    """A cone with a regular polygon as its base, cut into rings, and its angle at the apex."""
    a = 2 * np.pi * np.arange(sides) / sides
    V = np.vstack([[[0, 0, height]]] + [
        np.column_stack([r * np.cos(a), r * np.sin(a), np.full(sides, height * (1 - r))])
        for r in np.arange(1, rings + 1) / rings])
    i = np.arange(sides)
    j = (i + 1) % sides
    F = [np.column_stack([0 * i, 1 + i, 1 + j])]
    for k in range(rings - 1):
        a, b = 1 + k * sides, 1 + (k + 1) * sides
        F += [np.column_stack([a + i, b + i, b + j]), np.column_stack([a + i, b + j, a + j])]
    return V, np.vstack(F)


def flat_torus(n, m):
    """A flat torus of n by m squares of side 1: the faces and lengths of an abstract surface."""
    i, j = (a.ravel() for a in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    def v(i, j):
        return i % n * m + j % m
    a, b, c, d = v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1)
    F = np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    ones, diagonal = np.ones(n * m), np.full(n * m, np.sqrt(2))
    return F, np.vstack([np.column_stack([ones, ones, diagonal]),
                         np.column_stack([diagonal, ones, ones])])


class Random_places(unittest.TestCase):
    def surfaces(self, make, count=4):
        for seed in range(count):
            random = np.random.default_rng(seed)
            V, F, *more = make(random)
            placed_V, scale = placed(V, random)
            with self.subTest(seed=seed):
                yield random, it.Surface(placed_V, F), V, F, scale, *more


class Planes(Random_places):
    def squares(self):
        def make(random):
            P, F = random_square(random, 12)
            return np.column_stack([P, 0 * P[:, 0]]), F

        return self.surfaces(make)

    def test_distances_and_logarithms_are_those_of_the_plane(self):
        for random, s, V, F, scale in self.squares():
            f = random.integers(len(F))
            p = it.Point(int(f), tuple(random.dirichlet((1, 1, 1))))
            for source, x in (p, np.array(p.barycentric) @ V[F[f]]), (60, V[60]):
                d = np.linalg.norm(V - x, axis=1)
                np.testing.assert_allclose(s.distance(source) / scale, d, atol=1e-9)
                heat = s.distance(source, method="heat") / scale
                self.assertLess(np.abs(heat - d).mean(), 0.08)
                for method in "exact", "affine":  # exact in the plane, both
                    z = s.log_map(source, method=method) / scale
                    np.testing.assert_allclose(np.hypot(*z.T), d, atol=1e-7)
            a, b = random.integers(len(V), size=(2, 50))
            np.testing.assert_allclose(s.pair_distances(a, b) / scale,
                                       np.linalg.norm(V[a] - V[b], axis=1), atol=1e-9)

    def test_isolines_of_linear_functions_are_straight(self):
        for random, s, V, F, scale in self.squares():
            n = random.normal(size=2)
            n /= np.linalg.norm(n)
            u = V[:, :2] @ n
            level = (V[:, :2].mean(axis=0) + random.uniform(-0.2, 0.2, 2)) @ n
            line, = s.isolines(u, [level])
            # the part of the line in the square
            t = [(x - level * n[k]) / (n[1], -n[0])[k] for k in range(2) for x in (0, 1)]
            first, last = max(min(t[:2]), min(t[2:])), min(max(t[:2]), max(t[2:]))
            self.assertAlmostEqual(line.length / scale, abs(last - first), 9)
            self.assertEqual(line.status, "done")
            left = s.signed_distance(line) / scale  # negative where values are larger
            np.testing.assert_allclose(np.sign(left)[np.abs(u - level) > 0.1],
                                       np.sign(level - u)[np.abs(u - level) > 0.1])

    def test_matrices_know_areas_and_linear_functions(self):
        for random, s, V, F, scale in self.squares():
            for kind in "lumped", "galerkin", "voronoi":
                self.assertAlmostEqual(s.mass(kind).sum() / scale**2, 1, 9)
            L, M = s.laplacian(), s.mass("galerkin")
            u = V[:, :2] @ [3, 4]
            self.assertAlmostEqual(u @ (L @ u), 25, 8)
            self.assertAlmostEqual(u @ (M @ u) / scale**2, 9 / 3 + 16 / 3 + 2 * 12 / 4, 8)
            inside = (V[:, :2] % 1 != 0).all(axis=1)
            np.testing.assert_allclose((L @ u)[inside], 0, atol=1e-9)

    def test_parallel_fields_and_conformal_maps_are_those_of_the_plane(self):
        for random, s, V, F, scale in self.squares():
            field = s.transport(60, [1, 0])
            self.assertLess(np.ptp(field.vectors, axis=0).max(), 1e-7)
            z = V[:, :2] @ [1, 1j]
            for method in "lscm", "spectral":
                w = s.parametrize(method).uv @ [1, 1j]
                A = np.column_stack([z, np.ones_like(z)])
                rest = np.linalg.lstsq(A, w, rcond=None)[1]
                self.assertLess(np.sqrt(rest[0]) / scale, 1e-5)


class Curved(Random_places):
    def test_spheres_have_their_distances_and_eigenvalues(self):
        for random, s, V, F, scale in self.surfaces(lambda random: sphere(random, 2500), 2):
            angle = np.arccos(np.clip(V @ V[7], -1, 1))
            exact = s.distance(7) / scale
            self.assertLess(np.abs(exact - angle).max(), 0.01)
            self.assertTrue((exact <= angle + 1e-9).all())  # chords are shorter
            self.assertLess(np.abs(s.distance(7, method="heat") / scale - angle).mean(), 0.05)
            values, functions = s.eigen(9)
            np.testing.assert_allclose(values * scale**2, [0] + [2] * 3 + [6] * 5, atol=0.06)
            M = s.mass()
            np.testing.assert_allclose(functions.T @ (M @ functions), np.eye(9), atol=1e-8)
            r = np.hypot(*s.log_map(7).T) / scale
            np.testing.assert_allclose(r, exact, atol=1e-9)

    def test_distances_move_no_farther_than_their_source(self):
        random = np.random.default_rng(51)
        for _ in range(60):
            V, F = sphere(random, random.integers(5, 12))
            V = V * 10.0 ** random.uniform(-1, 0, 3)
            s, f, k = it.Surface(V, F), int(random.integers(len(F))), random.integers(3)
            F = s.faces  # hulls have faces that were turned around
            w = np.zeros(3)
            w[[k - 1, k - 2]] = random.uniform(0, 0.5, 2) * 10.0 ** random.integers(-18, 0, 2)
            w[k] = 1 - w.sum()
            moved = np.linalg.norm(w @ V[F[f]] - V[F[f][k]])
            change = np.abs(s.distance(it.Point(f, tuple(w))) - s.distance(int(F[f][k])))
            self.assertLessEqual(change.max(), moved + 1e-12)

    def test_an_exact_corner_is_a_vertex(self):
        V = np.array([[-.6, 1.1, .2], [-.4, 0, -.3], [1, 2, -3.3], [-.4, 1, 5.6], [.5, -.6, -1.6]])
        s = it.Surface(V, [[3, 1, 4], [3, 0, 1], [2, 4, 1], [2, 1, 0], [2, 3, 4], [2, 0, 3]])
        np.testing.assert_allclose(s.distance(it.Point(5, (0, 1, 0))), s.distance(0), rtol=1e-13)

    def test_cones_turn_vectors_by_their_angle(self):
        for height in 0.3, 1, 4:
            V, F = cone(6, 24, height)
            random = np.random.default_rng(3)
            placed_V, scale = placed(V, random)
            s = it.Surface(placed_V, F)
            ring = s.distance(0)[1:].reshape(6, 24) / scale
            side = np.hypot(1, height)
            np.testing.assert_allclose(ring, side * np.arange(1, 7)[:, None] / 6 * np.ones(24),
                                       rtol=1e-9)
            whole = 24 * 2 * np.arcsin(np.sin(np.pi / 24) / side)  # the angle at the apex
            # on the developed cone, vertices that are less than half a turn apart see each other
            k = np.arange(24)
            turn = whole / 24 * np.minimum(k, 24 - k)
            r = side * 3 / 6
            apart = np.where(turn < np.pi, 2 * r * np.sin(np.minimum(turn, np.pi) / 2), 2 * r)
            np.testing.assert_allclose(s.distance(49)[49:73] / scale, apart, rtol=1e-9, atol=1e-9)
            # a vector that is carried around the apex along edges turns by what is missing there
            angles, glue, corner = s.frames().angles, s.delaunay().glue, s.delaunay().faces
            turns = np.exp(1j * (angles[tuple(glue.transpose(2, 0, 1))] + np.pi - angles))
            other = np.roll(corner, -1, axis=1)
            step = {(i, j): z for i, j, z in zip(corner.ravel(), other.ravel(), turns.ravel())}
            around = np.prod([step[1 + i, 1 + (i + 1) % 24] for i in range(24)])
            self.assertLess(abs(around - np.exp(1j * (2 * np.pi - whole))), 1e-9)

    def test_flat_tori_have_their_distances_and_eigenvalues(self):
        n, m = 9, 7
        F, lengths = flat_torus(n, m)
        for scale in 1e-5, 1, 1e5:
            s = it.Surface(None, F, lengths=scale * lengths)
            i, j = np.divmod(np.arange(n * m), m)
            d = np.hypot(np.minimum(i, n - i), np.minimum(j, m - j))
            np.testing.assert_allclose(s.distance(0) / scale, d, rtol=1e-12)
            z = s.log_map(0) / scale
            np.testing.assert_allclose(np.hypot(*z.T), d, rtol=1e-12)
            k, l = (a.ravel() for a in np.meshgrid(np.arange(n), np.arange(m)))
            exact = np.sort(4 - 2 * np.cos(2 * np.pi * k / n) - 2 * np.cos(2 * np.pi * l / m))
            values = s.eigen(12)[0] * scale**2
            np.testing.assert_allclose(values, exact[:12], atol=1e-9)
            field = s.direction_field(1)
            self.assertEqual(field.index_sum, 0)
            self.assertEqual(len(field.singularities), 0)
            self.assertAlmostEqual(s.loop([0, 2, 5]).length / scale, 7, 12)  # around the torus
            self.assertEqual(s.loop([0, 1, m]).status, "contracted")


if __name__ == "__main__":
    unittest.main()
