# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the module share: meshes, and the program `intrinsic` to compare with."""

import os
import subprocess
import tempfile
import unittest

import numpy as np
import scipy.io
from program import MESHES, PROGRAM

PART = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "data",
                    "part.off")


def mesh(name):
    """The path of a mesh of CGAL's data set; skips the test if it is not installed."""
    path = os.path.join(MESHES, name)
    if not os.path.exists(path):
        raise unittest.SkipTest(f"{name} of CGAL's data set is not there")
    return path


def bumpy(n=12, seed=1):
    """Vertices and triangles of a height field with random places and slivers."""
    random = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(n, dtype=float), np.arange(n, dtype=float))
    V = np.column_stack([x.ravel(), 0.2 * y.ravel(), np.zeros(n * n)])
    V += random.uniform(-0.3, 0.3, V.shape) * [1, 0.2, 1]
    i = np.arange(n * n).reshape(n, n)
    a, b, c, d = i[:-1, :-1].ravel(), i[:-1, 1:].ravel(), i[1:, 1:].ravel(), i[1:, :-1].ravel()
    return V, np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


class Module_test(unittest.TestCase):
    """Has a directory of its own, and runs the program there."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def path(self, name):
        return os.path.join(self.directory, name)

    def run_program(self, *arguments):
        """Runs the program, and returns what it writes to standard output."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.directory, timeout=120,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def read_matrix(self, name):
        """A matrix that the program has written."""
        return scipy.io.mmread(self.path(name)).tocsr()

    def assert_same_matrix(self, a, b):
        """Checks that all entries are the same numbers."""
        self.assertEqual(a.shape, b.shape)
        self.assertEqual((a != b).nnz, 0)

    def assert_same_file(self, a, b):
        with open(self.path(a), "rb") as first, open(self.path(b), "rb") as second:
            self.assertTrue(first.read() == second.read(), f"{a} and {b} differ")
