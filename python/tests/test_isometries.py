# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Isometries and hashes of surfaces."""

import pickle
import unittest

import intrinsic as it
import numpy as np

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
QUADS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


def renumbered(points, faces, seed):
    order = np.random.default_rng(seed).permutation(len(points))
    place = np.argsort(order)
    return it.Surface(points[order], [[int(place[v]) for v in f] for f in faces])


class Isometries(unittest.TestCase):
    def test_cube_has_48_symmetries(self):
        cube = it.Surface(CUBE, QUADS)
        found = cube.isometries()
        self.assertEqual((found.answer, len(found), len(found.maps)), ("isometric", 48, 48))
        self.assertEqual(found.largest_difference, 0)
        self.assertTrue(found)
        images = {tuple(m.vertices.tolist()) for m in found.maps}
        self.assertEqual(len(images), 48)
        self.assertEqual(sum(m.reverses_orientation for m in found.maps), 24)
        with self.assertRaises(IndexError):
            found.maps[48]

    def test_maps_take_points_along(self):
        cube, other = it.Surface(CUBE, QUADS).refine(), renumbered(CUBE[:, [1, 2, 0]], QUADS, 3)
        for m in cube.isometries(other).maps[:8]:
            faces, weights = m.points(np.arange(8))
            corners = [other._core.number_of_input_faces > f for f in faces]
            self.assertTrue(all(corners))
            np.testing.assert_allclose(np.sort(weights, axis=1), [[0, 0, 1]] * 8, atol=1e-9)

    def test_results_can_be_pickled(self):
        found = pickle.loads(pickle.dumps(it.Surface(CUBE, QUADS).isometries()))
        self.assertEqual(len(found), 48)
        again = pickle.loads(pickle.dumps(found.maps[5]))
        self.assertEqual(again.vertices.tolist(), found.maps[5].vertices.tolist())
        self.assertEqual(len(pickle.loads(pickle.dumps(found.maps))), 48)

    def test_hash_depends_on_the_surface_alone(self):
        cube = it.Surface(CUBE, QUADS)
        self.assertEqual(cube.hash(), renumbered(CUBE, QUADS, 1).hash())
        self.assertEqual(cube.hash(), cube.refine().hash())
        self.assertNotEqual(cube.hash(), it.Surface(2 * CUBE, QUADS).hash())
        self.assertEqual(cube.isometries(it.Surface(2 * CUBE, QUADS)).answer, "not_isometric")
        self.assertFalse(cube.isometries(it.Surface(2 * CUBE, QUADS)))


if __name__ == "__main__":
    unittest.main()
