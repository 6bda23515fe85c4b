# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances in batches, and lines of equal distance."""

import ast
import json
import math
import random
import re
import struct

from cli_support import Cli_test, grid, icosphere, main


class Distances(Cli_test):
    def setUp(self):
        super().setUp()
        self.points, self.faces = icosphere(2)
        self.mesh = self.write_off("sphere.off", self.points, self.faces)
        self.random = random.Random(35)

    def numbers(self, name):
        with open(self.path(name), encoding="ascii") as file:
            return [float(line) for line in file]

    def read_npy(self, name):
        """The rows of a matrix in NumPy's format, without NumPy."""
        with open(self.path(name), "rb") as file:
            data = file.read()
        self.assertEqual(data[:8], b"\x93NUMPY\x01\x00")
        size, = struct.unpack("<H", data[8:10])
        self.assertEqual((10 + size) % 64, 0)
        header = ast.literal_eval(data[10:10 + size].decode())
        self.assertEqual((header["descr"], header["fortran_order"]), ("<f8", False))
        rows, columns = header["shape"]
        values = struct.unpack(f"<{rows * columns}d", data[10 + size:])
        return [values[columns * i:columns * (i + 1)] for i in range(rows)]

    def column(self, vertices, *options):
        """The distances of all vertices of the file, of one run."""
        self.stats("distance", self.mesh, "--source", ",".join(map(str, vertices)), "-o",
                   self.path("one.txt"), "--on", "input", *options)
        return self.numbers("one.txt")


class Pairs(Distances):
    def test_pairs_have_the_distances_of_single_runs(self):
        n = len(self.points)
        pairs = [(self.random.randrange(12), self.random.randrange(n)) for _ in range(30)] + [(5, 5)]
        self.write("pairs.txt", "# two each\n" + "".join(f"{a} {b}\n" for a, b in pairs))
        for method in ("exact", "heat"):
            options = ("--method", method)
            stats = self.stats("distance", self.mesh, "--pairs", self.path("pairs.txt"), "-o",
                               self.path("d.txt"), *options)["distance"]
            d = self.numbers("d.txt")
            self.assertEqual((stats["method"], stats["pairs"], stats["unreached"]),
                             (method, len(pairs), 0))
            self.assertEqual(stats["distances"], d)
            self.assertEqual((stats["min"], stats["max"]), (min(d), max(d)))
            self.assertEqual("time" in stats, method == "heat")
            columns = {a: self.column([a], *options) for a in {a for a, _ in pairs}}
            for (a, b), x in zip(pairs, d):
                self.assertAlmostEqual(x, columns[a][b], delta=1e-12)
                if method == "exact":
                    self.assertGreaterEqual(x, math.dist(self.points[a], self.points[b]) - 1e-12)

    def test_progress_of_a_batch_is_a_log(self):
        points, faces = icosphere(4)
        mesh = self.write_off("fine.off", points, faces)
        n = 1500  # two seconds on two processors
        self.write("pairs.txt", "".join(f"{a} 0\n" for a in range(1, n + 1)))
        run = self.run_program("distance", mesh, "--method", "exact", "--pairs",
                               self.path("pairs.txt"), "--progress")
        self.assertEqual(run.code, 0, run.err)
        steps = re.findall(rf"^\d+\.\d s: solving: (\d+) of {n}$", run.err, re.MULTILINE)
        self.assertTrue(steps, run.err)
        self.assertEqual(steps, sorted(steps, key=int))

    def test_pairs_of_different_components_are_infinitely_far(self):
        points, faces = grid(2)
        n = len(points)
        mesh = self.write_off("two.off", points + [(x + 9, y, z) for x, y, z in points],
                              faces + [tuple(v + n for v in f) for f in faces])
        self.write("pairs.txt", f"0 {n}\n0 1\n")
        for method in ("exact", "heat"):
            stats = self.stats("distance", mesh, "--pairs", self.path("pairs.txt"), "--method",
                               method, "-o", self.path("d.txt"))["distance"]
            self.assertEqual((stats["unreached"], stats["distances"][0]), (1, None))
            self.assertEqual(self.numbers("d.txt")[0], math.inf)

    def test_lists_of_records_are_short_unless_a_file_is_asked_for(self):
        pairs = [(i % 7, i % len(self.points)) for i in range(1234)]
        self.write("pairs.txt", "".join(f"{a} {b}\n" for a, b in pairs))
        arguments = ("distance", self.mesh, "--method", "exact", "--pairs", self.path("pairs.txt"),
                     "-o", self.path("d.txt"))
        stats = self.stats(*arguments, "--records", self.path("all.jsonl"))
        self.assertEqual(stats["records"], {"distance.distances": 1234})
        d = self.numbers("d.txt")
        self.assertEqual(stats["distance"]["distances"], d[:1000])
        with open(self.path("all.jsonl"), encoding="utf-8") as file:
            lines = [json.loads(line) for line in file]
        self.assertEqual(lines, [{"list": "distance.distances", "number": i, "value": x}
                                 for i, x in enumerate(d)])

    def test_bad_files(self):
        n = len(self.points)
        for text, words in (("", ["has no vertices", "two on each line"]),
                            ("0 1\n\n2\n", [":3:", "two vertices"]),
                            ("0 1 2\n", [":1:", "two vertices"]),
                            (f"0 1\n0 {n}\n", [":2:", f"vertex {n} does not exist", f"to {n - 1}"]),
                            ("0 x\n", [":1:", '"x" is not the number'])):
            self.write("bad.txt", text)
            run = self.run_program("distance", self.mesh, "--pairs", self.path("bad.txt"))
            self.assert_fails(run, "bad.txt", *words)
        points, faces = grid(1)
        mesh = self.write_off("lonely.off", points + [(5, 5, 5)], faces)
        self.write("bad.txt", "0 1\n4 0\n")
        self.assert_fails(self.run_program("distance", mesh, "--pairs", self.path("bad.txt")),
                          "bad.txt:2:", "vertex 4 is isolated")
        self.assert_fails(self.run_program("distance", self.mesh, "--pairs", "nowhere.txt"),
                          "nowhere.txt", "does not exist")


