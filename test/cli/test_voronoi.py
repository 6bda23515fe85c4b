# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells of the nearest source: intrinsic distance --voronoi."""

from cli_support import Cli_test, grid, main


class Cells(Cli_test):
    def setUp(self):
        super().setUp()
        self.mesh = self.write_off("grid.off", *grid(4))

    def test_two_sources_share_a_square(self):
        stats = self.stats("distance", self.mesh, "--method", "exact", "--source", "0,4",
                           "--voronoi", self.path("lines.obj"), "--on", "input",
                           "-o", self.path("d.txt"))["distance"]
        cells = stats["cells"]
        self.assertEqual((cells["boundaries"], cells["junctions"], cells["status"]), (1, 0, "done"))
        self.assertEqual(sum(cells["vertices"]), 25)
        whole = sum(cells["areas"])
        for area in cells["areas"]:
            self.assertAlmostEqual(area, whole / 2, delta=1e-2 * whole)
        with open(self.path("lines.obj"), encoding="ascii") as file:
            points = [tuple(map(float, line.split()[1:])) for line in file if line[0] == "v"]
        with open(self.mesh, encoding="ascii") as file:
            vertices = [tuple(map(float, line.split())) for line in file.readlines()[2:27]]
        for p in points:  # as near to both, up to twice the tolerance
            a, b = (sum((x - y) ** 2 for x, y in zip(p, vertices[i])) ** 0.5 for i in (0, 4))
            self.assertAlmostEqual(a, b, delta=4e-3)
        with open(self.path("d.txt"), encoding="ascii") as file:
            labels = [int(float(line.split()[1])) for line in file]
        self.assertEqual([labels.count(i) for i in (0, 1)], cells["vertices"])

    def test_sets_of_sources_share_cells(self):
        self.write("sets.txt", "0 20\n4 24\n")  # two sides of the square
        stats = self.stats("distance", self.mesh, "--method", "exact", "--sources",
                           self.path("sets.txt"), "--voronoi", self.path("lines.obj"),
                           "--cell-tolerance", "1e-6", "--on", "input", "-o",
                           self.path("d.txt"))["distance"]
        cells = stats["cells"]
        self.assertEqual((stats["sets"], cells["boundaries"], cells["junctions"]), (2, 1, 0))
        whole = sum(cells["areas"])
        for area in cells["areas"]:
            self.assertAlmostEqual(area, whole / 2, delta=1e-5 * whole)
        with open(self.path("d.txt"), encoding="ascii") as file:
            labels = [int(float(line.split()[1])) for line in file]
        self.assertEqual([labels.count(i) for i in (0, 1)], cells["vertices"])

    def test_bad_usage(self):
        self.write("sets.txt", "0\n")
        for options in (("--source", "0", "--method", "heat", "--voronoi", "l.obj"),
                        ("--source", "0", "--method", "exact", "--max-distance", "1",
                         "--voronoi", "l.obj"),
                        ("--pairs", self.path("sets.txt"), "--method", "exact",
                         "--voronoi", "l.obj"),
                        ("--source", "0", "--method", "exact", "--cell-tolerance", "1")):
            run = self.run_program("distance", self.mesh, *options)
            self.assertEqual(run.code, 2, run.err)
            self.assertIn("--voronoi", run.err)


if __name__ == "__main__":
    main()
