# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""`--metric`: lengths that are not those in space."""

import math

from cli_support import Cli_test, icosphere, jittered_grid, main


class Metric(Cli_test):
    def setUp(self):
        super().setUp()
        self.points, self.faces = jittered_grid(8)
        self.mesh = self.write_off("g.off", self.points, self.faces)

    def write_lines(self, rows):
        return self.write("metric.txt", "".join(" ".join(map(repr, r)) + "\n" for r in rows))

    def assert_same_surface(self, a, b):
        # lengths, which are rounded, tell the order of flips
        self.assertLess(abs(a["delaunay"]["flips"] - b["delaunay"]["flips"]), 5)
        self.assert_close(a["laplacian"]["trace"], b["laplacian"]["trace"], 1e-9)
        self.assert_close(a["area"]["intrinsic"], b["area"]["intrinsic"], 1e-9)
        self.assert_close(a["quality"]["min_angle_deg"], b["quality"]["min_angle_deg"], 1e-9)

    def test_a_constant_factor_is_another_unit(self):
        plain = self.stats("delaunay", self.mesh)
        for factor in (2.0, 0.3, 1e50):
            metric = self.write_lines([[factor]] * len(self.points))
            stats = self.stats("delaunay", self.mesh, "--metric", metric)
            self.assertEqual(stats["certificate"], "exact")
            self.assertEqual(stats["delaunay"]["flips"], plain["delaunay"]["flips"])
            self.assert_close(stats["laplacian"]["trace"], plain["laplacian"]["trace"], 1e-9)
            self.assert_close(stats["area"]["intrinsic"], factor ** 2 * plain["area"]["input"], 1e-12)
            self.assertEqual(stats["area"]["input"], plain["area"]["input"])
            self.assertEqual(stats["metric"]["violating_faces"], 0)
            self.assertEqual(stats["metric"]["changed_edges"], 0)

    def test_a_stored_metric_has_no_points_to_be_drawn(self):
        metric = self.write_lines([[2.0]] * len(self.points))
        self.stats("delaunay", self.mesh, "--metric", metric, "-o", "t.idt")
        for command in (("delaunay", "t.idt", "-o", "c.obj"),
                        ("distance", "t.idt", "--source", "0", "-o", "d.ply"),
                        ("distance", "t.idt", "--source", "0", "--on", "input", "-o", "d.ply"),
                        ("geodesic", "t.idt", "--path", "0,5", "-o", "g.obj")):
            self.assert_fails(self.run_program(*command), "t.idt", "no points", "start from the mesh")
        self.stats("distance", "t.idt", "--source", "0", "-o", "d.txt")

    def test_factors_of_an_inversion_give_the_inverted_points(self):
        points, faces = icosphere(2)
        points = [(x + 2, 1.3 * y, 0.8 * z) for x, y, z in points]
        mesh = self.write_off("s.off", points, faces)
        square = [math.fsum(x * x for x in p) for p in points]
        inverted = self.write_off("i.off", [tuple(x / s for x in p) for p, s in zip(points, square)],
                                  [f[::-1] for f in faces])
        metric = self.write_lines([[1 / s] for s in square])
        for command in ("delaunay", "refine"):
            stats = self.stats(command, mesh, "--metric", metric)
            self.assert_certified(stats)
            if command == "delaunay":
                self.assert_same_surface(stats, self.stats(command, inverted))

    def test_a_constant_tensor_transforms_the_points(self):
        # A = [[2, 0.5, 0], [0, 1, 0], [0, 0, 3]], M = A^T A
        tensor = [4.0, 1.0, 0.0, 1.25, 0.0, 9.0]
        metric = self.write_lines([tensor] * len(self.faces))
        transformed = self.write_off("t.off", [(2 * x + y / 2, y, 3 * z) for x, y, z in self.points],
                                     self.faces)
        self.assert_same_surface(self.stats("delaunay", self.mesh, "--metric", metric),
                                 self.stats("delaunay", transformed))
        for arithmetic in ("exact", "double"):
            stats = self.stats("refine", self.mesh, "--metric", metric, "--arithmetic", arithmetic,
                               "--min-angle", "30", "-o", "s.ply")
            self.assertGreaterEqual(stats["refine"]["satisfied_min_angle_deg"], 30)
            self.assert_close(stats["subdivision"]["area"], stats["area"]["input"], 1e-9)
            self.assert_close(stats["area"]["intrinsic"], 2 * stats["area"]["input"], 1e-9)

    def test_tensors_belong_to_the_faces_of_the_file(self):
        square = self.write_off("q.off", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0),
                                          (2, 1, 0)], [(0, 1, 2, 3), (1, 4, 5, 2)])
        metric = self.write_lines([[4.0, 0.0, 0.0, 4.0, 0.0, 1.0]] * 2)
        stats = self.stats("delaunay", square, "--metric", metric)
        self.assert_close(stats["area"]["intrinsic"], 8, 1e-12)

    def test_the_triangle_inequality_is_repaired_and_that_is_reported(self):
        factors = [[1.0] for _ in self.points]
        factors[40] = [1e-3]
        stats = self.stats("delaunay", self.mesh, "--metric", self.write_lines(factors))
        self.assertGreater(stats["metric"]["violating_faces"], 0)
        self.assertGreater(stats["metric"]["changed_edges"], 0)
        self.assertGreater(stats["metric"]["largest_relative_change"], 0)
        self.assertEqual(stats["delaunay"]["non_delaunay_edges"], 0)

    def test_what_is_wrong_is_named_with_its_line(self):
        n, m = len(self.points), len(self.faces)
        good = "1 0 0 1 0 1\n"
        for text, words in (("1\n" * (n - 1), ("m.txt", f"{n - 1} lines", f"{n} vertices")),
                            (good * n, ("m.txt", f"{n} lines", f"{m} faces")),
                            ("1\n0\n" + "1\n" * (n - 2), ("m.txt:2", "positive")),
                            ("1 2 3\n" * m, ("m.txt:1", "3 numbers", "tensor")),
                            (good * 3 + "1 2 0 1 0 1\n" + good * (m - 4),
                             ("m.txt:4", "positive definite")),
                            (good * (m - 1) + "1 0 0 1 0 -1\n", (f"m.txt:{m}", "positive definite")),
                            ("1\n1e999\n", ("m.txt:2", "1e999"))):
            run = self.run_program("delaunay", self.mesh, "--metric", self.write("m.txt", text))
            self.assert_fails(run, *words)
        self.assert_fails(self.run_program("delaunay", self.mesh, "--metric", self.write(
            "m.txt", "1e200\n" * n)), "g.off", "edge")
        self.run_program("delaunay", self.mesh, "-o", "t.idt")
        self.assert_fails(self.run_program("delaunay", "t.idt", "--metric", "m.txt"), "t.idt",
                          "start from the mesh")


if __name__ == "__main__":
    main()
