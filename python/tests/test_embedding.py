# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Convex polyhedra of metrics against hulls of points."""

import doctest
import unittest

import numpy as np
from scipy.spatial import ConvexHull
from scipy.spatial.distance import pdist

import intrinsic as it
import program
from intrinsic import _embedding
from support import CUBE, With_folder, grid


def hull(n, seed):
    V = np.random.default_rng(seed).normal(size=(n, 3))
    V /= np.linalg.norm(V, axis=1)[:, None]
    F = ConvexHull(V).simplices
    a, b, c = (V[F[:, k]] for k in range(3))
    inward = np.einsum("ij,ij->i", np.cross(b - a, c - a), a) < 0
    F[inward] = F[inward][:, ::-1]
    return V, F


def border(faces, top):
    sides = {(a, b) for f in faces if set(f) <= set(top) for a, b in zip(f, [*f[1:], f[0]])}
    return {(a, b) for a, b in sides if (b, a) not in sides}


class Embedding(With_folder):
    def test_distances_return_from_lengths(self):
        V, F = hull(50, 1)
        s = it.Surface(V, F)
        lengths = np.linalg.norm(V[F] - V[np.roll(F, -1, axis=1)], axis=2)
        for given in s, it.Surface(50, F, lengths=lengths):
            e = given.embed()
            self.assertEqual(e.status, "done")
            self.assertLess(e.error, 1e-14)
            self.assertTrue(e.certificate["proven"])
            np.testing.assert_allclose(pdist(e.points), pdist(V), rtol=0, atol=1e-13)
            self.assertEqual(sorted(map(sorted, e.faces.tolist())), sorted(map(sorted, F.tolist())))
        self.assertEqual(len(e.flat_vertices), 0)

    def test_results_show_and_save_themselves(self):
        e = it.Surface(*CUBE).embed()
        self.assertEqual(e.surface.number_of_vertices, 8)
        self.assertIn("<html", e.html())
        e.save(self.folder / "e.off")
        again = it.read(self.folder / "e.off")
        np.testing.assert_array_equal(again.points, e.points)

    def test_squares_front_and_back(self):
        e = it.Surface(*grid(2), domain="closed").embed()
        self.assertTrue(e.is_polygon)
        np.testing.assert_array_equal(e.points[:, 2], 0)
        self.assertEqual(len(e.faces), 4)
        self.assertIn("<html", e.html())

    def test_errors_name_what_is_wrong(self):
        with self.assertRaisesRegex(ValueError, "has a border; .*closed"):
            it.Surface(*grid(3)).embed()
        V, F = hull(30, 2)
        with self.assertRaisesRegex(
                ValueError, r"vertex \d+ has angles that sum to \d+\.?\d* degrees more"):
            it.Surface(np.where(np.arange(30)[:, None] == 3, V / 2, V), F).embed()

    def test_flat_vertices_with_curvature_stretch_the_surface(self):
        points, faces = CUBE
        for height in 0, 1e-6:
            top = [v for v, p in enumerate(points) if p[2] == 1]
            at = it.Surface([*points, [.5, .5, 1 + height]],
                            [f for f in faces if not set(f) <= set(top)]
                            + [[a, b, 8] for f in faces if set(f) <= set(top)
                               for a, b in zip(f, [*f[1:], f[0]]) if (a, b) in border(faces, top)])
            e = at.embed()
            self.assertEqual((e.status, e.flat_vertices.tolist()), ("done", [8]))
            self.assertTrue(e.certificate["proven"])
            # edges at the tip take the length of half a diagonal
            self.assertGreaterEqual(e.certificate["stretch"], .99 * height**2)
            self.assertLessEqual(e.certificate["stretch"], 4 * height**2)
        self.assertEqual(it.Surface(*CUBE).embed(flat_within=0).status, "done")

    @unittest.skipUnless(program.is_there(), "the program or its meshes are missing")
    def test_the_program_writes_the_same(self):
        s = it.Surface(*hull(40, 3))
        path, out = self.folder / "s.idt", self.folder / "e.obj"
        s.save(path)
        page = self.folder / "e.html"
        found = program.run("embed", path, "-o", out, "--view", page)["embed"]
        self.assertIn("<html", page.read_text())
        e = s.embed()
        self.assertEqual((found["status"], found["steps"], found["faces"]),
                         (e.status, e.steps, len(e.faces)))
        points = [line.split()[1:] for line in out.read_text().splitlines() if line[:2] == "v "]
        np.testing.assert_array_equal(np.array(points, float), e.points)


def load_tests(_loader, tests, _pattern):
    tests.addTests(doctest.DocTestSuite(_embedding, extraglobs={"Surface": it.Surface}))
    return tests


if __name__ == "__main__":
    unittest.main()
