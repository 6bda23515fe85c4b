# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ten tasks for the installed package `intrinsic-triangulations`: `python/check_wheel.sh` runs them
where the system's GMP and MPFR are hidden, cibuildwheel after each build."""

import importlib.metadata
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import scipy.sparse.linalg

import intrinsic as it

PART = Path(__file__).resolve().parents[2] / "examples" / "data" / "part.off"
PROGRAM = Path(sys.executable).with_name("intrinsic")


class Ten_tasks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.s = it.read(PART)
        cls.n = cls.s.number_of_input_vertices

    def test_1_the_package_has_its_version(self):
        self.assertEqual(it.__version__, importlib.metadata.version("intrinsic-triangulations"))

    def test_2_it_uses_the_libraries_that_came_with_it(self):
        used = {line.split()[-1] for line in Path("/proc/self/maps").read_text().splitlines()
                if "/libgmp.so" in line or "/libmpfr.so" in line}
        own = Path(it.__file__).parents[1] / "intrinsic.libs"
        self.assertEqual({Path(file).parent for file in used}, {own})

    def test_3_the_delaunay_triangulation_is_certified(self):
        self.assertEqual(self.s.delaunay().certificate, "exact")

    def test_4_refinement_reaches_the_angle(self):
        t = self.s.refine(min_angle=25)
        self.assertGreater(t.number_of_vertices, self.n)
        self.assertEqual(t.to_input(np.ones(t.number_of_vertices)).shape, (self.n,))

    def test_5_a_poisson_equation_has_a_solution(self):
        L, M = self.s.laplacian(), self.s.mass()
        u = scipy.sparse.linalg.spsolve((L + M).tocsc(), M @ np.ones(self.n))
        np.testing.assert_allclose(u, 1, rtol=1e-6)

    def test_6_distances_are_exact(self):
        d = self.s.distance(0)
        self.assertEqual(d[0], 0)
        self.assertTrue(np.all(np.isfinite(d)))

    def test_7_a_geodesic_is_no_longer_than_edges(self):
        self.assertGreater(self.s.path(0, self.n - 1).length, 0)

    def test_8_a_field_has_its_singularities(self):
        self.assertTrue(self.s.direction_field(4))

    def test_9_eigenvalues_increase(self):
        values, _ = self.s.eigen(4)
        self.assertTrue(np.all(np.diff(values) >= -1e-9))

    def test_10_the_program_is_there_with_its_companions(self):
        with tempfile.TemporaryDirectory() as folder:
            said = subprocess.run([PROGRAM, "delaunay", PART, "--stats", "-"], check=True,
                                  capture_output=True, text=True).stdout
            self.assertEqual(json.loads(said)["certificate"], "exact")
            values = Path(folder) / "distance.txt"
            subprocess.run([PROGRAM, "distance", PART, "--source", "0", "--on", "input", "-o",
                            values], check=True)
            self.assertEqual(len(np.loadtxt(values)), self.n)
            subprocess.run([PROGRAM, "study", "--help"], check=True, capture_output=True)
            page = Path(folder) / "page.html"
            drawn = subprocess.run([PROGRAM, "delaunay", PART, "--view", page],
                                   capture_output=True, text=True)
            if drawn.returncode == 1 and "was built without three.js" in drawn.stderr:
                self.skipTest("the wheel has no pages: three.js was missing where it was built")
            self.assertEqual(drawn.returncode, 0, drawn.stderr)
            self.assertIn("<canvas", page.read_text())


if __name__ == "__main__":
    unittest.main(verbosity=2)
