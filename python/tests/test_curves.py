# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Geodesics, isolines and cuts: closed forms, and bit for bit what the program computes."""

import copy
import doctest
import pickle
import unittest

import numpy as np

import intrinsic as it
import program
import ten_surfaces
from intrinsic import _curves
from support import CUBE, SQUARE, TETRAHEDRON, grown_memory, unit_grid

SIDES = 12


def prism(n):
    """A tube: the sides of a prism over a regular polygon of radius 1, in three layers."""
    layers = 3
    a = 2 * np.pi * np.arange(n) / n
    rings = [np.column_stack([np.cos(a), np.sin(a), np.full(n, z)]) for z in range(layers + 1)]
    i, z = (x.ravel() for x in np.meshgrid(np.arange(n), np.arange(layers)))
    p, q = z * n + i, z * n + (i + 1) % n
    return np.concatenate(rings), np.concatenate([np.column_stack([p, q, q + n]),
                                                  np.column_stack([p, q + n, p + n])])


def torus():
    """A torus in space: radii 2 and 1."""
    n = SIDES
    u, v = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    a, b = 2 * np.pi * u.ravel() / n, 2 * np.pi * v.ravel() / n
    V = np.column_stack([(2 + np.cos(b)) * np.cos(a), (2 + np.cos(b)) * np.sin(a), np.sin(b)])
    number = lambda i, j: (i % n) * n + j % n
    u, v = u.ravel(), v.ravel()
    p, q, r, s = number(u, v), number(u + 1, v), number(u + 1, v + 1), number(u, v + 1)
    return V, np.concatenate([np.column_stack([p, q, r]), np.column_stack([p, r, s])])


class Shapes(unittest.TestCase):
    def check(self, s, V, curve):
        """Weights give the points, and the length is that of the pieces."""
        places = (curve.barycentric[:, :, None] * V[curve.corners]).sum(axis=1)
        np.testing.assert_allclose(places, curve.points, atol=1e-14)
        ends = np.concatenate([curve.points, curve.points[:1]]) if curve.is_closed else curve.points
        length = np.linalg.norm(np.diff(ends, axis=0), axis=1).sum()
        self.assertAlmostEqual(curve.length, length, 12)
        self.assertTrue(curve.bounds[0] <= curve.length * (1 + 1e-13))
        self.assertTrue(curve.length <= curve.bounds[1] * (1 + 1e-13))
        for p, v in zip(curve.points, curve.vertices):
            if v >= 0:
                np.testing.assert_array_equal(V[v], p)


