# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Long work tells how far it is, and ends when the user says so. Nothing is spoilt by that."""

import contextlib
import importlib.util
import io
import re
import threading
import unittest
from pathlib import Path

import numpy as np

import intrinsic as it
from support import bumpy, failures_of_threads, unit_grid
from test_embedding import hull


class Enough(Exception):
    """What a user raises."""


class Stop:
    """A function that ends the work when some of it is done. The first call may come before it."""

    def __init__(self):
        self.calls = 0

    def __call__(self, stage, count, total):
        self.calls += 1
        if count > 0 or self.calls > 1:
            raise Enough(stage)


class Long_work(unittest.TestCase):
    def setUp(self):
        self.s = it.Surface(*unit_grid(150))
        self.u = self.s.points @ [1, 0.3, 0]

    def expect_end(self, call):
        with self.assertRaises(Enough):
            call(Stop())

    def test_isolines_and_cuts(self):
        s, u = self.s, self.u
        self.expect_end(lambda p: s.isolines(u, 3000, progress=p))
        lines = s.isolines(u, 400)
        self.expect_end(lambda p: s.cut(lines, progress=p))
        self.assertEqual(len(s.isolines(u, [0.5])), 1)
        self.assertEqual(s.cut(lines[200]).number_of_components, 2)

    def test_cells_and_logarithms(self):
        s = self.s
        self.expect_end(lambda p: s.voronoi(range(0, 22801, 57), cell_tolerance=1e-6, progress=p))
        self.expect_end(lambda p: s.log_map(0, progress=p))
        np.testing.assert_allclose(np.hypot(*s.log_map(0).T), np.hypot(*s.points[:, :2].T),
                                   atol=1e-12)

    def test_solutions(self):
        s = self.s
        self.expect_end(lambda p: s.eigen(60, progress=p))
        large = it.Surface(*unit_grid(300))
        self.expect_end(lambda p: large.direction_field(4, progress=p))
        self.expect_end(lambda p: large.parametrize("spectral", progress=p))
        self.expect_end(lambda p: large.transport(0, [1, 0], progress=p))
        handles, moves = [0, 300, 90000], np.eye(3)
        self.expect_end(lambda p: large.deform(handles, moves, progress=p))
        np.testing.assert_allclose(large.deform(handles, moves)[handles], moves, atol=1e-9)
        self.assertAlmostEqual(s.eigen(1)[0][0], 0)
        self.assertEqual(s.parametrize("lscm").status, "done")

    def test_isometries_and_polyhedra(self):
        s = it.Surface(*bumpy(150))
        self.expect_end(lambda p: it.Surface(*bumpy(300)).hash(progress=p))
        self.expect_end(lambda p: s.isometries(progress=p))
        self.assertEqual(len(s.isometries()), 1)  # nothing that was ended is kept
        sphere = it.Surface(*hull(2000, 1))
        self.expect_end(lambda p: sphere.embed(progress=p))
        self.assertEqual(sphere.embed().status, "done")

    def test_transfer(self):
        t = it.Surface(*unit_grid(250)).delaunay()
        self.expect_end(lambda p: t.to_input(np.ones(t.number_of_vertices), progress=p))
        np.testing.assert_allclose(t.to_input(np.ones(t.number_of_vertices)), 1, rtol=1e-9)

    def test_maps_of_points(self):
        V = np.random.default_rng(1).uniform(size=(25000, 3)) * [1, 1, 0]
        cloud = it.points(V, neighbors=12)
        self.expect_end(lambda p: cloud.parametrize("spectral", progress=p))
        self.expect_end(lambda p: cloud.direction_field(progress=p))
        self.assertEqual(cloud.parametrize("spectral").uv.shape, (25000, 2))


class Totals(unittest.TestCase):
    def test_they_are_known_of_what_is_listed(self):
        s = it.Surface(*unit_grid(100))
        seen = set()
        s.distances(range(12), progress=lambda *a: seen.add((a[0], a[2])))
        self.assertIn(("parts", 12), seen)
        seen.clear()
        s.isolines(s.points[:, 0], 800, progress=lambda *a: seen.add((a[0], a[2])))
        self.assertEqual({total for _, total in seen}, {800})
        seen.clear()
        s.refine(max_circumradius=0.003, max_insertions=100000,
                 progress=lambda *a: seen.add((a[0], a[2])))
        self.assertEqual({total for _, total in seen}, {None})

    @unittest.skipUnless(importlib.util.find_spec("tqdm"), "tqdm is not installed")
    def test_the_bar_of_the_manual(self):
        page = Path(__file__).parents[2] / "doc" / "Intrinsic_triangulations" / \
            "python_distances.md"
        code, = (block for block in re.findall("```py\n(.*?)```", page.read_text(), re.DOTALL)
                 if "tqdm" in block)
        names = {"s": it.Surface(*unit_grid(25))}
        with contextlib.redirect_stderr(io.StringIO()):
            exec(code, names)
        self.assertEqual(names["bar"].total, names["s"].number_of_vertices)
        self.assertEqual(names["bar"].desc, "parts")


class Callbacks(unittest.TestCase):
    """What users are told while several threads work."""

    def expect_refusals(self, call, use):
        """A function that is called while a surface works is called in the thread of the caller,
        and may not use the surface."""
        def attempt(_):
            def progress(stage, count, total):
                callers.append(threading.get_ident())
                use()

            callers = []
            with self.assertRaisesRegex(RuntimeError, "must not use that surface"):
                call(progress)
            self.assertEqual(callers, [threading.get_ident()])

        self.assertEqual(failures_of_threads(attempt, 1, 60), [])

    def test_they_come_in_the_thread_of_the_caller_and_cannot_use_the_surface(self):
        V, F = bumpy(40)
        s, every = it.Surface(V, F), range(1600)
        s.distance(0, method="heat")
        for threads in 1, 2, 5:
            for method in "exact", "heat":
                with self.subTest(threads=threads, method=method):
                    how = {"method": method, "threads": threads}
                    self.expect_refusals(
                        lambda p: s.distances([[i] for i in every] * 9, progress=p, **how),
                        lambda: s.distance(1))
                    self.expect_refusals(
                        lambda p: s.pair_distances(every, [i // 2 for i in every],
                                                   progress=p, **how), s.laplacian)

    def test_all_parts_are_told_and_results_do_not_depend_on_threads(self):
        s = it.Surface(*bumpy(12))
        found = [s.distances(range(144), threads=k, progress=lambda *a: None) for k in (1, 2, 7)]
        np.testing.assert_array_equal(found[0], found[1])
        np.testing.assert_array_equal(found[0], found[2])

    def test_a_thread_that_waits_for_the_surface_does_not_keep_it_from_the_error(self):
        s = it.Surface(*unit_grid(150))
        u = s.points @ [1, 0.3, 0]
        other = threading.Thread(target=s.laplacian)

        def use():
            other.start()
            other.join(0.2)  # until it waits
            s.laplacian()

        self.expect_refusals(lambda p: s.isolines(u, 3000, progress=p), use)
        other.join(60)
        self.assertFalse(other.is_alive())


if __name__ == "__main__":
    unittest.main()
