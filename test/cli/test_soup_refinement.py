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
        for seed in range(60):
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

    def test_of_repeated_right_triangles_end(self):
        # a copy of a circumcenter on an edge came to lie on the circumcenter
        points = [[0, 1, 0], [0, 2, 0], [1, 1, 2], [2, 2, 1], [2, 2, 2]]
        faces = [[3, 4, 0], [0, 4, 3], [1, 2, 3], [0, 4, 2], [0, 4, 2], [2, 3, 1], [1, 0, 3],
                 [3, 1, 0], [2, 1, 4], [4, 1, 2], [0, 3, 4], [4, 1, 3], [4, 3, 0], [3, 2, 0],
                 [3, 0, 2]]
        soups = [(points, faces)] + [soup_on_a_grid(seed) for seed in range(40)]
        for k, (p, f) in enumerate(soups):
            with self.subTest(k):
                mesh = self.write_off("g.off", p, f)
                refine = self.stats("refine", mesh, "--min-angle", "25")["refine"]
                self.assertEqual(refine["status"], "done")
                self.assertEqual(refine["unsatisfied"]["refused"], 0)


def soup_on_a_grid(seed):
    """Triangles of grid points, many of them right, with circumcenters on edges; some repeated."""
    r = random.Random(seed)
    points = [[r.randrange(3), r.randrange(3), r.randrange(3)] for _ in range(r.randrange(5, 8))]
    faces = []
    while len(faces) < 12:
        f = r.sample(range(len(points)), 3)
        a, b, c = (points[v] for v in f)
        p, q = [x - y for x, y in zip(b, a)], [x - y for x, y in zip(c, a)]
        if any(p[i] * q[j] != p[j] * q[i] for i, j in ((0, 1), (0, 2), (1, 2))):
            faces.append(f)
        elif len({tuple(x) for x in points}) < 4:
            return soup_on_a_grid(seed + 100000)
    return points, faces + [r.sample(f, 3) for f in faces[:seed % 5]]


def twisted_strip(r):
    """A strip that is turned half around once or twice, of random width."""
    n, half_turns, width = r.randrange(3, 9), r.choice((1, 1, 1, 2)), r.uniform(0.2, 0.6)
    points, faces = [], []
    for i in range(n):
        a = 2 * math.pi * i / n
        for side in -width, width:
            b = half_turns * a / 2
            x = 1 + side * math.cos(b)
            points.append([x * math.cos(a), x * math.sin(a), side * math.sin(b)])
        end = [2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 3]
        if i == n - 1:
            end[2:] = [1, 0] if half_turns == 1 else [0, 1]
        p, q, s, t = end
        faces += r.choice(([[p, s, t], [p, t, q]], [[p, s, q], [q, s, t]]))
    return points, faces


def book(r):
    """Pages of random width, cut into triangles, that meet at an edge."""
    n = r.randrange(1, 4)
    points, faces = [[0, 0, 2 * i / n] for i in range(n + 1)], []
    pages = r.randrange(3, 6)
    for page in range(pages):
        a, width = 2 * math.pi * page / pages + r.uniform(-0.4, 0.4), r.uniform(0.4, 2)
        first = len(points)
        points += [[width * math.cos(a), width * math.sin(a), 2 * i / n + r.uniform(-0.3, 0.3)]
                   for i in range(n + 1)]
        for i in range(n):
            p, q, s, t = i, i + 1, first + i, first + i + 1
            faces += r.choice(([[p, s, t], [p, t, q]], [[p, s, q], [q, s, t]]))
    return points, faces


