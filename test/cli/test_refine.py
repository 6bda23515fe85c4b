# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""`intrinsic refine`: what it reports agrees with what it writes."""

import math

from cli_support import Cli_test, grid, icosphere, jittered_grid, main


class Refine(Cli_test):
    def setUp(self):
        super().setUp()
        points, faces = icosphere(2)
        self.mesh = self.write_off("m.off", [(x, 4 * y, 0.1 * z) for x, y, z in points], faces)

    def test_reaches_the_angle_with_every_correspondence(self):
        inserted = set()
        for kind in ("integer", "crossings", "signposts", "none"):
            stats = self.stats("refine", self.mesh, "--min-angle", "28", "--correspondence", kind)
            refine = stats["refine"]
            self.assertEqual(refine["status"], "done")
            self.assertEqual(refine["unsatisfied_faces"], 0)
            self.assertGreaterEqual(refine["min_angle_deg"], 28)
            self.assertGreaterEqual(stats["quality"]["min_angle_deg"], 28)
            self.assertLess(stats["quality_before"]["min_angle_deg"], 28)
            self.assert_certified(stats)
            self.assert_close(stats["area"]["input"], stats["area"]["intrinsic"], 1e-12)
            inserted.add(refine["insertions"])
        self.assertEqual(len(inserted), 1)  # whoever looks, vertices are the same places

    def test_histograms_count_every_angle(self):
        stats = self.stats("refine", self.mesh, "--min-angle", "30")
        angles = stats["quality"]["angle_histogram"]
        # a closed surface of genus 0: F = 2 V - 4
        vertices = stats["input"]["vertices"] + stats["refine"]["insertions"]
        self.assertEqual(sum(angles), 3 * (2 * vertices - 4))
        self.assertEqual(sum(angles[:3]), 0)
        self.assertEqual(sum(stats["quality"]["cotan_weight_histogram"]), 3 * vertices - 6)

    def read_diagonal(self, name):
        size, _, entries = self.read_matrix(name)
        return [entries[i, i] for i in range(size)]

    def test_writes_the_laplacian_of_the_refined_triangulation(self):
        stats = self.stats("refine", self.mesh, "--laplacian", "l.mtx")
        diagonal = self.read_diagonal("l.mtx")
        self.assertEqual(len(diagonal), stats["input"]["vertices"] + stats["refine"]["insertions"])
        self.assert_close(sum(diagonal), stats["laplacian"]["trace"], 1e-12)

    def test_removed_vertices_have_no_rows(self):
        mesh = self.write_off("jittered.off", *jittered_grid(12))
        for arithmetic in ("exact", "double"):
            for kind in ("integer", "crossings", "signposts", "none"):
                stats = self.stats("refine", mesh, "--laplacian", "l.mtx", "--min-angle", "28",
                                   "--arithmetic", arithmetic, "--correspondence", kind,
                                   "-o", "t.idt")
                self.assertGreater(stats["refine"]["removals"], 10)
                diagonal = self.read_diagonal("l.mtx")
                vertices = stats["input"]["vertices"] + stats["refine"]["insertions"]
                self.assertEqual(len(diagonal), vertices)
                self.assertGreater(min(diagonal), 0)
                with open(self.path("t.idt"), encoding="ascii") as file:
                    counts = [line.split()[1] for line in file if line.startswith("vertices ")]
                self.assertEqual(counts, [str(vertices)])

    def test_subdivision_is_a_sphere(self):
        stats = self.stats("refine", self.mesh, "-o", self.path("s.obj"))
        s = stats["subdivision"]
        self.assertEqual(s["vertices"] - s["edges"] + s["faces"], 2)

    def test_faces_get_as_small_as_asked_for(self):
        points, faces = grid(3)
        mesh = self.write_off("g.off", points, faces)
        side = max(math.dist(points[a], points[b]) for a, b, _ in faces)
        stats = self.stats("refine", mesh, "--min-angle", "0", "--max-circumradius", str(side / 8))
        # a face of circumradius R has at most the area of an equilateral triangle
        largest = 3 * math.sqrt(3) / 4 * (side / 8) ** 2
        faces_now = sum(stats["quality"]["angle_histogram"]) / 3
        self.assertGreaterEqual(faces_now * largest, stats["area"]["input"])

    def test_optimal_delaunay_triangulation_follows(self):
        stats = self.stats("refine", self.mesh, "--arithmetic", "double", "--odt-length", "0.2")
        odt = stats["odt"]
        self.assertEqual(odt["status"], "converged")
        self.assertGreater(odt["moves"], 0)
        self.assertLess(odt["energy_after"], odt["energy_before"])
        self.assertEqual(stats["delaunay"]["non_delaunay_edges"], 0)
        # thousands of moves, each with some roundings of values near it
        self.assert_close(stats["area"]["intrinsic"], stats["area"]["input"], 1e-10)

    def test_cap_is_reported(self):
        stats = self.stats("refine", self.mesh, "--max-insertions", "3")
        self.assertEqual(stats["refine"]["status"], "cap")
        self.assertGreater(stats["refine"]["unsatisfied"]["stopped"], 0)


if __name__ == "__main__":
    main()
