# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vectors, maps and functions on clouds of points: closed forms in the plane."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import intrinsic as it
import program


class Clouds(unittest.TestCase):
    def test_vectors_in_the_plane(self):
        rng = np.random.default_rng(1)
        P = np.column_stack([rng.random((200, 2)), np.zeros(200)])
        s = it.points(P)
        field = s.transport(3, [1, 2, 0])
        self.assertLess(np.abs(field.vectors - [1, 2, 0]).max(), 1e-7)
        log = s.log_map(3)
        np.testing.assert_allclose(np.hypot(*log.T), np.linalg.norm(P - P[3], axis=1), atol=1e-9)
        self.assertEqual(s.direction_field(2).coordinates.shape, (200, 2))
        self.assertTrue((s.extend([0, 9], [1, 2]) <= 2).all())
        for call in (lambda: s.log_map(3, method="exact"), lambda: s.direction_field(4, align=0),
                     lambda: s.log_map(200), lambda: s.signed_distance([0, 1])):
            self.assertRaises(ValueError, call)

    def test_maps_of_the_plane(self):
        rng = np.random.default_rng(2)
        P = np.column_stack([rng.random((300, 2)), np.zeros(300)])
        uv = it.points(P).parametrize("spectral").uv
        d = np.linalg.norm(P[:, None] - P[None], axis=2)
        np.testing.assert_allclose(np.linalg.norm(uv[:, None] - uv[None], axis=2), d, atol=1e-6)
        self.assertEqual(it.points(P).eigen(3)[1].shape, (300, 3))
        with self.assertRaisesRegex(ValueError, "spectral"):
            it.points(P).parametrize()


def on_axis(radius, height, turns, rows):
    """Rows of `turns` points about the z axis, at the given radii and heights."""
    i, j = (x.ravel() for x in np.mgrid[:turns, :rows])
    a, r, z = 2 * np.pi * i / turns, radius(j), height(j)
    return np.column_stack([r * np.cos(a), r * np.sin(a), z + 0 * a])


def sphere(turns, rows):
    """Latitudes and longitudes, without poles."""
    step = np.pi / (rows + 1)
    return on_axis(lambda j: np.sin(step * (j + 1)), lambda j: np.cos(step * (j + 1)), turns, rows)


def torus(turns, rows):
    step = 2 * np.pi / rows
    return on_axis(lambda j: 2 + np.cos(step * j), lambda j: np.sin(step * j), turns, rows)


def box(a, b, c):
    return 0.1 * np.array([(x, y, z) for x in range(a) for y in range(b) for z in range(c)
                           if x in (0, a - 1) or y in (0, b - 1) or z in (0, c - 1)])


# Each square has its four corners on a circle, and all points have six neighbours at least.
EVEN = {"grid": np.column_stack([0.1 * x.ravel() for x in np.mgrid[:16, :12]] + [np.zeros(192)]),
        "torus": torus(16, 12), "sphere": sphere(16, 12), "cube": box(6, 6, 6),
        "cylinder": on_axis(lambda j: 1, lambda j: 0.4 * j, 16, 12),
        "long cylinder": on_axis(lambda j: 1, lambda j: 0.26 * j, 24, 12)}


def lattices():
    """Clouds with ties: four neighbours on a circle wherever one looks, or symmetric ones."""
    i, j = (x.ravel() for x in np.mgrid[:16, :12])
    hexagons = np.column_stack([i + 0.5 * j, 0.75**0.5 * j, 0 * j])[(i - j) % 3 != 0]
    x, y = (x.ravel() for x in np.mgrid[:9, :9])
    gold = (1 + 5**0.5) / 2
    icosahedron = [np.roll((0, a, b), k) for a in (1, -1) for b in (gold, -gold) for k in range(3)]
    return {**EVEN, "hexagons": hexagons, "cone": on_axis(lambda j: j + 1, lambda j: j, 12, 5),
            "sphere with many at its holes": sphere(32, 8), "tube of seven": torus(7, 9),
            "fold": np.column_stack([x, np.maximum(y - 4, 0), np.maximum(4 - y, 0)]),
            "bowl": np.column_stack([x, y, 0.05 * ((x - 4)**2 + (y - 4)**2)]),
            "plate": box(9, 4, 3), "octahedron": np.vstack([np.eye(3), -np.eye(3)]),
            "icosahedron": np.array(icosahedron), "cube of eight": box(2, 2, 2)}


def random_clouds(random):
    for k in range(5):
        ball = random.normal(size=(200, 3))
        yield f"ball {k}", ball / np.linalg.norm(ball, axis=1)[:, None]
        yield f"plane {k}", np.column_stack([random.random((200, 2)), np.zeros(200)])


