# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The module gives what the program `intrinsic` gives, bit for bit."""

import json
import unittest

import intrinsic as it
from support import PART, Module_test, mesh

# Manifold, with border, of polygons, with ties, of several components, of slivers.
MESHES = ("camel.off", "fandisk.off", "cube_quad.off", "eight.off", "mech-holes-shark.off",
          "hedra.off")


def without_times(statistics):
    return {key: value for key, value in statistics.items()
            if key not in ("seconds", "peak_rss_mib")}


class Program(Module_test):
    def some_meshes(self):
        yield PART
        found = 0
        for name in MESHES:
            try:
                yield mesh(name)
                found += 1
            except unittest.SkipTest:
                continue

    def statistics(self, *arguments):
        return json.loads(self.run_program(*arguments, "--stats", "-"))

    def test_delaunay_triangulations_laplacians_and_statistics(self):
        for path in self.some_meshes():
            with self.subTest(path=path):
                self.run_program("laplacian", path, "-o", "l.mtx", "--mass", "m.mtx",
                                 "--mass-kind", "galerkin")
                expected = self.statistics("delaunay", path, "-o", "p.idt")
                s = it.read(path)
                t = s.delaunay()
                t.save(self.path("t.idt"))  # before matrices, which sharpen what is stored
                self.assert_same_file("t.idt", "p.idt")
                for surface in (s, t):  # flipped behind the scenes, or before
                    self.assert_same_matrix(surface.laplacian(), self.read_matrix("l.mtx"))
                    mass, expected_mass = surface.mass("galerkin"), self.read_matrix("m.mtx")
                    # this command keeps no correspondence: areas of slivers are rounded otherwise
                    difference = abs(mass - expected_mass)
                    self.assertEqual((difference > 1e-12 * expected_mass).nnz, 0)
                self.assertEqual(without_times(t.statistics), without_times(expected))
                self.assertEqual(t.certificate, expected["certificate"])

    def test_refined_triangulations(self):
        for path in list(self.some_meshes())[1:4]:
            for options, arguments in (
                    ({"min_angle": 25}, ["--min-angle", 25]),
                    ({"min_angle": 20, "keep": 60.}, ["--min-angle", 20, "--sharp-angle", 60]),
                    ({"min_angle": 30, "max_insertions": 50, "arithmetic": "double"},
                     ["--min-angle", 30, "--max-insertions", 50, "--arithmetic", "double"])):
                with self.subTest(path=path, options=options):
                    arithmetic = options.pop("arithmetic", "exact")
                    expected = self.statistics("refine", path, "-o", "p.idt", "--laplacian",
                                               "l.mtx", *arguments)
                    t = it.read(path, arithmetic=arithmetic).refine(**options)
                    t.save(self.path("t.idt"))
                    self.assert_same_file("t.idt", "p.idt")
                    statistics = t.statistics
                    self.assert_same_matrix(t.laplacian(), self.read_matrix("l.mtx"))
                    self.assertEqual(without_times(statistics), without_times(expected))

    def test_common_subdivisions_and_transfer(self):
        for path in list(self.some_meshes())[:2]:
            with self.subTest(path=path):
                self.run_program("refine", path, "--interpolation", "p.mtx",
                                 "--input-interpolation", "q.mtx", "-o", "s.off")
                t = it.read(path).refine(min_angle=30)
                c = t.common_subdivision()
                self.assert_same_matrix(c.P_intrinsic, self.read_matrix("p.mtx"))
                self.assert_same_matrix(c.P_input, self.read_matrix("q.mtx"))
                with open(self.path("s.off"), encoding="ascii") as file:
                    rows = [line.split() for line in file if line[:1] not in "#\n"][2:]
                points = [[float(x) for x in row] for row in rows[:len(c.V)]]
                self.assertTrue(points == c.V.tolist())
                polygons = [[int(x) for x in row[1:1 + int(row[0])]] for row in rows[len(c.V):]]
                self.assertTrue(polygons == [p.tolist() for p in c.polygons])

    def test_stored_triangulations(self):
        self.run_program("refine", PART, "-o", "p.idt")
        t = it.load(self.path("p.idt"))
        t.save(self.path("t.idt"))
        self.assert_same_file("t.idt", "p.idt")
        self.assertEqual(t.certificate, "exact")

    def test_surfaces_of_arrays_are_those_of_files(self):
        for path in self.some_meshes():
            with self.subTest(path=path):
                s = it.read(path)
                if s.number_of_faces != s.number_of_input_faces:
                    continue  # of polygons, or a cover
                r = it.Surface(s.points, s.faces)
                self.assert_same_matrix(r.laplacian(), s.laplacian())


if __name__ == "__main__":
    unittest.main()
