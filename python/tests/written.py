# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The ten surfaces, written down in other ways.

A `Written` has the arrays of a surface. It takes what users give (places, vectors, functions) from
the first way to write it down, the base, to this one, and what they get (rows, places in space)
back. Points that divide edges and faces have weights with few digits, so that divided surfaces are
the same point for point.
"""

import functools
from fractions import Fraction

import numpy as np

import intrinsic as it
from ten_surfaces import ALL, arrays


class Written:
    """A surface as arrays, and how they come from the base.

    `weights` has for each vertex the vertices of the base that it is between, a dict; `of_face` the
    face of the base that each face is in.
    """

    def __init__(self, name, V, F, weights=None, of_face=None):
        self.name, self.V, self.F = name, np.array(V, dtype=float), F
        if F is not None:
            self.F = np.array(F)
        self.weights = weights or [{i: Fraction(1)} for i in range(len(V))]
        self.of_face = list(range(len(F or ()))) if of_face is None else of_face
        self.turn, self.shift, self.scale, self.naming = np.eye(3), np.zeros(3), 1.0, 0
        self.base_size = len(V)

    def copy(self):
        x = Written(self.name, self.V.copy(), None, list(self.weights), list(self.of_face))
        x.F = None if self.F is None else self.F.copy()
        x.base_size = self.base_size
        x.turn, x.shift, x.scale, x.naming = self.turn, self.shift, self.scale, self.naming
        return x

    # ---- What is computed once

    @functools.cached_property
    def s(self):
        """The surface."""
        return it.points(self.V, neighbors=12) if self.F is None else it.Surface(self.V, self.F)

    @functools.cached_property
    def d(self):
        """Its Delaunay triangulation."""
        return self.s.delaunay()

    @functools.cached_property
    def vertex(self):
        """The vertex that each vertex of the base is."""
        at = np.full(self.base_size, -1)
        for i, w in enumerate(self.weights):
            if len(w) == 1:
                at[next(iter(w))] = i
        return at

    @functools.cached_property
    def base_vertex(self):
        """The vertex of the base that each vertex is, or -1."""
        return np.array([next(iter(w)) if len(w) == 1 else -1 for w in self.weights])

    # ---- From the base to here

    def at(self, place):
        """A vertex or a dict from vertices of the base to weights, as the user names it here."""
        return self.names(place)[self.naming % len(self.names(place))]

    def names(self, place):
        """All names of a place: the vertex, and points of faces at it, or that it is in."""
        if np.ndim(place) == 0 and not isinstance(place, dict):
            if self.naming == 0:
                return [int(self.vertex[place])]
            place = {int(place): Fraction(1)}
        found = [int(self.vertex[v]) for v in place if len(place) == 1]
        for f, corners in enumerate(self.F if self.F is not None else ()):
            known = sorted(set().union(*(self.weights[v] for v in corners)))
            if not set(place) <= set(known):
                continue
            x = _solve([[self.weights[v].get(k, Fraction(0)) for v in corners] for k in known],
                       [place.get(k, Fraction(0)) for k in known])
            if x is not None and min(x) >= 0:
                found.append(it.Point(f, tuple(float(w) for w in x)))
        return found

    def values(self, u):
        """A function of the base that is linear in its faces, at vertices here."""
        return np.array([sum(float(w) * u[v] for v, w in ws.items()) for ws in self.weights])

    def vector(self, d):
        """A vector in space."""
        return self.turn @ np.asarray(d, dtype=float)

    # ---- From here to the base

    def rows(self, u):
        """Values at the vertices of the base."""
        return np.asarray(u)[self.vertex]

    def space(self, P):
        """Points in space."""
        return (np.asarray(P) - self.shift) @ self.turn / self.scale

    def vectors(self, W):
        """Vectors in space, of a length that does not change."""
        return np.asarray(W) @ self.turn

    # ---- Changes

    def moved(self, turn=None, shift=(0, 0, 0), scale=1.0):
        """The same turned, scaled, and moved by a vector."""
        x = self.copy()
        turn = np.eye(3) if turn is None else turn
        x.V = scale * (x.V @ turn.T) + shift
        x.turn, x.shift, x.scale = turn @ x.turn, scale * (turn @ x.shift) + shift, scale * x.scale
        return x

    def renumbered(self, random):
        """The same with vertices and faces in another order, and other corners first."""
        x = self.copy()
        order = random.permutation(len(self.V))  # of the old vertices
        x.V, x.weights = self.V[order], [self.weights[i] for i in order]
        if self.F is not None:
            faces = random.permutation(len(self.F))
            F = np.argsort(order)[self.F][faces]
            x.F = np.array([np.roll(f, k) for f, k in zip(F, random.integers(0, 3, len(F)))])
            x.of_face = [self.of_face[f] for f in faces]
        return x

    def named(self, k):
        """The same, with other names for places: from other faces."""
        x = self.copy()
        x.naming = k
        return x

    def turned_around(self, random):
        """The same with some faces turned around."""
        x = self.copy()
        for f in range(len(x.F)):
            if random.random() < 0.5:
                x.F[f] = x.F[f][[0, 2, 1]]
        return x

    def with_split_edge(self, a, b):
        """The same with a vertex in the middle of an edge."""
        x = self.copy()
        m, F, of_face = x._add(a, b), [], []
        for f, g in zip(self.F.tolist(), self.of_face):
            if a in f and b in f:
                F += [[m if v == a else v for v in f], [m if v == b else v for v in f]]
                of_face += [g, g]
            else:
                F.append(f)
                of_face.append(g)
        x.F, x.of_face = np.array(F), of_face
        return x

    def with_split_face(self, f):
        """The same with a vertex in a face."""
        x = self.copy()
        a, b, c = self.F[f]
        m = x._add(a, b, c, c)
        x.F = np.vstack([np.delete(self.F, f, axis=0), [[a, b, m], [b, c, m], [c, a, m]]])
        x.of_face = x.of_face[:f] + x.of_face[f + 1:] + [self.of_face[f]] * 3
        return x

    def refined(self):
        """The same with four triangles in each face, up to their shape."""
        x, middle, F = self.copy(), {}, []

        def m(a, b):
            key = min(a, b), max(a, b)
            if key not in middle:
                middle[key] = x._add(a, b)
            return middle[key]

        for a, b, c in self.F.tolist():
            F += [[a, m(a, b), m(c, a)], [m(a, b), b, m(b, c)], [m(c, a), m(b, c), c],
                  [m(a, b), m(b, c), m(c, a)]]
        x.F, x.of_face = np.array(F), [g for g in self.of_face for _ in range(4)]
        return x

    def _add(self, *vertices):
        weights = {}
        for v in vertices:
            for k, w in self.weights[v].items():
                weights[k] = weights.get(k, Fraction(0)) + w / len(vertices)
        self.weights.append(weights)
        self.V = np.vstack([self.V, sum(self.V[v] for v in vertices) / len(vertices)])
        return len(self.weights) - 1


def _solve(rows, right):
    """The exact solution x of three unknowns, or None."""
    m = [list(r) + [b] for r, b in zip(rows, right)]
    for k in range(3):
        pivot = next((i for i in range(k, len(m)) if m[i][k] != 0), None)
        if pivot is None:
            return None
        m[k], m[pivot] = m[pivot], m[k]
        m[k] = [e / m[k][k] for e in m[k]]
        m = [r if i == k else [e - r[k] * g for e, g in zip(r, m[k])] for i, r in enumerate(m)]
    return None if any(r[3] for r in m[3:]) else [m[k][3] for k in range(3)]


# ---- Changes of the ten surfaces -----------------------------------------------------------------


@functools.cache
def base(name):
    """One of the ten surfaces."""
    return Written(name, *arrays(name))


def rotation(random):
    q, r = np.linalg.qr(random.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def _random(name, change):
    return np.random.default_rng([ALL.index(name), *map(ord, change)])


def _divided(x, random):
    for _ in range(2):
        f = x.F[random.integers(len(x.F))]
        x = x.with_split_edge(int(f[0]), int(f[1]))
        x = x.with_split_face(int(random.integers(len(x.F))))
    return x


RIGID = {
    "turned": lambda x, r: x.moved(turn=rotation(r)),
    "moved": lambda x, r: x.moved(shift=r.uniform(-1, 1, 3)),
    "scaled by 0.001": lambda x, r: x.moved(scale=0.001),
    "scaled by 1000": lambda x, r: x.moved(scale=1000.),
    "scaled by 2**-9": lambda x, r: x.moved(scale=2.**-9),
    "scaled by 2**7": lambda x, r: x.moved(scale=2.**7),
}
RENUMBERED = {
    "renumbered": lambda x, r: x.renumbered(r),
    "named otherwise": lambda x, r: x.named(1),
    "named otherwise again": lambda x, r: x.named(2).renumbered(r),
    "written anew": lambda x, r: x.renumbered(r).moved(rotation(r), r.uniform(-9, 9, 3), 7.3),
}
DIVIDED = {
    "edge split": lambda x, r: x.with_split_edge(*map(int, x.F[r.integers(len(x.F))][:2])),
    "face split": lambda x, r: x.with_split_face(int(r.integers(len(x.F)))),
    "divided": lambda x, r: _divided(x, r).renumbered(r).named(1),
}
AROUND = {"turned around": lambda x, r: x.turned_around(r)}
CHANGES = RIGID | RENUMBERED | DIVIDED | AROUND


@functools.cache
def written(name, change):
    """One of the ten surfaces after a change of the tables above."""
    return CHANGES[change](base(name), _random(name, change))


@functools.cache
def refined(name, times):
    """One of the ten surfaces, so many times refined."""
    return base(name) if times == 0 else refined(name, times - 1).refined()


@functools.cache
def place(name, k):
    """Places of the base: 0 to 3 vertices, 4 and 5 in faces, 6 and 7 on edges."""
    x, random = base(name), _random(name, f"place {k}")
    used = np.unique(x.F) if x.F is not None else np.arange(len(x.V))
    if k < 4:
        start = int(used[random.integers(len(used))]) if k == 0 else place(name, 0)
        if k == 0:
            return start
        far = np.linalg.norm(x.V[used] - x.V[start], axis=1)  # some way off
        return int(used[np.argsort(far)[len(used) * (k + 1) // 5]])
    corners = [int(v) for v in x.F[random.integers(len(x.F))]]
    if k < 6:
        return dict(zip(corners, (Fraction(1, 2), Fraction(3, 8), Fraction(1, 8))))
    return dict(zip(corners[:2], (Fraction(5, 8), Fraction(3, 8))))
