# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of lengths alone are covered as surfaces in space are, by every `domain`."""

import itertools
import re
import unittest

import numpy as np

import intrinsic as it
from support import BOOK, TETRAHEDRON

MOEBIUS = ([[0, 0, 0], [1, 0, 0], [2, 1, 0], [1, 2, 1], [0, 1, 1]],
           [[i, (i + 1) % 5, (i + 2) % 5] for i in range(5)])
# The six vertices of the projective plane, in general position: its faces cross each other.
PROJECTIVE = ([[0, 0, 0], [1, 0, 0.1], [0.3, 1, 0], [0.2, 0.3, 1], [1.1, 0.9, 0.4], [0.1, 0.8, 1.2]],
              [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 1], [1, 2, 4], [2, 3, 5],
               [3, 4, 1], [4, 5, 2], [5, 1, 3]])
DOMAINS = "auto", "manifold", "orientation-cover", "tufted", "closed"


def klein_bottle(n=4, m=4):
    """A grid in space whose ends are glued, one of them turned around."""
    V = [[np.cos(2 * np.pi * i / n) * (3 + j), np.sin(2 * np.pi * i / n) * (3 + j), (i * j) % 3]
         for i in range(n) for j in range(m)]

    def at(i, j):
        return (i % n) * m + ((j if i < n else -j) % m)
    F = [f for i in range(n) for j in range(m)
         for f in ([at(i, j), at(i + 1, j), at(i + 1, j + 1)],
                   [at(i, j), at(i + 1, j + 1), at(i, j + 1)])]
    return V, F


def random_soup(seed):
    """Triangles among few vertices: most edges have at most three faces, some have more."""
    random = np.random.default_rng(seed)
    V = random.uniform(-1, 1, (7, 3))
    faces = list(itertools.combinations(range(7), 3))
    F = [list(random.permutation(faces[i])) for i in random.choice(len(faces), 9, replace=False)]
    return V, F


def sides(V, F):
    V = np.array(V, dtype=float)[np.array(F)]
    return np.linalg.norm(np.roll(V, -1, axis=1) - V, axis=2)


def most_faces_at_an_edge(F):
    count = {}
    for f in F:
        for k in range(3):
            edge = frozenset((f[k], f[(k + 1) % 3]))
            count[edge] = count.get(edge, 0) + 1
    return max(count.values())


class Lengths(unittest.TestCase):
    def surface(self, domain, *args, **kwargs):
        """The surface, or the reason why there is none."""
        try:
            return it.Surface(*args, domain=domain, **kwargs), ""
        except ValueError as e:
            return None, str(e)

    def expect_same(self, s, t):
        for name in "kind", "sheets", "vertices":
            self.assertEqual(s.report["domain"][name], t.report["domain"][name])
        self.assertEqual(len(s.faces), len(t.faces))
        # equal up to the rounding of lengths: no ties are near
        self.assertLess(abs(s.mass() - t.mass()).max(), 1e-12)
        self.assertLess(abs(s.distance(0) - t.distance(0))[np.isfinite(t.distance(0))].max(),
                        1e-10)

    def test_have_the_domains_of_points(self):
        surfaces = [("book", BOOK), ("Moebius", MOEBIUS), ("projective plane", PROJECTIVE),
                    ("Klein bottle", klein_bottle()), ("tetrahedron", TETRAHEDRON)]
        surfaces += [(f"soup {seed}", random_soup(seed)) for seed in range(12)]
        compared = 0
        random = np.random.default_rng(8)
        for (name, (V, F)), domain in itertools.product(surfaces, DOMAINS):
            V = V + random.uniform(-0.05, 0.05, np.shape(V))  # right angles at borders are ties
            with self.subTest(name=name, domain=domain):
                t, refusal = self.surface(domain, V, F)
                s, reason = self.surface(domain, None, F, lengths=sides(V, F))
                self.assertEqual(t is None, s is None, refusal + reason)
                # lengths do not give the order of more faces
                if s is not None and most_faces_at_an_edge(F) <= 3:
                    self.expect_same(s, t)
                    compared += 1
        self.assertGreater(compared, 25)

    def test_are_glued_as_they_are_told(self):
        """Sides that run in one direction are glued, too: the surface has one side."""
        random = np.random.default_rng(9)
        V, F = MOEBIUS[0] + random.uniform(-0.05, 0.05, (5, 3)), np.array(MOEBIUS[1])
        first, glue = {}, np.full((len(F), 3, 2), -1)
        for f, k in itertools.product(range(len(F)), range(3)):
            edge = frozenset((F[f][k], F[f][(k + 1) % 3]))
            if edge in first:
                glue[f, k], glue[first[edge]] = first[edge], (f, k)
            first[edge] = f, k
        s = it.Surface(None, F, lengths=sides(V, F), glue=glue)
        self.expect_same(s, it.Surface(V, F))

    def test_that_disagree_are_refused(self):
        lengths = sides(*BOOK)
        lengths[2, 0] *= 1 + 3e-9
        with self.assertRaisesRegex(ValueError, r"lengths\[2, 0\].*sides of an edge one length"
                                    ) as refused:
            it.Surface(None, BOOK[1], lengths=lengths)
        here, there = re.search(r"is (\S+), .* the length (\S+);", str(refused.exception)).groups()
        self.assertNotEqual(here, there)


if __name__ == "__main__":
    unittest.main()
