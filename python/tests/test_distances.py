# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances: closed forms, and bit for bit what the program computes."""

import doctest
import tempfile
import unittest
from pathlib import Path

import numpy as np

import intrinsic as it
import program
from intrinsic import _distances
from support import BOOK, CUBE, SQUARE, TETRAHEDRON, grown_memory, unit_grid


class Closed_forms(unittest.TestCase):
    def test_distances_on_a_cube(self):
        s = it.Surface(*CUBE)
        expected = [0, 1, 1, np.sqrt(2), 1, np.sqrt(2), np.sqrt(2), np.sqrt(5)]
        np.testing.assert_allclose(s.distance(0), expected, rtol=1e-15)

    def test_distances_on_a_tetrahedron(self):
        s = it.Surface(*TETRAHEDRON)
        edge = np.sqrt(8)
        np.testing.assert_allclose(s.distance(2), [edge, edge, 0, edge], rtol=1e-15)
        middle = it.Point(0, (0, 0.5, 0.5))  # of the edge from 1 to 2, opposite of 0
        height = edge * np.sqrt(3) / 2
        np.testing.assert_allclose(s.distance(0, targets=[middle, 1]), [height, edge], rtol=1e-15)

    def test_the_distance_of_one_target_is_a_number(self):
        s = it.Surface(*TETRAHEDRON)
        for method in "exact", "heat":
            for target in 1, np.int64(1), it.Point(0, (0, 0.5, 0.5)):
                found = s.distance(0, method=method, targets=target)
                self.assertIs(type(found), float)
                self.assertEqual([found], s.distance(0, method=method, targets=[target]).tolist())

    def test_distances_in_a_square_are_those_in_the_plane(self):
        V, F = unit_grid(7)
        s = it.Surface(V, F)
        for source in (0, 25, 63):
            expected = np.linalg.norm(V - V[source], axis=1)
            np.testing.assert_allclose(s.distance(source), expected, atol=1e-14)
        within = V[F[40]].T @ [0.2, 0.3, 0.5]
        np.testing.assert_allclose(s.distance(it.Point(40, (0.2, 0.3, 0.5))),
                                   np.linalg.norm(V - within, axis=1), atol=1e-14)

    def test_a_search_ends_where_it_is_told(self):
        V, F = unit_grid(6)
        d = it.Surface(V, F).distance(0, max_distance=0.5)
        near = np.linalg.norm(V, axis=1)
        np.testing.assert_allclose(d[near < 0.49], near[near < 0.49], atol=1e-14)
        self.assertTrue(np.isinf(d[near > 0.51]).all())

    def test_heat_comes_near(self):
        V, F = unit_grid(20)
        error = it.Surface(V, F).distance(0, method="heat") - np.linalg.norm(V, axis=1)
        self.assertLess(np.abs(error).max(), 0.05)

    def test_pairs_and_batches_agree_with_single_searches(self):
        V, F = unit_grid(5)
        s = it.Surface(V, F)
        A, B = np.arange(0, 36, 3), np.arange(35, -1, -3)
        for method in ("exact", "heat"):
            D = s.distances(A, method=method)
            for i, a in enumerate(A):
                np.testing.assert_array_equal(D[i], s.distance(int(a), method=method))
            np.testing.assert_allclose(s.pair_distances(A, B, method=method),
                                       D[np.arange(len(A)), B], rtol=1e-14)
        point = it.Point(3, (0.25, 0.25, 0.5))
        np.testing.assert_allclose(s.pair_distances(point, B), s.distance(point)[B], rtol=1e-14)
        np.testing.assert_allclose(s.pair_distances([point, 3], [4, point]),
                                   [s.distance(point)[4], s.distance(point)[3]], rtol=1e-14)

    def test_components_that_are_not_reached_are_infinitely_far(self):
        V, F = unit_grid(2)
        s = it.Surface(np.concatenate([V, V + [3, 0, 0]]), np.concatenate([F, F + len(V)]))
        for method in ("exact", "heat"):
            d = s.distance(0, method=method)
            self.assertTrue(np.isfinite(d[:9]).all() and np.isinf(d[9:]).all())
        cells = s.voronoi([0, 4])
        self.assertEqual(set(cells.labels[9:]), {-1})


