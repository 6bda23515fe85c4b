# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces are values: kept, copied, used by threads, interrupted, without leaks."""

import copy
import doctest
import errno
import gc
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import unittest

import intrinsic as it
import numpy as np
from support import (BOOK, PART, With_folder, bumpy, failures_of_threads, grown_memory,
                     has_sanitizer, unit_grid, without_times)

V, F = bumpy()


class Values(With_folder):
    def assert_same(self, a, b):
        self.assertTrue((a.faces == b.faces).all())
        self.assertTrue((a.lengths == b.lengths).all())
        self.assertTrue((a.glue == b.glue).all())
        self.assertTrue((a.points == b.points).all())
        self.assertEqual((a.laplacian() != b.laplacian()).nnz, 0)

    def test_copies_and_pickles(self):
        for arithmetic in ("exact", "double"):
            s = it.Surface(V, F, arithmetic=arithmetic)
            for t in (s, s.delaunay(keep=[[0, 1]]), s.refine(min_angle=28)):
                for other in (copy.copy(t), copy.deepcopy(t), t.copy(),
                              pickle.loads(pickle.dumps(t))):
                    self.assert_same(t, other)
        t.save(self.folder / "t.idt")
        self.assert_same(t, it.load(self.folder / "t.idt"))

    def test_methods_change_nothing(self):
        s = it.Surface(V, F)
        before = s.faces, s.lengths
        for work in (s.delaunay, s.refine, s.adapt, s.laplacian, s.mass):
            work()
        self.assertTrue((s.faces == before[0]).all() and (s.lengths == before[1]).all())
        self.assertGreater(s.statistics["delaunay"]["non_delaunay_edges"], 0)
        self.assertEqual(s.delaunay().statistics["delaunay"]["non_delaunay_edges"], 0)

    def test_kept_edges_and_sizes(self):
        s = it.Surface(V, F)
        t = s.delaunay(keep=[[0, 13]])
        corners = np.sort(np.stack([t.faces, np.roll(t.faces, -1, axis=1)], axis=2), axis=2)
        self.assertTrue((corners == [0, 13]).all(axis=2).any())
        self.assertEqual(t.statistics["constraints"]["input_edges"], 1)
        r = s.refine(min_angle=0, max_edge_length=0.5)
        self.assertLessEqual(r.lengths.max(), 0.5)
        size = np.where(V[:, 0] < 5, 0.4, 100)
        r = s.refine(min_angle=0, max_edge_length=size)
        self.assertLessEqual(r.statistics["refine"]["max_relative_edge_length"], 1)
        self.assertEqual(len(r.points), r.number_of_vertices)

    def test_transfer_and_places(self):
        s = it.Surface(V, F)
        t = s.refine(min_angle=25)
        u = V @ [1, 2, 0] + 3
        for how in ("l2", "pointwise"):
            up = t.from_input(u, how)
            self.assertEqual(up.shape, (t.number_of_vertices,))
            self.assertEqual(t.to_input(np.column_stack([up, up]), how).shape, (len(V), 2))
        self.assertAlmostEqual((t.mass("galerkin") @ t.from_input(u)).sum(), _integral(u), 6)
        points = [it.Point(f, w) for f, w in zip(range(50), np.random.default_rng(2).dirichlet(
            [1, 1, 1], 50))]
        faces, weights = t.locate(points)
        back, again = t.locate([it.Point(f, w) for f, w in zip(faces, weights)], on="input")
        there = (V[F[back]] * again[:, :, None]).sum(axis=1)
        here = np.array([w @ V[F[f]] for f, w in points])
        self.assertLess(abs(there - here).max(), 1e-9)
        faces, weights = t.locate(np.arange(len(V)))
        self.assertTrue((t.faces[faces, weights.argmax(axis=1)] == np.arange(len(V))).all())
        c = t.common_subdivision()
        self.assertLess(abs(c.P_input @ V - c.points).max(), 1e-12)
        triangles, polygon = c.triangles()
        self.assertEqual(len(triangles), (np.diff(c.begins) - 2).sum())
        self.assertTrue((c.input_face[polygon] < len(F)).all())

    def test_points_and_soups(self):
        P = np.random.default_rng(3).normal(size=(300, 3))
        P /= np.linalg.norm(P, axis=1)[:, None]
        s = it.points(P, neighbors=20)
        self.assertEqual(s.laplacian().shape, (300, 300))
        self.assertLess(abs(s.mass().sum() - 4 * np.pi), 0.5)
        self.assertEqual(s.report["domain"]["kind"], "points")
        book = it.Surface(*BOOK)
        self.assertEqual(book.report["domain"]["kind"], "tufted")
        self.assertEqual(book.mass().shape, (5, 5))

    def test_files_that_cannot_be_written_are_errors_of_the_system(self):
        s, nowhere = it.Surface(V, F), self.folder / "nowhere"
        for name, save in (("s.idt", s.save), ("s.ply", s.save), ("c.vtp", s.path(0, 2).save),
                           ("o.npz", s.operators(k=2).save)):
            with self.assertRaises(FileNotFoundError) as caught:
                save(nowhere / name)
            self.assertEqual((caught.exception.filename, caught.exception.errno),
                             (str(nowhere / name), errno.ENOENT))
        (self.folder / "d.idt").mkdir()
        with self.assertRaises(IsADirectoryError):
            s.save(self.folder / "d.idt")
        with self.assertRaises(FileNotFoundError) as caught:
            it.read(nowhere)
        self.assertEqual(caught.exception.filename, str(nowhere))

    def test_options_that_would_do_nothing_are_refused(self):
        s = it.Surface(V, F)
        with self.assertRaisesRegex(ValueError, "plain is of meshes"):
            s.save(self.folder / "s.idt", plain=True)
        with self.assertRaisesRegex(ValueError, "polygons is of faces between points"):
            it.Surface(len(V), F, lengths=s.lengths, polygons="planar")

    def test_pages(self):
        page = it.Surface(V, F).delaunay().html()
        self.assertIn("<html", page)
        self.assertIn("iframe", it.Surface(V, F)._repr_html_())
        path = it.Surface(V, F).show(path=self.folder / "page.html", open_browser=False)
        self.assertGreater(os.path.getsize(path), 1000)


