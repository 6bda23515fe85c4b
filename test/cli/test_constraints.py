# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges that `--sharp-angle` and `--keep` keep."""

import math
import random

from cli_support import CUBE, Cli_test, jittered_grid, main, shuffled

KINDS = ("integer", "crossings", "signposts", "none")


class Constraints(Cli_test):
    def setUp(self):
        super().setUp()
        # a rhombus that is cut along its long diagonal
        self.rhombus = self.write_off("r.off", [(0, 0, 0), (8, 0, 0), (4, 1, 0), (4, -1, 0)],
                                      [(0, 1, 2), (1, 0, 3)])

    def length_on_input_edges(self, name):
        """The length of all edges of a stored triangulation in doubles that run along edges of the input."""
        with open(self.path(name), encoding="ascii") as file:
            lines = [line.split() for line in file]
        scale = next(int(w[1]) for w in lines if w[0] == "scale")
        start = next(i for i, w in enumerate(lines) if w[0] == "edges")
        edges = lines[start + 1:start + 1 + int(lines[start][1])]
        return sum(math.sqrt(float.fromhex(w[0])) for w in edges if int(w[1]) < 0) / 2 ** scale

    def test_a_constrained_edge_is_not_flipped(self):
        kept = self.write("c.txt", "# the diagonal\n\n1 0 # either way\n")
        for kind in KINDS:
            for arithmetic in ("exact", "double"):
                options = ("--correspondence", kind, "--arithmetic", arithmetic)
                free = self.stats("delaunay", self.rhombus, *options)
                self.assertEqual(free["delaunay"]["flips"], 1)
                self.assertNotIn("constraints", free)
                stats = self.stats("delaunay", self.rhombus, "--keep", kept, *options)
                self.assertEqual(stats["delaunay"]["flips"], 0)
                self.assertEqual(stats["constraints"],
                                 {"input_edges": 1, "edges": 1, "non_delaunay_edges": 1})
                self.assertEqual(stats["delaunay"]["non_delaunay_edges"], 0)
                self.assertEqual(stats["certificate"], "exact" if arithmetic == "exact" else "none")
        stats = self.stats("laplacian", self.rhombus, "--keep", kept)
        self.assertEqual(stats["delaunay"]["flips"], 0)
        # nor of a stored triangulation, in which it was: coordinates tell where it is, whatever is
        # asked for
        self.stats("delaunay", self.rhombus, "-o", "s.idt")
        for command in (("laplacian",), ("delaunay", "--correspondence", "none")):
            stored = self.stats(command[0], "s.idt", "--keep", kept, *command[1:])
            self.assertEqual(stored["constraints"]["input_edges"], 1)
            self.assertAlmostEqual(stored["laplacian"]["trace"], stats["laplacian"]["trace"])

    def test_refinement_splits_constrained_edges_and_keeps_their_parts(self):
        kept = self.write("c.txt", "0 1\n")
        border = 4 * math.hypot(4, 1)
        for constraint, length in ((("--keep", kept), border + 8), ((), border)):
            stats = self.stats("refine", self.rhombus, "--arithmetic", "double", "-o", "t.idt",
                               "--min-angle", "30", "--max-edge-length", "0.5", *constraint)
            self.assertEqual(stats["refine"]["unsatisfied"]["refused"], 0)
            self.assert_close(self.length_on_input_edges("t.idt"), length, 1e-12)
        for kind in KINDS:
            stats = self.stats("refine", self.rhombus, "--max-edge-length", "0.5",
                               "--keep", kept, "--correspondence", kind)
            self.assertEqual(stats["constraints"]["input_edges"], 1)
            self.assertGreaterEqual(stats["constraints"]["edges"], 16)  # no part is longer
            self.assert_certified(stats)

    def test_conforming_refinement_splits_kept_edges_until_they_are_delaunay(self):
        kept = self.write("c.txt", "0 1\n")
        for kind in KINDS:
            refine = ("refine", self.rhombus, "--min-angle", "1", "--keep", kept,
                      "--correspondence", kind)
            free, stats = self.stats(*refine), self.stats(*refine, "--conforming")
            self.assertGreater(free["constraints"]["non_delaunay_edges"], 0)
            self.assertEqual(stats["constraints"]["non_delaunay_edges"], 0)
            self.assertGreater(stats["constraints"]["edges"], free["constraints"]["edges"])

    def test_optimization_keeps_constrained_edges(self):
        kept = self.write("c.txt", "0 1\n")
        stats = self.stats("refine", self.rhombus, "--arithmetic", "double", "-o", "t.idt",
                           "--keep", kept, "--odt-length", "0.5")
        self.assertGreater(stats["odt"]["splits"] + stats["odt"]["moves"], 0)
        self.assert_close(self.length_on_input_edges("t.idt"), 4 * math.hypot(4, 1) + 8, 1e-9)

    def test_all_edges_constrained_leave_the_mesh_as_it_is(self):
        points, faces = jittered_grid(6)
        mesh = self.write_off("g.off", points, faces)
        edges = {(min(a, b), max(a, b)) for f in faces for a, b in zip(f, f[1:] + f[:1])}
        kept = self.write("c.txt", "".join(f"{a} {b}\n" for a, b in edges))
        plain = self.stats("info", mesh)
        stats = self.stats("delaunay", mesh, "--keep", kept)
        self.assertEqual(stats["delaunay"]["flips"], 0)
        self.assertEqual(stats["constraints"],
                         {"input_edges": len(edges), "edges": len(edges),
                          "non_delaunay_edges": plain["delaunay"]["non_delaunay_edges"]})
        self.assertGreater(plain["delaunay"]["non_delaunay_edges"], 0)

    def test_edges_are_those_of_the_file_where_that_is_renumbered(self):
        points, faces = jittered_grid(257)  # smaller meshes keep their order
        *mixed, order, faces = shuffled(points, faces, 5)
        opposite = {}
        for f in faces:
            for k in range(3):
                a, b, c = f[k], f[(k + 1) % 3], f[(k + 2) % 3]
                opposite.setdefault((min(a, b), max(a, b)), []).append(c)
        edges = sorted(opposite)
        listed = random.Random(5).sample(edges, 5000)

        def cotangent(a, b, c):
            u, v = ([points[x][k] - points[c][k] for k in range(2)] for x in (a, b))
            return (u[0] * v[0] + u[1] * v[1]) / abs(u[0] * v[1] - u[1] * v[0])

        bad = [e for e in listed if sum(cotangent(*e, c) for c in opposite[e]) < 0
               and len(opposite[e]) == 2]
        self.assertGreater(len(bad), 100)
        self.assertLess(len(bad), 4000)
        mesh = self.write_off("s.off", *mixed)
        kept = self.write("c.txt", "".join(f"{order[a]} {order[b]}\n" for a, b in listed))
        stats = self.stats("laplacian", mesh, "--no-flip", "--keep", kept, "--arithmetic", "double")
        self.assertTrue(stats["input"]["renumbered"])
        self.assertEqual(stats["constraints"],
                         {"input_edges": 5000, "edges": 5000, "non_delaunay_edges": len(bad)})

    def test_sharp_edges_are_those_folded_by_more(self):
        fold = math.radians(40)
        tent = self.write_off("t.off", [(0, 0, 0), (1, 0, 0), (0.5, 2, 0),
                                        (0.5, -math.cos(fold), math.sin(fold))],
                              [(0, 1, 2), (1, 0, 3)])
        for angle, edges in ((39.9, 1), (40.1, 0), (0, 1), (180, 0)):
            stats = self.stats("delaunay", tent, "--sharp-angle", angle)
            self.assertEqual(stats["constraints"]["input_edges"], edges)
        for scale in (1, 1e150, 1e-160):
            points = [tuple(scale * x for x in p) for p in CUBE[0]]
            cube = self.write_off("c.off", points, CUBE[1])
            self.assertEqual(self.stats("delaunay", cube, "--sharp-angle", 89)["constraints"]
                             ["input_edges"], 12)
            self.assertEqual(self.stats("delaunay", cube, "--sharp-angle", 91)["constraints"]
                             ["input_edges"], 0)

    def test_kept_edges_that_were_flipped_before_a_triangulation_was_stored_come_back(self):
        points, faces = jittered_grid(9)
        points = [(x, y, 2 * random.Random(3 * i).random()) for i, (x, y, _) in enumerate(points)]
        mesh = self.write_off("g.off", points, faces)
        edges = sorted({(min(a, b), max(a, b)) for f in faces for a, b in zip(f, f[1:] + f[:1])})
        kept = self.write("c.txt", "".join(f"{b} {a}\n" for a, b in edges[::3]))
        for arithmetic in ("exact", "double"):
            free = self.stats("delaunay", mesh, "--arithmetic", arithmetic, "-o", "s.idt")
            for option in (("--keep", kept), ("--sharp-angle", "60")):
                asked = self.stats("delaunay", mesh, "--arithmetic", arithmetic, *option)
                stored = self.stats("delaunay", "s.idt", *option, "-o", "k.idt")
                self.assertGreater(asked["constraints"]["non_delaunay_edges"], 0)
                self.assertLess(asked["delaunay"]["flips"], free["delaunay"]["flips"])
                self.assertEqual(stored["constraints"], asked["constraints"])
                for key, name in (("laplacian", "trace"), ("area", "input"), ("area", "intrinsic")):
                    self.assert_close(stored[key][name], asked[key][name], 1e-10)
                self.assertEqual(stored["certificate"], asked["certificate"])
                again = self.stats("delaunay", "k.idt", *option)
                self.assertEqual(again["delaunay"]["flips"], 0)
                self.assertEqual(again["constraints"], asked["constraints"])
                refined = self.stats("refine", "s.idt", *option, "--min-angle", "20", "-o", "r.idt")
                self.assertGreater(refined["constraints"]["edges"], asked["constraints"]["edges"])
                again = self.stats("delaunay", "r.idt", *option)  # parts of kept edges are kept
                self.assertEqual(again["delaunay"]["flips"], 0)
                self.assertEqual(again["constraints"], refined["constraints"])
        self.assert_fails(self.run_program("delaunay", "s.idt", "--keep",
                                           self.write("k.txt", f"0 {len(points) - 1}\n")),
                          "k.txt:1", "s.idt")

    def test_both_options_add_up(self):
        cube = self.write_off("c.off", CUBE[0], CUBE[1])
        kept = self.write("c.txt", "0 1\n4 5\n")
        stats = self.stats("delaunay", cube, "--keep", kept, "--sharp-angle", 120)
        self.assertEqual(stats["constraints"]["input_edges"], 2)
        stats = self.stats("delaunay", cube, "--keep", kept, "--sharp-angle", 80)
        self.assertEqual(stats["constraints"]["input_edges"], 12)

    def test_what_is_wrong_is_named_with_its_line(self):
        cube = self.write_off("c.off", CUBE[0], CUBE[1])
        for text, words in (("0 1\n0 8\n", ("k.txt:2", "vertex 8", "0 to 7")),
                            ("# none\n0 7\n", ("k.txt:2", "c.off", "0 and 7", "path")),
                            ("0 1 2\n", ("k.txt:1", "two vertices")), ("0\n", ("k.txt:1",)),
                            ("0 -1\n", ("k.txt:1", "-1")), ("a b\n", ("k.txt:1", "\"a\"")),
                            ("0 1.5\n", ("k.txt:1", "1.5")), ("2 2\n", ("k.txt:1", "2 and 2"))):
            run = self.run_program("delaunay", cube, "--keep", self.write("k.txt", text))
            self.assert_fails(run, *words)
        self.assert_fails(self.run_program("delaunay", cube, "--keep", "no.txt"), "no.txt")
        self.assert_fails(self.run_program("delaunay", cube, "--keep", self.directory),
                          self.directory)
        # a diagonal that the program has cut a square along is no edge of the file
        self.assert_fails(self.run_program("delaunay", cube, "--keep",
                                           self.write("k.txt", "0 3\n1 2\n")), "k.txt:")
        self.run_program("delaunay", cube, "-o", "s.idt", "--correspondence", "none",
                         "--arithmetic", "double")
        self.assert_fails(self.run_program("refine", "s.idt", "--sharp-angle", "30"), "s.idt",
                          "start from the mesh")
        for kind in ("crossings", "signposts"):
            self.assert_fails(self.run_program("refine", "s.idt", "--correspondence", kind), "s.idt",
                              "integer coordinates", "start from the mesh")
        for angle in ("-1", "181", "nan", "sharp"):
            self.assertEqual(self.run_program("delaunay", cube, "--sharp-angle", angle).code, 2)


if __name__ == "__main__":
    main()