class Paths(Shapes):
    def test_each_is_that_of_a_new_surface_whatever_was_found_before(self):
        V, F = torus()
        s, random = it.Surface(V, F), np.random.default_rng(3)
        for i in range(24):
            method = ("flips", "exact")[i % 2]
            a, b, c = (int(v) for v in random.choice(len(V), 3, replace=False))
            if i % 6 == 4:  # a vertex is inserted
                b = it.Point(int(random.integers(len(F))), (0.2, 0.3, 0.5))
            if i % 6 == 5:
                with self.assertRaises(ValueError):
                    s.path(a, a, method=method)
            find = (lambda s: s.loop([a, b, c], method=method)) if i % 5 == 4 else \
                (lambda s: s.path(a, b, through=[c] if i % 4 == 3 else (), method=method))
            found, alone = find(s), find(it.Surface(V, F))
            np.testing.assert_array_equal(found.points, alone.points)
            self.assertEqual((found.length, found.status, found.initial_length),
                             (alone.length, alone.status, alone.initial_length))

    def test_paths_in_a_square_are_straight(self):
        V, F = unit_grid(5)
        s = it.Surface(V, F)
        for method in ("exact", "flips"):
            curve = s.path(0, 35, method=method)
            self.assertAlmostEqual(curve.length, np.sqrt(2), 14)
            self.check(s, V, curve)
            curve = s.path(3, 34, method=method)
            self.assertAlmostEqual(curve.length, np.linalg.norm(V[3] - V[34]), 14)
            self.check(s, V, curve)
        a, b = it.Point(2, (0.5, 0.25, 0.25)), it.Point(40, (0.125, 0.125, 0.75))
        ends = [V[F[p.face]].T @ p.barycentric for p in (a, b)]
        curve = s.path(a, b)
        np.testing.assert_allclose([curve.points[0], curve.points[-1]], ends, atol=1e-15)
        self.assertAlmostEqual(curve.length, np.linalg.norm(ends[0] - ends[1]), 13)
        self.check(s, V, curve)

    def test_paths_on_cube_and_tetrahedron(self):
        self.assertAlmostEqual(it.Surface(*CUBE).path(0, 7).length, np.sqrt(5), 14)
        V, F = TETRAHEDRON
        top, foot = it.Point(0, (0.5, 0.5, 0)), it.Point(3, (0, 0.5, 0.5))
        curve = it.Surface(V, F).path(top, foot)  # between the middles of opposite edges
        self.assertAlmostEqual(curve.length, np.sqrt(8), 14)

    def test_points_between_turn_a_path_only_if_it_stays_there(self):
        V, F = unit_grid(4)
        s = it.Surface(V, F)
        self.assertAlmostEqual(s.path(0, 24, through=4).length, np.sqrt(2), 13)
        curve = s.path(0, 24, through=[4], waypoints=True)
        self.assertAlmostEqual(curve.length, 2, 14)
        self.check(s, V, curve)

    def test_loops_of_a_prism_are_as_long_as_its_polygon(self):
        sides = 10
        V, F = prism(sides)
        s = it.Surface(V, F)
        around = 2 * sides * np.sin(np.pi / sides)
        for points in ([0, 3, 6], [0, sides + 3, 2 * sides + 6]):
            curve = s.loop(points)
            self.assertEqual((curve.is_closed, curve.status), (True, "done"))
            self.assertAlmostEqual(curve.length, around, 13)
            self.assertLessEqual(curve.length, curve.initial_length * (1 + 1e-14))
            self.check(s, V, curve)

    def test_a_loop_around_nothing_shrinks_to_a_point(self):
        V, F = unit_grid(6)
        curve = it.Surface(V, F).loop([8, 10, 22])
        self.assertEqual((curve.status, curve.length, len(curve)), ("contracted", 0, 1))

    def test_a_network_has_paths_and_loops_and_a_proof(self):
        V, F = torus()
        network = it.Surface(V, F).network([[0, 30], [30, 77]], [[0, 4, 8]], certify=True)
        self.assertEqual([c.is_closed for c in network], [False, False, True])
        self.assertIs(network.certified, True)
        self.assertAlmostEqual(network.length, sum(c.length for c in network), 15)
        self.assertIsNone(it.Surface(V, F).network([[0, 30]]).certified)

    def test_polygons_and_covers_have_paths(self):
        square = it.Surface([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]])
        self.assertAlmostEqual(square.path(1, 3).length, np.sqrt(2), 15)
        with self.assertRaisesRegex(ValueError, "polygon"):
            square.path(it.Point(0, (0.5, 0.25, 0.25)), 3)
        three = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1]])
        fins = it.Surface(three, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
        self.assertAlmostEqual(fins.path(2, 3).length, 2, 14)
        self.assertAlmostEqual(fins.distance(2)[4], 2, 14)
        point = it.Point(1, (0.5, 0.25, 0.25))
        place = 0.25 * three[1] + 0.25 * three[3]
        self.assertAlmostEqual(fins.distance(point)[3], np.linalg.norm(place - three[3]), 14)
        with self.assertRaisesRegex(ValueError, "cover"):
            fins.cut(fins.path(2, 3))


    def test_weights_follow_the_corners_of_faces_that_were_turned_around(self):
        V = np.array(SQUARE[0], dtype=float)
        s = it.Surface(V, [[0, 1, 2], [0, 3, 2]])
        np.testing.assert_array_equal(s.faces, SQUARE[1])
        curve = s.path(it.Point(1, (0.5, 0.3, 0.2)), 1)
        np.testing.assert_allclose(curve.points[0], [0.5, 0.3, 0.2] @ V[s.faces[1]], atol=1e-15)
        self.check(s, V, curve)


class Soups(Shapes):
    """Shortest paths are on the user's faces, any number of which meet at an edge."""

    def expect_on_faces(self, s, V, F, curve):
        self.check(s, V, curve)
        for p, q, face in zip(curve.points, curve.points[1:], curve.faces):
            for x in (p, q):
                corners = V[list(F[face])]
                weights = np.linalg.lstsq(np.vstack([corners.T, np.ones(3)]), np.append(x, 1),
                                          rcond=None)[0]
                np.testing.assert_allclose(weights @ corners, x, atol=1e-12)
                self.assertGreater(weights.min(), -1e-9)

    def test_paths_cross_edges_from_any_face_to_any_other(self):
        a = np.arange(4) * np.pi / 2
        V = np.array([(0, 0, 0), (0, 0, 1), *zip(np.cos(a), np.sin(a), [0.5] * 4)])
        for arithmetic in ("exact", "double"):
            F = [(0, 1, k) for k in range(2, 6)]
            s = it.Surface(V, F, arithmetic=arithmetic)
            for tip in (3, 4, 5):
                network = s.network([[2, tip]], certify=True)
                self.assertAlmostEqual(network[0].length, 2, 14)
                self.assertEqual((network.certified, network.obstacle), (True, None))
                self.assertEqual((network[0].status, len(network[0])), ("done", 3))
                self.expect_on_faces(s, V, F, network[0])
            around = s.network([[2, 3], [2, 4, 5]], [[2, 3, 4]], certify=True)
            self.assertEqual(len(around), 3)
            self.assertAlmostEqual(around[0].length, 2, 14)

    def test_books_unfold(self):
        random = np.random.default_rng(54)
        for _ in range(25):
            pages = int(random.integers(3, 7))
            a = 2 * np.pi * (np.arange(pages) + random.uniform(0.1, 0.9, pages)) / pages
            r, z = random.uniform(0.3, 2, pages), random.uniform(0.1, 0.9, pages)
            V = np.concatenate([[(0, 0, 0), (0, 0, 1)],
                                np.column_stack([r * np.cos(a), r * np.sin(a), z])])
            F = [random.permutation([0, 1, k + 2]).tolist() for k in range(pages)]
            s = it.Surface(V, F)
            i, j = random.choice(pages, 2, replace=False)
            w = random.dirichlet((1, 1, 1))
            place, height, part = it.Point(int(i), tuple(w)), w @ V[F[i], 2], w[F[i].index(i + 2)]
            network = s.network([[place, int(j) + 2]], certify=True)
            self.assertAlmostEqual(network[0].length, np.hypot(part * r[i] + r[j], height - z[j]),
                                   12)
            self.assertTrue(network.certified)
            self.expect_on_faces(s, V, F, network[0])

    def test_paths_are_as_long_as_distances(self):
        random = np.random.default_rng(55)
        for _ in range(20):
            n = int(random.integers(6, 12))
            V = random.random((n, 3))
            F = {tuple(sorted(random.choice(n, 3, replace=False))) for _ in range(2 * n)}
            F = [random.permutation(f).tolist() for f in sorted(F)]
            s = it.Surface(V, F)
            a, b = F[0][0], it.Point(len(F) - 1, tuple(random.dirichlet((1, 1, 1))))
            expected = s.distance(a, targets=[b])[0]
            if not np.isfinite(expected):
                continue
            network = s.network([[a, b]], certify=True)
            self.assertAlmostEqual(network[0].length, expected, 10)
            self.assertTrue(network.certified, network.obstacle)
            self.expect_on_faces(s, V, F, network[0])

    def test_what_is_not_proven_is_said(self):
        V, F = unit_grid(2)  # the path passes the vertex in the middle, straight
        V, F = np.concatenate([V, [[0.5, 0.25, 1]]]), [*F, [1, 4, 9], [9, 4, 1]]
        network = it.Surface(V, F[:-1]).network([[0, 8]], certify=True)
        if not network.certified:
            self.assertIn("vertex 4", network.obstacle)
        with self.assertRaisesRegex(ValueError, "3 is both ends of a curve; give another end"):
            it.Surface(V, F[:-1]).path(3, 3)
        with self.assertRaisesRegex(ValueError, "components"):
            it.Surface(np.concatenate([V, V + 5]),
                       [*F[:-1], *(np.array(F[:-1]) + 10)]).path(0, 18)
        again = pickle.loads(pickle.dumps(network))
        self.assertEqual(again.obstacle, network.obstacle)


class Traces(Shapes):
    def test_lines_in_a_square_are_straight(self):
        V, F = unit_grid(5)
        s = it.Surface(V, F)
        d = np.array([0.5, 0.3, 0])
        end = 0.9 * d / np.linalg.norm(d)
        curve = s.trace(0, d, 0.9)
        np.testing.assert_allclose(curve.points[-1], end, atol=1e-14)
        self.assertEqual(curve.status, "done")
        self.check(s, V, curve)
        start = V[F[10]].T @ [0.25, 0.5, 0.25]
        curve = s.trace(it.Point(10, (0.25, 0.5, 0.25)), [0, 2, 0], 0.3)
        np.testing.assert_allclose(curve.points[-1], start + [0, 0.3, 0], atol=1e-14)
        curve = s.trace(it.Point(10, (0.25, 0.5, 0.25)), 1j, 0.1)  # left of the first side
        np.testing.assert_allclose(curve.points[-1], start + [0, 0.1, 0], atol=1e-14)

    def test_they_end_at_the_border(self):
        V, F = unit_grid(3)
        curve = it.Surface(V, F).trace(5, [1, 0, 0], 7)
        self.assertEqual(curve.status, "border")
        np.testing.assert_allclose(curve.points[-1], [1, V[5][1], 0], atol=1e-14)
        self.assertAlmostEqual(curve.length, 1 - V[5][0], 14)

    def test_they_go_around_a_cube(self):
        V, F = np.array(CUBE[0]), CUBE[1]
        s = it.Surface(V, F)
        curve = s.trace(it.Point(0, (0.5, 0.25, 0.25)), [0, 1, 0], 4)
        np.testing.assert_allclose(curve.points[-1], curve.points[0], atol=1e-14)
        self.check(s, V, curve)

    def test_polar_coordinates_at_a_vertex_turn_once(self):
        V, F = unit_grid(4)
        s = it.Surface(V, F)
        ends = [s.trace(12, z, 0.2).points[-1] - V[12] for z in (1, 1j, -1, -1j)]
        for i, e in enumerate(ends):
            self.assertAlmostEqual(np.linalg.norm(e), 0.2, 14)
            np.testing.assert_allclose(np.cross([0, 0, 1], e), ends[(i + 1) % 4], atol=1e-14)


class Isolines(Shapes):
    def test_lines_of_a_coordinate_are_straight(self):
        V, F = unit_grid(6)
        s = it.Surface(V, F)
        lines = s.isolines(V[:, 0], [0.3, 0.7, 2])
        self.assertEqual([line.level for line in lines], [0.3, 0.7])
        np.testing.assert_allclose(lines.lengths, [1, 1], rtol=1e-14)
        self.assertEqual([len(x) for x in (lines[1:], lines[:0], lines + lines[:1])], [1, 0, 3])
        for part in lines[1:], lines + lines[:1]:
            self.assertIsInstance(part, it.Curves)
            self.assertIn("<html", part.html())
        self.assertAlmostEqual(lines.length, 2, 13)
        self.assertEqual((s.isolines(V[:, 0], [2]).lengths.shape, s.isolines(V[:, 0], [2]).length),
                         ((0,), 0))
        np.testing.assert_allclose(s.network([[0, 6], [0, 42]]).lengths, [1, 1], rtol=1e-14)
        for line in lines:
            np.testing.assert_allclose(line.points[:, 0], line.level, atol=1e-15)
            self.assertAlmostEqual(line.length, 1, 14)
            self.check(s, V, line)

    def test_sums_and_copies_of_lines_are_lines_of_the_same_surface(self):
        V, F = unit_grid(4)
        s, other = it.Surface(V, F), it.Surface(2 * V, F)
        lines, foreign = s.isolines(V[:, 0], [0.3, 0.6]), other.isolines(V[:, 0], [0.3])
        none = s.isolines(V[:, 0], [2])
        for found, expected in (([] + lines, list(lines)), (lines.copy(), list(lines)),
                                (none.copy(), []), (it.Curves() + none, []),
                                ([lines[1]] + lines, [lines[1], *lines]),
                                (lines + [s.path(0, 5)][:0], list(lines)),
                                (sum([lines, lines], []), [*lines, *lines])):
            self.assertIsInstance(found, it.Curves)
            self.assertEqual(list(found), expected)
            self.assertIn("<html", found.html())
        self.assertIsNot(lines.copy(), lines)
        for mixed in lines + foreign, list(foreign) + lines, lines + [foreign[0]], none + foreign:
            self.assertIs(type(mixed), list)
        for x in (1,), ["x"], "", 3, None, iter(lines):
            with self.assertRaisesRegex(TypeError, "unsupported operand"):
                lines + x

    def test_levels_lie_evenly_between_finite_values(self):
        V, F = unit_grid(4)
        u = V[:, 1].copy()
        u[0] = np.inf
        lines = it.Surface(V, F).isolines(u, 3)
        self.assertEqual(sorted({line.level for line in lines}), [0.25, 0.5, 0.75])


class Isolines_of_covers(unittest.TestCase):
    """Lines on double covers, against the pieces in faces, each counted once."""

    @staticmethod
    def lengths(V, F, u, level):
        """The length of the line in each face where the linear function has the level."""
        result = []
        for f in F:
            ends = []
            for a, b in ((f[0], f[1]), (f[1], f[2]), (f[2], f[0])):
                if (u[a] < level) != (u[b] < level):
                    x = (level - u[a]) / (u[b] - u[a])
                    ends.append((1 - x) * V[a] + x * V[b])
            result.append(np.linalg.norm(ends[0] - ends[1]) if ends else 0)
        return np.array(result)

    def test_lines_come_once(self):
        for name in "Moebius", "soup", "book":
            for seed in range(4):
                V, F = (np.array(x) for x in ten_surfaces.MAKERS[name](np.random.default_rng(seed)))
                u = V @ np.random.default_rng(seed).normal(size=3)
                level = np.quantile(u, 0.4)
                with self.subTest(name=name, seed=seed):
                    lines = it.Surface(V, F).isolines(u, [level])
                    pieces = self.lengths(V, F, u, level)
                    self.assertAlmostEqual(sum(x.length for x in lines), pieces.sum(), delta=1e-9)
                    found = np.zeros(len(F))
                    for x in lines:
                        P = np.vstack([x.points, x.points[:1]]) if x.is_closed else x.points
                        np.add.at(found, x.faces[:len(P) - 1],
                                  np.linalg.norm(np.diff(P, axis=0), axis=1))
                    np.testing.assert_allclose(found, pieces, atol=1e-9)

    def test_lines_of_flipped_covers_come_once(self):
        """A linear function is linear on Delaunay triangles of a plane, whatever the flips."""
        random = np.random.default_rng(5)
        V, F = unit_grid(6)
        V[:, :2] += random.uniform(-0.05, 0.05, (len(V), 2))
        middle = (V[0] + V[1]) / 2
        F = np.vstack([F, [[0, 1, len(V)], [0, 1, len(V) + 1]]]) # two fins
        V = np.vstack([V, middle + [0, 0, 0.2], middle - [0, 0, 0.2]])
        u = V @ [0.3, 1, 0]
        s = it.Surface(V, F)
        level = float(np.quantile(u, 0.7))
        expected = self.lengths(V, F, u, level).sum()
        d = s.delaunay()
        self.assertGreater(d.statistics["delaunay"]["flips"], 4)
        for t in s, d:
            lines = t.isolines(u, [level])
            self.assertAlmostEqual(sum(x.length for x in lines), expected, delta=1e-9)


class Cuts(unittest.TestCase):
    def test_a_square_is_cut_in_two(self):
        V, F = unit_grid(4)
        s = it.Surface(V, F)
        for curves in (s.isolines(V[:, 0], [0.3]), s.path(10, 14), s.network([[10, 14]]),
                       s.trace(10, [0, 1, 0], 2)):
            cut = s.cut(curves)
            self.assertEqual(cut.number_of_components, 2)
            np.testing.assert_allclose(cut.interpolation @ V, cut.points, atol=1e-15)
            np.testing.assert_array_equal(cut.points[:len(V)], V)
            np.testing.assert_array_equal(cut.points[cut.original_vertex], cut.points)
            known = cut.input_vertex >= 0
            np.testing.assert_array_equal(V[cut.input_vertex[known]], cut.points[known])
            corners = cut.points[cut.faces]
            areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0],
                                            corners[:, 2] - corners[:, 0]), axis=1) / 2
            self.assertAlmostEqual(areas.sum(), 1, 14)
            self.assertTrue((cut.curve_of_side.max(axis=1) <= 1).all())
            self.assertEqual(cut.surface.distance(0).shape, (len(cut.points),))
            middle = V[np.array(F)[cut.input_face]].mean(axis=1)
            self.assertLess(np.abs(middle - corners.mean(axis=1)).max(), 0.25)

    def test_curves_may_cross(self):
        V, F = unit_grid(5)
        s = it.Surface(V, F)
        lines = s.isolines(V[:, 0], [0.5]) + s.isolines(V[:, 1], [0.5]) + [s.path(0, 35)]
        self.assertEqual(s.cut(lines).number_of_components, 6)

    def test_curves_can_be_pickled_and_copied(self):
        V, F = unit_grid(4)
        s = it.Surface(V, F)
        network = s.network([[10, 14], [2, 22]])
        for twin in (pickle.loads(pickle.dumps(network)), copy.deepcopy(network)):
            np.testing.assert_array_equal(twin[0].points, network[0].points)
            self.assertEqual(twin[1].bounds, network[1].bounds)
            self.assertEqual(s.cut(twin).number_of_components, 4)
            self.assertEqual(s.cut(twin[0]).number_of_components, 2)
        cut = pickle.loads(pickle.dumps(s.cut(network)))
        self.assertEqual((cut.interpolation != s.cut(network).interpolation).nnz, 0)

    def test_a_torus_becomes_a_disk(self):
        V, F = torus()
        cut = it.Surface(V, F).cut(through=[5])
        vertices, faces = len(cut.points), len(cut.faces)
        edges = len({tuple(sorted(e)) for f in cut.faces for e in zip(f, np.roll(f, 1))})
        self.assertEqual(vertices - edges + faces, 1)
        self.assertGreaterEqual((cut.original_vertex == 5).sum(), 2)


