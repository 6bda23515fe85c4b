# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The module gives what the program `intrinsic` gives, bit for bit: triangulations and matrices."""

import unittest

import numpy as np
import scipy.io

import intrinsic as it
import program
from support import BOOK, PART, without_times

MOEBIUS = [[0, 0, 0], [1, 0, 0], [2, 1, 0], [1, 2, 1], [0, 1, 1]], [[i, (i + 1) % 5, (i + 2) % 5]
                                                                 for i in range(5)]


@unittest.skipUnless(program.is_there(), "the program or its meshes are missing")
class Program(program.Comparison):
    def meshes(self, names):
        """A part of slivers, surfaces that are covered, and meshes of the data set."""
        yield PART
        for name, (V, F) in ("book.off", BOOK), ("moebius.off", MOEBIUS):
            path = self.folder / name
            lines = [f"OFF {len(V)} {len(F)} 0", *(" ".join(map(str, p)) for p in V),
                     *(" ".join(map(str, [len(f), *f])) for f in F)]
            path.write_text("\n".join(lines))
            yield path
        for name in names:
            yield program.MESHES / name

    def matrix(self, name):
        """A matrix that the program has written."""
        return scipy.io.mmread(self.folder / name).tocsr()

    def expect_same_matrix(self, a, b):
        self.assertEqual(a.shape, b.shape)
        self.assertEqual((a != b).nnz, 0)

    def expect_saved_as(self, t, name):
        t.save(self.folder / "t.idt")
        there = (self.folder / name).read_bytes()
        self.assertTrue((self.folder / "t.idt").read_bytes() == there, f"{name} differs")

    def test_delaunay_triangulations_laplacians_and_statistics(self):
        for path in self.meshes(program.TWENTY):
            with self.subTest(path=path):
                program.run("laplacian", path, "-o", self.folder / "l.mtx", "--mass",
                            self.folder / "m.mtx", "--mass-kind", "galerkin")
                expected = program.run("delaunay", path, "-o", self.folder / "p.idt")
                s = it.read(path)
                t = s.delaunay()
                self.expect_saved_as(t, "p.idt")  # before matrices, which sharpen values
                statistics = t.statistics
                for surface in (s, t):  # flipped behind the scenes, or before
                    self.expect_same_matrix(surface.laplacian(), self.matrix("l.mtx"))
                    mass, expected_mass = surface.mass("galerkin"), self.matrix("m.mtx")
                    # this command keeps no correspondence: areas of slivers are rounded otherwise
                    difference = abs(mass - expected_mass)
                    self.assertEqual((difference > 1e-12 * expected_mass).nnz, 0)
                self.assertEqual(without_times(statistics), without_times(expected))
                self.assertEqual(t.certificate, expected["certificate"])
                if s.number_of_faces == s.number_of_input_faces:  # no polygons, no cover
                    r = it.Surface(s.points, s.faces)
                    self.expect_same_matrix(r.laplacian(), self.matrix("l.mtx"))

    def test_refined_triangulations(self):
        few = "nefertiti.off", "hand.off", "mpi.off", "double-torus-3-holes.off"
        for path in self.meshes(program.some(few, program.TWENTY)):
            for options, arguments in (
                    ({"min_angle": 25}, ["--min-angle", 25]),
                    ({"min_angle": 20, "keep": 60.}, ["--min-angle", 20, "--sharp-angle", 60]),
                    ({"min_angle": 30, "max_insertions": 50, "arithmetic": "double"},
                     ["--min-angle", 30, "--max-insertions", 50, "--arithmetic", "double"])):
                with self.subTest(path=path, options=options):
                    arithmetic = options.pop("arithmetic", "exact")
                    expected = program.run("refine", path, "-o", self.folder / "p.idt",
                                           "--laplacian", self.folder / "l.mtx", *arguments)
                    t = it.read(path, arithmetic=arithmetic).refine(**options)
                    self.expect_saved_as(t, "p.idt")
                    statistics = t.statistics
                    self.expect_same_matrix(t.laplacian(), self.matrix("l.mtx"))
                    self.assertEqual(without_times(statistics), without_times(expected))

    def test_common_subdivisions_and_transfer(self):
        for path in self.meshes(program.some(("patch-13.off", "eight.off"), program.TWENTY)):
            with self.subTest(path=path):
                program.run("refine", path, "--interpolation", self.folder / "p.mtx",
                            "--input-interpolation", self.folder / "q.mtx",
                            "-o", self.folder / "s.off")
                t = it.read(path).refine()
                c = t.common_subdivision()
                self.expect_same_matrix(c.P_intrinsic, self.matrix("p.mtx"))
                self.expect_same_matrix(c.P_input, self.matrix("q.mtx"))
                V, polygons = program.surface(self.folder / "s.off")
                np.testing.assert_array_equal(V, c.points)
                self.assertTrue(polygons == [p.tolist() for p in c.polygons])

    def test_stored_triangulations(self):
        program.run("refine", PART, "-o", self.folder / "p.idt")
        t = it.load(self.folder / "p.idt")
        self.expect_saved_as(t, "p.idt")
        self.assertEqual(t.certificate, "exact")


if __name__ == "__main__":
    unittest.main()
