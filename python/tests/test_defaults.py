# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Without options, methods have the defaults of the library's table, and every command of the
program gives what the method gives."""

import inspect
import unittest

import numpy as np
import scipy.io

import intrinsic as it
import program
from intrinsic import _core
from support import PART

S = it.Surface
# Parameters and their names in the table. Others have no default value but None.
TABLE = [
    (S.__init__, {"domain": "domain", "arithmetic": "arithmetic",
                  "mollification": "mollification", "polygons": "polygons"}),
    (it.read, {"domain": "domain", "polygons": "polygons"}),
    (it.points, {"neighbors": "neighbors", "arithmetic": "arithmetic",
                 "mollification": "mollification"}),
    (S.refine, {"min_angle": "min_angle", "order": "order"}),
    (S.adapt, {"min_angle": "min_angle", "tolerance": "tolerance",
               "max_vertices": "max_vertices"}),
    (S.mass, {"kind": "mass_kind"}),
    (S.to_input, {"method": "transfer_method"}),
    (S.from_input, {"method": "transfer_method"}),
    *((f, {"method": "distance_method"}) for f in (S.distance, S.distances, S.pair_distances)),
    *((f, {"time_factor": "time_factor"}) for f in (
        S.distance, S.distances, S.log_map, S.transport, S.extend, S.signed_distance)),
    *((f, {"method": "curve_method"}) for f in (S.path, S.loop, S.network)),
    (S.isolines, {"levels": "levels"}),
    (S.parametrize, {"method": "map_method"}),
    (S.uniformize, {"start": "start"}),
    (S.direction_field, {"degree": "degree"}),
    (S.eigen, {"count": "count"}),
    (S.deform, {"energy": "energy"}),
    (S.simplify, {"cost": "removal_cost"}),
]


class Signatures(unittest.TestCase):
    def test_signatures_have_the_defaults_of_the_table(self):
        for function, names in TABLE:
            parameters = inspect.signature(function).parameters
            for parameter, name in names.items():
                with self.subTest(function=function.__name__, parameter=parameter):
                    self.assertEqual(parameters[parameter].default, _core.defaults[name])


@unittest.skipUnless(program.is_there(), "the program or its meshes are missing")
class Commands(program.Comparison):
    """Each command of the program without options, and its method, on a mesh with a border and on a
    closed one."""

    meshes = PART, program.MESHES / "nefertiti.off"

    def test_triangulations(self):
        for path in self.meshes:
            s = it.read(path)
            for command, found in ("delaunay", s.delaunay()), ("refine", s.refine()):
                with self.subTest(path=path, command=command):
                    program.run(command, path, "-o", self.folder / "p.idt")
                    found.save(self.folder / "t.idt")
                    self.assertTrue((self.folder / "p.idt").read_bytes() ==
                                    (self.folder / "t.idt").read_bytes())
            report = program.run("info", path)["input"]
            self.assertEqual(report, s.report["input"])
        adapted = program.run("refine", self.meshes[1], "--adaptive")["adaptive"]
        self.assertEqual(adapted, it.read(self.meshes[1]).adapt().statistics["adaptive"])

    def test_matrices_and_transfer(self):
        for path in self.meshes:
            s = it.read(path)
            program.run("laplacian", path, "-o", self.folder / "l.mtx", "--mass",
                        self.folder / "m.mtx")
            for name, matrix in ("l.mtx", s.laplacian()), ("m.mtx", s.mass()):
                there = scipy.io.mmread(self.folder / name).tocsr()
                self.assertLessEqual(abs(there - matrix).max(), 1e-12 * abs(there).max())
            u = np.cos(np.arange(s.number_of_vertices))
            np.savetxt(self.folder / "u.txt", u, fmt="%r")
            _, there = self.numbers_of_program("transfer", path, self.folder / "u.txt")
            np.testing.assert_array_equal(there, s.delaunay().from_input(u))

    def test_curves_and_cuts(self):
        for path in self.meshes:
            s = it.read(path)
            found = program.run("geodesic", path, "--path", "0,200")["geodesic"]
            self.assertEqual(found["curves"][0]["length"], s.path(0, 200).length)
        path = self.meshes[1]
        s = it.read(path)
        found = program.run("cut", path, "--source", 0, "--levels", 3)["cut"]
        cut = s.cut(s.isolines(s.distance(0), 3))
        self.assertEqual(found["faces"], len(cut.faces))

    def test_distances(self):
        for path in self.meshes:
            s = it.read(path)
            _, d = self.numbers_of_program("distance", path, "--source", 0)
            np.testing.assert_array_equal(d, s.distance(0))
            (self.folder / "pairs.txt").write_text("0 200\n1 30\n")
            found = program.run("distance", path, "--pairs", self.folder / "pairs.txt")
            np.testing.assert_array_equal(found["distance"]["distances"],
                                          s.pair_distances([0, 1], [200, 30]))
            (self.folder / "sets.txt").write_text("0\n1 200\n")
            program.run("distance", path, "--sources", self.folder / "sets.txt", "-o",
                        self.folder / "d.npy")
            matrix = np.load(self.folder / "d.npy")
            np.testing.assert_array_equal(matrix, s.distances([0, [1, 200]]))
            program.run("distance", path, "--sources", self.folder / "sets.txt", "-o",
                        self.folder / "d.txt")
            np.testing.assert_array_equal(matrix, np.loadtxt(self.folder / "d.txt"))
            program.run("distance", path, "--source", 0, "--isolines", self.folder / "l.obj")
            t = s.delaunay()
            self.assertEqual(len(program.polylines(self.folder / "l.obj")),
                             sum(len(line) > 1 for line in t.isolines(t.distance(0))))
            found = program.run("distance", path, "--source", "0,200", "--voronoi",
                                self.folder / "v.obj")["distance"]["cells"]
            np.testing.assert_array_equal(found["areas"], s.voronoi([0, 200]).areas)
        _, d = self.numbers_of_program("distance", path, "--signed", "--curve", "0,200")
        np.testing.assert_array_equal(d, s.signed_distance([0, 200]))

    def test_vectors(self):
        (self.folder / "v.txt").write_text("0 0\n")
        for path in self.meshes:
            s = it.read(path)
            _, d = self.numbers_of_program("transport", path, "--vectors", self.folder / "v.txt")
            np.testing.assert_array_equal(d[:, 1:3], s.transport(0, [1, 0]).coordinates)
            _, d = self.numbers_of_program("logmap", path, "--source", 0)
            np.testing.assert_array_equal(d, s.log_map(0))
            _, d = self.numbers_of_program("field", path)
            np.testing.assert_array_equal(d[:, :2], s.direction_field().coordinates)

    def test_maps_eigenfunctions_and_deformations(self):
        path = self.meshes[1]
        s = it.read(path)
        for p in path, program.MESHES / "eight.off":  # a disk, and a surface that must be cut open
            _, uv = self.numbers_of_program("parametrize", p)
            np.testing.assert_array_equal(uv[:, :2], it.read(p).parametrize().uv)
        _, u = self.numbers_of_program("uniformize", path)
        np.testing.assert_array_equal(u, s.uniformize().u)
        values, _ = s.eigen()
        np.testing.assert_array_equal(program.run("eigen", path)["eigen"]["values"], values)
        (self.folder / "h.txt").write_text("0 1 0 0\n9 0 0 0\n")
        _, moved = self.numbers_of_program("edit", path, "--handles", self.folder / "h.txt")
        np.testing.assert_array_equal(moved, s.deform({0: [1, 0, 0], 9: [0, 0, 0]}))


if __name__ == "__main__":
    unittest.main()
