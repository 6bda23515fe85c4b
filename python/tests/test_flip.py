# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""`flip=False`: operators on the faces of the mesh, as they are."""

import inspect
import os
import unittest

import numpy as np

import intrinsic as it
from support import bumpy

PART = os.path.join(os.path.dirname(__file__), "..", "..", "examples", "data", "part.off")
# What methods with `flip` are called with, and what is compared of their results.
OPERATORS = {
    "laplacian": lambda s, **k: s.laplacian(**k).toarray(),
    "mass": lambda s, **k: s.mass("galerkin", **k).toarray(),
    "connection_laplacian": lambda s, **k: s.connection_laplacian(2, **k).toarray(),
    "eigen": lambda s, **k: s.eigen(4, **k)[0],
    "deform": lambda s, **k: s.deform({0: [1, 0, 0], 20: [0, 0, 1]}, **k),
    "distance": lambda s, **k: s.distance(0, method="heat", **k),
    "distances": lambda s, **k: s.distances([0, [1, 2]], method="heat", **k),
    "pair_distances": lambda s, **k: s.pair_distances([0, 1], [2, 3], method="heat", **k),
    "signed_distance": lambda s, **k: s.signed_distance([0, int(s.faces[s.faces[:, 0] == 0][0, 1])],
                                                        **k),
    "extend": lambda s, **k: s.extend([0, 20], [1, 2], **k),
    "transport": lambda s, **k: s.transport(0, [1, 0], **k).coordinates,
    "log_map": lambda s, **k: s.log_map(0, method="affine", **k),
    "direction_field": lambda s, **k: s.direction_field(1, fixed=([3], [[1, 0]]), **k).coordinates,
    "operators": lambda s, **k: s.operators(k=4, **k).gradient_x.toarray(),
    "frames": lambda s, **k: s.frames(**k).angles,
    "parametrize": lambda s, **k: s.parametrize("lscm", **k).uv,
}


class Flip(unittest.TestCase):
    def test_it_keeps_all_edges(self):
        V, F = bumpy(6)
        s = it.Surface(V * [1, 4, 1], F)
        kept = s.delaunay(keep=np.vstack([F[:, [0, 1]], F[:, [1, 2]], F[:, [2, 0]]]))
        np.testing.assert_array_equal(s.faces, kept.faces)
        for name, call in OPERATORS.items():
            with self.subTest(name):
                as_it_is, delaunay = call(s, flip=False), call(s)
                np.testing.assert_allclose(as_it_is, call(kept), atol=1e-9)
                self.assertGreater(abs(as_it_is - delaunay).max(), 1e-4)
        np.testing.assert_array_equal(s.faces, F)

    def test_all_that_have_it_are_tested(self):
        found = {name for name, x in inspect.getmembers(it.Surface, inspect.isfunction)
                 if "flip" in inspect.signature(x).parameters and not name.startswith("_")}
        self.assertEqual(found, set(OPERATORS))

    def test_conformal_maps_start_from_the_faces(self):
        V, F = bumpy(4)
        s = it.Surface(V * [1, 2, 1], F)
        np.testing.assert_array_equal(s.parametrize("conformal", flip=False).u,
                                      s.parametrize("conformal", start="input").u)

    def test_integrals_of_functions_on_the_mesh_need_it(self):
        s = it.read(PART)
        t = s.refine(min_angle=25)
        u = t.points[:, 0] ** 2
        integral = (t.mass("galerkin") @ u).sum()
        v = t.to_input(u)
        own = s.mass(flip=False)
        self.assertAlmostEqual((own @ v).sum() / integral, 1, places=10)
        self.assertGreater(abs((s.mass() @ v).sum() / integral - 1), 1e-5)
        ratio = own.diagonal() / s.mass().diagonal()
        self.assertGreater(max(ratio.max(), 1 / ratio.min()), 200)


if __name__ == "__main__":
    unittest.main()