class Arguments(unittest.TestCase):
    def test_bad_arguments_are_named(self):
        V, F = unit_grid(2)
        s = it.Surface(V, F)
        for call, words in [
                (lambda: s.path(0, 9), "^b is 9"), (lambda: s.path(0, 0), "both ends.*another end"),
                (lambda: s.network([[0, 1, 1]]), "follows itself.*give it once"),
                (lambda: s.path(0, it.Point(0, (1, 0, 0))), "both ends"),
                (lambda: s.trace(0, 1, np.inf), "length is inf.*ends at a border by itself"),
                (lambda: s.cut(s.path(0, 5), through=[3]), "through is of cuts to disks"),
                (lambda: s.path(0, 1, method="exactly"), "method"),
                (lambda: s.loop([0, 1]), "^points has 2 points"), (lambda: s.network(), "curve"),
                (lambda: s.network([[0]]), "paths"),
                (lambda: s.cut(it.Surface(*unit_grid(9)).path(0, 99)), r"curves\[0\].*another"),
                (lambda: s.trace(0, [0, 0, 0], 1), "direction"),
                (lambda: s.trace(0, [0, 0, 1], 1), "direction"),
                (lambda: s.trace(0, [0, 1], -1), "length"),
                (lambda: s.trace([0, 1], 1, 1), "point"),
                (lambda: s.trace(0, [0, np.nan, 1], 1), "direction"),
                (lambda: s.trace(0, [0, 1, 0, 1], 1), "direction"),
                (lambda: s.isolines(V[:3, 0], 3), "u has the shape"),
                (lambda: s.isolines(V[:, 0], 0), "levels"),
                (lambda: s.isolines(V[:, 0], [np.inf]), "levels"),
                (lambda: s.isolines(V[:, 0] * np.nan, [0.5]), ""),
                (lambda: s.cut([V]), "not a Curve"),
                (lambda: s.cut(through=[it.Point(0, (0.5, 0.5, 0))]), "vertices")]:
            with self.assertRaisesRegex(ValueError, words):
                call()
        two = it.Surface(np.concatenate([V, V + 5]), np.concatenate([F, F + 9]))
        with self.assertRaisesRegex(ValueError, "components"):
            two.path(0, 10)

    def test_calls_leave_nothing_behind(self):
        V, F = torus()
        s = it.Surface(V, F)

        def work():
            s.path(0, it.Point(3, (0.5, 0.25, 0.25)))
            network = s.network([[0, 30]], [[0, 4, 8]], certify=True)
            s.cut(network)
            s.cut(s.isolines(V[:, 0], 2) + [s.trace(1, [0, 1, 1], 2)])

        self.assertLess(grown_memory(work, 20, before=3), 50_000)


