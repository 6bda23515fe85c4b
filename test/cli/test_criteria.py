# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What `refine` can be asked for beside angles: lengths of edges per vertex, and small errors."""

import math

from cli_support import Cli_test, beside, icosphere, jittered_grid, main, product


class Sizes(Cli_test):
    def setUp(self):
        super().setUp()
        self.points, faces = jittered_grid(8)
        self.mesh = self.write_off("g.off", self.points, faces)

    def write_sizes(self, sizes):
        return self.write("sizes.txt", "# lengths\n" + "".join(f"{x!r}\n" for x in sizes))

    def edges_with_ends(self, stats):
        """Length, and coordinates of both ends, of each edge of a refined planar mesh."""
        p, q = self.read_matrix("p.mtx"), self.read_matrix("q.mtx")
        row = {j: i for (i, j), x in p[2].items() if x == 1}
        coordinates = [product(q, [x[k] for x in self.points]) for k in range(2)]
        ends = [tuple(c[row[v]] for c in coordinates) for v in range(p[1])]
        self.assertEqual(len(ends), len(self.points) + stats["refine"]["insertions"])
        mass = self.read_matrix("m.mtx")[2]  # has an entry per edge
        return [(math.dist(ends[i], ends[j]), ends[i], ends[j]) for i, j in mass if i < j]

    def test_edges_are_as_short_as_wanted_at_their_ends(self):
        # linear in space, so that it is known at inserted vertices
        wanted = lambda p: 0.03 + 0.02 * p[0]
        sizes = self.write_sizes([wanted(p) for p in self.points])
        for kind in ("integer", "crossings", "signposts"):
            stats = self.stats("refine", self.mesh, "--max-edge-length", sizes, "--mass", "m.mtx",
                               "--mass-kind", "galerkin", "--interpolation", "p.mtx",
                               "--input-interpolation", "q.mtx", "--correspondence", kind)
            self.assertEqual(stats["refine"]["status"], "done")
            self.assertEqual(stats["refine"]["unsatisfied"]["refused"], 0)
            self.assertLessEqual(stats["refine"]["max_relative_edge_length"], 1)
            self.assert_certified(stats)
            edges = self.edges_with_ends(stats)
            worst = max(length / ((wanted(a) + wanted(b)) / 2) for length, a, b in edges)
            self.assertLessEqual(worst, 1 + 1e-9)
            self.assert_close(worst, stats["refine"]["max_relative_edge_length"], 1e-9)
            self.assertGreater(worst, 0.8)  # and no shorter than needed
            fine = [length for length, a, b in edges if max(a[0], b[0]) < 2]
            coarse = [length for length, a, b in edges if min(a[0], b[0]) > 6]
            self.assertGreater(sum(coarse) / len(coarse), 2 * sum(fine) / len(fine))

    def test_constant_sizes_are_a_bound_of_all_lengths(self):
        sizes = self.write_sizes([0.3] * len(self.points))
        stats = self.stats("refine", self.mesh, "--max-edge-length", sizes)
        bound = self.stats("refine", self.mesh, "--max-edge-length", "0.3")
        self.assertEqual(stats["refine"]["insertions"], bound["refine"]["insertions"])
        for key in ("angle_histogram", "min_angle_deg", "max_angle_deg"):
            self.assertEqual(stats["quality"][key], bound["quality"][key])

    def test_sizes_are_in_units_of_the_input(self):
        points, faces = jittered_grid(5)
        insertions = set()
        for scale in (1, 2.0 ** 40, 2.0 ** -40):
            mesh = self.write_off("s.off", [tuple(scale * x for x in p) for p in points], faces)
            sizes = self.write_sizes([scale * (0.2 + 0.1 * p[0]) for p in points])
            insertions.add(self.stats("refine", mesh, "--max-edge-length", sizes)["refine"]["insertions"])
        self.assertEqual(len(insertions), 1)

    def test_large_sizes_change_nothing(self):
        sizes = self.write_sizes([1e6] * len(self.points))
        self.assertEqual(self.stats("refine", self.mesh, "--max-edge-length", sizes)["quality"],
                         self.stats("refine", self.mesh)["quality"])

    def test_what_is_wrong_is_named_with_its_line(self):
        n = len(self.points)
        for text, words in (("1\n" * (n - 1), ("f.txt", f"{n - 1} lines", f"{n} vertices", "g.off")),
                            ("1\n" * (n + 1), ("f.txt", f"more than {n} lines")),
                            ("1\n0\n" + "1\n" * (n - 2), ("f.txt:2", "positive")),
                            ("1\n-3\n" + "1\n" * (n - 2), ("f.txt:2", "positive")),
                            ("# sizes\n1\nnan\n", ("f.txt:3", "nan")), ("1\ninf\n", ("f.txt:2", "inf")),
                            ("1\n1 2\n", ("f.txt:2", "2 numbers")), ("1 2\n1 2\n", ("f.txt:1", "one")),
                            ("", ("f.txt", "no numbers")), ("x\n", ("f.txt:1", "\"x\""))):
            run = self.run_program("refine", self.mesh, "--max-edge-length", self.write("f.txt", text))
            self.assert_fails(run, *words)
        self.assert_fails(self.run_program("refine", self.mesh, "--max-edge-length", "none.txt"), "none.txt")
        sizes = self.write_sizes([1] * n)
        self.assertEqual(self.run_program("refine", self.mesh, "--max-edge-length", sizes,
                                          "--correspondence", "none").code, 2)
        self.run_program("delaunay", self.mesh, "-o", "t.idt", "--arithmetic", "double",
                         "--correspondence", "none")
        self.assert_fails(self.run_program("refine", "t.idt", "--max-edge-length", sizes), "t.idt",
                          "start from the mesh")

    def test_a_stored_triangulation_is_refined_to_sizes(self):
        sizes = self.write_sizes([0.2 + 0.1 * abs(p[0]) for p in self.points])
        asked = self.stats("refine", self.mesh, "--max-edge-length", sizes)
        self.run_program("delaunay", self.mesh, "-o", "t.idt")
        stored = self.stats("refine", "t.idt", "--max-edge-length", sizes, "-o", "r.idt")
        self.assertGreater(stored["refine"]["insertions"], 0)
        self.assertEqual(stored["refine"]["insertions"], asked["refine"]["insertions"])
        again = self.stats("refine", "r.idt", "--max-edge-length", sizes)
        self.assertEqual(again["refine"]["insertions"], 0)


