# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tufted Laplacians of random soups, computed a second time from the definition in rational numbers.

Triangles are drawn whose areas are rational, and so all that flips make of them is. Faces are unfolded over their common
edge with the edge as unit, and a circle through three points decides: neither numbers nor formulas are those of the program."""

import math
import random
from fractions import Fraction

from cli_support import Cli_test, Glued_triangles, main

SOUPS = 25


def minus(p, q):
    return tuple(Fraction(x - y) for x, y in zip(p, q))


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def cross(u, v):
    return tuple(u[a] * v[b] - u[b] * v[a] for a, b in ((1, 2), (2, 0), (0, 1)))


def rational_area(p, q, r):
    """The area of a triangle with integer corners, or None if it is zero or not rational."""
    n = cross(*([y - x for x, y in zip(p, s)] for s in (q, r)))
    square = dot(n, n)
    root = math.isqrt(square)
    return Fraction(root, 2) if root > 0 and root * root == square else None


def random_soup(seed):
    """Points, and triangles over them of rational area, no two of which lie in one half plane at an edge."""
    r = random.Random(seed)
    points = r.sample([(x, y, z) for x in range(6) for y in range(6) for z in range(4)], 9 + seed % 8)
    faces, rays = [], set()
    for _ in range(3000):
        f = r.sample(range(len(points)), 3)
        if len(faces) == 5 + seed % 25 or not rational_area(*(points[i] for i in f)):
            continue
        at = {around(points, *sorted((f[k], f[(k + 1) % 3])), f[(k + 2) % 3]) for k in range(3)}
        if not rays & at:
            faces.append(f)
            rays |= at
    return points, faces


def around(points, u, v, apex):
    """The edge from u to v with the direction in which the apex lies, the same for each point of one half plane."""
    e, w = minus(points[v], points[u]), minus(points[apex], points[u])
    w = tuple(a * dot(e, e) - b * dot(w, e) for a, b in zip(w, e))
    size = max(abs(a) for a in w) or 1
    return u, v, tuple(a / size for a in w)


def sorted_around(points, u, v, faces):
    """Faces at an edge by the angle of their planes, counterclockwise seen from v."""
    e = minus(points[v], points[u])
    ray = {f: around(points, u, v, apex)[2] for f, apex in faces}
    first = ray[faces[0][0]]

    def key(f):
        # the cotangent falls over each half of the turn
        x, y = dot(ray[f], first), dot(e, cross(first, ray[f]))
        return (0 if x > 0 else 2) if y == 0 else 1 if y > 0 else 3, -x / y if y else 0
    return sorted(ray, key=key)


class Tufted(Glued_triangles):
    """Faces 2f and 2f + 1 are the sides of a triangle."""

    def __init__(self, points, triangles):
        super().__init__()
        self.area, at_edge = [], {}
        for f, (i, j, k) in enumerate(triangles):
            for corners in ((i, j, k), (j, i, k)):
                self.origin += corners
                self.area.append(rational_area(*(points[c] for c in corners)))
            for u, v, apex in ((i, j, k), (j, k, i), (k, i, j)):
                at_edge.setdefault((min(u, v), max(u, v)), []).append((f, apex))
        for h, v in enumerate(self.origin):
            e = minus(points[v], points[self.origin[self.next(h)]])
            self.squared.append(dot(e, e))
        for (u, v), faces in at_edge.items():
            order = sorted_around(points, u, v, faces)
            for f, g in zip(order, order[1:] + order[:1]):
                a, b = self.side(f, u, v), self.side(g, v, u)
                self.glue[a], self.glue[b] = b, a

    def side(self, triangle, u, v):
        return next(h for h in range(6 * triangle, 6 * triangle + 6)
                    if (self.origin[h], self.origin[self.next(h)]) == (u, v))

    def apex(self, h):
        """The third corner in the plane, where h runs from (0, 0) to (1, 0)."""
        n = self.next(h)
        base, to_end, to_start = (self.squared[x] for x in (h, n, self.next(n)))
        return (base + to_start - to_end) / (2 * base), 2 * self.area[h // 3] / base

    def cotangent(self, h):
        x, y = self.apex(h)
        return (x * (x - 1) + y * y) / y

    def is_bad(self, h):
        """Whether the corner across h is inside the circle of the face of h, by the power of the point."""
        (x, y), (a, b) = self.apex(h), self.apex(self.glue[h])
        p, q = 1 - a, -b
        center = (x * x + y * y - x) / (2 * y)
        return p * p + q * q - p - 2 * center * q < 0

    def flip(self, h):
        o = self.glue[h]
        (x, y), (a, b) = self.apex(h), self.apex(o)
        p, q, base = 1 - a, -b, self.squared[h]
        self.exchange(h)
        self.squared[h] = self.squared[o] = base * ((x - p) ** 2 + (y - q) ** 2)
        for s in (h, o):  # what the sides of the new faces are in the plane of both
            corners = {h: ((x, y), (p, q), (1, 0)), o: ((p, q), (x, y), (0, 0))}[s]
            (ax, ay), (bx, by), (cx, cy) = corners
            self.area[s // 3] = base * abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2

    def weights(self):
        """The weight between two rows of the soup; both copies of an edge have half of its cotangents."""
        result = {}
        for h, v in enumerate(self.origin):
            w = self.origin[self.next(h)]
            if v != w:
                key = min(v, w), max(v, w)
                result[key] = result.get(key, 0) + self.cotangent(h) / 4
        return result


class Tufted_rationals(Cli_test):
    def test_laplacians_of_random_soups_are_what_the_definition_says(self):
        flipped = nonmanifold = zeros = 0
        for seed in range(SOUPS):
            points, faces = random_soup(seed)
            cover = Tufted(points, faces)
            before = list(cover.squared)
            expected = cover.flip_to_delaunay().weights()
            flipped += before != cover.squared
            mesh = self.write_off("soup.off", points, faces)
            stats = self.stats("laplacian", mesh, "--domain", "tufted", "-o", "l.mtx")
            nonmanifold += stats["domain"]["nonmanifold_edges"] > 0
            self.assert_certified(stats)
            entries = self.read_matrix("l.mtx")[2]
            with self.subTest(seed=seed):
                for (v, w), x in expected.items():
                    self.assertGreaterEqual(x, 0)
                    self.assert_close(-entries.get((v, w), 0), float(x), 1e-12, (v, w, x))
                    zeros += x == 0
                between = {key for key in entries if key[0] < key[1]}
                self.assertLessEqual(between, {key for key, x in expected.items() if x > 0})
        # all that is asked for was seen
        self.assertGreater(min(flipped, nonmanifold, zeros), SOUPS / 4)


if __name__ == "__main__":
    main()
