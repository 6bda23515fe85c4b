# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proofs end: on soups whose faces coincide or overlap, on clouds of a curve, and for straight curves."""

import time
import unittest

import numpy as np

import intrinsic as it


def turned(rng):
    """A random rotation or reflection."""
    return np.linalg.qr(rng.normal(size=(3, 3)))[0]


def fan_with_overlaps(seed):
    """A fan over a nearly flat polygon, with triangles of the same corner that overlap others: a
    tufted cover, on which ties pass over most of the sheets."""
    rng = np.random.default_rng(seed)
    k, radius, turn = rng.integers(6, 15), 0.07 * rng.uniform(0.5, 2), np.pi * rng.uniform(0.5, 2)
    a = turn * np.arange(k) / k
    flat = np.column_stack([radius * np.cos(a), radius * np.sin(a), 1e-6 * rng.normal(size=k)])
    V = np.float32(flat @ turned(rng) + [0, 0, 0.77]).astype(float)
    F = [(0, q, q + 1) for q in range(1, k - 1)]
    for _ in range(rng.integers(1, 4)):
        p, q = sorted(rng.choice(np.arange(1, k), 2, replace=False))
        F.append((0, p, q))
    F = [f if rng.random() < 0.5 else f[::-1] for f in F]
    return V, np.array(F)[rng.permutation(len(F))]


def tube(n, layers, rng):
    """A tube of n sides, turned: rulings are parallel up to rounding only."""
    a = 2 * np.pi * np.arange(n) / n
    V = np.concatenate([np.column_stack([np.cos(a), np.sin(a), np.full(n, z)])
                        for z in range(layers + 1)])
    i, z = (x.ravel() for x in np.meshgrid(np.arange(n), np.arange(layers)))
    p, q = z * n + i, z * n + (i + 1) % n
    return V @ turned(rng), np.concatenate([np.column_stack([p, q, q + n]),
                                            np.column_stack([p, q + n, p + n])])


class Ends(unittest.TestCase):
    def test_ties_of_sheets_need_no_numbers(self):
        """The field took minutes for some of these, and left one of them undecided."""
        start, ties = time.perf_counter(), 0
        for seed in range(60):
            s = it.Surface(*fan_with_overlaps(seed)).delaunay()
            found = s.statistics["delaunay"]
            self.assertEqual(s.certificate, "exact")
            self.assertNotIn("field", found["rungs"])
            ties += found["rungs"].get("mirrored", {"zeros": 0})["zeros"]
        self.assertGreater(ties, 30)
        self.assertLess(time.perf_counter() - start, 5)

    def test_rungs_say_how_signs_were_found(self):
        s = it.Surface(*fan_with_overlaps(19)).delaunay()
        found = s.statistics["delaunay"]
        self.assertEqual(sum(rung["zeros"] for rung in found["rungs"].values()),
                         found["certified_zero"])
        for rung in found["rungs"].values():
            self.assertLessEqual(rung["zeros"], rung["decided"])
            self.assertLessEqual(rung["decided"], rung["asked"])
            self.assertGreaterEqual(rung["seconds"], 0)

    def test_a_cloud_of_a_curve_ends(self):
        t = np.linspace(0, 2 * np.pi, 600, endpoint=False)
        P = np.round(np.column_stack([50 * np.cos(t), 50 * np.sin(t), 10 * t]), 2)
        start = time.perf_counter()
        s = it.points(P).delaunay()
        self.assertIn(s.certificate, ("exact", "interval"))
        self.assertLess(time.perf_counter() - start, 5)

    def test_certificates_of_curves_on_tubes_end_in_both_arithmetics(self):
        rng = np.random.default_rng(3)
        start = time.perf_counter()
        for n in (6, 11, 16):
            V, F = tube(n, 4, rng)
            for arithmetic in ("exact", "double"):
                s = it.Surface(V, F, arithmetic=arithmetic)
                for p, q in rng.integers(0, len(V), (6, 2)):
                    if p != q:
                        certified = s.network([[p, q]], certify=True).certified
                        self.assertTrue(certified or arithmetic == "double")
        self.assertLess(time.perf_counter() - start, 5)


if __name__ == "__main__":
    unittest.main()
