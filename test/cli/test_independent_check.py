# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laplacian and areas, computed a second time with other means: flips in the plane with 50 digits, and
sums over what the files say. The Delaunay Laplacian is unique, so the flips need not be the same."""

from decimal import Decimal, getcontext
from fractions import Fraction

from cli_support import Cli_test, Glued_triangles, grid, icosphere, main

getcontext().prec = 50
TIE = Decimal(10) ** -30  # far above the rounding of 50 digits, far below any cotangent that is no tie


class Reference(Glued_triangles):
    """Lengths are numbers of 50 digits."""

    def __init__(self, points, faces):
        super().__init__()
        self.origin = [v for f in faces for v in f]
        side = {(v, self.origin[self.next(h)]): h for h, v in enumerate(self.origin)}
        self.glue = {h: side.get((w, v)) for (v, w), h in side.items()}
        self.squared = [sum((Decimal(a) - Decimal(b)) ** 2 for a, b in zip(points[v], points[w]))
                        for v, w in side]

    def apex(self, h):
        """The third corner of the face of h in the plane, where h runs from (0, 0) along x."""
        n = self.next(h)
        base, to_end, to_start = self.squared[h], self.squared[n], self.squared[self.next(n)]
        length = base.sqrt()
        x = (base + to_start - to_end) / (2 * length)
        return x, max(to_start - x * x, Decimal(0)).sqrt()

    def cotangent(self, h):
        """The cotangent of the angle opposite h."""
        x, y = self.apex(h)
        length = self.squared[h].sqrt()
        return (x * (x - length) + y * y) / (y * length)

    def weight(self, h):
        w = self.cotangent(h)
        return (w if self.glue[h] is None else w + self.cotangent(self.glue[h])) / 2

    def is_bad(self, h):
        return self.weight(h) <= -TIE

    def flip(self, h):
        o = self.glue[h]
        (xk, yk), (xm, ym) = self.apex(h), self.apex(o)
        across = (xk - (self.squared[h].sqrt() - xm)) ** 2 + (yk + ym) ** 2
        self.exchange(h)
        self.squared[h] = self.squared[o] = across

    def laplacian(self):
        entries = {}
        for h, o in sorted(self.glue.items()):
            i, j = self.origin[h], self.origin[self.next(h)]
            if (o is not None and o < h) or i == j:
                continue
            w = self.weight(h)
            for a, b, x in ((i, i, w), (j, j, w), (i, j, -w), (j, i, -w)):
                entries[a, b] = entries.get((a, b), 0) + x
        return entries


def trace(matrix):
    return float(sum(x for (i, j), x in matrix.items() if i == j))


def energy(matrix, points, k):
    return float(sum(x * type(x)(points[i][k]) * type(x)(points[j][k])
                     for (i, j), x in matrix.items()))


def read_idt(path):
    """Edges, as pairs of vertices with a sum of cotangents, and the area, from an .idt file."""
    with open(path) as file:
        lines = file.read().split("\n")
    exact = lines[0] == "IDT 5 exact"
    number = (lambda words: (float.fromhex(words[0]) + float.fromhex(words[2])) / 2) if exact else \
        (lambda words: float.fromhex(words[0]))
    scale = int(lines[1].split()[1])
    at = {line.split()[0]: i for i, line in enumerate(lines) if line and line[0].isalpha()}

    def section(name):
        start = at[name]
        return [line.split() for line in lines[start + 1:start + 1 + int(lines[start].split()[1])]]

    squared = [number(words) for words in section("edges")]
    input_vertex = [int(words[0]) for words in section("input_vertices")]
    cotangents, ends, area = [0.0] * len(squared), [None] * len(squared), 0.0
    for words in section("faces"):
        h, v, a = [int(w) for w in words[:3]], [int(w) for w in words[3:6]], number(words[6:])
        area += a / 4
        for k in range(3):
            ij, jk, ki = (h[(k + i) % 3] // 2 for i in range(3))
            cotangents[ij] += (squared[jk] + squared[ki] - squared[ij]) / a
            ends[ij] = input_vertex[v[k]], input_vertex[v[(k + 1) % 3]]
    return ends, cotangents, area * 4.0 ** -scale


class Independent_check(Cli_test):
    def fractions(self, name):
        return {key: Fraction(x) for key, x in self.read_matrix(name)[2].items()}

    def meshes(self):
        points, faces = icosphere(2)
        yield [(x, 0.7 * y, 0.05 * z) for x, y, z in points], faces
        points, faces = grid(8)
        yield [(x, y, (x * x * 3 + y * 5) % 4) for x, y, _ in points], faces
        # the same, smooth and stretched: slivers, a border
        yield [(x + 0.3 * y, 0.11 * y, 0.01 * x * y) for x, y, _ in points], faces

    def test_laplacian_is_that_of_the_reference(self):
        for points, faces in self.meshes():
            reference = Reference(points, faces)
            reference.flip_to_delaunay()
            expected = reference.laplacian()
            mesh = self.write_off("m.off", points, faces)
            for arithmetic in ("exact", "double"):
                stats = self.stats("laplacian", mesh, "--arithmetic", arithmetic, "-o", "l.mtx")
                matrix = self.fractions("l.mtx")
                # doubles: some hundred flips, each with a few rounding errors of 1e-16 times the
                # aspect ratio of a face, which is below 1e3
                self.assert_close(stats["laplacian"]["trace"], trace(expected), 1e-9)
                self.assert_close(trace(matrix), trace(expected), 1e-9)
                for k, axis in enumerate("xyz"):
                    value = energy(expected, [[float(x) for x in p] for p in points], k)
                    self.assert_close(stats["dirichlet"][axis], value, 1e-9)
                    self.assert_close(energy(matrix, points, k), value, 1e-9)
                largest = max(abs(x) for x in expected.values())
                for key in expected.keys() | matrix.keys():
                    difference = float(expected.get(key, 0)) - float(matrix.get(key, 0))
                    self.assertLessEqual(abs(difference), 1e-9 * float(largest))

    def test_stored_triangulation_gives_the_same(self):
        for points, faces in self.meshes():
            mesh = self.write_off("m.off", points, faces)
            for arithmetic in ("exact", "double"):
                stats = self.stats("delaunay", mesh, "--arithmetic", arithmetic, "-o", "t.idt")
                ends, cotangents, area = read_idt(self.path("t.idt"))
                self.assert_close(area, stats["area"]["intrinsic"], 1e-13)
                self.assert_close(sum(c for (i, j), c in zip(ends, cotangents) if i != j),
                                  stats["laplacian"]["trace"], 1e-11)
                for k, axis in enumerate("xyz"):
                    value = sum(c / 2 * (points[i][k] - points[j][k]) ** 2
                                for (i, j), c in zip(ends, cotangents))
                    self.assert_close(value, stats["dirichlet"][axis], 1e-11)

    def test_mass_matrices(self):
        for points, faces in self.meshes():
            mesh = self.write_off("m.off", points, faces)
            for kind in ("lumped", "galerkin"):
                stats = self.stats("laplacian", mesh, "--mass", "m.mtx", "--mass-kind", kind)
                total = float(sum(self.fractions("m.mtx").values()))
                self.assert_close(total, stats["area"]["input"], 1e-12)


if __name__ == "__main__":
    main()
