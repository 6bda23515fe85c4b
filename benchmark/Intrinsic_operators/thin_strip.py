#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What doubles and a tolerance make of a thin strip of the plane: thin_strip.py [SEEDS].

The strip has needles of a few ulps. Edges are flipped as doubles say, with lengths that flips
update, where the cotangents of the angles opposite to an edge sum to less than minus a tolerance.
In the plane, an intrinsic edge is the straight segment between its ends: triangles whose corners do
not run counterclockwise are folded, which integers tell exactly. Prints a table of means. Needs
only Python 3.
"""
import itertools
import math
import random
import sys

from flips_with_tolerance import Triangulation

COLUMNS, ROWS = 12, 6


def strip(power, seed):
    """Points and triangles of a strip: a lattice of integers with jitter, whose second coordinates
    count for 10^-power of the first ones."""
    numbers, size = random.Random(seed), 1000
    jitter = lambda i, n: numbers.randint(-350, 350) if 0 < i < n else 0
    points = [(size * i + jitter(i, COLUMNS), size * j + jitter(j, ROWS))
              for j in range(ROWS + 1) for i in range(COLUMNS + 1)]
    faces = []
    for j, i in itertools.product(range(ROWS), range(COLUMNS)):
        a = j * (COLUMNS + 1) + i
        b, c, d = a + 1, a + COLUMNS + 2, a + COLUMNS + 1
        faces += [[a, b, c], [a, c, d]]
    return points, [(x / 7000, y / 7000 * 10. ** -power) for x, y in points], faces


def side(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


class Flat_triangulation(Triangulation):
    """Lengths in doubles."""

    def __init__(self, points, faces):
        super().__init__(faces, 1)
        self.lists[0] = [math.dist(points[self.origin[h]], points[self.origin[self.next(h)]])
                         for h in range(len(self.twin))]

    @staticmethod
    def cotangent(e, a, b):
        """That of the angle opposite to e, with Kahan's formula of the area."""
        x, y, z = sorted((a, b, e), reverse=True)
        square = (x + (y + z)) * (z - (x - y)) * (z + (x - y)) * (x + (y - z))
        dot = a * a + b * b - e * e
        return dot / math.sqrt(square) if square > 0 else math.copysign(math.inf, dot)

    def excess(self, h, numbers):
        e, a, b, c, d = (numbers[i] for i in self.diamond(h))
        return self.cotangent(e, a, b) + self.cotangent(e, c, d)

    def flipped(self, h, numbers):
        """The distance of the opposite corners in the plane, with e on the first axis."""
        e, a, b, c, d = (numbers[i] for i in self.diamond(h))
        x, y = (e * e + b * b - a * a) / (2 * e), (e * e + c * c - d * d) / (2 * e)
        height = lambda side, foot: math.sqrt(max(side * side - foot * foot, 0))
        return math.hypot(x - y, height(b, x) + height(c, y))

    def triangles(self):
        return [self.origin[h:h + 3] for h in range(0, len(self.origin), 3)]


def folded(points, triangles):
    return [t for t in triangles if side(*(points[v] for v in t)) <= 0]


def main():
    seeds = int(sys.argv[1]) if len(sys.argv) > 1 else 10
    print("height 10^-n, tolerance: flips, folded triangles, runs that do not end")
    for power, tolerance in itertools.product((6, 7, 8, 9, 10), (0, 1e-8, 1e-5)):
        total = [0, 0, 0]
        for seed in range(seeds):
            lattice, points, faces = strip(power, seed)
            t = Flat_triangulation(points, faces)
            flips = t.make_delaunay(tolerance, 20000)
            for k, x in enumerate([flips, len(folded(lattice, t.triangles())), flips > 20000]):
                total[k] += x
        print(power, tolerance, *(x / seeds for x in total[:2]), total[2], flush=True)


if __name__ == "__main__":
    main()