class Curves_on_one_sheet(Cli_test):
    """Curves lie on one sheet of a cover: refinement keeps them, and ends on all sheets."""

    def points_of_curve(self, r, points, faces):
        """Places in faces and at vertices."""
        for _ in range(2):
            weights = [r.random() + 0.05 for _ in range(3)]
            yield ":".join(map(repr, [r.randrange(len(faces)),
                                      *(w / sum(weights) for w in weights)]))
        yield str(r.choice(r.choice(faces)))

    def kept_length(self, name):
        """The length of all edges of the subdivision between points of curves."""
        ply = self.read_ply(name)
        places = [(v["x"], v["y"], v["z"]) for v in ply["vertex"]]
        is_on_curve = [v["curve"] >= 0 for v in ply["vertex"]]
        edges = {tuple(sorted(edge)) for f in ply["face"]
                 for edge in zip(f["vertex_indices"], f["vertex_indices"][1:] +
                                 f["vertex_indices"][:1]) if all(is_on_curve[v] for v in edge)}
        return sum(math.dist(places[a], places[b]) for a, b in edges)

    def refined(self, mesh, *arguments, is_one_path=True):
        stats = self.stats("geodesic", mesh, "--refine", "--min-angle", "30", "--subdivision", "-o",
                           "s.ply", *arguments)
        refine = stats["refine"]
        self.assertEqual(refine["status"], "done")
        self.assertEqual(refine["unsatisfied"]["refused"], 0)
        self.assertGreaterEqual(refine["satisfied_min_angle_deg"], 30 - 1e-9)
        # the other figure is measured elsewhere, by other formulas
        self.assertAlmostEqual(refine["min_angle_deg"], stats["quality"]["min_angle_deg"],
                               delta=1e-6)
        # Edges that join points of a curve, or of two, and are on none, add to it; two curves, or
        # two parts of a loop, may share edges.
        length = stats["geodesic"]["length"] / (1 if is_one_path else 2)
        self.assertGreaterEqual(self.kept_length("s.ply"), length * (1 - 1e-9))
        return refine

    def test_stay_and_end(self):
        for seed in range(60):
            r = random.Random(seed)
            make = (twisted_strip, twisted_strip, book, None)[seed % 4]
            points, faces = make(r) if make else soup(seed)
            mesh = self.write_off("s.off", points, faces)
            a, b, c = self.points_of_curve(r, points, faces)
            curves = r.choice((["--path", f"{a},{b}"], ["--path", f"{c},{a}"],
                               ["--path", f"{a},{b}", "--path", f"{b},{c}"],
                               ["--loop", f"{a},{b},{c}"]))
            domain = ["--domain", "tufted"] if seed % 4 == 1 else []
            with self.subTest(seed=seed):
                self.refined(mesh, "--max-insertions", "3000", *curves, *domain,
                             is_one_path=len(curves) == 2 and curves[0] == "--path")

    def test_beside_the_border(self):
        """The curve is a hair's breadth from it: copies of it on the other sheet are, too."""
        points = []
        for i in range(3):
            a = 2 * math.pi * i / 3
            for side in -0.5, 0.5:
                x = 2 + side * math.cos(a / 2)
                points.append([x * math.cos(a), x * math.sin(a), side * math.sin(a / 2)])
        faces = [[0, 2, 3], [0, 3, 1], [2, 4, 5], [2, 5, 3], [4, 1, 0], [4, 0, 5]]
        refine = self.refined(self.write_off("m.off", points, faces), "--path", "0,3:.2:.3:.5")
        self.assertLessEqual(refine["insertions"], 100)


class Optimal_delaunay(Cli_test):
    def square(self):
        return self.write_off("q.off", [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]],
                              [[0, 1, 2], [0, 2, 3]])

    def test_takes_no_more_vertices_than_allowed(self):
        for most in 0, 1, 17, 60:
            stats = self.stats("refine", self.square(), "--odt-length", "0.02", "--max-insertions",
                               str(most))
            self.assertLessEqual(stats["refine"]["insertions"] + stats["odt"]["splits"] +
                                 stats["odt"]["insertions"], most)
            self.assertEqual(stats["odt"]["status"], "cap")

    def test_refuses_lengths_that_need_too_many(self):
        for length in 1e-9, 1e-100, 1e-300:
            run = self.run_program("refine", self.square(), "--odt-length", repr(length))
            self.assert_fails(run, "q.off", "vertices", "longer")
        vertices = 1 / (0.1 * 0.1 * math.sqrt(3) / 2)
        self.assertGreater(self.stats("refine", self.square(), "--odt-length", "0.1")["odt"]["splits"],
                           vertices / 2)


if __name__ == "__main__":
    main()