class Ties(unittest.TestCase):
    """Where four points are on a circle, neither rounding nor numbers decide what matrices show."""

    def compare(self, expected, q, order):
        for a, b in zip(expected, (q.laplacian(), q.mass())):
            # weights are cotangents: angles above 1e-3 and coordinates of 10 edges lose 1e-9
            self.assertLess(abs(a[order][:, order] - b).max(), 1e-8 * abs(a).max())

    def test_turned_and_renumbered(self):
        rng = np.random.default_rng(8)
        for neighbors in 10, 30:
            for name, P in [*lattices().items(), *random_clouds(rng)]:
                with self.subTest(cloud=name, neighbors=neighbors):
                    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
                    turn *= np.linalg.det(turn)
                    order = rng.permutation(len(P))
                    p = it.points(P, neighbors=neighbors)
                    expected = p.laplacian(), p.mass()
                    for Q in P[order], P[order] @ turn.T + rng.normal(size=3):
                        self.compare(expected, it.points(Q, neighbors=neighbors), order)

    def test_lattices_are_covered_evenly(self):
        for name, P in EVEN.items():
            with self.subTest(cloud=name):
                triangles = np.sort(it._core.triangles_at_points(P, 30), axis=1)
                copies = np.unique(triangles, axis=0, return_counts=True)[1]
                self.assertEqual(set(copies), {3})

    def test_areas_of_lattices(self):
        def of_rings(P, is_closed):
            """The area of quadrilaterals, and of polygons at the ends."""
            rows = 12
            P = P.reshape(-1, rows, 3)
            Q, R = np.roll(P, -1, axis=0), np.roll(P, -1, axis=1)
            S = np.roll(Q, -1, axis=1)
            return sum(np.linalg.norm(np.cross(b - P, S - P), axis=2)[:, :rows - (not is_closed)]
                       .sum() / 2 for b in (Q, R))

        end = 16 / 2 * np.sin(np.pi / 8) * np.sin(np.pi / 13)**2  # a polygon around a pole
        areas = {"grid": 1.65, "torus": of_rings(EVEN["torus"], True), "cube": 1.5,
                 "sphere": of_rings(EVEN["sphere"], False) + 2 * end,
                 "cylinder": 32 * np.sin(np.pi / 16) * 4.4,
                 "long cylinder": 48 * np.sin(np.pi / 24) * 2.86}
        for name, area in areas.items():
            found = it.points(EVEN[name]).mass().diagonal()
            with self.subTest(cloud=name):
                self.assertAlmostEqual(found.sum() / area, 1, delta=1e-12)
                self.assertGreater(found.min(), 0)


@unittest.skipUnless(program.is_there(), "the program or its meshes are missing")
class Few_points(unittest.TestCase):
    def test_distances_end_and_are_a_metric(self):
        """Stars of few points glue a triangle to others that are glued to more of them: fans that
        followed such sides had no end."""
        for seed in range(40):
            rng = np.random.default_rng(seed)
            sphere = rng.normal(size=(24, 3))
            for P in (rng.random((rng.integers(8, 24), 3)),
                      sphere / np.linalg.norm(sphere, axis=1)[:, None]):
                with self.subTest(seed=seed, points=len(P)):
                    s = it.points(P)
                    D = np.array([s.distance(k) for k in range(len(P))])
                    chords = np.linalg.norm(P[:, None] - P, axis=2)
                    self.assertTrue(np.all(D >= chords - 1e-12))
                    known = np.isfinite(D)
                    np.testing.assert_array_equal(known, known.T)
                    np.testing.assert_allclose(D[known], D.T[known], atol=1e-12)

    def test_distances_are_those_on_its_faces(self):
        """The same triangles, given as faces. In a cloud each comes from the star of a point."""
        for seed in range(10):
            rng = np.random.default_rng(seed)
            P = rng.random((rng.integers(20, 60), 3))
            s = it.points(P)
            faces = it.Surface(P, np.unique(np.sort(s.faces, axis=1), axis=0))
            d = s.distance(0)
            np.testing.assert_allclose(d, faces.distance(0), rtol=1e-12)
            for v in np.flatnonzero(np.isfinite(d))[1:6]:
                with self.subTest(seed=seed, target=v):
                    path = s.path(0, int(v))
                    self.assertEqual(path.status, "done")
                    pieces = np.linalg.norm(np.diff(path.points, axis=0), axis=1)
                    self.assertAlmostEqual(pieces.sum(), d[v], delta=1e-9)


class As_the_program(unittest.TestCase):
    def test_vectors_and_functions(self):
        path, points, _ = program.mesh("hand.off")
        options = "--domain", "points", "--neighbors", 12
        with tempfile.TemporaryDirectory() as folder:
            def expected(command, *more):
                program.run(command, path, *options, *more, "-o", Path(folder) / "x.txt")
                return np.genfromtxt(Path(folder) / "x.txt")

            s = it.points(points, neighbors=12)
            np.testing.assert_array_equal(s.log_map(3), expected("logmap", "--source", 3))
            (Path(folder) / "v.txt").write_text("3 0 2\n")
            found = s.transport(3, [2, 0])
            there = expected("transport", "--vectors", Path(folder) / "v.txt")
            np.testing.assert_array_equal(found.coordinates, there[:, 1:3])
            np.testing.assert_array_equal(found.axes, there[:, 3:6])
            field = s.direction_field(2)
            there = expected("field", "--degree", 2)
            np.testing.assert_array_equal(field.coordinates, there[:, :2])
            self.assertEqual((len(field.singularities), field.index_sum), (0, 0))


if __name__ == "__main__":
    unittest.main()
