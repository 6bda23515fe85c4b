# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the program `intrinsic` share: running it, and reading what it writes."""

import argparse
import atexit
import importlib.util
import json
import math
import os
import random
import struct
import subprocess
import sys
import tempfile
import time
import unittest

TIME_LIMIT = 60  # seconds, for machines that are slow or busy

HERE = os.path.dirname(os.path.abspath(__file__))
REPORT = os.path.join(HERE, "..", "..", "workflow", "study", "report.py")
# Debian's packages pandas and matplotlib are not for a Python that is found before its own.
REPORT_PYTHON = (sys.executable
                 if all(importlib.util.find_spec(m) for m in ("pandas", "matplotlib"))
                 else "/usr/bin/python3")


CUBE = ([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)],
        [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])


class Run:
    """One run of the program and all that it said."""

    def __init__(self, program, arguments, directory):
        start = time.monotonic()
        done = subprocess.run([program] + [str(a) for a in arguments], cwd=directory,
                              capture_output=True, text=True, timeout=TIME_LIMIT)
        self.seconds = time.monotonic() - start
        self.code = done.returncode
        self.out = done.stdout
        self.err = done.stderr

    def json(self):
        return json.loads(self.out)


class Report_run:
    """One run of the script that makes a page of the results of a study, by a process that has
    loaded it, and all that it said."""

    worker = None

    def __init__(self, arguments, directory):
        if not Report_run.worker:
            Report_run.worker = subprocess.Popen(
                [REPORT_PYTHON, os.path.join(HERE, "report_worker.py"), os.path.dirname(REPORT)],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
            atexit.register(Report_run.worker.communicate)
        with tempfile.TemporaryDirectory() as said:
            out, err = os.path.join(said, "out"), os.path.join(said, "err")
            request = dict(arguments=arguments, directory=directory, out=out, err=err)
            print(json.dumps(request), file=self.worker.stdin, flush=True)
            self.code = int(self.worker.stdout.readline())
            with open(out, encoding="utf-8") as out, open(err, encoding="utf-8") as err:
                self.out, self.err = out.read(), err.read()


class Cli_test(unittest.TestCase):
    """Runs the program in a directory of its own."""

    program = None

    def setUp(self):
        self._directory = tempfile.TemporaryDirectory()
        self.directory = self._directory.name
        self.addCleanup(self._directory.cleanup)

    def triangulation(self, name):
        """What a file says of a triangulation: all of it; in doubles all but how it lies on the input, which commands do not
        keep."""
        with open(self.path(name), encoding="ascii") as file:
            text = file.read()
        if text.startswith("IDT 5 exact\n"):
            return text
        edges = text.index("\nedges ")
        faces = text.index("\nfaces ")
        lengths = [line.split(" ")[0] for line in text[edges:faces].split("\n")[2:]]
        end = text.find("\nplaces ")
        return (text[text.index("\nvertices "):edges], lengths,
                text[faces:end if end > 0 else text.index("\nend\n")])

    def assert_same_triangulation(self, a, b):
        self.assertEqual(self.triangulation(a), self.triangulation(b))

    def run_program(self, *arguments):
        return Run(self.program, arguments, self.directory)

    def stats(self, command, mesh, *arguments):
        run = self.run_program(command, mesh, "--stats", "-", *arguments)
        self.assertEqual(run.code, 0, run.err)
        return run.json()

    def path(self, name):
        return os.path.join(self.directory, name)

    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)
        return self.path(name)

    def write_off(self, name, points, faces):
        lines = ["OFF", f"{len(points)} {len(faces)} 0"]
        lines += [" ".join(repr(float(x)) for x in p) for p in points]
        lines += [" ".join(str(i) for i in [len(f), *f]) for f in faces]
        return self.write(name, "\n".join(lines) + "\n")

    def make_report(self, *arguments):
        return Report_run(arguments, self.directory)

    def read_matrix(self, name):
        """Rows, columns and entries of a file in Matrix Market format; those of symmetric matrices on both sides."""
        with open(self.path(name), encoding="ascii") as file:
            symmetric = file.readline().split()[-1] == "symmetric"
            lines = [line.split() for line in file if not line.startswith("%")]
        entries = {}
        for i, j, x in lines[1:]:
            entries[int(i) - 1, int(j) - 1] = float(x)
            if symmetric:
                entries[int(j) - 1, int(i) - 1] = float(x)
        return int(lines[0][0]), int(lines[0][1]), entries

    def read_rows(self, name):
        """The rows of numbers of a text."""
        with open(self.path(name), encoding="ascii") as file:
            return [[float(x) for x in line.split()] for line in file]

    def read_ply(self, name):
        """The rows of the elements of a PLY that is binary: properties by name, numbers or lists."""
        with open(self.path(name), "rb") as file:
            head, data = file.read().split(b"end_header\n", 1)
        elements, rows, start = [], {}, 0
        for word in map(str.split, head.decode("ascii").splitlines()):
            if word[0] == "element":
                elements.append((word[1], int(word[2]), []))
            elif word[0] == "property":
                elements[-1][2].append(word[1:])

        def take(type_name, count=1):
            nonlocal start
            form = f"<{count}" + {"double": "d", "int": "i", "uchar": "B"}[type_name]
            values = struct.unpack_from(form, data, start)
            start += struct.calcsize(form)
            return values

        for element, count, properties in elements:
            rows[element] = [{p[-1]: list(take(p[2], take(p[1])[0])) if p[0] == "list"
                              else take(p[0])[0] for p in properties} for _ in range(count)]
        return rows

    def assert_same_file(self, a, b):
        with open(self.path(a), "rb") as one, open(self.path(b), "rb") as other:
            self.assertEqual(one.read(), other.read())

    def assert_close(self, a, b, relative, message=None):
        self.assertLessEqual(abs(a - b), relative * max(abs(a), abs(b)), message or f"{a} {b}")

    def assert_certified(self, stats):
        self.assertEqual(stats["certificate"], "exact")
        self.assertEqual(stats["delaunay"]["non_delaunay_edges"], 0)
        self.assertEqual(stats["delaunay"]["probable_zero"], 0)

    def assert_fails(self, run, *words):
        """The run failed on valid usage and its message has all the words."""
        self.assertEqual(run.code, 1, run.out + run.err)
        self.assertEqual(run.out, "")
        for word in words:
            self.assertIn(word, run.err)


