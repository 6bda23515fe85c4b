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
EXACT = Decimal(10) ** -60  # relative; what short strips of faces leave of 100 digits, by far
ROUNDED = Decimal(10) ** -9  # relative; thousands of moves in doubles, on faces with ordinary angles


def decimal(word):
    if word == "inf":
        return Decimal("Infinity")
    x = Fraction(float.fromhex(word))
    return Decimal(x.numerator) / Decimal(x.denominator)


class Surface:
    """Connectivity, from the lines of faces."""

    def __init__(self, faces, border):
        self.sides = [[int(w) for w in words[:3]] for words in faces]
        self.corners = [[int(w) for w in words[3:6]] for words in faces]
        self.border = [[int(w) for w in words] for words in border]
        self.next, self.face, self.start = {}, {}, {}
        for f, (sides, corners) in enumerate(zip(self.sides, self.corners)):
            for k in range(3):
                self.next[sides[k]] = sides[(k + 1) % 3]
                self.face[sides[k]] = f
                self.start[sides[k]] = corners[k]
        for h, _ in self.border:
            self.start[h] = self.start[self.next[h ^ 1]]


class Stored:
    """The sections of a file of version 5 with an input of points, or none."""

    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            lines = [line.split(" ") for line in file.read().split("\n")]
        self.at = iter(lines)
        assert next(self.at)[:2] == ["IDT", "5"]
        self.exact = lines[0][2] == "exact"
        self.scale = int(next(self.at)[1])
        for key in ("degenerate_faces", "mollification", "renumbered", "triangulated_polygons",
                    "reversed_faces"):
            assert next(self.at)[0] == key
        kind = next(self.at)
        self.has_input = kind != ["input", "none"]
        assert self.has_input or not self.exact
        if self.has_input:
            assert kind == ["input", "points"], kind
            self.delta = decimal(next(self.at)[1])
        vertices = self.section("input_vertices")
        self.input_vertices = len(vertices)
        self.section("input_edges")
        faces = self.section("input_faces")
        if self.has_input:
            self.points = [[decimal(w) for w in words[2:]] for words in vertices]
            self.input = Surface([words[1:] for words in faces], self.section("input_border"))
        self.section("polygons")
        assert next(self.at) == ["sheets", "1"]
        self.section("rows")
        self.vertices = self.section("vertices")
        edges = self.section("edges")
        values = 3 if self.exact else 1
        self.edges = [[decimal(w) for w in words[:values]] for words in edges]
        faces = self.section("faces")
        self.areas = [[decimal(w) for w in words[6:]] for words in faces]
        self.surface = Surface(faces, self.section("border"))
        if self.has_input:
            self.normal = [int(words[values]) for words in edges]
            self.roundabout = [None if w == "-" else int(w) for words in edges
                               for w in words[values + 1:]]
            self.places = self.section("places")
        assert next(self.at) == ["end"]

    def section(self, keyword):
        found, count = next(self.at)
        assert found == keyword, found
        return [next(self.at) for _ in range(int(count))]


