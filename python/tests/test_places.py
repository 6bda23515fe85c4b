# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points as users name them: results do not depend on the name, and the program and the module find
the same points, also on refined triangulations."""

import unittest

import numpy as np

import intrinsic as it
import program
from support import BOOK, bumpy

MOEBIUS = ([[0, 0, 0], [1, 0, 0], [2, 1, 0], [1, 2, 1], [0, 1, 1]],
           [[i, (i + 1) % 5, (i + 2) % 5] for i in range(5)])


def surfaces():
    """Names, vertices and faces: a height field with slivers, a cone, and surfaces to be covered."""
    angles = np.arange(7) * 0.7
    rim = np.column_stack([np.cos(angles), np.sin(angles), 0 * angles])
    cone = np.vstack([[0, 0, 1], rim]), [[0, i, i % 7 + 1] for i in range(1, 8)]
    for name, (V, F) in (("bumpy", bumpy(6)), ("cone", cone), ("Moebius", MOEBIUS), ("book", BOOK)):
        yield name, np.array(V, dtype=float), np.array(F)


def sides(F):
    """The faces and the corner where a side starts, by the ends of edges."""
    found = {}
    for f, corners in enumerate(F):
        for k in range(3):
            edge = frozenset((int(corners[k]), int(corners[(k + 1) % 3])))
            found.setdefault(edge, []).append((f, k))
    return found


def on_side(F, f, k, u, first):
    """The point at a parameter between the vertex `first` and the other end of a side."""
    weights = [0., 0., 0.]
    weights[k], weights[(k + 1) % 3] = (1 - u, u) if F[f][k] == first else (u, 1 - u)
    return it.Point(f, tuple(weights))


def random_point(F, random):
    return it.Point(int(random.integers(len(F))), tuple(random.dirichlet([1, 1, 1]).tolist()))


class Names(unittest.TestCase):
    def results(self, s, p, q):
        """What functions return for a point, and another one."""
        yield "exact", s.distance(p)
        yield "heat", s.distance(p, method="heat")
        yield "targets", s.distance(q, targets=[p])
        yield "heat at targets", s.distance(q, method="heat", targets=[p])
        yield "pairs", s.pair_distances([p, q], [q, p])
        yield "batch", s.distances([[p], [p, q]])
        yield "extend", s.extend([p, q], [1, 2])
        yield "path", s.path(p, q).length
        yield "places", s.locate([p])[1]
        cells = s.voronoi([p, q])
        yield "cells", np.concatenate([cells.distances, cells.areas])

    def expect_same(self, make, names, q):
        """All names of a point give the same numbers: they are one point, not points nearby. Each
        name has a surface of its own, since computing makes what surfaces store more accurate."""
        expected = list(self.results(make(), names[0], q))
        for name in names[1:]:
            for (what, a), (_, b) in zip(expected, self.results(make(), name, q), strict=True):
                np.testing.assert_array_equal(a, b, err_msg=f"{what} from {name}, not {names[0]}")

    def makers(self, V, F):
        return (lambda: it.Surface(V, F)), (lambda: it.Surface(V, F).refine(min_angle=20))

    def test_of_corners_do_not_matter(self):
        random = np.random.default_rng(5)
        for name, V, F in surfaces():
            for make in self.makers(V, F):
                for f in random.choice(len(F), min(3, len(F)), replace=False):
                    k = int(random.integers(3))
                    corner = it.Point(int(f), tuple(np.eye(3)[k]))
                    with self.subTest(name=name, corner=corner):
                        self.expect_same(make, [int(F[f][k]), corner], random_point(F, random))

    def test_of_points_on_edges_do_not_matter(self):
        random = np.random.default_rng(6)
        for name, V, F in surfaces():
            shared = [(edge, found) for edge, found in sides(F).items() if len(found) > 1]
            for make in self.makers(V, F):
                for i in random.choice(len(shared), min(3, len(shared)), replace=False):
                    edge, found = shared[i]
                    u = random.uniform(0.1, 0.9)
                    names = [on_side(F, f, k, u, min(edge)) for f, k in found]
                    with self.subTest(name=name, names=names):
                        self.expect_same(make, names, random_point(F, random))

    def test_of_points_on_edges_turn_logarithms_by_the_frame_of_the_face(self):
        """By the angle between the first sides of two faces that are unfolded into a plane."""
        random = np.random.default_rng(7)
        _, V, F = list(surfaces())[0]
        s = it.Surface(V, F)
        shared = [(edge, found) for edge, found in sides(F).items() if len(found) == 2]
        for i in random.choice(len(shared), 4, replace=False):
            edge, found = shared[i]
            u = random.uniform(0.1, 0.9)
            turn = []
            for f, k in found:  # of the side that is shared, from the first side of the face
                a, b, c = V[F[f]]
                x = (b - a) / np.linalg.norm(b - a)
                y = np.cross(np.cross(b - a, c - a), x)
                along = V[F[f][(k + 1) % 3]] - V[F[f][k]]
                turn.append(np.arctan2(along @ y / np.linalg.norm(y), along @ x))
            for method in "exact", "affine", "polar":
                z = [s.log_map(on_side(F, f, k, u, min(edge)), method=method) @ [1, 1j]
                     for f, k in found]
                turned = z[0] * -np.exp(1j * (turn[1] - turn[0]))
                self.assertLess(np.abs(turned - z[1]).max(), 1e-9 * np.abs(z[1]).max(), method)

    def test_that_are_wrong_are_refused(self):
        s = it.Surface(*list(surfaces())[0][1:])
        for weights in ((.5, .4, 0), (1.5, -.5, 0), (np.nan, .5, .5), (np.inf, 0, 0), (0, 0, 0)):
            with self.assertRaisesRegex(ValueError, "barycentric"):
                s.distance(it.Point(0, weights))
        with self.assertRaises(ValueError):
            s.distance(it.Point(10**6, (1, 0, 0)))


@unittest.skipUnless(program.is_there(), "the program or its meshes are missing")
class Program(program.Comparison):
    """Refines first and finds points after that, as the module does."""

    def write(self, name, V, F):
        path = self.folder / f"{name}.off"
        path.write_text("\n".join([f"OFF {len(V)} {len(F)} 0",
                                   *(" ".join(map(repr, map(float, p))) for p in V),
                                   *(" ".join(map(str, [3, *f])) for f in F)]))
        return path

    def word(self, p):
        return ":".join(map(repr, (p.face, *p.barycentric))) if isinstance(p, it.Point) else str(p)

    def cases(self, seed):
        """Files, their surfaces as the program has them by options, and points of each kind."""
        random = np.random.default_rng(seed)
        for name, V, F in surfaces():
            path = self.write(name, V, F)
            edge, ((f, k), *_) = list(sides(F).items())[int(random.integers(len(F)))]
            points = [random_point(F, random), on_side(F, f, k, 0.3, min(edge)),
                      it.Point(int(f), (0., 1., 0.)), int(random.integers(len(V)))]
            for options in ((), ("--refine", "--min-angle", "20")):
                s = it.read(path)
                yield path, options, s.refine(min_angle=20) if options else s.delaunay(), points

    def expect_near(self, a, b, error=1e-12):
        a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
        self.assertEqual(a.shape, b.shape)
        np.testing.assert_array_equal(np.isfinite(a), np.isfinite(b))
        finite = np.isfinite(b)
        self.assertLessEqual(np.abs(a - b)[finite].max(initial=0),
                             error * np.abs(b[finite]).max(initial=1))

    def test_distances(self):
        for path, options, s, points in self.cases(11):
            for p in points:
                with self.subTest(path=path, options=options, p=p):
                    stats, d = self.numbers_of_program(
                        "distance", path, "--source", self.word(p), *options, "--method", "exact",
                        "--targets", ",".join(map(self.word, points)))
                    self.expect_near(stats["distance"]["targets"], s.distance(p, targets=points))
                    _, d = self.numbers_of_program("distance", path, "--source", self.word(p),
                                                   *options, "--method", "exact")
                    self.expect_near(d, s.distance(p))
                    _, d = self.numbers_of_program("distance", path, "--source", self.word(p),
                                                   *options, "--method", "heat")
                    self.expect_near(d, s.distance(p, method="heat"))

    def test_distances_are_those_before_refinement(self):
        """Exact ones do not depend on the triangulation."""
        for path, options, s, points in self.cases(12):
            if options:
                p = points[0]
                _, d = self.numbers_of_program("distance", path, "--source", self.word(p), *options,
                                               "--method", "exact", "--on", "input")
                self.expect_near(d, it.read(path).distance(p), 1e-10)

    def test_logarithms(self):
        for path, options, s, points in self.cases(13):
            for p in points[0], points[3]:
                for method in "exact", "affine", "polar":
                    with self.subTest(path=path, options=options, p=p, method=method):
                        _, z = self.numbers_of_program("logmap", path, "--source", self.word(p),
                                                       *options, "--method", method)
                        self.expect_near(z[:, :2], s.log_map(p, method=method), 1e-11)

    def test_cells(self):
        for path, options, s, points in self.cases(14):
            with self.subTest(path=path, options=options):
                stats = program.run("distance", path, "--method", "exact", *options, "--source",
                                    ",".join(map(self.word, points)), "--voronoi",
                                    self.folder / "v.obj")
                self.expect_near(stats["distance"]["cells"]["areas"], s.voronoi(points).areas)

    def test_geodesics(self):
        for path, options, s, points in self.cases(15):
            if options and "book" in str(path):
                continue  # curves that refinement keeps as edges are on the cover
            for q in points[1:]:
                with self.subTest(path=path, options=options, q=q):
                    p = points[0]
                    stats = program.run("geodesic", path, "--path",
                                        f"{self.word(p)},{self.word(q)}", *options)
                    curve = stats["geodesic"]["curves"][0]
                    self.expect_near(curve["length"], it.read(path).path(p, q).length, 1e-10)

    def test_distances_from_curves(self):
        """Of heat, through points in faces: near those from many points on the curve."""
        n = 9
        x, y = np.meshgrid(np.arange(n), np.arange(n))
        V = np.column_stack([x.ravel(), y.ravel(), 0 * x.ravel()])
        i = np.arange(n * n).reshape(n, n)[:-1, :-1].ravel()
        F = np.vstack([np.column_stack([i, i + 1, i + n + 1]),
                       np.column_stack([i, i + n + 1, i + n])])
        path = self.write("plane", V, F)
        for options in ((), ("--refine", "--min-angle", "20"),
                        ("--refine", "--max-edge-length", "0.6")):
            for signed in ((), ("--signed",)):
                stats, d = self.numbers_of_program(  # from (0.5, 0.25) along x = 0.5 + ...
                    "distance", path, "--curve", "0:.5:.25:.25,36,80", *signed, *options)
                self.assertEqual(stats["distance"]["unreached_vertices"], 0)
                self.assertLess(abs(d[80]), 0.1)
                self.assertLess(abs(d[36]), 0.1)
                # no vertex is farther from the curve than from its ends, in first order
                ends = np.hypot(V[:, 0] - 8, V[:, 1] - 8)
                self.assertLess((np.abs(d[:len(V)]) - ends).max(), 0.5)


if __name__ == "__main__":
    unittest.main()
