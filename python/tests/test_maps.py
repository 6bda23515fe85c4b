# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps, eigenfunctions, deformations: closed forms, and bit for bit what the program computes."""

import doctest
import unittest
from fractions import Fraction

import numpy as np

import intrinsic as it
import program
from support import CUBE, grid, grown_memory


def bent(n=9):
    """Half a cylinder of radius 1, as wide as half its circumference."""
    V, F = grid(n)
    x = V[:, 0] / (n - 1) * np.pi
    return np.column_stack([np.cos(x), np.sin(x), V[:, 1] / (n - 1) * np.pi]), F


def torus(n=12, m=8):
    i, j = (x.ravel() for x in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    u, v = 2 * np.pi * i / n, 2 * np.pi * j / m
    V = np.column_stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)])
    a, b, c, d = ((i + k) % n * m + (j + l) % m for k, l in ((0, 0), (1, 0), (1, 1), (0, 1)))
    return V, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


class Closed_forms(unittest.TestCase):
    def test_the_surface_of_a_map_has_the_faces_that_it_is_certified_on(self):
        random = np.random.default_rng(1)
        for k in range(12):  # sheared and bent, so that edges flip
            V, F = grid(6)
            V = V + np.c_[random.random((len(V), 2)) * .4, random.random(len(V))]
            s = it.Surface(V @ [[1, 0, 0], [2.5, 1, 0], [0, 0, 1]], F)
            for method in ("harmonic", "lscm", "spectral"):
                with self.subTest(k=k, method=method):
                    m = s.parametrize(method)
                    p = m.uv[m.surface.faces]
                    areas = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
                    self.assertEqual(m.certificate["flipped_faces"], (areas < 0).sum())
                    if not m.inserted_vertices:
                        np.testing.assert_array_equal(m.surface.faces, s.delaunay().faces)

    def test_flat_surfaces_are_only_turned(self):
        V, F = grid()
        d = np.linalg.norm(V[:, None] - V[None], axis=2)
        for method in ("lscm", "spectral", "conformal"):
            m = it.Surface(V, F).parametrize(method)
            uv = m.uv if method != "conformal" else m.layout.uv
            if method == "conformal":
                np.testing.assert_allclose(m.u, 0, atol=1e-9)
                order = np.argsort(m.layout.vertices)
                uv = uv[order[-81:]]
            self.assertTrue(m.certificate["locally_injective"])
            self.assertAlmostEqual(m.distortion["max_quasi_conformal"], 1, 9)
            found = np.linalg.norm(uv[:, None] - uv[None], axis=2)
            np.testing.assert_allclose(found, d, atol=1e-9)

    def test_conformal_maps_of_disks_are_those_of_uniformize(self):
        s = it.Surface(*bent())
        for start in (None, "delaunay", "input"):
            m = s.parametrize("conformal", start=start)
            same = s.uniformize(start=start or "delaunay")
            np.testing.assert_array_equal(m.u, same.u)
            np.testing.assert_array_equal(m.layout.uv, same.layout.uv)

    def test_harmonic_maps_go_to_the_unit_disk(self):
        m = it.Surface(*bent()).parametrize()
        self.assertEqual((m.status, m.certificate["injective"], m.injective_on_input),
                         ("done", True, True))
        self.assertAlmostEqual(np.hypot(*m.uv.T).max(), 1, 14)
        self.assertGreater(m.distortion["mean_quasi_conformal"], 1.1)
        self.assertEqual(m.surface._core.number_of_vertices, len(m.uv))

    def test_spheres_become_round_and_tori_flat(self):
        sphere = it.Surface(*CUBE).uniformize()
        self.assertEqual((sphere.target, sphere.status), ("sphere", "done"))
        np.testing.assert_allclose(np.linalg.norm(sphere.points, axis=1), 1, rtol=1e-12)
        self.assertTrue(sphere.sphere["injective"])
        flat = it.Surface(*torus()).uniformize()
        self.assertEqual((flat.target, flat.status), ("torus", "done"))
        self.assertLess(flat.residual, 1e-10)
        self.assertLess(flat.proven_residual, 1e-8)
        self.assertAlmostEqual(flat.period.real, 0, 9)  # a mirror goes along it
        self.assertGreaterEqual(abs(flat.period), 1 - 1e-12)
        self.assertAlmostEqual(sum(flat.u), 0, 9)
        np.testing.assert_allclose(flat.scale_factors, np.exp(flat.u / 2), rtol=1e-15)
        # differences across seams are integers in the basis of the translations
        at = {}
        for v, uv in zip(flat.layout.vertices, flat.layout.uv):
            if v >= 0:
                at.setdefault(v, []).append(uv)
        copies = [p - ps[0] for ps in at.values() for p in ps]
        np.testing.assert_allclose(copies, np.round(copies), atol=1e-9)

    def test_cones_of_a_cube(self):
        found = it.Surface(*CUBE).uniformize(["3/2pi"] * 8)
        self.assertEqual((found.target, found.status), ("plane", "done"))
        np.testing.assert_allclose(found.u, 0, atol=1e-9)  # it has these angles
        self.assertEqual(found.cones, {v: 1.5 * np.pi for v in range(8)})
        for angles in ([1.5 * np.pi] * 8, ["3pi/2"] * 8, [Fraction(3, 2)] * 8):
            np.testing.assert_allclose(it.Surface(*CUBE).uniformize(angles).u, 0, atol=1e-9)
        free = it.Surface(*CUBE).uniformize(cones={0: "free", 3: "free", 5: "free"})
        self.assertEqual(free.status, "done")
        np.testing.assert_array_equal(free.u[[0, 3, 5]], 0)
        self.assertEqual(len(it.Surface(*CUBE).uniformize(cones=8).cones), 8)

    def test_layouts_have_all_faces_in_the_plane(self):
        found = it.Surface(*bent()).uniformize()
        layout = found.layout
        self.assertEqual(set(layout.input_faces), set(range(128)))
        u, v = layout.uv.T
        area = sum(u[p] @ np.roll(v[p], -1) - v[p] @ np.roll(u[p], -1) for p in layout.polygons) / 2
        self.assertAlmostEqual(area, 2 * 8 * np.sin(np.pi / 16) * np.pi, 9)  # it can be developed
        self.assertEqual(layout.seams.shape, (0, 2))
        self.assertEqual(set(it.Surface(*bent()).uniformize(start="input").layout.input_faces),
                         set(range(128)))

    def test_surfaces_with_handles_go_to_the_disk(self):
        V, F = torus()
        V2, keep = V + [0, 20, 0], np.arange(1, len(F))  # two tori, glued along a missing face
        i, j = F[0], F[0][[0, 2, 1]] + len(V)
        F2 = F[keep, ::-1] + len(V)
        number = np.arange(2 * len(V))
        number[j] = i[[0, 2, 1]]
        used, faces = np.unique(number[np.concatenate([F[keep], F2])], return_inverse=True)
        s = it.Surface(np.concatenate([V, V2])[used], faces.reshape(-1, 3))
        found = s.uniformize()
        self.assertEqual((found.target, found.status), ("disk", "done"))
        self.assertLess(np.hypot(*found.layout.uv.T).max(), 1)
        # pieces have straight sides, which cut geodesics off: one may turn over from the other start
        self.assertTrue(s.uniformize(start="input").certificate["locally_injective"])

    def test_edges_to_cut_at(self):
        m = it.Surface(*CUBE).parametrize("lscm", cut=[[0, 1], [1, 3], [3, 2]])
        self.assertEqual(len(m.uv), 10)
        self.assertEqual(sorted(m.original_vertex[8:]), [1, 3])
        self.assertTrue(m.certificate["locally_injective"])
        whole = it.Surface(*grid()).parametrize("lscm", cut="auto")  # is a disk
        np.testing.assert_array_equal(whole.original_vertex, np.arange(81))

    def test_surfaces_that_are_no_disks_are_cut_open(self):
        m = it.Surface(*CUBE).parametrize()
        self.assertTrue(m.certificate["injective"])
        self.assertGreater(len(m.original_vertex), 8)
        self.assertIsNone(it.Surface(*grid()).parametrize().original_vertex)  # is a disk

    def test_eigenvalues_of_a_square(self):
        s = it.Surface(*grid(33))
        values, functions = s.eigen(4)
        expected = (np.pi / 32) ** 2 * np.array([0, 1, 1, 2])
        np.testing.assert_allclose(values, expected, atol=2e-4)
        M = s.mass()
        np.testing.assert_allclose(functions.T @ (M @ functions), np.eye(4), atol=1e-10)
        np.testing.assert_allclose(s.laplacian() @ functions, (M @ functions) * values, atol=1e-12)

    def test_iterations_agree_with_factors(self):
        s = it.Surface(*grid(40))
        for name, solve in (("eigen", lambda x: s.eigen(4, solver=x)[0]),
                            ("deform", lambda x: s.deform({0: [1], 90: [3]}, solver=x)),
                            ("harmonic", lambda x: s.parametrize(solver=x).uv),
                            ("lscm", lambda x: s.parametrize("lscm", solver=x).uv),
                            ("field", lambda x: s.direction_field(
                                2, fixed=([703], [[1, 0]]), solver=x).coordinates)):
            found, expected = solve("iterative"), solve("direct")
            np.testing.assert_allclose(found, expected, atol=1e-7, err_msg=name)
            np.testing.assert_array_equal(solve("auto"), expected, err_msg=name)  # a small one

    def test_deformations_of_a_square(self):
        V, F = grid()
        s = it.Surface(V, F)
        d = s.deform({0: [0, 0, 2], 8: [0, 0, 2], 80: [0, 0, 2]})
        np.testing.assert_allclose(d, np.tile([0, 0, 2], (81, 1)), atol=1e-9)
        rows, border = np.arange(81), (V[:, :2] % 8 == 0).any(axis=1)
        linear = V[:, :2] @ [[1, 0], [2, 1]]
        for energy in ("harmonic", "biharmonic"):
            found = s.deform(rows[border], linear[border], energy=energy)
            np.testing.assert_array_equal(found[border], linear[border])
            if energy == "harmonic":
                np.testing.assert_allclose(found, linear, atol=1e-12)


