#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a tolerance leaves wrong in ideal Delaunay triangulations: flips_with_tolerance.py [SEEDS].

A sphere of 162 vertices is scaled by random factors over some powers of ten. Edges are flipped as
floating point numbers say, with lambda lengths that flips update, unless the test is within a
tolerance. The same lambda lengths are kept as fractions, too, which tell exactly what is wrong in
the end: edges that are not Delaunay, and triangles that violate the triangle inequality, so that
they have no shape in the plane. Prints a table of means. Needs only Python 3.
"""
import collections
import itertools
import math
import random
import sys
from fractions import Fraction


def sphere(rounds):
    """Points and triangles of an icosahedron whose faces are divided in four."""
    g = (1 + math.sqrt(5)) / 2
    points = [p for a, b in itertools.product((1, -1), (g, -g))
              for p in ((0, a, b), (a, b, 0), (b, 0, a))]
    near = lambda i, j: math.dist(points[i], points[j]) < 2.1
    faces = [[i, j, k] for i, j, k in itertools.combinations(range(12), 3)
             if near(i, j) and near(j, k) and near(k, i)]
    for f in faces:
        a, b, c = (points[v] for v in f)
        if sum(a[k] * (b[k - 2] * c[k - 1] - b[k - 1] * c[k - 2]) for k in range(3)) < 0:
            f.reverse()
    for _ in range(rounds):
        middle = {}

        def between(i, j):
            key = (min(i, j), max(i, j))
            if key not in middle:
                middle[key] = len(points)
                points.append([x + y for x, y in zip(points[i], points[j])])
            return middle[key]
        faces = [t for a, b, c in faces for ab, bc, ca in
                 [(between(a, b), between(b, c), between(c, a))]
                 for t in ([a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca])]
        points = [[x / math.hypot(*p) for x in p] for p in points]
    return points, faces


class Triangulation:
    """Halfedges 3 f + k, each with its twin, or -1 on the border. Numbers of a halfedge are in
    lists, equal for both sides of an edge."""

    def __init__(self, faces, lists):
        self.origin = [v for f in faces for v in f]
        ends = {(self.origin[h], self.origin[self.next(h)]): h for h in range(len(self.origin))}
        self.twin = [ends.get((w, v), -1) for v, w in sorted(ends, key=ends.get)]
        self.lists = [[None] * len(self.twin) for _ in range(lists)]

    @staticmethod
    def next(h):
        return h - 2 if h % 3 == 2 else h + 1

    def diamond(self, h):
        t = self.twin[h]
        return [h, self.next(h), self.next(self.next(h)), self.next(t), self.next(self.next(t))]

    def flip(self, h):
        # ij with faces ijk and jim becomes km, with faces kmj and mki
        h, jk, ki, im, mj = self.diamond(h)
        t = self.twin[h]
        values = [[n[i] for i in (jk, ki, im, mj)] + [self.flipped(h, n)] for n in self.lists]
        outer = [self.twin[i] for i in (jk, ki, im, mj)]
        names = {jk: 0, ki: 1, im: 2, mj: 3}
        j, k, i, m = (self.origin[x] for x in (jk, ki, im, mj))
        f, g = h - h % 3, t - t % 3
        # sides km, mj, jk of one face, and mk, ki, im of the other
        place = {0: f + 2, 3: f + 1, 2: g + 2, 1: g + 1}
        self.origin[f:f + 3], self.origin[g:g + 3] = [k, m, j], [m, k, i]
        for number, at in place.items():
            other = outer[number]
            other = place[names[other]] if other in names else other
            self.twin[at] = other
            if other >= 0:
                self.twin[other] = at
            for n, v in zip(self.lists, values):
                n[at] = v[number]
        self.twin[f], self.twin[g] = g, f
        for n, v in zip(self.lists, values):
            n[f] = n[g] = v[4]

    def make_delaunay(self, tolerance, most):
        """Returns the number of flips; more than `most`: it does not end."""
        queue, flips = collections.deque(range(len(self.twin))), 0
        while queue and flips <= most:
            h = queue.popleft()
            if self.twin[h] >= 0 and self.excess(h, self.lists[0]) < -tolerance:
                self.flip(h)
                flips += 1
                f, g = h - h % 3, self.twin[h - h % 3]
                queue.extend([f + 1, f + 2, g - g % 3 + 1, g - g % 3 + 2])
        return flips


class Ideal_triangulation(Triangulation):
    """Lambda lengths in doubles, and as fractions."""

    def __init__(self, points, faces, factors):
        super().__init__(faces, 2)
        for h, t in enumerate(self.twin):
            if h < t:
                v, w = sorted((self.origin[h], self.origin[t]))
                numbers = math.dist(points[v], points[w]), factors[v], factors[w]
                for i in (h, t):
                    self.lists[0][i] = math.prod(numbers)
                    self.lists[1][i] = math.prod(map(Fraction, numbers))

    def excess(self, h, numbers):
        """The sum of two cosines, negative if the edge is not Delaunay: 2 cos is
        (a^2 + b^2 - e^2) / (a b)."""
        e, a, b, c, d = (numbers[i] for i in self.diamond(h))
        return (a * a + b * b - e * e) / (a * b) + (c * c + d * d - e * e) / (c * d)

    def flipped(self, h, numbers):
        e, a, b, c, d = (numbers[i] for i in self.diamond(h))
        return (a * c + b * d) / e

    def faults(self):
        edges = sum(h < self.twin[h] and self.excess(h, self.lists[1]) < 0
                    for h in range(len(self.twin)))
        faces = 0
        for h in range(0, len(self.twin), 3):
            a, b, c = sorted(self.lists[1][h:h + 3])
            faces += a + b <= c
        return edges, faces


def main():
    seeds = int(sys.argv[1]) if len(sys.argv) > 1 else 10
    points, faces = sphere(2)
    print("powers of ten, tolerance: flips, edges not Delaunay, triangles that cannot be laid out, "
          "runs that do not end")
    for powers, tolerance in itertools.product((2, 6, 10, 20), (0, 1e-12, 1e-8, 1e-5)):
        total = [0, 0, 0, 0]
        for seed in range(seeds):
            numbers = random.Random(seed)
            factors = [10 ** numbers.uniform(-powers / 2, powers / 2) for _ in points]
            t = Ideal_triangulation(points, faces, factors)
            flips = t.make_delaunay(tolerance, 20000)
            for k, x in enumerate([flips, *t.faults(), flips > 20000]):
                total[k] += x
        print(powers, tolerance, *(x / seeds for x in total[:3]), total[3], flush=True)


if __name__ == "__main__":
    main()
