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

    def test_covers_are_not_compared_with_meshes(self):
        rim = [[0, k, k % 5 + 1] for k in range(1, 6)]
        hemi = it.Surface(6, rim + [[1, 2, 4], [2, 3, 5], [3, 4, 1], [4, 5, 2], [5, 1, 3]],
                          lengths=np.ones((10, 3)))
        top = [[0, k, k % 5 + 1] for k in range(1, 6)]
        sides = [[k, k + 5, k % 5 + 1] for k in range(1, 6)]
        sides += [[k % 5 + 1, k + 5, k % 5 + 6] for k in range(1, 6)]
        icosahedron = it.Surface(12, top + sides + [[11, k % 5 + 6, k + 5] for k in range(1, 6)],
                                 lengths=np.ones((20, 3)))
        found = hemi.isometries(icosahedron)
        self.assertEqual((found.answer, len(found)), ("undecided", 0))
        self.assertIn("cover", found.note)
        self.assertIn("covers", hemi.isometries().note)
        self.assertEqual((icosahedron.isometries().note, len(icosahedron.isometries())), ("", 120))
        self.assertNotEqual(hemi.hash(), icosahedron.hash())
        with self.assertRaisesRegex(ValueError, "one-sided"):
            hemi.embed()

    def test_a_chain_of_lengths_is_no_rounding(self):
        def fan(steps):
            angle = np.cumsum(steps) / sum(steps) * 2 * np.pi
            points = np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
            n = len(steps)
            return it.Surface([[0, 0, .3], *points],
                              [[0, 1 + k, 1 + (k + 1) % n] for k in range(n)])
        steps = 1 + .8e-5 * np.arange(400)
        found = fan(steps).isometries(fan(np.random.default_rng(1).permutation(steps)))
        self.assertEqual((found.answer, len(found)), ("not_isometric", 0))
        self.assertEqual(found.largest_difference, np.inf)

    def test_sizes_far_apart_differ(self):
        found = it.Surface(CUBE * 2.**-500, QUADS).isometries(it.Surface(CUBE * 2.**500, QUADS))
        self.assertEqual((found.answer, len(found)), ("not_isometric", 0))

    def test_shared_vertices_stay_shared(self):
        triangles = [[f[0], *f[k:k + 2]] for k in (1, 2) for f in QUADS]
        lengths = [[np.linalg.norm(CUBE[a] - CUBE[b]) for a, b in ((f[0], f[1]), (f[1], f[2]),
                                                                   (f[2], f[0]))]
                   for f in triangles]

        def cubes(seed):  # that meet at two opposite corners
            place = np.array([0, *range(8, 14), 7])
            faces = np.array(triangles + place[triangles].tolist())
            random = np.random.default_rng(seed)
            order, numbers = random.permutation(24), random.permutation(14)
            return it.Surface(14, numbers[faces][order], lengths=np.array(2 * lengths)[order])
        for seed in range(1, 5):
            self.assertEqual(cubes(0).isometries(cubes(seed)).answer, "isometric")


if __name__ == "__main__":
    unittest.main()
