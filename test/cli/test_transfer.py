# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""`intrinsic transfer`: functions between a mesh and its intrinsic triangulation."""

import math

from cli_support import Cli_test, icosphere, jittered_grid, main, product


class Transfer(Cli_test):
    def setUp(self):
        super().setUp()
        self.points, self.faces = jittered_grid(7)
        self.mesh = self.write_off("g.off", self.points, self.faces)

    def write_field(self, name, rows):
        return self.write(name, "".join(" ".join(map(repr, r)) + "\n" for r in rows))

    def intrinsic_points(self, *options):
        """Where the vertices of the intrinsic triangulation are, by other ways than this command."""
        self.stats("refine" if options else "laplacian", self.mesh, "--interpolation", "p.mtx",
                   "--input-interpolation", "q.mtx")
        p, q = self.read_matrix("p.mtx"), self.read_matrix("q.mtx")
        row = {j: i for (i, j), x in p[2].items() if x == 1}
        on_subdivision = [product(q, [x[k] for x in self.points]) for k in range(3)]
        return [[c[row[v]] for c in on_subdivision] for v in range(p[1])]

    def test_a_stored_triangulation_transfers_as_the_mesh_does(self):
        field = self.write("f.txt", "".join(f"{p[0] ** 2 - p[1]}\n" for p in self.points))
        for arithmetic in ("exact", "double"):
            asked = self.stats("transfer", self.mesh, field, "-o", "a.txt", "--arithmetic",
                               arithmetic)
            self.run_program("delaunay", self.mesh, "-o", "s.idt", "--arithmetic", arithmetic)
            stored = self.stats("transfer", "s.idt", field, "-o", "b.txt")
            for x, y in zip(stored["transfer"]["L2_distance"], asked["transfer"]["L2_distance"],
                            strict=True):
                self.assertAlmostEqual(x, y, delta=1e-9)
            with open(self.path("a.txt"), encoding="ascii") as a, \
                    open(self.path("b.txt"), encoding="ascii") as b:
                for x, y in zip(a.read().split(), b.read().split(), strict=True):
                    self.assertAlmostEqual(float(x), float(y), delta=1e-9)

    def test_a_stored_refinement_needs_no_criteria(self):
        """The rows are those of the matrices that were written with it."""
        rows = [[math.sin(3 * p[0]) + p[1] ** 2] for p in self.points]
        field = self.write_field("f.txt", rows)
        criteria = ("--min-angle", "28", "--max-edge-length", "0.7")
        for arithmetic in ("exact", "double"):
            self.stats("refine", self.mesh, "--arithmetic", arithmetic, *criteria, "-o", "r.idt",
                       "--laplacian", "l.mtx")
            self.stats("transfer", self.mesh, field, "--arithmetic", arithmetic, "--refine",
                       *criteria, "-o", "a.txt")
            self.stats("transfer", "r.idt", field, "-o", "b.txt")
            asked, stored = self.read_rows("a.txt"), self.read_rows("b.txt")
            self.assertEqual(len(stored), self.read_matrix("l.mtx")[0])
            self.assertGreater(len(stored), len(rows))
            for x, y in zip(asked, stored, strict=True):
                self.assertAlmostEqual(x[0], y[0], delta=1e-9)
            # and back: what is linear between the vertices of the mesh comes back
            self.stats("transfer", "r.idt", self.path("b.txt"), "--from", "intrinsic", "-o",
                       "c.txt", "--method", "pointwise")
            self.assertEqual(len(self.read_rows("c.txt")), len(rows))

    def test_linear_functions_are_reproduced_both_ways(self):
        field = self.write_field("f.txt", self.points)
        for options in ((), ("--refine",)):
            wanted = self.intrinsic_points(*options)
            for method in ("l2", "pointwise"):
                for arithmetic in ("exact", "double"):
                    stats = self.stats("transfer", self.mesh, field, "-o", "g.txt", "--method",
                                       method, "--arithmetic", arithmetic, *options)
                    self.assertEqual(stats["transfer"]["functions"], 3)
                    self.assertLess(max(stats["transfer"]["L2_distance"]), 1e-9)
                    values = self.read_rows("g.txt")
                    self.assertEqual(len(values), len(wanted))
                    for a, b in zip(values, wanted):
                        self.assertLess(math.dist(a, b), 1e-9)
                    self.stats("transfer", self.mesh, self.path("g.txt"), "-o", "h.txt", "--from",
                               "intrinsic", "--method", method, "--arithmetic", arithmetic, *options)
                    for a, b in zip(self.read_rows("h.txt"), self.points):
                        self.assertLess(math.dist(a, b), 1e-9)

    def rough(self, n):
        return [[math.sin(17 * i) + math.cos(5 * i * i)] for i in range(n)]

    def test_the_nearest_function_keeps_integrals_and_is_nearest(self):
        field = self.write_field("f.txt", self.rough(len(self.points)))
        for direction in ("input", "intrinsic"):
            for options in ((), ("--refine",)):
                if direction == "intrinsic":
                    vertices = len(self.intrinsic_points(*options))
                    field = self.write_field("f.txt", self.rough(vertices))
                best, copy = (self.stats("transfer", self.mesh, field, "--method", method, "--from",
                                         direction, *options)["transfer"]
                              for method in ("l2", "pointwise"))
                self.assertAlmostEqual(best["integral_on_input"][0], best["integral_on_intrinsic"][0], 9)
                self.assertLess(best["L2_distance"][0], copy["L2_distance"][0])

    def test_integrals_are_those_of_the_mass_matrix(self):
        field = self.rough(len(self.points))
        stats = self.stats("transfer", self.mesh, self.write_field("f.txt", field), "-o", "g.txt",
                           "--refine")["transfer"]
        for name, command, values in (("integral_on_input", ("laplacian", "--no-flip"), field),
                                      ("integral_on_intrinsic", ("refine",), self.read_rows("g.txt"))):
            self.stats(command[0], self.mesh, "--mass", "m.mtx", *command[1:])
            weighted = product(self.read_matrix("m.mtx"), [x for x, in values])
            self.assertAlmostEqual(sum(weighted), stats[name][0], 9)

    def test_values_at_vertices_come_back_as_they_were(self):
        field = self.rough(len(self.points))
        self.stats("transfer", self.mesh, self.write_field("f.txt", field), "-o", "g.txt", "--refine",
                   "--min-angle", "33", "--method", "pointwise")
        self.stats("transfer", self.mesh, self.path("g.txt"), "-o", "h.txt", "--refine",
                   "--min-angle", "33", "--method", "pointwise", "--from", "intrinsic")
        self.assertEqual(self.read_rows("h.txt"), field)

    def test_constants_on_a_surface_with_other_options(self):
        points, faces = icosphere(2)
        mesh = self.write_off("m.off", [(x, 3 * y, 0.3 * z) for x, y, z in points], faces)
        field = self.write_field("f.txt", [[7.0]] * len(points))
        for options in (("--sharp-angle", "20"), ("--refine", "--adaptive", "--tolerance", "0.03"),
                        ("--refine", "--max-edge-length", "0.5", "--sharp-angle", "20")):
            stats = self.stats("transfer", mesh, field, "-o", "g.txt", *options)
            self.assertTrue(all(abs(x - 7) < 1e-9 for x, in self.read_rows("g.txt")))
            self.assert_close(stats["transfer"]["integral_on_input"][0],
                              7 * stats["area"]["input"], 1e-10)

    def test_common_subdivision_carries_the_functions(self):
        field = self.write_field("f.txt", [[x, y] for x, y, _ in self.points])
        for name in ("s.ply", "s.vtp"):
            stats = self.stats("transfer", self.mesh, field, "-o", name)
            with open(self.path(name), "rb") as file:
                text = file.read()
            for word in (b"field_on_input_0", b"field_on_input_1", b"field_on_intrinsic_1"):
                self.assertIn(word, text)
            self.assertIn(str(stats["subdivision"]["vertices"]).encode(), text)

    def test_bad_input(self):
        n = len(self.points)
        for text, words in (("1\n" * (n - 1), ("f.txt", f"{n - 1} lines", f"{n} vertices", "g.off")),
                            ("1\nx\n", ("f.txt:2", "\"x\"")), ("1 2\n1\n", ("f.txt:2", "1 numbers")),
                            ("", ("f.txt", "no numbers"))):
            self.assert_fails(self.run_program("transfer", self.mesh, self.write("f.txt", text)),
                              *words)
        field = self.write("f.txt", "1\n" * n)
        self.assert_fails(self.run_program("transfer", self.mesh, field, "--refine", "--from",
                                           "intrinsic"), "f.txt", "intrinsic triangulation")
        self.assert_fails(self.run_program("transfer", self.mesh, "none.txt"), "none.txt")
        self.run_program("delaunay", self.mesh, "-o", "t.idt", "--arithmetic", "double",
                         "--correspondence", "none")
        self.assert_fails(self.run_program("transfer", "t.idt", field), "t.idt",
                          "start from the mesh")
        for arguments in ((), (field, "-o", "s.off"), (field, "--method", "best"),
                          (field, "--from", "there"), (field, "--min-angle", "20"),
                          (field, "--adaptive"), (field, "--max-edge-length", field)):
            self.assertEqual(self.run_program("transfer", self.mesh, *arguments).code, 2, arguments)


if __name__ == "__main__":
    main()
