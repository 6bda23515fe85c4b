# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `simplify`: distances stay within the proven bounds, flat surfaces stay the same."""

import math
import pathlib

from cli_support import CUBE, Cli_test, grid, icosphere, main, triangles

LOOPS = pathlib.Path(__file__).resolve().parent / "data" / "loops.off"


def subdivided(points, faces):
    """Four triangles for each, with new vertices in the middle of edges."""
    points, middle = list(points), {}

    def between(a, b):
        key = min(a, b), max(a, b)
        if key not in middle:
            middle[key] = len(points)
            points.append(tuple((x + y) / 2 for x, y in zip(points[a], points[b])))
        return middle[key]

    result = []
    for a, b, c in faces:
        d, e, f = between(a, b), between(b, c), between(c, a)
        result += [(a, d, f), (b, e, d), (c, f, e), (d, e, f)]
    return points, result


class Simplify(Cli_test):
    def distances(self, mesh, source):
        self.stats("distance", mesh, "--source", str(source), "--on", "intrinsic", "-o", "d.txt")
        return [row[0] for row in self.read_rows("d.txt")]

    def places(self):
        """The places of the fine vertices, and the coarse vertex of each that is at one."""
        with open(self.path("p.txt"), encoding="ascii") as file:
            rows = [line.split() for line in file if not line.startswith("#")]
        return rows, {i: int(row[0]) for i, row in enumerate(rows) if len(row) == 1}

    def test_distances_are_within_the_proven_bounds(self):
        points, faces = icosphere(3)
        points = [tuple(x * (1 + .1 * math.sin(9 * p[0] + 5 * p[1])) for x in p) for p in points]
        mesh = self.write_off("s.off", points, faces)
        stats = self.stats("simplify", mesh, "--vertices", "20%", "-o", "c.idt",
                           "--places", "p.txt")
        found = stats["simplify"]
        self.assertEqual((found["status"], found["vertices"]), ("done", len(points) // 5))
        self.assertEqual(found["removed"], len(points) - found["vertices"])
        bounds = found["stretch"]
        self.assertLess(bounds["lower"], bounds["mean_lower"])
        self.assertLess(bounds["mean_upper"], bounds["upper"])
        _, coarse_of = self.places()
        self.assertEqual(len(coarse_of), found["vertices"])
        for source in list(coarse_of)[:3]:
            fine = self.distances(mesh, source)
            coarse = self.distances("c.idt", coarse_of[source])
            for v, w in coarse_of.items():
                if v != source:
                    ratio = coarse[w] / fine[v]
                    self.assertLessEqual(bounds["lower"], ratio)
                    self.assertLessEqual(ratio, bounds["upper"])

    def test_flat_vertices_go_and_nothing_changes(self):
        points, faces = subdivided(*subdivided(CUBE[0], triangles(CUBE[1])))
        mesh = self.write_off("c.off", points, faces)
        stats = self.stats("simplify", mesh, "--flat", "0", "-o", "d.off")["simplify"]
        self.assertEqual((stats["vertices"], stats["faces"], stats["status"]), (8, 12, "done"))
        self.assertLess(abs(stats["stretch"]["upper"] - 1), 1e-12)
        self.assertLess(abs(stats["stretch"]["lower"] - 1), 1e-12)

    def test_prolongation_keeps_linear_functions_on_a_flat_square(self):
        points, faces = grid(9)
        mesh = self.write_off("g.off", points, faces)
        stats = self.stats("simplify", mesh, "--vertices", "8", "--prolongation", "P.mtx",
                           "--places", "p.txt")["simplify"]
        self.assertLess(stats["vertices"], 20)
        _, coarse_of = self.places()
        kept = {w: v for v, w in coarse_of.items()}
        sums = [[0.0, 0.0, 0.0] for _ in points]
        for (i, j), x in self.read_matrix("P.mtx")[2].items():
            self.assertGreaterEqual(x, 0)
            for c in range(2):
                sums[i][c] += x * points[kept[j]][c]
            sums[i][2] += x
        for p, s in zip(points, sums):
            self.assertLess(max(abs(p[0] - s[0]), abs(p[1] - s[1]), abs(1 - s[2])), 1e-11)

    def test_vectors_are_prolonged_with_weights_that_sum_to_1(self):
        mesh = self.write_off("s.off", *icosphere(2))
        for cost in ("stretch", "curvature", "area", "balanced"):
            stats = self.stats("simplify", mesh, "--vertices", "40", "--cost", cost,
                               "--vector-prolongation", "Q.mtx")
            self.assertEqual(stats["simplify"]["vertices"], 40)
            sums = [0.] * 162
            with open(self.path("Q.mtx"), encoding="ascii") as file:
                lines = file.read().splitlines()
            self.assertEqual(lines[0], "%%MatrixMarket matrix coordinate complex general")
            entries = [line.split() for line in lines if not line.startswith("%")]
            self.assertEqual(entries[0][:2], ["162", "40"])
            for i, _, x, y in entries[1:]:  # of other faces than those for functions, at ties
                sums[int(i) - 1] += math.hypot(float(x), float(y))
            for total in sums:
                self.assertAlmostEqual(total, 1, places=12)

    def test_what_is_kept_stays(self):
        points, faces = icosphere(2)
        mesh = self.write_off("s.off", points, faces)
        wanted = [3, 50, 77, 120]
        file = self.write("k.txt", "".join(f"{v}\n" for v in wanted))
        edges = [(f[0], f[1]) for f in faces[:4]]
        marked = self.write("e.txt", "".join(f"{a} {b}\n" for a, b in edges))
        self.stats("simplify", mesh, "--vertices", "1", "--keep-vertices", file, "--keep", marked,
                   "--places", "p.txt")
        _, coarse_of = self.places()
        self.assertLessEqual({*wanted, *(v for e in edges for v in e)}, coarse_of.keys())

    def test_a_bound_of_the_stretch_holds(self):
        mesh = self.write_off("s.off", *icosphere(3))
        for bound in (1.01, 1.1):
            found = self.stats("simplify", mesh, "--stretch", str(bound))["simplify"]
            self.assertLessEqual(found["stretch"]["upper"], bound)
            self.assertGreaterEqual(found["stretch"]["lower"], 1 / bound)
            self.assertGreater(found["kept_by_bound"], 0)

    def test_it_ends_where_flips_around_loops_could_go_in_a_circle(self):
        self.stats("simplify", str(LOOPS), "--domain", "manifold", "--cost", "curvature",
                   "--stretch", "1.9651826198829903", "--time-limit", "20")

    def test_standard_output_gets_the_coarse_surface(self):
        mesh = self.write_off("s.off", *icosphere(2))
        run = self.run_program("simplify", mesh, "-o", "-", "--quiet")
        self.assertEqual((run.code, run.out[:4]), (0, "IDT "), run.err)

    def test_covers_are_warned_of(self):
        mesh = self.write_off("m.off", [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, -1, 0)],
                              [(0, 1, 2), (0, 1, 3), (0, 1, 4)])
        run = self.run_program("simplify", mesh, "--vertices", "3")
        self.assertEqual(run.code, 0, run.err)
        self.assertIn("cover", run.err)

    def test_parts_of_covers_count_copies_as_the_default_does(self):
        points, faces = grid(8)
        points += [(i + .5, 4, 1) for i in range(8)]  # a third face at each edge of a line
        faces += [(9 * i + 4, 9 * i + 13, 81 + i) for i in range(8)]
        mesh = self.write_off("g.off", points, faces)
        default = self.stats("simplify", mesh)["simplify"]
        tenth = self.stats("simplify", mesh, "--vertices", "10%")["simplify"]
        self.assertEqual(default["vertices"], tenth["vertices"])
        self.assertEqual(default["removed"], tenth["removed"])
        half = self.stats("simplify", mesh, "--vertices", "50%")["simplify"]
        self.assertAlmostEqual(half["vertices"] / (half["vertices"] + half["removed"]), .5,
                               delta=.02)

    def test_bad_options_are_refused(self):
        mesh = self.write_off("s.off", *icosphere(1))
        for options in (["--vertices", "x"], ["--vertices", "0"], ["--vertices", "200%"],
                        ["--stretch", ".5"], ["--flat", "-1"], ["--cost", "x"],
                        ["--flat", "0", "--vertices", "3"]):
            self.assertEqual(self.run_program("simplify", mesh, *options).code, 2, options)
        file = self.write("k.txt", "4711\n")
        self.assert_fails(self.run_program("simplify", mesh, "--keep-vertices", file), "4711")


if __name__ == "__main__":
    main()
