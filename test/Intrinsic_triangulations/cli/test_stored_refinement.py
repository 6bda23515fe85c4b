# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Refined triangulations in files: read by the specification of the format alone, and checked with 100 digits;
and what the program says of a file agrees with what it said when it wrote it."""

import math
from decimal import Decimal, getcontext
from fractions import Fraction

from cli_support import Cli_test, grid, icosphere, main

getcontext().prec = 100
ANGLE = 25
EXACT = Decimal(10) ** -60  # relative; what thousands of moves leave of 100 digits, by far
ROUNDED = Decimal(10) ** -9  # relative; thousands of moves in doubles, on faces with ordinary angles


def decimal(word):
    if word == "inf":
        return Decimal("Infinity")
    x = Fraction(float.fromhex(word))
    return Decimal(x.numerator) / Decimal(x.denominator)


class Stored:
    """The sections of a file of version 2."""

    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            lines = [line.split(" ") for line in file.read().split("\n")]
        self.at = iter(lines)
        assert next(self.at)[:2] == ["IDT", "2"]
        self.exact = lines[0][2] == "exact"
        self.scale = int(next(self.at)[1])
        for key in ("degenerate_faces", "mollification", "renumbered"):
            assert next(self.at)[0] == key
        self.vertices = self.section("vertices")
        self.edges = [[decimal(w) for w in words] for words in self.section("edges")]
        faces = self.section("faces")
        self.sides = [[int(w) for w in words[:3]] for words in faces]
        self.corners = [[int(w) for w in words[3:6]] for words in faces]
        self.areas = [[decimal(w) for w in words[6:]] for words in faces]
        self.border = [[int(w) for w in words] for words in self.section("border")]
        self.section("input_faces")
        if self.exact:
            self.points = [[decimal(w) for w in words] for words in self.section("points")]
            self.delta = decimal(next(self.at)[1])
            self.input_sides = [[int(w) for w in words] for words in self.section("sides")]
            self.moves = self.section("moves")
            self.versions = [[int(w) for w in words] for words in self.section("versions")]
        assert next(self.at) == ["end"]

    def section(self, keyword):
        found, count = next(self.at)
        assert found == keyword, found
        return [next(self.at) for _ in range(int(count))]


class Replay:
    """Versions of faces, three squared lengths and the quadruple area each, from the input and the moves."""

    def __init__(self, stored):
        self.version = []
        for a, b, c in stored.input_sides:
            p, q, r = (stored.points[i] for i in (a, b, c))
            sides = [sum((x - y) ** 2 for x, y in zip(u, v)) + stored.delta
                     for u, v in ((p, q), (q, r), (r, p))]
            t = sides[0] + sides[2] - sides[1]
            self.version.append((sides, (4 * sides[0] * sides[2] - t * t).sqrt()))
        for words in stored.moves:
            getattr(self, words[0])(words[1:])

    def face(self, words):
        """Squared lengths from a side on, and the area."""
        version, slot = int(words[0]), int(words[1])
        lengths, area = self.version[version]
        self.version[version] = None  # consumed
        return [*(lengths[slot:] + lengths[:slot]), area]

    def flip(self, words):
        ij, jk, ki, f = self.face(words)
        ji, im, mj, g = self.face(words[2:])
        self.same(ij, ji)
        p, q = ij + ki - jk, ij + im - mj
        km = ki + im - (p * q - f * g) / (2 * ij)
        self.version += [([km, mj, jk], ((2 * ij - q) * f + (2 * ij - p) * g) / (2 * ij)),
                         ([km, ki, im], (q * f + p * g) / (2 * ij))]

    def insert(self, words):
        ij, jk, ki, area = self.face(words)
        a, b, c = (decimal(w) for w in words[2:])
        self.same(a + b + c, 1)
        ip = b * b * ij + c * c * ki + b * c * (ij + ki - jk)
        jp = c * c * jk + a * a * ij + c * a * (jk + ij - ki)
        kp = a * a * ki + b * b * jk + a * b * (ki + jk - ij)
        self.version += [([ij, jp, ip], c * area), ([jk, kp, jp], a * area),
                         ([ki, ip, kp], b * area), None]

    def insert_border(self, words):
        ij, jk, ki, area = self.face(words)
        a, b = (decimal(w) for w in words[2:])
        self.same(a + b, 1)
        pk = a * a * ki + b * b * jk + a * b * (ki + jk - ij)
        self.version += [([b * b * ij, pk, ki], b * area), ([a * a * ij, jk, pk], a * area)]

    def remove(self, words):
        faces = [self.face(words[2 * k:]) for k in range(3)]
        for k in range(3):
            self.same(faces[k][1], faces[(k + 1) % 3][2])
        self.version += [([f[0] for f in faces], sum(f[3] for f in faces)), None]

    def remove_border(self, words):
        pk, ki, ip, f = self.face(words)
        kp, pj, jk, g = self.face(words[2:])
        self.same(pk, kp)
        p, q = pk + ip - ki, pk + pj - jk  # the angles at p sum to pi
        ij = ip + pj - (p * q - f * g) / (2 * pk)
        self.version += [([ij, jk, ki], f + g), None]

    @staticmethod
    def same(a, b):
        assert abs(a - b) <= EXACT * abs(a), (a, b)


class Stored_refinement(Cli_test):
    def meshes(self):
        points, faces = icosphere(1)
        yield [(x, 3 * y, 0.2 * z) for x, y, z in points], faces
        points, faces = grid(5)  # a border; thin faces near it, where vertices are removed again
        yield [(x, 0.12 * y, 0.02 * ((x * x * 3 + y * 5) % 4)) for x, y, _ in points], faces

    def values_of(self, stored):
        """Squared lengths of edges and quadruple areas of faces; of exact files those of the moves."""
        if not stored.exact:
            return [e[0] for e in stored.edges], [a[0] for a in stored.areas]
        replay = Replay(stored)
        lengths, areas = [None] * len(stored.edges), []
        for f, (version, first) in enumerate(stored.versions):
            edges = [h // 2 for h in stored.sides[f]]
            k = edges.index(first)
            of_sides, area = replay.version[version]
            replay.version[version] = None
            areas.append(area)
            for edge, length in zip(edges[k:] + edges[:k], of_sides):
                if lengths[edge] is not None:
                    Replay.same(length, lengths[edge])
                lengths[edge] = length
        self.assertEqual([v for v in replay.version if v], [])
        for (low, high, near), x in zip(stored.edges + stored.areas, lengths + areas):
            self.assertLessEqual(low * (1 - EXACT), x)
            self.assertLessEqual(x, high * (1 + EXACT))
            self.assertTrue(low <= near <= high)
            self.assertLessEqual(abs(x - near), ROUNDED * x)
        return lengths, areas

    def check_connectivity(self, stored, stats):
        inserted = [i for i, words in enumerate(stored.vertices) if words[0] == "-"]
        self.assertEqual(len(inserted), stats["refine"]["insertions"])
        self.assertEqual(inserted, list(range(stats["input"]["vertices"], len(stored.vertices))))
        halfedges = [h for sides in stored.sides for h in sides] + [h for h, _ in stored.border]
        self.assertEqual(sorted(halfedges), list(range(2 * len(stored.edges))))
        start = {h: v for sides, corners in zip(stored.sides, stored.corners)
                 for h, v in zip(sides, corners)}
        for sides, corners in zip(stored.sides, stored.corners):
            for k in range(3):
                if sides[k] ^ 1 in start:
                    self.assertEqual(start[sides[k] ^ 1], corners[(k + 1) % 3])
        # the Euler characteristic is that of the input
        self.assertEqual(len(stored.vertices) - len(stored.edges) + len(stored.sides),
                         stats["input"]["vertices"] - stats["input"]["edges"] +
                         stats["input"]["faces"])

    def check_faces(self, stored, tolerance):
        """Every angle is at least the bound, every inner edge is Delaunay; returns the area."""
        lengths, areas = self.values_of(stored)
        cotangent = 1 / Decimal(math.tan(math.radians(ANGLE)))
        sums, total = {}, Decimal(0)
        for sides, area in zip(stored.sides, areas):
            edges = [h // 2 for h in sides]
            l = [lengths[e] for e in edges]
            square = 4 * l[0] * l[2] - (l[0] + l[2] - l[1]) ** 2
            self.assertLessEqual(abs(square - area * area), 4 * tolerance * area * area)
            total += area
            for k in range(3):
                opposite = (l[(k + 1) % 3] + l[(k + 2) % 3] - l[k]) / area
                # the bound itself is a double
                self.assertLessEqual(opposite, cotangent * (1 + tolerance + Decimal(2) ** -48))
                sums.setdefault(edges[k], []).append(opposite)
        border = {h // 2 for h, _ in stored.border}
        for edge, cotangents in sums.items():
            self.assertEqual(len(cotangents), 1 if edge in border else 2)
            if edge not in border:
                self.assertGreaterEqual(sum(cotangents), -10 * tolerance)
        return total / 4 / Decimal(4) ** stored.scale

    def test_stored_faces_are_well_shaped_and_delaunay(self):
        removals = 0
        for points, faces in self.meshes():
            mesh = self.write_off("m.off", points, faces)
            exact_points = [[Decimal(x) for x in p] for p in points]
            input_area = sum(self.area(*(exact_points[i] for i in f)) for f in faces)
            for arithmetic, tolerance in (("exact", EXACT), ("double", ROUNDED)):
                stats = self.stats("refine", mesh, "--min-angle", str(ANGLE), "--arithmetic",
                                   arithmetic, "-o", "r.idt")
                self.assertEqual(stats["refine"]["unsatisfied_faces"], 0)
                self.assertGreater(stats["refine"]["insertions"], 10)
                removals += stats["refine"]["removals"]
                stored = Stored(self.path("r.idt"))
                self.check_connectivity(stored, stats)
                area = self.check_faces(stored, tolerance)
                self.assertLessEqual(abs(area - input_area), tolerance * input_area)
        self.assertGreater(removals, 0)

    @staticmethod
    def area(p, q, r):
        u, v = [b - a for a, b in zip(p, q)], [b - a for a, b in zip(p, r)]
        uv = sum(a * b for a, b in zip(u, v))
        return (sum(a * a for a in u) * sum(a * a for a in v) - uv * uv).sqrt() / 2

    def test_commands_go_on_with_a_file(self):
        for points, faces in self.meshes():
            mesh = self.write_off("m.off", points, faces)
            for arithmetic in ("exact", "double"):
                done = self.stats("refine", mesh, "--arithmetic", arithmetic, "--min-angle", "25", "-o",
                                  "r.idt", "--laplacian", "r.mtx")
                info = self.stats("info", "r.idt")
                for key in ("quality", "laplacian", "certificate", "arithmetic"):
                    self.assertEqual(info[key], done[key])
                self.assertEqual(info["area"]["intrinsic"], done["area"]["intrinsic"])
                if arithmetic == "exact":
                    self.assert_certified(info)
                    self.assertEqual(info["area"], done["area"])
                self.stats("laplacian", "r.idt", "-o", "l.mtx")
                self.assertEqual(self.entries("l.mtx"), self.entries("r.mtx"))
                again = self.stats("delaunay", "r.idt", "-o", "d.idt")
                self.assertEqual(again["delaunay"]["flips"], 0)
                with open(self.path("r.idt"), "rb") as a, open(self.path("d.idt"), "rb") as b:
                    self.assertEqual(a.read(), b.read())
                more = self.stats("refine", "r.idt", "--min-angle", "29", "-o", "s.idt")
                self.assertGreaterEqual(more["quality"]["min_angle_deg"], 29 - 1e-9)
                self.assertEqual(self.stats("info", "s.idt")["quality"], more["quality"])

    def entries(self, name):
        """The entries of a matrix, without empty rows, which numbers with gaps leave."""
        with open(self.path(name), encoding="ascii") as file:
            rows = [line.split() for line in file if line[0] != "%"][1:]
        used = sorted({int(i) for i, j, x in rows if float(x) != 0})
        rank = {i: n for n, i in enumerate(used)}
        return {(rank[int(i)], rank[int(j)]): float(x) for i, j, x in rows if int(i) in rank}

    def test_a_file_does_not_know_the_mesh(self):
        points, faces = icosphere(1)
        mesh = self.write_off("m.off", points, faces)
        self.stats("refine", mesh, "-o", "r.idt", "--max-edge-length", "0.4", "--min-angle", "0")
        self.assert_fails(self.run_program("refine", "r.idt", "-o", "s.ply"), "r.idt", "mesh")


if __name__ == "__main__":
    main()