def icosphere(levels):
    """An icosahedron, subdivided; points on the unit sphere."""
    g = (1 + math.sqrt(5)) / 2
    points = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
              (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(levels):
        middle, finer = {}, []

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(points)
                points.append(tuple((x + y) / 2 for x, y in zip(points[a], points[b])))
            return middle[key]

        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = finer
    return [tuple(x / math.hypot(*p) for x in p) for p in points], faces


def grid(n):
    """A planar grid with integer coordinates: every square is an exact tie."""
    points = [(i, j, 0) for i in range(n + 1) for j in range(n + 1)]
    faces = []
    for i in range(n):
        for j in range(n):
            a, b = i * (n + 1) + j, (i + 1) * (n + 1) + j
            faces += [(a, b, b + 1), (a, b + 1, a + 1)]
    return points, faces


def jittered_grid(n):
    """A planar grid whose points are moved a little, and that is not Delaunay as it is flat."""
    points, faces = grid(n)
    return [(x + 0.3 * math.sin(7 * x + 13 * y), 0.15 * (y + 0.3 * math.sin(11 * x - 5 * y)), 0)
            for x, y, _ in points], faces


def parabola_fan(n):
    """All faces at one of the points of a parabola: doubles lose much of it."""
    return [(i, i * i / n, 0) for i in range(n)], [(0, i, i + 1) for i in range(1, n - 1)]


def beside(points, faces, x):
    """Two copies of a mesh, the second one moved along the first axis."""
    n = len(points)
    return (list(points) + [(p[0] + x, *p[1:]) for p in points],
            list(faces) + [tuple(v + n for v in f) for f in faces])


def shuffled(points, faces, seed):
    """A mesh with vertices and faces in another order; the new number of each vertex; and faces in
    the new order with the old numbers of vertices."""
    generator = random.Random(seed)
    place = list(range(len(points)))
    generator.shuffle(place)
    faces = generator.sample(faces, len(faces))
    moved = sorted(range(len(points)), key=lambda v: place[v])
    return [points[v] for v in moved], [tuple(place[v] for v in f) for f in faces], place, faces


class Glued_triangles:
    """Triangles with lengths; halfedge 3f + k is side k of face f: its first vertex, its squared
    length, and the side it is glued to, or None at a border."""

    def __init__(self):
        self.origin, self.squared, self.glue = [], [], {}

    @staticmethod
    def next(h):
        return h - 2 if h % 3 == 2 else h + 1

    def exchange(self, h):
        """Flips the edge of a halfedge; what depends on its own length is not changed."""
        o = self.glue[h]
        h1, o1 = self.next(h), self.next(o)
        h2, o2 = self.next(h1), self.next(o1)
        apex, opposite = self.origin[h2], self.origin[o2]
        moved = {o2: h1, h1: h2, h2: o1, o1: o2}
        old = {s: (self.origin[s], self.squared[s], self.glue[s]) for s in moved}
        for s, place in moved.items():
            self.origin[place], self.squared[place], partner = old[s]
            partner = moved.get(partner, partner)
            self.glue[place] = partner
            if partner is not None:
                self.glue[partner] = place
        self.origin[h], self.origin[o] = apex, opposite

    def flip_to_delaunay(self):
        """Flips edges for which `is_bad()` holds until there is none."""
        waiting = list(range(len(self.origin)))
        while waiting:
            h = waiting.pop()
            o = self.glue[h]
            if o is not None and h // 3 != o // 3 and self.is_bad(h):
                self.flip(h)
                waiting += [x for y in (h, o) for x in range(3 * (y // 3), 3 * (y // 3) + 3)]
        return self


def product(matrix, vector):
    """A matrix that `read_matrix()` has read times a vector."""
    rows, _, entries = matrix
    result = [0.0] * rows
    for (i, j), x in entries.items():
        result[i] += x * vector[j]
    return result


def torus(n, m):
    """Cells of a torus in space, in squares; vertex (x, y) has number n y + x."""
    points, faces = [], []
    for i in range(n * m):
        a, b = 2 * math.pi * (i % n) / n, 2 * math.pi * (i // n) / m
        r = 3 + math.cos(b)
        points.append((r * math.cos(a), r * math.sin(a), math.sin(b)))
        x, y, right, up = i % n, i // n, (i % n + 1) % n, (i // n + 1) % m
        faces.append([n * y + x, n * y + right, n * up + right, n * up + x])
    return points, faces


def triangles(faces):
    """Two of each square."""
    return [t for a, b, c, d in faces for t in ([a, b, c], [a, c, d])]


def read_obj(path):
    """Points, places in the plane, and the pairs of both at the corners of faces."""
    points, places, faces = [], [], []
    with open(path, encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                points.append(tuple(map(float, words[1:])))
            elif words[:1] == ["vt"]:
                places.append(tuple(map(float, words[1:])))
            elif words[:1] == ["f"]:
                faces.append([tuple(int(i) - 1 for i in w.split("/")) for w in words[1:]])
    return points, places, faces


def main():
    """Runs the tests of the calling script; the options are those that ctest gives."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--intrinsic", required=True)
    options, rest = parser.parse_known_args()
    Cli_test.program = os.path.abspath(options.intrinsic)
    unittest.main(argv=[sys.argv[0]] + rest, verbosity=2)