class Cells(unittest.TestCase):
    def test_cells_of_a_square_are_halves(self):
        V, F = unit_grid(4)
        cells = it.Surface(V, F).voronoi([0, 4])
        np.testing.assert_allclose(cells.areas, [0.5, 0.5], rtol=1e-12)
        boundary, = cells.boundaries
        np.testing.assert_allclose(boundary.points[:, 1], 0.5, atol=1e-14)
        self.assertAlmostEqual(boundary.length, 1, 13)
        self.assertEqual({boundary.left, boundary.right}, {0, 1})
        np.testing.assert_array_equal(cells.labels[V[:, 1] < 0.4], 0)

    def test_sets_of_sources_share_a_cell(self):
        V, F = unit_grid(4)
        cells = it.Surface(V, F).voronoi([[0, 4], [20, 24]], cell_tolerance=1e-6)
        np.testing.assert_allclose(cells.areas, [0.5, 0.5], rtol=1e-9)

    def test_three_cells_meet_at_a_junction(self):
        V, F = unit_grid(4)
        cells = it.Surface(V, F).voronoi([0, 4, 22])
        self.assertEqual(len(cells.junctions.cells), 1)
        self.assertEqual(set(cells.junctions.cells[0]), {0, 1, 2})
        place = cells.junctions.points[0]
        distances = np.linalg.norm(V[[0, 4, 22]] - place, axis=1)
        np.testing.assert_allclose(distances, distances[0], atol=1e-3)

    def test_farthest_points_of_a_square_are_its_corners(self):
        V, F = unit_grid(6)
        found = it.Surface(V, F).farthest_points(4)
        self.assertEqual(set(found.vertices), {0, 6, 42, 48})
        self.assertAlmostEqual(found.radius, np.sqrt(0.5), 13)