@unittest.skipUnless(program.is_there(), "the program or its meshes are missing")
class Same_as_the_program(program.Comparison):
    names = program.some(("eight.off", "elephant.off", "cube-meshed.off", "mech-holes-shark.off",
                          "cross_quad.off"), program.CONNECTED)

    def expect_curves(self, path, network, *options):
        out = self.folder / "curves.obj"
        found = program.run("geodesic", path, *options, "-o", out)["geodesic"]
        for curve, facts, points in zip(network, found["curves"], program.polylines(out),
                                        strict=True):
            self.assertEqual(curve.length, facts["length"])
            self.assertEqual(list(curve.bounds), facts.get("length_bounds", [0, np.inf]))
            self.assertEqual(curve.initial_length, facts["initial_length"])
            self.assertEqual(curve.is_closed, facts["is_loop"])
            np.testing.assert_array_equal(curve.points, points[:len(curve)])
        self.assertEqual(network.flips, found["flips"])
        self.assertEqual(network.certified, found["certified"])

    def test_paths(self):
        for name in self.names:
            path, V, F = program.mesh(name)
            s, n = it.Surface(V, F), len(V)
            ends = [1, n // 3], [n // 2, n - 1]
            options = [o for a, b in ends for o in ("--path", f"{a},{b}")]
            self.expect_curves(path, s.network(ends, certify=True), *options)
            network = s.network(ends[:1], method="flips", certify=True)
            self.expect_curves(path, network, *options[:2], "--method", "flips")

    def test_points_in_faces_waypoints_and_loops(self):
        path, V, F = program.mesh("elephant.off")
        s = it.Surface(V, F)
        p = it.Point(100, (0.5, 0.25, 0.25))
        network = s.network([[p, 1000, 2000]], waypoints=True, certify=True)
        self.expect_curves(path, network, "--path", "100:0.5:0.25:0.25,1000,2000", "--waypoints")
        path, V, F = program.mesh("eight.off")
        loops = [[0, 100, 200], [5, 150, 300, 40]]
        lists = [",".join(map(str, loop)) for loop in loops]
        network = it.Surface(V, F).network((), loops, certify=True)
        self.expect_curves(path, network, "--loop", lists[0], "--loop", lists[1])

    def test_paths_on_soups(self):
        a = np.arange(4) * np.pi / 2
        V = np.array([(0, 0, 0), (0, 0, 1), *zip(np.cos(a), np.sin(a), [0.5] * 4)])
        F = [(0, 1, k) for k in range(2, 6)]
        path = self.folder / "book.off"
        path.write_text("OFF\n6 4 0\n" + "\n".join(" ".join(map(repr, map(float, p))) for p in V)
                        + "\n" + "\n".join("3 %d %d %d" % f for f in F) + "\n")
        network = it.Surface(V, F).network([[2, 3], [2, 0, 4], [2, 4]], waypoints=True,
                                           certify=True)
        self.expect_curves(path, network, "--path", "2,3", "--path", "2,0,4", "--path", "2,4",
                           "--waypoints")

    def test_a_surface_with_doubles(self):
        path, V, F = program.mesh("elephant.off")
        s = it.Surface(V, F, arithmetic="double")
        network = s.network([[3, 1500]], certify=True)
        self.expect_curves(path, network, "--path", "3,1500", "--arithmetic", "double")

    def expect_cut(self, path, cut, *options):
        out = self.folder / "cut.off"
        program.run("cut", path, *options, "-o", out, "--labels", self.folder / "labels.txt")
        V, F = program.surface(out)
        np.testing.assert_array_equal(cut.points, V)
        np.testing.assert_array_equal(cut.faces, F)
        labels = np.loadtxt(self.folder / "labels.txt", dtype=int)
        np.testing.assert_array_equal(np.column_stack([cut.component, cut.input_face]), labels)

    def test_cuts(self):
        for name in self.names:
            path, V, F = program.mesh(name)
            s, n = it.Surface(V, F), len(V)
            self.expect_cut(path, s.cut(s.network([[1, n // 2]])), "--path", f"1,{n // 2}")
            lines = s.isolines(V[:, 2], 3)
            values = self.folder / "values.txt"
            values.write_text("\n".join(map(repr, V[:, 2].tolist())))
            self.expect_cut(path, s.cut(lines), "--levels", 3, "--values", values)
        path, V, F = program.mesh("eight.off")
        self.expect_cut(path, it.Surface(V, F).cut(), "--to-disk")


def load_tests(loader, tests, pattern):
    """Adds the examples in docstrings, whose surface is a square."""
    tests.addTests(doctest.DocTestSuite(_curves, extraglobs={"s": it.Surface(*SQUARE)}))
    return tests


if __name__ == "__main__":
    unittest.main()