class Sources(Distances):
    def test_rows_are_those_of_single_runs(self):
        n = len(self.points)
        sets = [[3], [0, 7, 100], [self.random.randrange(n) for _ in range(25)]]
        self.write("sets.txt", "".join(" ".join(map(str, s)) + "\n" for s in sets))
        for method in ("exact", "heat"):
            for options in ((), ("--refine", "--max-edge-length", "0.25")):
                run = ("distance", self.mesh, "--method", method, "--sources",
                       self.path("sets.txt"), *options)
                stats = self.stats(*run, "-o", self.path("d.npy"))
                self.stats(*run, "-o", self.path("d.txt"))
                rows = self.read_npy("d.npy")
                self.assertEqual(rows, list(map(tuple, self.read_rows("d.txt"))))
                self.assertEqual((len(rows), len(rows[0])), (3, n))
                stats = stats["distance"]
                self.assertEqual((stats["sets"], stats["status"], stats["unreached"], stats["min"],
                                  stats["max"]), (3, "done", 0, 0, max(map(max, rows))))
                for s, row in zip(sets, rows):
                    for x, y in zip(row, self.column(s, "--method", method, *options)):
                        self.assertAlmostEqual(x, y, delta=1e-12)

    def test_searches_end_at_a_distance(self):
        self.write("sets.txt", "0\n5\n")
        stats = self.stats("distance", self.mesh, "--method", "exact", "--max-distance", "0.5",
                           "--sources", self.path("sets.txt"), "-o", self.path("d.txt"))["distance"]
        known = [x for row in self.read_rows("d.txt") for x in row if x < math.inf]
        self.assertEqual(len(known) + stats["unreached"], 2 * len(self.points))
        self.assertGreater(stats["unreached"], 0)
        for x, exact in zip(self.read_rows("d.txt")[0], self.column([0], "--method", "exact")):
            if exact <= 0.5:
                self.assertAlmostEqual(x, exact, delta=1e-12)

    def test_bad_usage(self):
        self.write("sets.txt", "0\n")
        sets = self.path("sets.txt")
        for options, word in ((("--sources", sets), "-o"),
                              (("--sources", sets, "-o", "d.vtp"), ".npy or .txt"),
                              (("--sources", sets, "--pairs", sets, "-o", "d.npy"), "one of them"),
                              (("--sources", sets, "--source", "0", "-o", "d.npy"), "--source"),
                              (("--sources", sets, "--view", "v.html", "-o", "d.npy"), "--source"),
                              (("--pairs", sets, "-o", "d.npy"), ".txt"),
                              (("--pairs", sets, "--max-distance", "1"), "--max-distance"),
                              (("--source", "0", "-o", "d.npy"), "--sources"),
                              (("--sources", sets, "-o", sets + ".npy", "--max-distance", "1",
                                "--method", "heat"), "--method heat"),
                              (("--source", "0", "--levels", "3"), "--isolines")):
            run = self.run_program("distance", self.mesh, *options)
            self.assertEqual(run.code, 2, run.err)
            self.assertIn(word, run.err)
        self.write("sets.txt", "0 1\n2 700\n")
        self.assert_fails(self.run_program("distance", self.mesh, "--sources", sets, "-o", "d.npy"),
                          "sets.txt:2:", "vertex 700 does not exist")


