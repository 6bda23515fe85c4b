# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ten small surfaces with irregular vertices, so that nothing is a tie. Coordinates are multiples of
2**-16."""

import numpy as np
from scipy.spatial import ConvexHull, Delaunay


def _round(V):
    return np.round(np.asarray(V) * 2**16) / 2**16


def _outward(V, F):
    F = np.array(F)
    a, b, c = (V[F[:, k]] for k in range(3))
    inward = np.einsum("ij,ij->i", np.cross(b - a, c - a), a) < 0
    F[inward] = F[inward][:, [0, 2, 1]]
    return F.tolist()


def ball(random, n):
    z = 1 - (2 * np.arange(n) + 1) / n
    angle = 2.399963 * np.arange(n)
    V = np.column_stack([np.sqrt(1 - z * z) * np.cos(angle), np.sqrt(1 - z * z) * np.sin(angle), z])
    V += random.normal(scale=0.4 / np.sqrt(n), size=V.shape)
    V /= np.linalg.norm(V, axis=1)[:, None]
    F = _outward(V, ConvexHull(V).simplices)
    return V * random.uniform(0.9, 1.1, (n, 1)), F


def _quads(random, at, quads):
    """Divides quads along diagonals at random; `at` gives the number of a vertex."""
    F = []
    for q in quads:
        a, b, c, d = (at[p] for p in q)
        F += [[a, b, c], [a, c, d]] if random.random() < 0.5 else [[a, b, d], [b, c, d]]
    return F


def sheet(random, n, m, wraps_i=False, wraps_j=False, twisted=False):
    """Quads of a grid, which may be closed."""
    at = {(i, j): (i % n) * m + j % m for i in range(n + 1) for j in range(m + 1)}
    if twisted:
        at.update({(n, j): m - 1 - j for j in range(m)})
    return _quads(random, at, [((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
                               for i in range(n if wraps_i or twisted else n - 1)
                               for j in range(m if wraps_j else m - 1)])


def grid(n, m):
    i, j = np.divmod(np.arange(n * m), m)
    return i.astype(float), j.astype(float)


def _torus(random):
    n, m = 9, 6
    i, j = grid(n, m)
    i, j = (x + random.uniform(-0.25, 0.25, n * m) for x in (i, j))
    a, b = 2 * np.pi * i / n, 2 * np.pi * j / m
    r = 1 + 0.45 * np.cos(b)
    return np.column_stack([r * np.cos(a), r * np.sin(a), 0.45 * np.sin(b)]), \
        sheet(random, n, m, True, True)


def _genus_2(random):
    cubes = {(i, j) for i in range(5) for j in range(3)} - {(1, 1), (3, 1)}
    quads = []
    for i, j in sorted(cubes):
        corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
        quads += [[(*p, 1) for p in corners], [(*p, 0) for p in corners[::-1]]]
        for k, (di, dj) in enumerate([(0, -1), (1, 0), (0, 1), (-1, 0)]):
            if (i + di, j + dj) not in cubes:
                p, q = corners[k], corners[(k + 1) % 4]
                quads.append([(*p, 0), (*q, 0), (*q, 1), (*p, 1)])
    at = {p: k for k, p in enumerate(sorted({p for q in quads for p in q}))}
    V = np.array(sorted(at), dtype=float) * 0.5
    return V + random.uniform(-0.09, 0.09, V.shape), _quads(random, at, quads)


def disk(random):
    n = 44
    r, angle = np.sqrt((np.arange(n) + 0.5) / n), 2.399963 * np.arange(n)
    xy = np.column_stack([r * np.cos(angle), r * np.sin(angle)])
    xy += random.uniform(-0.05, 0.05, xy.shape)
    F = Delaunay(xy).simplices
    a, b, c = (xy[F[:, k]] for k in range(3))
    cross = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    F[cross < 0] = F[cross < 0][:, [0, 2, 1]]
    F = F[abs(cross) > 0.02]
    return np.column_stack([xy, 0.4 * np.cos(2 * xy[:, 0] + xy[:, 1])]), F.tolist()


def _plane(random):
    i, j = (x + random.uniform(-0.2, 0.2, 42) for x in grid(7, 6))
    return np.column_stack([i, j, 0 * i]) / 4, sheet(random, 7, 6)


def _cone(random):
    n, m = 9, 4
    i, j = (x + random.uniform(-0.2, 0.2, n * m) for x in grid(n, m))
    angle, r = 2 * np.pi * i / n, (j + 1) / m
    V = np.vstack([np.column_stack([r * np.cos(angle), r * np.sin(angle), 1.5 - 1.5 * r]),
                   [[0, 0, 1.5]]])
    F = [[c, b, a] for a, b, c in sheet(random, n, m, True)]
    return V, F + [[i * m, (i + 1) % n * m, n * m] for i in range(n)]


def _moebius(random):
    n, m = 12, 4
    i, j = (x + random.uniform(-0.2, 0.2, n * m) for x in grid(n, m))
    a, w = 2 * np.pi * i / n, 0.25 * (j - 1.5)
    r = 1 + w * np.cos(a / 2)
    return np.column_stack([r * np.cos(a), r * np.sin(a), w * np.sin(a / 2)]), \
        sheet(random, n, m, twisted=True)


def _soup(random):
    V, F = ball(random, 30)
    V, F = list(V), list(F)
    for k in 3, 17, 31:  # fins at edges of the ball, the last of two triangles
        a, b, _ = F[k]
        tip = 1.5 * (V[a] + V[b]) / 2 + random.uniform(-0.2, 0.2, 3)
        V.append(tip)
        F.append([a, b, len(V) - 1])
    V.append(V[-1] + V[F[-1][0]] * 0.5)
    F.append([F[-1][0], len(V) - 2, len(V) - 1])
    return np.array(V), F


def _book(random, pages=4, n=5):
    V, F = [], []
    for i in range(n):
        V.append([0, 0, 0.4 * i + random.uniform(-0.08, 0.08)])
    for page in range(pages):
        angle = 2 * np.pi * page / pages + random.uniform(-0.3, 0.3)
        at = {(i, 0): i for i in range(n)}
        for j in range(1, 4):
            for i in range(n):
                at[i, j] = len(V)
                r = 0.35 * j + random.uniform(-0.07, 0.07)
                bend = angle + random.uniform(-0.1, 0.1)
                V.append([r * np.cos(bend), r * np.sin(bend),
                          0.4 * i + random.uniform(-0.08, 0.08)])
        F += _quads(random, at, [((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
                                 for i in range(n - 1) for j in range(3)])
    return np.array(V), F


def of_many_sheets(random):
    """A book or a soup at random, with edges of several faces."""
    if random.random() < 0.5:
        return _book(random, pages=int(random.integers(3, 7)), n=int(random.integers(2, 5)))
    return _soup(random)


def _cloud(random):
    return ball(random, 150)[0], None


MAKERS = {"sphere": lambda random: ball(random, 42), "torus": _torus, "genus 2": _genus_2,
          "disk": disk, "plane": _plane, "cone": _cone, "Moebius": _moebius, "soup": _soup,
          "book": _book, "cloud": _cloud}
ALL = tuple(MAKERS)
MESHES = tuple(name for name in ALL if name != "cloud")
CLOSED = "sphere", "torus", "genus 2"
DISKS = "disk", "plane", "cone"
ORIENTED = CLOSED + DISKS


def arrays(name):
    """The vertices and the faces of one of them; no faces of the cloud of points."""
    V, F = MAKERS[name](np.random.default_rng(ALL.index(name) + 11))
    return _round(V), None if F is None else [list(map(int, f)) for f in F]