class Arguments(unittest.TestCase):
    def test_bad_ones_are_named(self):
        s, cube = it.Surface(*grid(4)), it.Surface(*CUBE)
        frame = it.Surface(grid(4)[0], np.delete(grid(4)[1], [8, 9], axis=0))
        for message, call in (
                ("does not exist", lambda: s.parametrize("fast")),
                ("does not exist", lambda: cube.parametrize(cut="all")),
                ("shape", lambda: cube.parametrize(cut=[0, 1])),
                ("no edge joins", lambda: cube.parametrize(cut=[[0, 7]])),
                ("does not exist", lambda: s.uniformize(target="cube")),
                ("does not exist", lambda: s.uniformize(start="end")),
                ("does not exist", lambda: s.parametrize("conformal", start="end")),
                ("of conformal maps", lambda: s.parametrize("lscm", start="input")),
                ("leave cut out", lambda: cube.parametrize("conformal", cut="auto")),
                ("is closed; uniformize", lambda: cube.parametrize("conformal")),
                ("has 2 borders; uniformize", lambda: frame.parametrize("conformal")),
                ("start", lambda: s.parametrize("conformal", start="delaunay", flip=False)),
                ("leave cut and flip", lambda: it.points(grid(4)[0]).parametrize(
                    "spectral", cut="auto")),
                ("would be 0, as it is flat; take the target plane, or torus",
                 lambda: it.Surface(*torus()).uniformize(target="disk")),
                ("target sphere", lambda: cube.uniformize(target="disk")),
                ("not both", lambda: cube.uniformize([1] * 8, cones=3)),
                ("has 2 angles", lambda: cube.uniformize([1, 2])),
                ("vertex 0 is", lambda: cube.uniformize(["2"] * 8)),
                ("vertex 1 is -1", lambda: cube.uniformize(cones={1: -1})),
                ("from 0 to 7", lambda: cube.uniformize(cones={8: 1})),
                ("no cones", lambda: cube.uniformize(cones=4, target="sphere")),
                ("Gauss", lambda: cube.uniformize(["pi"] * 8)),
                ("count is .*; give a positive whole number", lambda: s.eigen(-1)),
                ("count is .*; give a positive whole number", lambda: s.eigen(2.5)),
                ("a row for each", lambda: s.deform([0, 1], [[1, 0, 0]])),
                ("displacements are missing", lambda: s.deform([0])),
                ("displacements are given twice", lambda: s.deform({0: [1]}, [[2]])),
                ("handles is empty", lambda: s.deform({})),
                ("handles is empty", lambda: s.deform([], np.zeros((0, 3)))),
                ("from 0 to 15", lambda: s.deform({16: [1]})),
                ("energy", lambda: s.deform({0: [1.0]}, energy="none")),
                ("leave it out", lambda: s.parametrize("conformal", solver="iterative")),
                ("direct solver", lambda: it.points(grid(4)[0]).direction_field(
                    solver="iterative"))):
            with self.assertRaisesRegex(ValueError, message):
                call()

    def test_nothing_leaks(self):
        s = it.Surface(*grid(4))

        def work():
            s.parametrize()
            s.uniformize()
            s.eigen(3)
            s.deform({0: [0, 0, 1]})

        self.assertLess(grown_memory(work, 50), 20000)