class Arguments(unittest.TestCase):
    def setUp(self):
        self.s = it.Surface(*unit_grid(2))

    def test_results_go_where_the_caller_wants_them(self):
        expected = self.s.distances([0, 4, 8])
        for dtype in (np.float32, np.float64):
            out = np.empty((3, 9), dtype)
            self.assertIs(self.s.distances([0, 4, 8], out=out), out)
            np.testing.assert_array_equal(out, expected.astype(dtype))
        with tempfile.TemporaryDirectory() as folder:
            out = np.memmap(Path(folder) / "d", np.float64, "w+", shape=(3, 9))
            self.s.distances([0, 4, 8], method="heat", out=out, threads=2)
            np.testing.assert_array_equal(out, self.s.distances([0, 4, 8], method="heat"))
            del out

    def test_arrays_that_cannot_hold_the_results_are_refused(self):
        read_only = np.empty((1, 9))
        read_only.flags.writeable = False
        for out in (np.empty((9, 1)), np.empty((1, 9), np.int32), np.empty((2, 9))[::2][:, ::-1],
                    np.empty((1, 9), ">f8"), read_only, [0.0] * 9, np.empty(9)):
            with self.assertRaises(ValueError):
                self.s.distances([0], out=out)

    def test_sources_are_numbers_lists_and_arrays_of_any_type(self):
        expected = self.s.distance([1, 5])
        for sources in ((1, 5), np.array([1, 5], np.uint8), np.array([1., 5.]),
                        np.array([1, 0, 5, 0])[::2], [np.int16(1), 5],
                        [it.Point(0, (0, 0, 1)), 1, 5][1:]):
            np.testing.assert_array_equal(self.s.distance(sources), expected)

    def test_bad_arguments_are_named(self):
        s, point = self.s, it.Point
        for call, words in [
                (lambda: s.distance(9), "sources"), (lambda: s.distance(-1), "sources"),
                (lambda: s.distance([]), "source"), (lambda: s.distance([0.5]), "whole"),
                (lambda: s.distance("x"), "sources"), (lambda: s.distance([[0, 1]]), r"sources\[0\].*Point"),
                (lambda: s.distance(0, method="fast"), "method"),
                (lambda: s.distance(0, method="heat", max_distance=1), "max_distance"),
                (lambda: s.distance(0, time_factor=2), "time_factor is for method=.heat"),
                (lambda: s.distances([0], time_factor=2), "time_factor is for method=.heat"),
                (lambda: s.distance(0, max_distance=np.nan), "max_distance"),
                (lambda: s.distance(0, targets=[99]), "targets"),
                (lambda: s.distance(point(8, (1, 0, 0))), "face"),
                (lambda: s.distance(point(0, (1, 1, 0))), "barycentric"),
                (lambda: s.distance(point(0, (1, 0))), "barycentric"),
                (lambda: s.distances([[0], []]), "source"),
                (lambda: s.pair_distances([0, 1], [1, 2, 3]), "A has 2"),
                (lambda: s.voronoi([]), "each cell needs a source"),
                (lambda: s.voronoi([0, []]), "each cell needs a source"),
                (lambda: s.voronoi([0], cell_tolerance=0), "cell_tolerance"),
                (lambda: s.farthest_points(1, start=[0, 1]), "start")]:
            with self.assertRaisesRegex(ValueError, words):
                call()

    def test_isolated_vertices_are_no_sources(self):
        V, F = unit_grid(1)
        s = it.Surface(np.concatenate([V, [[5, 5, 5]]]), F)
        self.assertTrue(np.isinf(s.distance(0)[4]))
        with self.assertRaisesRegex(ValueError, "isolated"):
            s.distance(4)

    def test_the_user_sees_progress_and_may_end_it(self):
        seen = []

        def stop(stage, count, total):
            seen.append(stage)
            raise KeyboardInterrupt

        s = it.Surface(*unit_grid(150))  # each search asks now and then
        t = s.delaunay()
        for work in (lambda: s.distances(range(2000), progress=stop),
                     lambda: s.farthest_points(20000, progress=stop),
                     lambda: s.network([[0, 11400, 22800]] * 20, progress=stop),
                     lambda: s.network([], [[0, 150, 22800]] * 20, progress=stop)):
            del seen[:]
            with self.assertRaises(KeyboardInterrupt):
                work()
            self.assertEqual(len(seen), 1)
        np.testing.assert_array_equal(s.distance(0), t.distance(0))  # nothing is spoilt

    def test_pages_of_a_book_unfold(self):
        random = np.random.default_rng(50)
        for pages in (3, 4, 5, 6) * 3:
            r, z = random.uniform(0.3, 2, pages), random.uniform(0.1, 0.9, pages)
            angle = np.sort(random.uniform(0, 2 * np.pi, pages))
            V = np.vstack([[[0, 0, 0], [0, 0, 1]], np.column_stack([r * np.cos(angle),
                                                                    r * np.sin(angle), z])])
            F = np.array([[i % 2, 1 - i % 2, 2 + i] for i in range(pages)])
            s = it.Surface(V, F)
            page, w = random.integers(pages, size=12), random.dirichlet([0.3] * 3, 12)
            points = [it.Point(int(f), tuple(x)) for f, x in zip(page, w)]
            x = w[:, 2] * r[page]
            y = w[:, 2] * z[page] + np.where(page % 2 == 0, w[:, 1], w[:, 0])
            beyond = np.where(page[:, None] == page, x[:, None] - x, x[:, None] + x)
            expected = np.hypot(beyond, y[:, None] - y)
            for p, d in zip(points, expected):
                np.testing.assert_allclose(s.distance(p, targets=points), d, atol=1e-12)
                np.testing.assert_allclose(s.pair_distances(p, points), d, atol=1e-12)
            tips = np.hypot(r[:, None] + r, z[:, None] - z) * (1 - np.eye(pages))
            found = s.distances(np.arange(2, 2 + pages))[:, 2:]
            np.testing.assert_allclose(found, tips, atol=1e-12)
            cells = s.voronoi([2, 3])
            self.assertAlmostEqual(cells.areas.sum(), r.sum() / 2, delta=1e-12)

    def test_points_in_faces_of_covers_are_on_all_sheets(self):
        s = it.Surface(*BOOK)
        points = [it.Point(f, (0.2, 0.3, 0.5)) for f in range(3)] + [2]
        expected = [s.distance(points[0], targets=[p])[0] for p in points]
        np.testing.assert_allclose(s.pair_distances(points[0], points), expected, atol=1e-12)
        np.testing.assert_allclose(s.pair_distances(points, points[0]), expected, atol=1e-12)

    def test_calls_leave_nothing_behind(self):
        s = self.s

        def work():
            s.distance(0)
            s.distance(it.Point(0, (0.5, 0.25, 0.25)), method="heat", targets=[3])
            s.distances([0, 1])
            s.pair_distances([0, 1], [2, 3])
            s.voronoi([0, 8])
            s.farthest_points(3)

        self.assertLess(grown_memory(work, 100, before=5), 50_000)


