# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vectors and signed distances wherever a point is: on sheets of covers, at edges, vertices and
borders, beside faces without area; by closed forms and by other descriptions of one surface."""

import unittest

import numpy as np

import intrinsic as it
from support import BOOK, TETRAHEDRON, bumpy, grid

SEED = 50


def sphere(levels=1, random=None):
    """An icosphere with vertices moved at random on the unit sphere."""
    t = (1 + 5 ** 0.5) / 2
    V = np.array([[0, 1, t], [0, -1, t], [0, 1, -t], [0, -1, -t], [1, t, 0], [-1, t, 0], [1, -t, 0],
                  [-1, -t, 0], [t, 0, 1], [t, 0, -1], [-t, 0, 1], [-t, 0, -1]])
    d = np.linalg.norm(V[:, None] - V, axis=2)
    F = [[i, j, k] for i in range(12) for j in range(i) for k in range(j)
         if max(d[i, j], d[j, k], d[k, i]) < 2.1]
    F = np.array([f if np.linalg.det(V[f]) > 0 else f[::-1] for f in F])
    for _ in range(levels):
        middle, V, faces = {}, list(V), []
        for f in F:
            m = []
            for a, b in zip(f, np.roll(f, -1)):
                key = min(a, b), max(a, b)
                if key not in middle:
                    middle[key] = len(V)
                    V.append((V[a] + V[b]) / 2)
                m.append(middle[key])
            faces += [[f[0], m[0], m[2]], [m[0], f[1], m[1]], [m[2], m[1], f[2]], m]
        V = np.array(V)
        V /= np.linalg.norm(V, axis=1)[:, None]
        F = np.array(faces)
    if random is not None:
        V = V + random.uniform(-0.08, 0.08, V.shape)
    return V / np.linalg.norm(V, axis=1)[:, None], F


def moebius_strip(random, n=11):
    """A strip of triangles in space, an odd number, closed with half a twist."""
    k = np.arange(n)
    a = 2 * np.pi * (k + random.uniform(-0.1, 0.1, n)) / n
    h = np.where(k % 2, 0.4, -0.4) * random.uniform(0.8, 1.2, n)
    r = 2 + h * np.cos(a / 2)
    V = np.column_stack([r * np.cos(a), r * np.sin(a), h * np.sin(a / 2)])
    return V, np.column_stack([k, (k + 1) % n, (k + 2) % n])


def with_fins(V, F, random, count=2):
    """Adds triangles at edges, each with a new vertex."""
    V, F = list(np.array(V, dtype=float)), list(F)
    for f in random.choice(len(F), count, replace=False):
        i, j = F[f][:2]
        F.append([i, j, len(V)])
        V.append((V[i] + V[j]) / 2 + random.normal(size=3) * 0.3)
    return np.array(V, dtype=float), np.array(F)


def turned_at_random(F, random):
    """The same triangles, some of them turned around."""
    return np.array([f[::-1] if random.random() < 0.5 else f for f in F])


def rotation(random):
    q, r = np.linalg.qr(random.normal(size=(3, 3)))
    return q * np.sign(np.linalg.det(q))


def soups(random):
    for _ in range(3):
        yield moebius_strip(random)
        yield with_fins(*TETRAHEDRON, random, 1)
        yield with_fins(*sphere(1, random), random)
    yield BOOK


class Covers(unittest.TestCase):
    def test_logarithms_are_as_long_as_shortest_paths(self):
        random = np.random.default_rng(SEED)
        for V, F in [*soups(random), *(moebius_strip(random) for _ in range(5))]:
            s = it.Surface(V, F)
            for v in random.choice(len(V), 3, replace=False):
                length, distance = np.hypot(*s.log_map(v).T), s.distance(v)
                self.assertTrue(np.isfinite(length).all())
                np.testing.assert_allclose(length, distance, rtol=1e-9, atol=1e-12)

    def test_logarithms_on_a_tufted_sphere_are_those_on_the_sphere(self):
        random = np.random.default_rng(SEED + 1)
        for _ in range(3):
            V, F = sphere(1, random)
            s, tufted = it.Surface(V, F), it.Surface(V, F, domain="tufted")
            for v in random.choice(len(V), 3, replace=False):
                for method in ("exact", "affine"):
                    z, w = s.log_map(v, method=method), tufted.log_map(v, method=method)
                    # up to a turn, or a reflection: the inner products
                    np.testing.assert_allclose(w @ w.T, z @ z.T, atol=1e-8)

    def test_traces_along_logarithms_end_at_vertices(self):
        random = np.random.default_rng(SEED + 2)
        for _ in range(5):
            V, F = with_fins(*sphere(0, random), random, 2)
            s = it.Surface(V, F)
            v = int(random.integers(12))
            ends = 0
            z = s.log_map(v)
            others = [w for w in range(len(V)) if w != v]
            for w in others:
                end = s.trace(v, complex(*z[w]), np.hypot(*z[w])).points[-1]
                ends += np.linalg.norm(end - V[w]) < 1e-6
            self.assertGreaterEqual(ends, len(others) - 2)  # but where paths bend at a fin

    def test_extended_values_do_not_depend_on_sides_of_faces(self):
        random = np.random.default_rng(SEED + 3)
        for V, F in soups(random):
            at = random.choice(len(V), 3, replace=False)
            values = random.normal(size=3)
            s, other = it.Surface(V, F), it.Surface(V, turned_at_random(F, random))
            x = s.extend(at, values)
            self.assertTrue(np.isfinite(x).all())
            self.assertTrue(values.min() - 1e-9 <= x.min() and x.max() <= values.max() + 1e-9)
            np.testing.assert_allclose(other.extend(at, values), x, atol=1e-8)

    def test_transported_vectors_do_not_depend_on_sides_of_faces(self):
        random = np.random.default_rng(SEED + 4)
        for _ in range(3):
            V, F = with_fins(*sphere(1, random), random)
            at, vectors = random.choice(42, 2, replace=False), random.normal(size=(2, 3))
            vectors -= np.sum(vectors * V[at], axis=1)[:, None] * V[at]
            s, other = it.Surface(V, F), it.Surface(V, turned_at_random(F, random))
            x, y = s.transport(at, vectors), other.transport(at, vectors)
            self.assertTrue(np.isfinite(x.vectors).all())
            body = np.setdiff1d(np.arange(42), F[len(F) - 2:])  # without the edges of fins
            np.testing.assert_allclose(y.vectors[body], x.vectors[body], atol=1e-6)
            np.testing.assert_allclose(np.linalg.norm(x.axes, axis=1), 1, rtol=1e-9)


class Places(unittest.TestCase):
    """Logarithms by heat from points on edges and beside vertices."""

    @staticmethod
    def edge(F, random):
        """An edge, both of its faces, and the places of its ends in them."""
        f = random.integers(len(F))
        i, j = F[f][:2]
        g = next(g for g in range(len(F)) if g != f and i in F[g] and j in F[g])
        return f, g, [[list(F[h]).index(k) for k in (i, j)] for h in (f, g)]

    @staticmethod
    def along(V, F, f, ends):
        """The direction of an edge in the frame of a face: a complex number."""
        x = V[F[f]]
        e = x[1] - x[0]
        e /= np.linalg.norm(e)
        n = np.cross(e, x[2] - x[0])
        d = x[ends[1]] - x[ends[0]]
        d /= np.linalg.norm(d)
        return d @ e + 1j * (d @ np.cross(n / np.linalg.norm(n), e))

    def test_both_faces_of_an_edge_give_the_same(self):
        random = np.random.default_rng(SEED + 5)
        for V, F in (sphere(1, random), bumpy(6), grid(5)):
            s = it.Surface(V, F)
            for method in ("affine", "polar"):
                for _ in range(4):
                    try:
                        f, g, ends = self.edge(F, random)
                    except StopIteration:  # at the border
                        continue
                    x = random.uniform(0.1, 0.9)
                    found = []
                    for face, (i, j) in zip((f, g), ends):
                        w = np.zeros(3)
                        w[i], w[j] = 1 - x, x
                        z = s.log_map(it.Point(int(face), tuple(w)), method=method) @ [1, 1j]
                        found.append(z / self.along(V, F, face, (i, j)))
                    np.testing.assert_allclose(found[1], found[0], atol=1e-8)

    def test_points_beside_places_tend_to_them(self):
        random = np.random.default_rng(SEED + 6)
        for V, F in (sphere(1, random), bumpy(6)):
            s = it.Surface(V, F)
            for method in ("affine", "polar"):
                for _ in range(4):
                    f = int(random.integers(len(F)))
                    on_edge = np.array([random.uniform(0.2, 0.8), 0, 0])
                    on_edge[1] = 1 - on_edge[0]
                    for w in on_edge, np.array([1.0, 0, 0]):
                        there = s.log_map(it.Point(f, tuple(w)), method=method)
                        d = w + 1e-13 * (np.ones(3) / 3 - w)
                        beside = s.log_map(it.Point(f, tuple(d)), method=method)
                        # squares of lengths are continuous; directions are torn behind a vertex
                        np.testing.assert_allclose(np.hypot(*beside.T), np.hypot(*there.T),
                                                   atol=1e-6)
                        near = slice(None) if w is on_edge else F[f][1:]
                        np.testing.assert_allclose(beside[near], there[near], atol=1e-6)

    def test_logarithms_of_points_in_the_plane_are_as_accurate_as_those_of_vertices(self):
        random = np.random.default_rng(SEED + 7)
        V, F = grid(9)
        inside = (V[:, :2] % 8 != 0).all(axis=1)
        V = V + inside[:, None] * random.uniform(-0.25, 0.25, V.shape) * [1, 1, 0]
        s = it.Surface(V, F)

        def error(p, place, method):
            found = np.hypot(*s.log_map(p, method=method).T)
            return np.abs(found - np.linalg.norm(V - place, axis=1))

        of_corners, of_points = [], []
        for f in random.choice(len(F), 12, replace=False):
            w = random.dirichlet([1, 1, 1])
            p, place = it.Point(int(f), tuple(w)), w @ V[F[f]]
            of_points.append(error(p, place, "polar").mean())
            of_corners.append(w @ [error(v, V[v], "polar").mean() for v in F[f]])
            self.assertLess(error(p, place, "affine").max(), 1e-7)
        self.assertLess(np.mean(of_points), 1.3 * np.mean(of_corners))

    def test_sides_of_a_face_have_their_directions_at_its_corners(self):
        random = np.random.default_rng(SEED + 8)
        for V, F in (TETRAHEDRON, sphere(0, random), sphere(1, random), bumpy(5)):
            V, F = np.array(V, dtype=float), np.array(F)
            s = it.Surface(V, F)
            for f in random.choice(len(F), 4, replace=False):
                x = V[F[f]]
                e = (x[1] - x[0]) / np.linalg.norm(x[1] - x[0])
                n = np.cross(e, x[2] - x[0])
                axes = np.array([e, np.cross(n / np.linalg.norm(n), e)])
                for k in range(3):
                    z = s.log_map(it.Point(int(f), tuple(np.eye(3)[k])))
                    for other in (k + 1) % 3, (k + 2) % 3:
                        side = x[other] - x[k]
                        if s.distance(int(F[f][k]))[F[f][other]] > (1 - 1e-9) * np.linalg.norm(side):
                            np.testing.assert_allclose(z[F[f][other]], axes @ side, atol=1e-9)


class Signed_distances(unittest.TestCase):
    def test_curves_along_edges_in_the_plane(self):
        """A square around the middle: the distance is known."""
        random = np.random.default_rng(SEED + 9)
        y, x = np.divmod(np.arange(25), 5)
        V = np.column_stack([y, x, 0 * x]).astype(float)
        a = np.array([5 * j + i for j in range(4) for i in range(4)])
        F = np.concatenate([np.column_stack([a, a + 1, a + 6]), np.column_stack([a, a + 6, a + 5])])
        loop = [6, 8, 18, 16, 6]
        turns = [np.eye(3), np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])]
        for turn in turns + [rotation(random) for _ in range(10)]:
            s = it.Surface(V @ turn.T, F)
            d = s.signed_distance([s.path(i, j) for i, j in zip(loop, loop[1:])])
            np.testing.assert_allclose(s.signed_distance([loop]), d, atol=1e-9)
            self.assertLess(abs(abs(d[24]) - 2 ** 0.5), 0.3)  # heat on a coarse grid
            self.assertEqual(len(set(np.sign(d[[0, 4, 20, 24]]))), 1)
            self.assertLess(d[12] * d[24], 0)

    def test_curves_do_not_depend_on_the_position_in_space(self):
        random = np.random.default_rng(SEED + 10)
        for _ in range(6):
            V, F = grid(7)
            V = V + random.uniform(-0.3, 0.3, V.shape) * [1, 1, 0.5]
            s, other = it.Surface(V, F), it.Surface(V @ rotation(random).T, F)
            for i, j in random.choice(49, (3, 2), replace=False):
                d, e = s.signed_distance(s.path(i, j)), other.signed_distance(other.path(i, j))
                np.testing.assert_allclose(e, d, atol=1e-7)

    def test_paths_and_lists_of_vertices_along_edges_give_the_same(self):
        random = np.random.default_rng(SEED + 11)
        V, F = sphere(1, random)
        s = it.Surface(V, F)
        for _ in range(4):
            way = [int(random.integers(42))]
            while len(way) < 5:
                i = way[-1]
                near = [j for j in set(F[(F == i).any(axis=1)].ravel()) - set(way)
                        if s.distance(i)[j] > np.linalg.norm(V[i] - V[j]) * (1 - 1e-9)]
                way.append(int(random.choice(sorted(near))))
            curve = [s.path(i, j) for i, j in zip(way, way[1:])]
            np.testing.assert_allclose(s.signed_distance(curve), s.signed_distance(way), atol=1e-9)

    def test_distances_from_points_on_edges_do_not_depend_on_the_face(self):
        random = np.random.default_rng(SEED + 12)
        V, F = sphere(1, random)
        s = it.Surface(V, F)
        for _ in range(4):
            f, g, ends = Places.edge(F, random)
            found = []
            for face, (i, j) in zip((f, g), ends):
                w = np.zeros(3)
                w[i], w[j] = 0.25, 0.75
                found.append(s.distance(it.Point(int(face), tuple(w)), method="heat"))
            np.testing.assert_allclose(found[1], found[0], atol=1e-8)


class Borders(unittest.TestCase):
    def setUp(self):
        self.random = np.random.default_rng(SEED + 13)
        self.V, self.F = grid(5)
        self.border = [v for v in range(25) if (self.V[v, :2] % 4 == 0).any()]

    def surfaces(self):
        """The square, in planes in space, with the vectors that point out at a border vertex."""
        for _ in range(12):
            turn, v = rotation(self.random), int(self.random.choice(self.border))
            out = np.sum([d for d in np.vstack([np.eye(2), -np.eye(2)])
                          if not (abs(self.V[v, :2] + d - 2) <= 2).all()], axis=0)
            angle = self.random.uniform(-1, 1) * (np.pi / 4 if np.abs(out).sum() < 2 else np.pi / 2)
            c, s = np.cos(angle), np.sin(angle)
            vector = np.array([*(np.array([[c, -s], [s, c]]) @ out), 0])
            yield it.Surface(self.V @ turn.T, self.F), v, turn @ vector / np.linalg.norm(vector)

    def test_vectors_out_of_the_surface_are_transported_as_they_are(self):
        for s, v, vector in self.surfaces():
            field = s.transport(v, 2 * vector)
            np.testing.assert_allclose(field.vectors, np.tile(2 * vector, (25, 1)), atol=1e-8)

    def test_fixed_directions_out_of_the_surface_stay(self):
        for s, v, vector in self.surfaces():
            field = s.direction_field(1, fixed=(v, vector))
            np.testing.assert_allclose(field.vectors[0][v], vector, atol=1e-9)

    def test_traces_out_of_the_surface_end_at_once(self):
        for s, v, vector in self.surfaces():
            curve = s.trace(v, vector, 1.0)
            self.assertEqual((curve.status, curve.length), ("border", 0))
            np.testing.assert_allclose(curve.points[-1], s.points[v], atol=1e-12)
            middle = s.points[12] - s.points[v]  # of the square
            self.assertEqual(s.trace(v, middle, 0.01).status, "done")


class Faces_without_area(unittest.TestCase):
    def test_axes_are_defined(self):
        V = [[0, 0, 0], [0, 0, 0], [0, 1, 0], [1, 1, 0], [2, 0, 3]]
        s = it.Surface(V, [[0, 1, 2], [1, 3, 2], [1, 4, 3]])
        field = s.direction_field(4)
        self.assertTrue(np.isfinite(field.axes).all())
        self.assertTrue(np.isfinite(field.vectors).all())
        np.testing.assert_allclose(np.linalg.norm(field.axes, axis=1), 1, rtol=1e-9)

    def test_thin_faces_at_random(self):
        random = np.random.default_rng(SEED + 14)
        for _ in range(10):
            V, F = grid(5)
            V = V + random.uniform(-0.2, 0.2, V.shape)
            f = F[random.integers(len(F))]
            i, j, k = random.permutation(f)
            V[k] = V[i] if random.random() < 0.5 else (V[i] + V[j]) / 2
            s = it.Surface(V, F)
            axes = s.frames().vertices
            np.testing.assert_allclose(np.linalg.norm(axes, axis=2), 1, rtol=1e-6)
            self.assertTrue(np.isfinite(s.direction_field(2).vectors).all())


if __name__ == "__main__":
    unittest.main()