@unittest.skipUnless(program.is_there(), "the program or its meshes are missing")
class As_the_program(program.Comparison):
    DISKS = program.some(("nefertiti.off", "patch-30.off", "mushroom.off"), program.DISKS)
    CLOSED = program.some(("hand.off", "rotor.off", "anchor.off", "double-torus-example.off"),
                          program.CLOSED)

    def test_maps_to_the_plane(self):
        for name in self.DISKS:
            path, V, F = program.mesh(name)
            s = it.Surface(V, F)
            for method in ("harmonic", "lscm", "spectral"):
                found, expected = self.numbers_of_program("parametrize", path, "--method", method)
                m, found = s.parametrize(method), found["parametrize"]
                np.testing.assert_array_equal(m.uv, expected, f"{name} {method}")
                self.assertEqual(m.injective_on_input, found["injective_on_input"])
                for key in ("injective", "flipped_faces", "degenerate_faces", "border_is_simple"):
                    self.assertEqual(m.certificate[key], found[key])
                self.assertEqual(m.distortion["max_quasi_conformal"], found["max_quasi_conformal"])
                self.assertEqual((m.rounds, m.inserted_vertices),
                                 (found["rounds"], found["inserted_vertices"]))

    def test_maps_of_surfaces_that_are_cut_open(self):
        for name in "rotor.off", "double-torus-example.off", "hand.off":
            path, V, F = program.mesh(name)
            for method in ("harmonic", "spectral"):
                found, expected = self.numbers_of_program("parametrize", path, "--method", method,
                                                   "--cut", "auto")
                m = it.Surface(V, F).parametrize(method, cut="auto")
                np.testing.assert_allclose(m.uv, expected[:, :2], atol=1e-9, err_msg=name)
                rows = expected[:len(m.original_vertex), 2]
                np.testing.assert_array_equal(m.original_vertex, rows, name)
                self.assertEqual(m.certificate["injective"], found["parametrize"]["injective"])

    def test_scale_factors(self):
        for name in self.DISKS + self.CLOSED:
            path, V, F = program.mesh(name)
            s = it.Surface(V, F)
            for start in ("input", "delaunay"):
                for cones in (None, 4):
                    options = ("--start", start) + (() if cones is None else ("--cones", cones))
                    if cones is None and name in self.CLOSED[2:]:
                        continue  # no flat metric
                    found, expected = self.numbers_of_program("uniformize", path, *options)
                    m, found = s.uniformize(cones=cones, start=start), found["conformal"]
                    np.testing.assert_array_equal(m.u, expected, f"{name} {start} {cones}")
                    self.assertEqual((m.status, m.iterations, m.flips, m.proven_residual),
                                     (found["status"], found["iterations"], found["flips"],
                                      found["proven_residual"]))
                    self.assertEqual(len(m.cones), found["cones"])

    def test_layouts(self):
        for name in self.DISKS + self.CLOSED:
            path, V, F = program.mesh(name)
            for start in ("delaunay", "input"):
                found = program.run("uniformize", path, "--cones", 4, "--start", start, "-o",
                                    self.folder / "x.vtp")["conformal"]
                m = it.Surface(V, F).uniformize(cones=4, start=start)
                for key in ("injective", "flipped_faces", "degenerate_faces"):
                    self.assertEqual(m.certificate[key], found[key], name)
                self.assertEqual(m.distortion["mean_quasi_conformal"],
                                 found["mean_quasi_conformal"])

    def test_eigenfunctions(self):
        for name in self.DISKS + self.CLOSED:
            path, V, F = program.mesh(name)
            found, expected = self.numbers_of_program("eigen", path, "--count", 5)
            values, functions = it.Surface(V, F).eigen(5)
            np.testing.assert_array_equal(functions, expected, name)
            np.testing.assert_array_equal(values, found["eigen"]["values"], name)

    def test_deformations(self):
        (self.folder / "h.txt").write_text("3 0 0 0\n8 1 2 3\n")
        for name in self.DISKS + self.CLOSED:
            path, V, F = program.mesh(name)
            s = it.Surface(V, F)
            for energy in ("harmonic", "biharmonic"):
                _, expected = self.numbers_of_program("edit", path, "--energy", energy, "--handles",
                                               self.folder / "h.txt")
                found = s.deform([3, 8], [[0, 0, 0], [1, 2, 3]], energy=energy)
                np.testing.assert_array_equal(found, expected, f"{name} {energy}")


def load_tests(loader, tests, pattern):
    """Adds the examples in the manual."""
    tests.addTests(doctest.DocFileSuite("../../doc/Intrinsic_triangulations/python_fields.md"))
    return tests


if __name__ == "__main__":
    unittest.main()