class Isolines(Distances):
    def polylines(self, name):
        """Level, points and whether it is closed, of each line of an OBJ file."""
        points, lines, level = [], [], None
        with open(self.path(name), encoding="ascii") as file:
            for kind, *words in map(str.split, file):
                if kind == "v":
                    points.append([float(x) for x in words])
                elif kind == "#" and words[0] == "level":
                    level = int(words[1])
                elif kind == "l":
                    numbers = [int(i) - 1 for i in words]
                    lines.append((level, [points[i] for i in numbers], numbers[0] == numbers[-1]))
        return lines

    def test_levels_between_nearest_and_farthest(self):
        stats = self.stats("distance", self.mesh, "--method", "exact", "--source", "0", "--isolines",
                           self.path("l.obj"), "--levels", "4")["distance"]
        for k, level in enumerate(stats["levels"]):
            self.assertAlmostEqual(level, stats["max"] * (k + 1) / 5, delta=1e-14)
        lines = self.polylines("l.obj")
        self.assertEqual(len(lines), stats["isolines"])
        self.assertEqual({level for level, _, _ in lines}, {0, 1, 2, 3})
        centre = self.points[0]
        for level, points, is_closed in lines:
            self.assertTrue(is_closed)  # around the vertex
            for p in points:  # near a circle of the sphere
                length = math.hypot(*p)
                angle = math.acos(sum(a * b for a, b in zip(p, centre)) / length)
                self.assertAlmostEqual(angle, stats["levels"][level], delta=0.05)

    def test_a_list_of_levels_on_a_plane(self):
        mesh = self.write_off("grid.off", *grid(8))
        stats = self.stats("distance", mesh, "--method", "exact", "--source", "0", "--isolines",
                           self.path("l.vtp"), "--levels", "5.0")["distance"]
        self.assertEqual((stats["levels"], stats["isolines"]), ([5], 1))
        stats = self.stats("distance", mesh, "--method", "exact", "--source", "0", "--isolines",
                           self.path("l.obj"), "--levels", "2.5,20,1e-3,5")["distance"]
        self.assertEqual(stats["levels"], [2.5, 20, 1e-3, 5])
        lines = self.polylines("l.obj")
        self.assertEqual([level for level, _, _ in lines], [0, 2, 3])
        for level, points, is_closed in lines:
            self.assertFalse(is_closed)  # from border to border
            for end in (points[0], points[-1]):
                self.assertEqual(min(end[0], end[1]), 0)
            for p in points:  # distances are exact at vertices and linear between them
                self.assertLess(math.hypot(*p), stats["levels"][level] + 1e-12)
                self.assertGreater(math.hypot(*p), stats["levels"][level] - 0.5)

    def test_signed_distances(self):
        mesh = self.write_off("grid.off", *grid(8))
        stats = self.stats("distance", mesh, "--curve", "36,44", "--signed", "--isolines",
                           self.path("l.obj"), "--levels", "3")["distance"]
        self.assertLess(stats["levels"][0], 0)
        self.assertGreater(stats["levels"][2], 0)

    def test_bad_levels(self):
        for text in ("0", "1,x", "1,,2", "nan", "1e999", "20000", "1,2,"):
            run = self.run_program("distance", self.mesh, "--source", "0", "--isolines", "l.obj",
                                   "--levels=" + text)
            self.assertEqual(run.code, 2, text + run.err)
            self.assertIn("--levels", run.err)


if __name__ == "__main__":
    main()
