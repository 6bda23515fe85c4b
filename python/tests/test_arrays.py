# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of any type and any layout work, and bad ones get an error that says why."""

import unittest

import intrinsic as it
import numpy as np
from support import bumpy

try:
    from hypothesis import given, settings
    from hypothesis import strategies as st
except ImportError:  # the other tests need it not
    given = None

V, F = bumpy(5)


def matrix(surface):
    return surface.laplacian().toarray()


class Arrays(unittest.TestCase):
    def test_types_and_layouts(self):
        expected = matrix(it.Surface(V, F))
        wide = np.zeros((2 * len(V), 6))
        wide[::2, ::2] = V
        backwards = np.ascontiguousarray(F[::-1])[::-1]
        read_only = V.copy()
        read_only.flags.writeable = False
        for v in (V.tolist(), np.asfortranarray(V), wide[::2, ::2], read_only, V.astype("O"),
                  V.astype(np.longdouble), V.astype(">f8"), tuple(map(tuple, V))):
            for f in (F, F.tolist(), np.asfortranarray(F), backwards, F.astype(np.uint8),
                      F.astype(np.int16), F.astype(">i4"), F.astype(np.uint64), F.astype(float),
                      [np.array(face) for face in F], list(map(tuple, F))):
                self.assertTrue((matrix(it.Surface(v, f)) == expected).all())
        for kind in (np.int8, np.int64, np.uint32, np.float16, np.float32):
            v = np.round(4 * V).astype(int) % 60
            v[:, 2] = np.arange(len(v)) % 3
            self.assertTrue((matrix(it.Surface(v.astype(kind), F))
                             == matrix(it.Surface(v.astype(float), F))).all())

    def test_words(self):
        for name, word in (("correspondence", "signposts"), ("correspondence", "crossings"),
                           ("correspondence", "x"), ("domain", "points"), ("arithmetic", None)):
            with self.assertRaisesRegex(ValueError, f"{name}=.*give"):
                it.Surface(V, F, **{name: word})
        with self.assertRaisesRegex(ValueError, "intrinsic delaunay --correspondence signposts"):
            it.Surface(V, F, correspondence="signposts")

    def test_the_plane_and_polygons(self):
        square = [[0, 0], [1, 0], [1, 1], [0, 1], [2, .5]]
        s = it.Surface(square, [[0, 1, 2, 3], [1, 4, 2]])
        self.assertEqual(s.number_of_faces, 3)
        self.assertEqual(s.number_of_input_faces, 2)
        self.assertAlmostEqual(s.mass().sum(), 1.5)
        self.assertTrue((it.Surface(square, np.array([[0, 1, 2, 3]])).points[:4, 2] == 0).all())

    def test_results_in_the_users_numbers(self):
        s = it.Surface(V, F)
        self.assertTrue((s.faces == F).all())
        self.assertTrue((s.points == V).all())
        sides = np.linalg.norm(V[F] - V[np.roll(F, -1, axis=1)], axis=2)
        self.assertTrue(np.allclose(s.lengths, sides, rtol=1e-14))
        order = np.random.default_rng(0).permutation(len(V))
        inverse = np.argsort(order)
        r = it.Surface(V[order], inverse[F])
        self.assertTrue(np.allclose(matrix(r), matrix(s)[np.ix_(order, order)], atol=1e-12))

    def test_abstract_surfaces(self):
        t = it.Surface(V, F).delaunay()
        r = it.Surface(None, t.faces, lengths=t.lengths, glue=t.glue)
        self.assertTrue(np.allclose(matrix(r), matrix(t), atol=1e-9))
        self.assertIsNone(r.points)
        self.assertEqual(r.statistics["delaunay"]["non_delaunay_edges"], 0)
        flat = np.array([[[0, 2], [0, 1], [0, 0]]])  # a cone: two sides of one triangle are glued
        self.assertRaises(ValueError, it.Surface, 1, [[0, 0, 0]], lengths=[[1, 1, 1]], glue=flat)
        torus = it.Surface(1, [[0, 0, 0], [0, 0, 0]], lengths=[[1, 1, 2**.5], [1, 1, 2**.5]],
                           glue=[[[1, 0], [1, 1], [1, 2]], [[0, 0], [0, 1], [0, 2]]])
        self.assertEqual(torus.report["input"]["genus"], 1)
        self.assertAlmostEqual(torus.mass().sum(), 1)

    def test_errors_name_element_and_remedy(self):
        nan = V.copy()
        nan[3, 1] = np.nan
        for arguments, words in (
                ((V[:, :1], F), "points has the shape"), ((V.ravel(), F), "points has the shape"),
                ((nan, F), r"points\[3, 1\] is nan"), ((V.astype(complex), F), "complex"),
                ((V.astype(str), F), "no real numbers"), (([[0, 0, 0], [1]], F), "different"),
                ((V, []), "faces has no faces"), ((V, F[:0]), "faces has no faces"),
                ((V, F + 1), r"faces\[.*\] is 25"), ((V, F - 1), "is -1"),
                ((V, F[:, :2]), "2 vertices"),
                ((V, F.astype(float) + .5), "whole numbers"), ((V, [[0, 1], [1, 2, 3]]), "face 0"),
                ((V, "none"), "faces"), ((V, F == 0), "bool"), ((V, [[0, 1, 10**30]]), "faces"),
                ((V, np.full((1, 3), np.inf)), "inf"), ((V[:0], F), "faces"),
                ((V, [[0, 0, 1]]), "face")):
            with self.assertRaisesRegex((ValueError, TypeError), words):
                it.Surface(*arguments)
        s = it.Surface(V, F)
        for call, words in (
                (lambda: it.Surface(V, F, domain="closd"), "closd"),
                (lambda: it.Surface(V, F, arithmetic="float"), "float"),
                (lambda: it.Surface(V, F, lengths=np.ones((3, 3))), "lengths has the shape"),
                (lambda: it.Surface(V, F, lengths=-np.ones(F.shape)), r"lengths\[0, 0\]"),
                (lambda: it.Surface(V, F, lengths=np.arange(F.size).reshape(F.shape)),
                 "one length"),
                (lambda: s.delaunay(keep=[[0, 24]]), r"keep\[0\]: no edge"),
                (lambda: s.delaunay(keep=[[0, 99]]), "99"),
                (lambda: s.refine(max_edge_length=np.zeros(len(V))), r"max_edge_length\[0\]"),
                (lambda: s.refine(min_angle=70), "angle"),
                (lambda: s.mass("heavy"), "heavy"),
                (lambda: s.to_input(np.ones(3)), "25"),
                (lambda: s.locate([it.Point(0, (1, 1, 1))]), "sum to 1"),
                (lambda: s.locate([99]), "99"),
                (lambda: it.points(V[:2]), ""), (lambda: it.points(V, neighbors=1), "from 2"),
                (lambda: it.Surface(V, F, domain="manifold").adapt(99), "99")):
            with self.assertRaisesRegex(ValueError, words):
                call()
        with self.assertRaises(FileNotFoundError):
            it.read("no such file.off")

    if given is not None:
        @settings(max_examples=150, deadline=None, derandomize=True)
        @given(st.lists(st.lists(st.floats(-9, 9, width=16) | st.just(float("nan")), min_size=2,
                                 max_size=4), max_size=6),
               st.lists(st.lists(st.integers(-1, 6), max_size=5), max_size=8))
        def test_any_lists_work_or_are_refused(self, points, faces):
            try:
                s = it.Surface(points, faces)
            except ValueError as error:
                self.assertGreater(len(str(error)), 10)
                return
            self.assertEqual(s.faces.shape, (s.number_of_faces, 3))
            try:
                sums = abs(s.laplacian().sum(axis=1)).max()
            except ValueError as error:  # of a degenerate surface
                self.assertIn("area", str(error))
            else:
                self.assertLess(sums, 1e-6 * max(1, abs(s.laplacian()).max()))


if __name__ == "__main__":
    unittest.main()