def _integral(u):
    """The integral over the faces of the function with values at vertices."""
    area = np.linalg.norm(np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]]), axis=1) / 2
    return (u[F].mean(axis=1) * area).sum()


class Work(With_folder):
    def test_progress(self):
        calls = []
        s = it.Surface(*bumpy(60))
        s.refine(min_angle=32, max_edge_length=0.05, max_insertions=30000,
                 progress=lambda stage, count, total: calls.append((stage, count)))
        self.assertTrue(calls)
        self.assertTrue(all(isinstance(n, int) for _, n in calls))
        del calls[:]
        it.Surface(*bumpy(3)).delaunay(progress=lambda *a: calls.append(a[0]))
        self.assertTrue(calls)  # of the first step, however short the work is

        def stop(stage, count, total):
            raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            s.refine(min_angle=32, max_edge_length=0.01, progress=stop)
        self.assertEqual(s.delaunay().certificate, "exact")  # nothing is spoilt

    def test_statistics_are_found_when_they_are_asked_for_and_are_the_same_then(self):
        part = it.read(PART)
        for points, faces in unit_grid(6), (V, F), bumpy(12, 5), (part.points, part.faces):
            s, stages = it.Surface(points, faces), set()
            keep = [faces[0][:2], faces[7][:2]]
            early = s.delaunay(keep=keep, progress=lambda stage, *counts: stages.add(stage))
            if len(points) == 49:  # no slivers
                self.assertNotIn("verifying", stages)
            expected = early.statistics
            late = s.delaunay(keep=keep)
            self.assertEqual((early.laplacian() != late.laplacian()).nnz, 0)
            np.testing.assert_array_equal(early.lengths, late.lengths)
            for found in late.statistics, copy.copy(late).statistics:
                for key in "delaunay", "constraints", "certificate", "input":
                    self.assertEqual(without_times(found[key]), without_times(expected[key]))
                for key in "quality", "area", "laplacian":
                    for name, value in expected[key].items():
                        np.testing.assert_allclose(found[key][name], value, rtol=1e-8)
            self.assertEqual(expected["constraints"]["input_edges"], 2)

    def test_faces_that_are_gone_are_not_counted(self):
        t = it.Surface(*bumpy(4)).refine(odt_length=0.05)
        self.assertEqual(t.number_of_faces, len(t.faces))

    def test_interrupts(self):
        s = it.Surface(*bumpy(40))
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            s.refine(min_angle=30, max_edge_length=0.002)
        self.assertLess(time.monotonic() - start, 30)
        timer.join()

    def test_threads(self):
        s, t = it.Surface(V, F), it.Surface(V, F).delaunay()
        expected = s.laplacian()

        def work(k):
            mine = it.Surface(V + k, F)
            for _ in range(5):
                mine.refine(min_angle=20)
                if (s.laplacian() != expected).nnz or (t.laplacian() != expected).nnz:
                    raise AssertionError("another matrix")
                t.common_subdivision()
                s.delaunay()

        self.assertEqual(failures_of_threads(work, 8), [])

    def test_nothing_leaks(self):
        points, faces = bumpy(4)

        def everything():
            s = it.Surface(points, faces)
            t = s.refine(min_angle=20, keep=[[0, 1]])
            t.laplacian(), t.mass(), t.faces, t.lengths, t.glue, t.points, t.statistics, s.report
            t.common_subdivision(), t.to_input(np.ones(t.number_of_vertices)), t.locate([0, 3])
            pickle.loads(pickle.dumps(t)), s.adapt(0, max_vertices=20)
            for bad in ([[0, 1, 99]], [[0, 0, 1]]):
                try:
                    it.Surface(points, bad)
                except ValueError:
                    pass

        grown_memory(everything, 20)
        gc.collect()
        resident = _resident()
        self.assertLess(grown_memory(everything, 300, before=0), 100_000)
        if not has_sanitizer():  # one page for each of the calls is more
            self.assertLess(_resident() - resident, 8_000_000)

    def test_import_is_fast_and_takes_no_scipy(self):
        code = ("import sys, time, numpy; t = time.process_time(); import intrinsic; "
                "print(time.process_time() - t, any(m.startswith('scipy') for m in sys.modules))")
        times = []
        for _ in range(3):
            seconds, has_scipy = subprocess.run([sys.executable, "-c", code], check=True, text=True,
                                                capture_output=True).stdout.split()
            times.append(float(seconds))
            self.assertEqual(has_scipy, "False")
        self.assertLess(min(times), 0.15)

    def test_examples_in_the_documentation(self):
        for module in (it, sys.modules["intrinsic._surface"]):
            self.assertEqual(doctest.testmod(module).failed, 0)


def _resident():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


if __name__ == "__main__":
    unittest.main()
