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
