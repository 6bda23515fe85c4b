# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Refinement of covers of random soups, and caps of optimal Delaunay triangulations."""

import math
import random

from cli_support import Cli_test, main


def soup(seed):
    """Random triangles, which meet at edges in any number, some of them twice."""
    r = random.Random(seed)
    n = r.randrange(6, 20)
    points = [[r.gauss(0, 1) for _ in range(3)] for _ in range(n)]
    faces = [r.sample(range(n), 3) for _ in range(r.randrange(6, 30))]
    return points, faces + faces[:seed % 3]


class Soups(Cli_test):
    def test_meet_the_bound_but_where_they_cannot(self):
        for seed in range(40):
            mesh = self.write_off("s.off", *soup(seed))
            with self.subTest(seed=seed):
                stats = self.stats("refine", mesh, "--min-angle", "25")
                refine = stats["refine"]
                self.assertEqual(refine["status"], "done")
                self.assertEqual(refine["unsatisfied"]["refused"], 0)
                self.assertGreaterEqual(refine["satisfied_min_angle_deg"], 25 - 1e-9)
                # the other figure is measured elsewhere, by other formulas
                self.assertAlmostEqual(refine["min_angle_deg"], stats["quality"]["min_angle_deg"],
                                       delta=1e-6)
                if refine["unsatisfied_faces"] > 0:
                    self.assertLess(refine["min_angle_deg"], 25)


class Optimal_delaunay(Cli_test):
    def square(self):
        return self.write_off("q.off", [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]],
                              [[0, 1, 2], [0, 2, 3]])

    def test_takes_no_more_vertices_than_allowed(self):
        for most in 0, 1, 17, 60:
            stats = self.stats("refine", self.square(), "--odt", "0.02", "--max-insertions",
                               str(most))
            self.assertLessEqual(stats["refine"]["insertions"] + stats["odt"]["splits"] +
                                 stats["odt"]["insertions"], most)
            self.assertEqual(stats["odt"]["status"], "cap")

    def test_refuses_lengths_that_need_too_many(self):
        for length in 1e-9, 1e-100, 1e-300:
            run = self.run_program("refine", self.square(), "--odt", repr(length))
            self.assert_fails(run, "q.off", "vertices", "longer")
        vertices = 1 / (0.1 * 0.1 * math.sqrt(3) / 2)
        self.assertGreater(self.stats("refine", self.square(), "--odt", "0.1")["odt"]["splits"],
                           vertices / 2)


if __name__ == "__main__":
    main()
