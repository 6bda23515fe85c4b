# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators for learning: what gradients are exact for, how they converge, what the cache finds."""

import os
import unittest
import warnings
from unittest import mock

import numpy as np

import intrinsic as it
from intrinsic import _core
from support import PART, With_folder, bumpy, unit_grid
from ten_surfaces import ball


def gradients(o, u):
    """Gradients in space."""
    x, y = o.gradient_x @ u, o.gradient_y @ u
    return o.frames[:, 0] * x[:, None] + o.frames[:, 1] * y[:, None]


class Gradients(unittest.TestCase):
    def test_of_linear_functions_they_are_exact_where_it_is_flat(self):
        V, F = unit_grid(8)
        random = np.random.default_rng(3)
        inner = (V[:, :2] > 0).all(axis=1) & (V[:, :2] < 1).all(axis=1)
        V[inner, :2] += random.uniform(-0.05, 0.05, (inner.sum(), 2))
        corner = np.isin(V[:, 0], [0, 1]) & np.isin(V[:, 1], [0, 1])  # angles there are doubled
        turn = np.linalg.qr(random.normal(size=(3, 3)))[0]
        slope = np.array([2., -3., 0.])
        o = it.Surface(V @ turn.T, F).operators(k=2)
        np.testing.assert_allclose(gradients(o, V @ slope)[~corner],
                                   np.broadcast_to(turn @ slope, (len(V), 3))[~corner], atol=1e-12)
        identity = np.einsum("nij,nkj->nik", o.frames, o.frames)
        np.testing.assert_allclose(identity, np.broadcast_to(np.eye(3), identity.shape), atol=1e-14)

    def test_on_a_sphere_they_converge(self):
        errors = []
        for n in 500, 2000:
            V, F = ball(np.random.default_rng(1), n)
            V /= np.linalg.norm(V, axis=1)[:, None]
            expected = np.array([0, 0, 1]) - V[:, 2:] * V
            o = it.Surface(V, F).operators(k=1)
            errors.append(np.linalg.norm(gradients(o, V[:, 2]) - expected, axis=1).mean())
        self.assertLess(errors[0], 0.1)
        self.assertLess(errors[1], 0.7 * errors[0])

    def test_constants_have_none(self):
        o = it.Surface(*bumpy()).refine(min_angle=25).operators(k=4)
        for x in o.gradient_x, o.gradient_y:
            self.assertLess(abs(x @ np.ones(x.shape[0])).max(), 1e-9 * abs(x).max())


class Set_of_operators(With_folder):
    def test_they_are_those_of_the_methods(self):
        s = it.Surface(*bumpy())
        o = s.operators(k=7)
        np.testing.assert_array_equal(o.L.toarray(), s.laplacian().toarray())
        np.testing.assert_array_equal(o.mass, s.mass().diagonal())
        values, functions = s.eigen(7)
        np.testing.assert_allclose(o.eigenvalues, values, atol=1e-12)
        np.testing.assert_allclose(o.eigenfunctions.T @ (o.mass[:, None] * o.eigenfunctions),
                                   np.eye(7), atol=1e-9)

    def test_files_have_the_keys_of_diffusionnet(self):
        path = os.path.join(self.folder, "o.npz")
        o = it.Surface(*bumpy()).operators(k=3)
        o.save(path)
        with np.load(path) as file:
            self.assertEqual(set(file), {
                "verts", "faces", "k_eig", "frames", "mass", "evals", "evecs",
                *(f"{x}_{part}" for x in ("L", "gradX", "gradY")
                  for part in ("data", "indices", "indptr", "shape"))})
        again = it.Operators.load(path)
        for name, x, y in zip(o._fields, o, again):
            with self.subTest(name):
                x, y = (z.toarray() if hasattr(z, "toarray") else z for z in (x, y))
                np.testing.assert_array_equal(x, y)

    def test_the_cache_knows_meshes_by_their_content(self):
        V, F = bumpy()
        cache = os.path.join(self.folder, "cache")
        first = it.Surface(V, F).operators(k=3, cache=cache)
        with mock.patch.object(_core, "eigen", side_effect=AssertionError("computed again")):
            again = it.Surface(V.copy(), F.tolist()).operators(k=3, cache=cache)
            np.testing.assert_array_equal(first.eigenfunctions, again.eigenfunctions)
            self.assertEqual(len(os.listdir(cache)), 1)
            for other in (it.Surface(V * 2, F), it.Surface(V, F[::-1]), it.Surface(V, F).delaunay(),
                          it.Surface(V, F, arithmetic="double")):
                with self.assertRaises(AssertionError):
                    other.operators(k=3, cache=cache)
            with self.assertRaises(AssertionError):
                it.Surface(V, F).operators(k=4, cache=cache)

    def test_other_files_are_refused(self):
        np.savez(self.folder / "other.npz", a=1)
        for path in self.folder / "other.npz", PART:
            with self.assertRaisesRegex(ValueError, f"{path.name}.*has no operators"):
                it.Operators.load(path)
        with self.assertRaisesRegex(ValueError, r"Operators.load\(\)"):
            it.read(self.folder / "other.npz")

    def test_single_arrays_are_refused_without_a_warning(self):
        np.save(self.folder / "one.npy", np.zeros(3))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaisesRegex(ValueError, r"one\.npy: the file has no operators"):
                it.Operators.load(self.folder / "one.npy")

    def test_damaged_files_are_named(self):
        path = self.folder / "damaged.npz"
        operators = it.Surface(*bumpy()).operators(k=3)
        operators.save(path)
        whole = path.read_bytes()
        it.Operators.load(path)

        def changed_at(i):
            return whole[:i] + bytes([whole[i] ^ 1]) + whole[i + 1:]

        numbers, header = whole.index(operators.mass.tobytes()), whole.index(b"NUMPY")
        for damaged in whole[:len(whole) // 2], changed_at(numbers), changed_at(header):
            path.write_bytes(damaged)
            with self.assertRaisesRegex(ValueError, r"damaged\.npz: the file is damaged; delete"):
                it.Operators.load(path)
        path.write_bytes(b"")  # of which NumPy says different things
        with self.assertRaisesRegex(ValueError, r"damaged\.npz: the file"):
            it.Operators.load(path)

    def test_what_has_no_gradients_is_refused(self):
        V, F = unit_grid(2)
        fin = it.Surface(np.vstack([V, [[0.5, 0.5, 1]]]), np.vstack([F, [[0, 4, 9]]]))
        for s in fin, it.points(np.random.default_rng(1).uniform(size=(60, 3))), it.Surface(
                None, [[0, 1, 2]], lengths=[[3, 4, 5]]):
            with self.assertRaisesRegex(ValueError, "oriented manifold"):
                s.operators(k=2)


if __name__ == "__main__":
    unittest.main()
