# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hard but valid meshes: exact results, values as good as signs, and effort that is counted.

Counts say what times on a busy machine cannot: 53 and 106 bits are doubles and sums of two doubles, 256 bits are numbers of
fixed size; only what takes more bits than that computes with memory from the heap."""

import math

from cli_support import Cli_test, icosphere, main, parabola_fan


def two_parabolas(n, slope=0.0):
    """Facing chains, triangulated as badly as can be: quadratically many flips."""
    low = [(i - n / 2, 0.1 * (i - n / 2) ** 2 / n, 0) for i in range(n)]
    high = [(x + 0.25, n / 2 - y) for x, y, _ in low]
    return (low + [(x, y, slope * y) for x, y in high],
            [(i, i + 1, n) for i in range(n - 1)] +
            [(n - 1, n + i + 1, n + i) for i in range(n - 1)])


def chain(n):
    """Exactly collinear edges between a fan and a fan of faces without area."""
    return ([(i, 0, 0) for i in range(n + 1)] + [(n / 2, n, 0), (n / 2, -n, 0)],
            [(i, i + 1, n + 1) for i in range(n)] + [(0, i + 1, i) for i in range(1, n)] +
            [(n, 0, n + 2)])


def bipyramid(n, height):
    circle = [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n), 0) for i in range(n)]
    return (circle + [(0, 0, height), (0, 0, -height)],
            [(i, (i + 1) % n, n) for i in range(n)] + [((i + 1) % n, i, n + 1) for i in range(n)])


def stretched(level, factor, axis):
    points, faces = icosphere(level)
    length = math.hypot(*axis)
    u = [x / length for x in axis]
    result = []
    for p in points:
        along = sum(a * b for a, b in zip(u, p)) * (factor - 1)
        result.append(tuple(x + along * a for x, a in zip(p, u)))
    return result, faces


def more_than_256_bits(counts):
    return sum(n for bits, n in counts.items() if int(bits) > 256)


class Extremes(Cli_test):
    def flip(self, points, faces, *options):
        stats = self.stats("delaunay", self.write_off("m.off", points, faces), *options)
        self.assertEqual(stats["certificate"], "exact")
        self.assertEqual(stats["delaunay"]["probable_zero"], 0)
        self.assertEqual(stats["delaunay"]["non_delaunay_edges"], 0)
        self.assert_close(stats["area"]["intrinsic"], stats["area"]["input"], 1e-12)
        return stats["delaunay"]

    def test_many_flips_in_flat_parts_take_no_more_than_doubles(self):
        for correspondence in ("none", "integer", "signposts"):
            for slope in (0, 0.5):
                delaunay = self.flip(*two_parabolas(250, slope), "--correspondence",
                                     correspondence)
                self.assertGreater(delaunay["flips"], 30000)
                self.assertEqual({b for b, n in delaunay["escalations"].items() if n} - {"53"},
                                 set())

    def test_spheres_stretched_in_any_direction(self):
        for factor in (1e6, 1e12, 1e15):
            delaunay = self.flip(*stretched(3, factor, (1, 2, 3)))
            self.assertGreater(delaunay["flips"], 1000)
            self.assertEqual(more_than_256_bits(delaunay["escalations"]), 0)

    def test_symmetric_surfaces_are_proven_to_be_tied(self):
        for factor in (100, 1e6):
            delaunay = self.flip(*stretched(3, factor, (1, 0, 0)))
            self.assertGreater(delaunay["certified_zero"], 50)
            self.assertEqual(more_than_256_bits(delaunay["escalations"]), 0)

    def test_results_on_a_mesh_of_any_size(self):
        points, faces = icosphere(2)
        points = [(x, y, z * (1 + 0.3 * x)) for x, y, z in points]
        values = [x * y for x, y, _ in points]
        found = {}
        for exponent in (0, -498, -330, 330, 498):  # 1e-150, 1e-100, 1e100, 1e150
            scale = 2.0 ** exponent
            mesh = self.write_off("m.off", [[scale * x for x in p] for p in points], faces)
            self.write("u.txt", "".join(f"{x * scale!r}\n" for x in values))
            eigen = [x for solver in ("direct", "iterative")
                     for x in self.stats("eigen", mesh, "--count", "5", "--solver",
                                         solver)["eigen"]["values"]]
            field = self.stats("field", mesh, "--degree", "2", "--align", "1")["field"]
            refined = ("--refine", "--max-edge-length", repr(0.3 * scale))
            distances = [self.stats("transfer", mesh, "u.txt", *refined, "--method",
                                    method)["transfer"]["L2_distance"][0]
                         for method in ("pointwise", "l2")]
            self.assertLess(distances[1], distances[0])
            found[exponent] = ([x * scale * scale for x in eigen] +
                               [x / scale / scale for x in distances],
                               [field["index_sum"], field["singular_faces"]])
        for exponent, (numbers, counts) in found.items():
            with self.subTest(exponent):
                for x, y in zip(numbers, found[0][0]):
                    self.assert_close(x, y, 1e-11)
                self.assertEqual(counts, found[0][1])
        mesh = self.write_off("m.off", [[1e-160 * x for x in p] for p in points], faces)
        self.assert_fails(self.run_program("eigen", mesh), "m.off", "beyond doubles",
                          "scale the mesh")

    def test_a_vertex_that_is_far_away(self):
        points, faces = icosphere(3)
        points[5] = tuple(1e100 * x for x in points[5])
        self.flip(points, faces)

    def test_weights_to_a_far_apex(self):
        n, height = 400, 1e6
        mesh = self.write_off("m.off", *bipyramid(n, height))
        self.run_program("laplacian", mesh, "-o", "l.mtx")
        expected = -math.sin(math.pi / n) / math.hypot(height, math.cos(math.pi / n))
        entries = self.read_matrix("l.mtx")[2]
        weights = [w for (i, j), w in entries.items() if i >= n and i != j]
        self.assertGreaterEqual(len(weights), 2 * n)
        for w in weights:
            # points are off the circle by 2^-53, which a base of length 0.016 sees 1e10 times as
            # large
            self.assert_close(w, expected, 1e-9)

    def test_rounding_that_hides_angles_is_named(self):
        mesh = self.write_off("m.off", *bipyramid(2000, 1e6))
        self.assert_fails(self.run_program("laplacian", mesh, "--arithmetic", "double", "-o",
                                           "l.mtx"), "m.off", "vertex 200", "exact")

    def test_refinement_ends_on_chains_and_fans(self):
        for points, faces in (chain(500), parabola_fan(1000), two_parabolas(250)):
            mesh = self.write_off("m.off", points, faces)
            stats = self.stats("refine", mesh, "--min-angle", "25")
            self.assertEqual(stats["certificate"], "exact")
            self.assertEqual(stats["refine"]["status"], "done")
            self.assert_close(stats["area"]["intrinsic"], stats["area"]["input"], 1e-12)
            self.assertEqual(more_than_256_bits(stats["delaunay"]["escalations"]), 0)


if __name__ == "__main__":
    main()