@unittest.skipUnless(program.is_there(), "the program or its meshes are missing")
class Same_as_the_program(program.Comparison):
    names = program.some(("eight.off", "elephant.off", "cube-meshed.off", "mech-holes-shark.off",
                          "cross_quad.off"), program.TWENTY)

    def test_distances(self):
        for name in self.names:
            path, V, F = program.mesh(name)
            sources = [len(V) // 3, len(V) // 2]
            text = ",".join(map(str, sources))
            for method in ("exact", "heat"):
                s = it.Surface(V, F)  # a search sharpens what is stored
                program.run("distance", path, "--method", method, "--source", text, "--on",
                            "intrinsic", "-o", self.folder / "d.txt")
                expected = np.loadtxt(self.folder / "d.txt")
                np.testing.assert_array_equal(s.distance(sources, method=method), expected, name)

    def test_targets_and_limits(self):
        path, V, F = program.mesh("elephant.off")
        s = it.Surface(V, F)
        targets = [5, 700, 1500]
        found = program.run("distance", path, "--method", "exact", "--source", 3, "--targets",
                            ",".join(map(str, targets)))["distance"]
        np.testing.assert_array_equal(s.distance(3, targets=targets), found["targets"])
        program.run("distance", path, "--method", "exact", "--source", 3, "--max-distance", 0.2,
                    "--on", "intrinsic", "-o", self.folder / "d.txt")
        np.testing.assert_array_equal(s.distance(3, max_distance=0.2),
                                      np.loadtxt(self.folder / "d.txt"))

    def test_batches_and_pairs(self):
        path, V, F = program.mesh("elephant.off")
        s = it.Surface(V, F)
        sets = [[0, 10], [7], [100, 200, 300]]
        pairs = [[1, 5], [900, 3], [1, 2000]]
        for name, lists in ("sets.txt", sets), ("pairs.txt", pairs):
            text = "\n".join(" ".join(map(str, row)) for row in lists)
            (self.folder / name).write_text(text + "\n")
        for method in ("exact", "heat"):
            program.run("distance", path, "--method", method, "--sources", self.folder / "sets.txt",
                        "-o", self.folder / "d.npy")
            np.testing.assert_array_equal(s.distances(sets, method=method),
                                          np.load(self.folder / "d.npy"))
            found = program.run("distance", path, "--method", method, "--pairs",
                                self.folder / "pairs.txt")["distance"]["distances"]
            A, B = np.array(pairs).T
            np.testing.assert_array_equal(s.pair_distances(A, B, method=method), found)

    def test_cells(self):
        path, V, F = program.mesh("elephant.off")
        found = program.run("distance", path, "--method", "exact", "--source", "0,1000,2000",
                            "--voronoi", self.folder / "v.obj")["distance"]["cells"]
        cells = it.Surface(V, F).voronoi([0, 1000, 2000])
        np.testing.assert_array_equal(cells.areas, found["areas"])
        lines = program.polylines(self.folder / "v.obj")
        self.assertEqual(len(lines), len(cells.boundaries))
        for line, boundary in zip(lines, cells.boundaries):
            np.testing.assert_array_equal(line[:len(boundary)], boundary.points)

    def test_isolines_of_distances(self):
        path, V, F = program.mesh("elephant.off")
        program.run("distance", path, "--method", "exact", "--source", 0, "--isolines",
                    self.folder / "i.obj", "--levels", 7)
        t = it.Surface(V, F).delaunay()
        lines = [line for line in t.isolines(t.distance(0), 7) if len(line) > 1]
        expected = program.polylines(self.folder / "i.obj")
        self.assertEqual(len(lines), len(expected))
        for line, points in zip(lines, expected):
            np.testing.assert_array_equal(points[:len(line)], line.points)


def load_tests(loader, tests, pattern):
    """Adds the examples in docstrings, whose surface is a square, and those in the manual."""
    tests.addTests(doctest.DocTestSuite(_distances, extraglobs={"s": it.Surface(*SQUARE)}))
    page = "../../doc/Intrinsic_triangulations/python_distances.md"
    tests.addTests(doctest.DocFileSuite(page))
    return tests


if __name__ == "__main__":
    unittest.main()