class Unfolding:
    """Squared lengths and quadruple areas of the triangulation, from its curves and the input."""

    def __init__(self, stored):
        self.stored, self.input, self.surface = stored, stored.input, stored.surface
        self.place = {}
        for i, words in enumerate(stored.places):
            weights = [decimal(w) for w in words[2:]]
            assert sum(weights) == 1 and len(weights) == {"face": 3, "edge": 2}[words[0]]
            self.place[stored.input_vertices + i] = (int(words[1]), weights + [Decimal(0)] * (3 - len(weights)))
        self.entered = [[None] * max(n, 0) for n in stored.normal]  # by halfedge 2e
        for sides in self.surface.sides:
            for k in range(3):
                for i in range(self.curves(sides[k])[1][0]):
                    self.follow(sides[k], i)
        assert all(None not in entered for entered in self.entered)
        self.lengths = [self.length(e) for e in range(len(stored.edges))]

    def crossings(self, h):
        return max(self.stored.normal[h // 2], 0)

    def curves(self, h):
        """How many curves cut off the corners of the face of h, from its source on, and start from them."""
        sides = [h, self.surface.next[h], self.surface.next[self.surface.next[h]]]
        n = [self.crossings(s) for s in sides]
        start = [max(0, n[(k + 1) % 3] - n[k] - n[(k + 2) % 3]) for k in range(3)]
        cut = [max(0, n[k] + n[(k + 2) % 3] - n[(k + 1) % 3] - start[(k + 1) % 3] -
                   start[(k + 2) % 3]) // 2 for k in range(3)]
        return cut, start

    def curve(self, h, count):
        """The input halfedge along the curve that is count places after the roundabout of h."""
        x = self.stored.roundabout[h]
        v = self.surface.start[h]
        for _ in range(count):
            x = x ^ 1 if v in self.place else self.around(x)
        return x

    def around(self, x):
        return self.input.next[self.input.next[x]] ^ 1

    def follow(self, h, index):
        """Follows the curve from the source of h into its face, after `index` others."""
        x = self.curve(h, index + (1 if self.stored.normal[h // 2] < 0 else 0))
        side, position = self.surface.next[h], self.curves(h)[0][1] + index
        while True:
            # from left to right over `side`, which enters the face of x
            if side % 2 == 0:
                self.entered[side // 2][position] = x
            else:
                self.entered[side // 2][self.crossings(side) - 1 - position] = x ^ 1
            side ^= 1
            cut, start = self.curves(side)
            from_source = self.crossings(side) - 1 - position
            following = self.surface.next[side]
            last = self.surface.next[following]
            if from_source < cut[0]:
                side, position = last, self.crossings(last) - 1 - from_source
            elif from_source < cut[0] + start[2]:
                end = self.curve(last, from_source - cut[0] + (1 if self.stored.normal[last // 2] < 0 else 0))
                assert end == x ^ 1
                return
            else:
                side = following

    def squared(self, x):
        """Of an input edge."""
        p, q = (self.stored.points[self.input.start[h]] for h in (x, x ^ 1))
        return sum((a - b) ** 2 for a, b in zip(p, q)) + self.stored.delta

    def apex(self, x, z, w):
        """The third corner of the face of x, whose source and target are at z and w."""
        y = self.input.next[x]
        ij, jk, ki = self.squared(x), self.squared(y), self.squared(self.input.next[y])
        p = ij + ki - jk
        a = (4 * ij * ki - p * p).sqrt()
        e = (w[0] - z[0], w[1] - z[1])
        return (z[0] + (e[0] * p - e[1] * a) / (2 * ij), z[1] + (e[0] * a + e[1] * p) / (2 * ij))

    def start(self, h):
        """Where the source of h is: an input halfedge beside which h starts, and weights."""
        v, x = self.surface.start[h], self.stored.roundabout[h]
        if x is None:
            return self.place[v]
        if v not in self.place:
            weights = [Decimal(1), Decimal(0), Decimal(0)]
        else:
            of, weights = self.place[v]
            assert of // 2 == x // 2
            weights = list(weights) if of == x else [weights[1], weights[0], weights[2]]
        if self.stored.normal[h // 2] < 0:
            return x, weights
        return x ^ 1, [weights[1], weights[0], weights[2]]

    def position(self, place, x, corners):
        """Of a place in the face of x, whose source, target and apex are given."""
        h, weights = place
        assert self.input.face[h] == self.input.face[x]
        while h != x:
            h, weights = self.input.next[h], [weights[1], weights[2], weights[0]]
        return [sum(w * c[k] for w, c in zip(weights, corners)) for k in range(2)]

    def length(self, e):
        if self.stored.normal[e] < 0:
            (x, a), (y, b) = self.start(2 * e), self.start(2 * e + 1)
            assert x == y ^ 1
            return (a[0] - b[1]) ** 2 * self.squared(x)
        first, last = self.start(2 * e), self.start(2 * e + 1)
        base = self.entered[e][0] ^ 1 if self.entered[e] else first[0]
        z, w = (Decimal(0), Decimal(0)), (self.squared(base).sqrt(), Decimal(0))
        corners = [z, w, self.apex(base, z, w)]
        begin = self.position(first, base, corners)
        for x in self.entered[e]:
            sides = [base, self.input.next[base], self.input.next[self.input.next[base]]]
            k = sides.index(x ^ 1)
            z, w = corners[(k + 1) % 3], corners[k]
            base, corners = x, [z, w, self.apex(x, z, w)]
        end = self.position(last, base, corners)
        return sum((a - b) ** 2 for a, b in zip(begin, end))

    def area(self, f):
        """Quadruple, from lengths."""
        ij, jk, ki = (self.lengths[h // 2] for h in self.surface.sides[f])
        return (4 * ij * ki - (ij + ki - jk) ** 2).sqrt()


class Stored_refinement(Cli_test):
    def meshes(self):
        points, faces = icosphere(1)
        yield [(x, 3 * y, 0.2 * z) for x, y, z in points], faces
        points, faces = grid(5)  # a border; thin faces near it, where vertices are removed again
        yield [(x, 0.12 * y, 0.02 * ((x * x * 3 + y * 5) % 4)) for x, y, _ in points], faces

    def values_of(self, stored):
        """Squared lengths of edges and quadruple areas of faces; of exact files those of the places."""
        if not stored.exact:
            return [e[0] for e in stored.edges], [a[0] for a in stored.areas]
        unfolding = Unfolding(stored)
        lengths = unfolding.lengths
        areas = [unfolding.area(f) for f in range(len(stored.areas))]
        for (low, high, near), x in zip(stored.edges + stored.areas, lengths + areas):
            self.assertLessEqual(low * (1 - EXACT), x)
            self.assertLessEqual(x, high * (1 + EXACT))
            self.assertTrue(low <= near <= high)
            self.assertLessEqual(abs(x - near), ROUNDED * x)
        return lengths, areas

    def check_connectivity(self, stored, stats):
        self.assertEqual(stored.input_vertices, stats["input"]["vertices"])
        self.assertEqual(len(stored.vertices) - stored.input_vertices,
                         stats["refine"]["insertions"])
        sides_of_faces, border = stored.surface.sides, stored.surface.border
        halfedges = [h for sides in sides_of_faces for h in sides] + [h for h, _ in border]
        self.assertEqual(sorted(halfedges), list(range(2 * len(stored.edges))))
        start = {h: v for sides, corners in zip(sides_of_faces, stored.surface.corners)
                 for h, v in zip(sides, corners)}
        for sides, corners in zip(sides_of_faces, stored.surface.corners):
            for k in range(3):
                if sides[k] ^ 1 in start:
                    self.assertEqual(start[sides[k] ^ 1], corners[(k + 1) % 3])
        # the Euler characteristic is that of the input
        self.assertEqual(len(stored.vertices) - len(stored.edges) + len(sides_of_faces),
                         stats["input"]["vertices"] - stats["input"]["edges"] +
                         stats["input"]["faces"])

    def check_faces(self, stored, tolerance):
        """Every angle is at least the bound, every inner edge is Delaunay; returns the area."""
        lengths, areas = self.values_of(stored)
        cotangent = 1 / Decimal(math.tan(math.radians(ANGLE)))
        sums, total = {}, Decimal(0)
        for sides, area in zip(stored.surface.sides, areas):
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
        border = {h // 2 for h, _ in stored.surface.border}
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
                for key in ("certificate", "arithmetic"):
                    self.assertEqual(info[key], done[key])
                self.assert_close(info["laplacian"]["trace"], done["laplacian"]["trace"], 1e-12)
                self.assert_same_quality(info, done)
                self.assertEqual(info["area"]["intrinsic"], done["area"]["intrinsic"])
                if arithmetic == "exact":
                    self.assert_certified(info)
                    self.assertEqual(info["area"], done["area"])
                self.stats("laplacian", "r.idt", "-o", "l.mtx")
                entries, before = self.read_matrix("l.mtx")[2], self.read_matrix("r.mtx")[2]
                self.assertEqual(entries.keys(), before.keys())
                for key, value in entries.items():
                    self.assert_close(value, before[key], 1e-12, key)
                again = self.stats("delaunay", "r.idt", "-o", "d.idt")
                self.assertEqual(again["delaunay"]["flips"], 0)
                self.assert_same_triangulation("r.idt", "d.idt")
                more = self.stats("refine", "r.idt", "--min-angle", "29", "-o", "s.idt")
                self.assertGreaterEqual(more["quality"]["min_angle_deg"], 29 - 1e-9)
                self.assert_same_quality(self.stats("info", "s.idt"), more)

    def assert_same_quality(self, a, b):
        """Predicates make stored intervals smaller, which may move the double within by its last bits."""
        self.assertEqual(a["quality"].keys(), b["quality"].keys())
        for key, value in a["quality"].items():
            if isinstance(value, float):
                self.assert_close(value, b["quality"][key], 1e-12, key)
            else:
                self.assertEqual(value, b["quality"][key], key)

    def test_a_file_with_correspondence_is_drawn_as_from_the_mesh(self):
        points, faces = icosphere(1)
        mesh = self.write_off("m.off", points, faces)
        for arithmetic in ("exact", "double"):
            options = ("--max-edge-length", "0.4", "--min-angle", "0", "--arithmetic", arithmetic)
            self.stats("refine", mesh, "-o", "r.idt", *options)
            asked = self.stats("refine", mesh, "-o", "m.ply", *options)
            stored = self.stats("delaunay", "r.idt", "-o", "s.ply", "--view", "s.html")
            self.assertEqual(stored["subdivision"], asked["subdivision"])
            self.assert_close(stored["area"]["input"], asked["area"]["input"], 1e-14)
            self.assert_same_file("m.ply", "s.ply")
        self.stats("delaunay", mesh, "-o", "n.idt", "--arithmetic", "double", "--correspondence",
                   "none")
        self.assert_fails(self.run_program("refine", "n.idt", "-o", "s.ply"), "n.idt", "mesh")


if __name__ == "__main__":
    main()
