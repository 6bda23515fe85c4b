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


def lattices():
    """Clouds with ties: four neighbours on a circle wherever one looks."""
    i, j = (x.ravel() for x in np.mgrid[:16, :12])
    u, v, w = i * np.pi / 8, j * np.pi / 6, (j + 1) * np.pi / 13
    ring = (np.cos(u), np.sin(u))
    side = np.array([(x, y, z) for x in range(6) for y in range(6) for z in range(6)
                     if {x, y, z} & {0, 5}])
    hexagons = np.column_stack([i + 0.5 * j, 0.75**0.5 * j, 0 * j])[(i - j) % 3 != 0]
    return {"grid": np.column_stack([0.1 * i, 0.1 * j, 0 * i]), "hexagons": hexagons,
            "torus": np.column_stack([(2 + np.cos(v)) * ring[0], (2 + np.cos(v)) * ring[1],
                                      np.sin(v)]),
            "sphere": np.column_stack([np.sin(w) * ring[0], np.sin(w) * ring[1], np.cos(w)]),
            "cylinder": np.column_stack([ring[0], ring[1], 0.4 * j]), "cube": 0.1 * side}


class Ties(unittest.TestCase):
    """Where four points are on a circle, rounding decides nothing that matrices show."""

    def compare(self, P, Q, order, neighbors):
        for matrix in (it.Surface.laplacian, it.Surface.mass):
            a, b = (matrix(it.points(x, neighbors=neighbors)) for x in (P, Q))
            # weights are cotangents: angles above 1e-3 and coordinates of 10 edges lose 1e-9
            self.assertLess(abs(a[order][:, order] - b).max(), 1e-8 * abs(a).max())

    def test_turned_and_renumbered(self):
        rng = np.random.default_rng(8)
        sphere = rng.normal(size=(200, 3))
        random = {"plane": np.column_stack([rng.random((200, 2)), np.zeros(200)]),
                  "ball": sphere / np.linalg.norm(sphere, axis=1)[:, None]}
        for neighbors in 10, 30:
            for name, P in {**lattices(), **random}.items():
                with self.subTest(cloud=name, neighbors=neighbors):
                    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
                    Q = P @ turn.T + rng.normal(size=3)
                    self.compare(P, Q, np.arange(len(P)), neighbors)
                    if name in RENUMBERED:
                        order = rng.permutation(len(P))
                        self.compare(P, Q[order], order, neighbors)

    def test_areas_of_lattices(self):
        # of the quadrilaterals: a ring about the axis has the lengths of its two polygons
        P = lattices()["torus"].reshape(16, 12, 3)
        Q = np.roll(P, -1, axis=0)
        R = np.roll(P, -1, axis=1)
        S = np.roll(Q, -1, axis=1)
        area = sum(np.linalg.norm(np.cross(b - P, S - P), axis=2).sum() / 2 for b in (Q, R))
        found = it.points(P.reshape(-1, 3)).mass().diagonal()
        self.assertAlmostEqual(found.sum() / area, 1, delta=1e-12)
        self.assertGreater(found.min(), 0)


# Others have symmetries: their borders and edges are no manifold, and copies of faces there are
# alike, so that numbers choose.
RENUMBERED = "grid", "hexagons", "torus", "plane", "ball"


@unittest.skipUnless(program.is_there(), "the program or its meshes are missing")
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
