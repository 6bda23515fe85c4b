# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands that solve something on the triangulation: eigen, edit."""

import math
import os

from cli_support import Cli_test, icosphere, jittered_grid, main


class Applications(Cli_test):
    def setUp(self):
        super().setUp()
        self.points, self.faces = icosphere(3)
        self.sphere = self.write_off("sphere.off", self.points, self.faces)

    def values(self, name):
        with open(self.path(name), encoding="ascii") as file:
            return [[float(x) for x in line.split()] for line in file]

    def scalars(self, page):
        """The description of the field of a page."""
        with open(self.path(page), encoding="utf-8") as file:
            text = file.read()
        begin = text.index('id="scalars"')
        return text[begin:text.index(">", begin)]


class Eigen(Applications):
    def test_frequencies_of_a_sphere_are_those_of_spherical_harmonics(self):
        for arithmetic in ("exact", "double"):
            stats = self.stats("eigen", self.sphere, "--count", "9", "--arithmetic", arithmetic,
                               "-o", "e.txt")
            values = stats["eigen"]["values"]
            # l (l + 1) for l = 0, 1, 2, which masses at vertices lower by (frequency h)^2 / 4 of it for edges of h = 0.16
            for got, wanted in zip(values, [0] + 3 * [2] + 5 * [6]):
                self.assertLess(abs(got - wanted), 0.0064 * wanted**2 + 1e-9)
            rows = self.values("e.txt")
            self.assertEqual((len(rows), len(rows[0])), (len(self.points), 9))

    def test_is_written_where_it_is_asked_for(self):
        for on, options in (("subdivision", ()), ("input", ()), ("subdivision", ("--refine",)),
                            ("input", ("--refine", "--min-angle", "30"))):
            stats = self.stats("eigen", self.sphere, "--count", "2", "--on", on, "-o", "e.vtp",
                               *options)
            self.assertTrue(os.path.getsize(self.path("e.vtp")) > 0)
            self.assertEqual("subdivision" in stats, on == "subdivision")
        self.stats("eigen", self.sphere, "--count", "2", "--refine", "--max-circumradius", "0.05",
                   "--on", "input", "-o", "e.txt")
        self.assertEqual(len(self.values("e.txt")), len(self.points))
        run = self.run_program("eigen", self.sphere, "--on", "intrinsic", "-o", "e.vtp")
        self.assertEqual(run.code, 1)
        self.assertIn("--on subdivision", run.err)

    def test_page_has_lines_of_equal_values(self):
        run = self.run_program("eigen", self.sphere, "--count", "3", "--view", "e.html")
        if run.code == 1 and "three.js" in run.err:
            self.skipTest("the program was built without three.js")
        self.assertEqual(run.code, 0, run.err)
        field = self.scalars("e.html")
        self.assertIn('data-name="eigenfunction_1"', field)
        self.assertIn('data-isolines="20" data-edges="hidden"', field)

    def test_isolated_vertices_do_not_matter(self):
        mesh = self.write_off("isolated.off", self.points + [[9, 9, 9]], self.faces)
        values = self.stats("eigen", mesh, "--count", "5")["eigen"]["values"]
        self.assertLess(abs(values[1]), 1e-9)  # it is a component
        self.assertLess(abs(values[2] - 2), 0.04)

    def test_more_than_there_are_is_all(self):
        points, faces = jittered_grid(2)
        mesh = self.write_off("g.off", points, faces)
        self.assertEqual(self.stats("eigen", mesh, "--count", "50")["eigen"]["count"], len(points))
        self.assertEqual(self.run_program("eigen", mesh, "--count", "0").code, 2)


class Edit(Applications):
    def handles(self, rows):
        return self.write("handles.txt", "".join(" ".join(map(repr, r)) + "\n" for r in rows))

    def test_handles_that_move_alike_move_everything(self):
        file = self.handles([[0, 1, 2, 3], [5, 1, 2, 3]])
        for energy in ("harmonic", "biharmonic"):
            self.stats("edit", self.sphere, "--handles", file, "--energy", energy, "-o", "d.txt")
            for row in self.values("d.txt"):
                self.assertLess(math.dist(row, (1, 2, 3)), 1e-9)

    def test_writes_the_deformed_mesh(self):
        file = self.handles([[0, 0.5, 0, 0], [7, 0, 0, 0], [9, 0, 0, 0]])
        stats = self.stats("edit", self.sphere, "--handles", file, "-o", "d.off", "--on", "input")
        self.assertEqual(stats["edit"]["handles"], 3)
        self.stats("edit", self.sphere, "--handles", file, "-o", "d.txt", "--on", "input")
        with open(self.path("d.off"), encoding="ascii") as out:
            rows = [list(map(float, line.split())) for line in out.readlines()[2:]]
        for p, d, q in zip(self.points, self.values("d.txt"), rows):
            self.assertLess(math.dist([a + b for a, b in zip(p, d)], q), 1e-12)

    def test_refuses_files_that_make_no_sense(self):
        for rows, what in (([[0, 1, 2]], "three coordinates"), ([[99999, 0, 0, 0]], "no such"),
                           ([[0.5, 0, 0, 0]], "no such"), ([[0, 0, 0, 0], [0, 1, 0, 0]], "two")):
            run = self.run_program("edit", self.sphere, "--handles", self.handles(rows))
            self.assertEqual(run.code, 1, rows)
            self.assertIn(what, run.err)


if __name__ == "__main__":
    main()