class Adaptive_refinement(Cli_test):
    def setUp(self):
        super().setUp()
        points, faces = icosphere(2)
        self.points, self.faces = [(x, 2 * y, 0.5 * z) for x, y, z in points], faces
        self.mesh = self.write_off("m.off", self.points, faces)

    def test_goes_on_until_the_error_is_small(self):
        for arithmetic in ("exact", "double"):
            stats = self.stats("refine", self.mesh, "--adaptive", "--tolerance", "0.01",
                               "--min-angle", "30",
                               "--laplacian", "l.mtx", "--arithmetic", arithmetic)
            adaptive = stats["adaptive"]
            self.assertEqual((adaptive["status"], adaptive["source"]), ("done", 0))
            rounds = adaptive["rounds"]
            self.assertLessEqual(rounds[-1]["estimated_error"], 0.01)
            self.assertGreater(rounds[-2]["estimated_error"], 0.01)
            vertices = [r["vertices"] for r in rounds]
            self.assertEqual(vertices, sorted(set(vertices)))
            self.assertEqual(self.read_matrix("l.mtx")[0], vertices[-1])
            self.assertTrue(all(r["marked_faces"] > 0 for r in rounds))
            self.assertEqual(stats["delaunay"]["non_delaunay_edges"], 0)
            self.assertGreaterEqual(stats["quality"]["min_angle_deg"], 30)
            self.assertNotIn("refine", stats)

    def test_vertices_gather_at_the_source(self):
        for source in (0, 17):
            stats = self.stats("refine", self.mesh, "--adaptive", "--source", source, "--tolerance",
                               "0.003", "--mass", "m.mtx")
            self.assertEqual(stats["adaptive"]["source"], source)
            mass = self.read_matrix("m.mtx")[2]
            area = sorted(mass.values())
            # the vertex with the singularity is among those with the smallest areas
            self.assertLess(mass[source, source], area[len(area) // 20])

    def test_does_not_depend_on_the_scale(self):
        rounds = []
        for scale in (1, 2.0 ** 30, 2.0 ** -30):
            mesh = self.write_off("s.off", [tuple(scale * x for x in p) for p in self.points],
                                  self.faces)
            stats = self.stats("refine", mesh, "--adaptive", "--tolerance", "0.02")
            rounds.append([r["vertices"] for r in stats["adaptive"]["rounds"]])
        self.assertEqual(rounds[0], rounds[1])
        self.assertEqual(rounds[0], rounds[2])

    def test_heat_kernel(self):
        rounds = []
        for scale in (1, 2.0 ** 30):
            mesh = self.write_off("s.off", [tuple(scale * x for x in p) for p in self.points],
                                  self.faces)
            stats = self.stats("refine", mesh, "--adaptive", "--heat-time", "4", "--source", "17",
                               "--tolerance", "0.05", "--mass", "m.mtx")
            adaptive = stats["adaptive"]
            self.assertEqual((adaptive["status"], adaptive["heat_time"]), ("done", 4))
            self.assertLessEqual(adaptive["rounds"][-1]["estimated_error"], 0.05)
            rounds.append([r["vertices"] for r in adaptive["rounds"]])
            mass = self.read_matrix("m.mtx")[2]
            area = sorted(mass.values())
            self.assertLess(mass[17, 17], area[len(area) // 20])
        self.assertEqual(rounds[0], rounds[1])
        run = self.run_program("refine", self.mesh, "--heat-time", "4")
        self.assertEqual(run.code, 2)

    def test_cap_on_vertices(self):
        stats = self.stats("refine", self.mesh, "--adaptive", "--tolerance", "1e-6",
                           "--max-vertices", "400")
        self.assertEqual(stats["adaptive"]["status"], "cap")
        self.assertEqual(stats["adaptive"]["rounds"][-1]["vertices"], 400)

    def test_constraints_are_kept(self):
        kept = self.write("c.txt", f"{self.faces[0][0]} {self.faces[0][1]}\n")
        stats = self.stats("refine", self.mesh, "--adaptive", "--keep", kept)
        self.assertGreaterEqual(stats["constraints"]["edges"], 1)

    def test_bad_input(self):
        self.assert_fails(self.run_program("refine", self.mesh, "--adaptive", "--source", "162"),
                          "m.off", "vertex 162", "below 162")
        two = self.write_off("two.off", *beside(self.points, self.faces, 9))
        self.assert_fails(self.run_program("refine", two, "--adaptive"), "two.off", "connected")
        for arguments in (("--source", "1"), ("--tolerance", "1"), ("--max-vertices", "9"),
                          ("--adaptive", "--order", "worst"), ("--adaptive", "--tolerance", "-1"),
                          ("--adaptive", "--max-edge-length", "1"), ("--adaptive", "--odt-length", "1"),
                          ("--adaptive", "--source", "-1"),
                          ("--adaptive", "--correspondence", "crossings"),
                          ("--adaptive", "--correspondence", "none")):
            self.assertEqual(self.run_program("refine", self.mesh, *arguments).code, 2, arguments)

    def test_a_stored_triangulation_is_refined(self):
        asked = self.stats("refine", self.mesh, "--adaptive", "--tolerance", "0.02")
        self.run_program("delaunay", self.mesh, "-o", "t.idt")
        stored = self.stats("refine", "t.idt", "--adaptive", "--tolerance", "0.02")
        self.assertEqual([r["vertices"] for r in stored["adaptive"]["rounds"]],
                         [r["vertices"] for r in asked["adaptive"]["rounds"]])


if __name__ == "__main__":
    main()
