# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Conformal maps against an own computation: Ptolemy's flips, angles and orientations."""

import unittest
from fractions import Fraction

import numpy as np

import intrinsic as it
import program
from support import BOOK, CUBE, TETRAHEDRON, grid

Long = np.longdouble  # 64 bits: a hundred thousand times less rounding than there are errors below


class Ideal:
    """Triangles with lambda lengths, which are flipped until they are ideal Delaunay."""

    def __init__(self, V, F, u):
        """The lengths of edges, rounded to doubles, times exp((u_i + u_j) / 2). Squares of lengths
        are doubles, if points are those of `rounded()`."""
        self.origin = np.asarray(F).ravel().copy()
        n = len(self.origin)
        side = {}
        self.twin = np.empty(n, int)
        for h in range(n):
            side[self.origin[h], self.origin[self.next(h)]] = h
        for (i, j), h in side.items():
            self.twin[h] = side[j, i]
        w = np.exp(np.asarray(u, Long) / 2)
        p, q = (np.asarray(V)[[self.origin[f(h)] for h in range(n)]] for f in (int, self.next))
        self.length = np.sqrt(((p - q) ** 2).sum(axis=1)).astype(Long)
        self.length *= w[self.origin] * w[self.origin[[self.next(h) for h in range(n)]]]
        waiting = list(range(n))
        while waiting:
            h = waiting.pop()
            if self.is_delaunay(h):
                continue
            waiting += self.flip(h)

    @staticmethod
    def next(h):
        return h - 2 if h % 3 == 2 else h + 1

    def sides(self, h):
        return h, self.next(h), self.next(self.next(h))

    def cosine(self, h):
        """Of the angle opposite to a side."""
        a, b, c = (self.length[k] for k in self.sides(h))
        return (b / c + c / b - a / b * (a / c)) / 2

    def is_delaunay(self, h):
        return h // 3 == self.twin[h] // 3 or self.cosine(h) + self.cosine(self.twin[h]) > -1e-15

    def flip(self, h):
        """Replaces the edge ij of the faces ijk and jim by km; returns the sides around it."""
        (a, b, c), (d, e, f) = self.sides(h), self.sides(self.twin[h])
        i, j, k, m = self.origin[[a, d, c, f]]
        new = (self.length[b] * self.length[e] + self.length[c] * self.length[f]) / self.length[a]
        place = {c: b, e: c, f: e, b: f}  # of each side in the faces mki and kmj
        known = [(y, self.twin[x], self.length[x]) for x, y in place.items()]
        self.origin[[a, b, c, d, e, f]] = m, k, i, k, m, j
        self.length[[a, d]] = new
        for y, t, length in known:
            t = place.get(t, t)
            self.twin[y], self.twin[t], self.length[y] = t, y, length
        return list(place.values())

    def angle_sums(self, vertices):
        sums = np.zeros(vertices, Long)
        for h in range(len(self.origin)):
            a, b, c = (self.length[k] for k in self.sides(h))  # the angle opposite to a
            part = (a + (b - c)) * (a - (b - c)) / (((b + c) - a) * (a + b + c))
            sums[self.origin[self.sides(h)[2]]] += 2 * np.arctan(np.sqrt(part))
        return sums


def rounded(V):
    """Points whose differences, up to 8, have squares without rounding."""
    return np.round(np.ldexp(V, 22)) / 2 ** 22


def tube(rings, around, rise):
    """A tube with caps; all rings have one radius."""
    t = 2 * np.pi * (np.arange(around)[None] + np.arange(rings)[:, None] % 2 / 2) / around
    V = np.dstack([np.cos(t), np.sin(t), np.repeat(rise * np.arange(rings)[:, None], around, 1)])
    V = np.vstack([V.reshape(-1, 3), [[0, 0, -.5], [0, 0, rise * (rings - 1) + .5]]])
    F = []
    for i in range(rings - 1):
        for j in range(around):
            a, b = around * i + j, around * i + (j + 1) % around
            c, d = a + around, b + around
            F += [(a, b, c), (b, d, c)] if i % 2 == 0 else [(a, b, d), (a, d, c)]
    ends = len(V) - 2, len(V) - 1
    last = around * (rings - 1)
    for j in range(around):
        k = (j + 1) % around
        F += [(k, j, ends[0]), (last + j, last + k, ends[1])]
    return rounded(V), np.array(F)


def torus(n=16, m=10):
    i, j = (x.ravel() for x in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    u, v = 2 * np.pi * i / n, 2 * np.pi * j / m
    V = np.column_stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)])
    a, b, c, d = ((i + k) % n * m + (j + l) % m for k, l in ((0, 0), (1, 0), (1, 1), (0, 1)))
    return V, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def two_tori():
    """A surface of genus 2: two tori, glued along a missing face."""
    V, F = torus()
    i, j = F[0], F[0][[0, 2, 1]] + len(V)
    number = np.arange(2 * len(V))
    number[j] = i[[0, 2, 1]]
    faces = number[np.concatenate([F[1:], F[1:, ::-1] + len(V)])]
    used, faces = np.unique(faces, return_inverse=True)
    return np.concatenate([V, V + [0, 20, 0]])[used], faces.reshape(-1, 3)


def moebius(n=12):
    """A strip of n squares with half a turn."""
    t = np.pi * np.repeat(np.arange(n), 2) / n
    r = np.tile([-1, 1], n) / 2
    V = np.column_stack([np.cos(2 * t) * (2 + r * np.cos(t)), np.sin(2 * t) * (2 + r * np.cos(t)),
                         r * np.sin(t)])
    quads = [(2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2) for i in range(n - 1)]
    quads.append((2 * n - 2, 2 * n - 1, 0, 1))
    return V, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def split_edges(V, F, random, place, both):
    """Splits edges, at most one of each face: faces on both sides, or one, beside which a face
    without area stays. `place(a, b)` is the new vertex."""
    V, F = list(V), [tuple(map(int, f)) for f in F]
    face = {(f[k], f[(k + 1) % 3]): n for n, f in enumerate(F) for k in range(3)}
    used, added = {}, []
    for (a, b), n in face.items():
        other = face.get((b, a))
        if other is None or n in used or other in used or random.random() > .3:
            continue
        m = len(V)
        V.append(place(V[a], V[b]))
        used[n], used[other] = (a, b, m), (b, a, m) if both else None
        if not both:
            added.append((a, b, m))
    for n, f in enumerate(F):
        if used.get(n) is None:
            added.append(f)
            continue
        a, b, m = used[n]
        c, = set(f) - {a, b}
        added += [(a, m, c), (m, b, c)]
    return np.array(V), np.array(added)


def turned(layout, faces):
    """How many triangles of the pieces of these faces are not counterclockwise, exactly."""
    count = 0
    for polygon, face in zip(layout.polygons, layout.input_faces):
        if face not in faces:
            continue
        (x, y), *rest = [[Fraction(float(t)) for t in layout.uv[v]] for v in polygon]
        for (a, b), (c, d) in zip(rest, rest[1:]):
            count += (a - x) * (d - y) - (b - y) * (c - x) <= 0
    return count


def beside_corners(V, F, random, size, corners):
    """Puts a vertex in some faces beside one of these corners, as far from it as a part of the
    face."""
    V, F = list(V), [tuple(map(int, f)) for f in F]
    for n in random.permutation(len(F))[:len(F) // 4]:
        a, b, c = np.roll(F[n], random.integers(3)).tolist()
        if a not in corners:
            continue
        m, (s, t) = len(V), size * random.uniform(.3, 1, 2)
        V.append(V[a] + s * (V[b] - V[a]) + t * (V[c] - V[a]))
        F[n] = a, b, m
        F += [(b, c, m), (c, a, m)]
    return np.array(V), np.array(F)


class Residuals(unittest.TestCase):
    def test_bounds_hold_for_what_is_written(self):
        random = np.random.default_rng(1)
        for _ in range(4):
            around = int(random.integers(5, 9))
            V, F = tube(int(random.integers(55, 70)), around, random.uniform(.7, 1.))
            cones = [0, 1, 2, len(V) - 2]  # at one end, so that the scale grows along the tube
            m = it.Surface(V, F).uniformize(cones=dict.fromkeys(cones, "pi"), start="input")
            self.assertGreater(np.ptp(m.u), 40)
            wanted = np.full(len(V), 2 * Long("3.14159265358979323846264338327950288"))
            wanted[cones] /= 2
            for u in (m.u, 2 * np.log(m.scale_factors.astype(Long))):
                sums = Ideal(V, F, u).angle_sums(len(V))
                self.assertLessEqual(np.abs(sums - wanted).max(), m.proven_residual)


    def test_needles_get_their_angles(self):
        random = np.random.default_rng(2)
        for size in (1e-4, 1e-6, 1e-8):
            V, F = split_edges(*torus(), random, lambda p, q: p + size * (q - p), both=True)
            V = rounded(V) if size > 1e-7 else V
            for start in ("input", "delaunay"):
                m = it.Surface(V, F).uniformize(start=start)
                self.assertLess(m.residual, 1e-10)
                self.assertIn(m.status, ("done", "inaccurate"))
            if size < 1e-7:
                continue
            m = it.Surface(V, F).uniformize(start="input", target="plane")
            sums = Ideal(V, F, m.u).angle_sums(len(V))  # of u, which has fewer digits
            error = np.abs(sums - 2 * Long("3.14159265358979323846264338327950288")).max()
            self.assertLessEqual(error, m.proven_residual)
            self.assertLess(m.proven_residual, 1e-14 / size)  # which is due to its digits

    def test_units_do_not_matter(self):
        V, F = two_tori()
        V = V + np.random.default_rng(4).uniform(-.1, .1, V.shape)  # no cut is as short as another
        one = it.Surface(V, F).uniformize()
        self.assertEqual((one.target, one.status), ("disk", "done"))
        for power in (-500, -30, 400):
            m = it.Surface(np.ldexp(V, power), F).uniformize()
            self.assertEqual(m.status, "done")
            self.assertLess(m.proven_residual, 1e-9)
            self.assertLess(np.abs(m.u + power * np.log(2) - one.u).max(), 1e-9)
            np.testing.assert_allclose(m.layout.uv, one.layout.uv, atol=1e-6)
        small = it.Surface(1e-150 * V, F).uniformize()
        self.assertEqual(small.status, "done")
        self.assertLess(np.abs(small.u - 150 * np.log(10) - one.u).max(), 1e-9)


class Layouts(unittest.TestCase):
    def test_faces_without_area_do_not_spoil_others(self):
        random = np.random.default_rng(3)
        for seed in range(3):
            disk = grid(12)
            disk[0][:, 2] = random.uniform(-.3, .3, len(disk[0]))
            for shape, cones in ((torus(), None), (disk, None), (disk, 4)):
                V, F = split_edges(*shape, random, lambda p, q: (p + q) / 2, both=False)
                sides = V[F] - V[np.roll(F, 1, axis=1)]
                area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
                with_area = set(np.flatnonzero(area > 1e-12).tolist())
                self.assertLess(len(with_area), len(F))
                for start in ("input", "delaunay"):
                    m = it.Surface(V, F).uniformize(start=start, cones=cones)
                    self.assertEqual((m.status, turned(m.layout, with_area)), ("done", 0))

    def test_needles_inside_of_disks_turn_no_pieces(self):
        """Angles are right on both sides of the double of a disk, not only on average: copies of
        edges have equal lengths."""
        random = np.random.default_rng(5)
        inside = {12 * y + x for x in range(3, 9) for y in range(3, 9)}
        for size in (1e-4, 1e-7, 1e-8, 1e-9):
            V, F = grid(12)
            V += random.uniform(-.2, .2, V.shape)
            V, F = beside_corners(V, F, random, size, inside)
            for start in ("input", "delaunay"):
                m = it.Surface(V, F).uniformize(start=start)
                self.assertEqual((m.status, turned(m.layout, set(range(len(F))))), ("done", 0))


class Recipes(program.Comparison):
    def surfaces(self):
        """Faces that form no oriented manifold, one manifold with handles, and their lengths."""
        V, F = torus(8, 6)
        fins = np.vstack([V, 2 * V[[0, 20]]]), np.vstack([F, [[0, 1, len(V)], [20, 21, len(V) + 1]]])
        for V, F in (moebius(), fins, BOOK, (V, F)):
            V, F = np.array(V, float), np.array(F)
            yield V, F, it.Surface(V, F), 1
        lengths = np.linalg.norm(V[F] - V[np.roll(F, -1, axis=1)], axis=2)
        yield V, F, it.Surface(None, F, lengths=lengths), 0

    def test_all_surfaces_are_cut_to_disks(self):
        for V, F, s, has_points in self.surfaces():
            for method in ("lscm", "harmonic"):
                m = s.parametrize(method, cut="auto")
                self.assertEqual((m.status, m.injective_on_input), ("done", True))
                self.assertEqual(set(m.original_vertex.tolist()), set(range(len(V))))
                self.assertEqual(m.certificate["faces"], len(F) + 2 * m.inserted_vertices)
                if not has_points or not program.is_there():
                    continue
                path = self.folder / "m.off"
                path.write_text(f"OFF {len(V)} {len(F)} 0\n" + "".join(
                    " ".join(map(repr, map(float, p))) + "\n" for p in V) + "".join(
                    f"3 {a} {b} {c}\n" for a, b, c in F))
                found, rows = self.numbers_of_program("parametrize", path, "--method", method)
                np.testing.assert_allclose(m.uv, rows[:, :2], atol=1e-9)
                self.assertEqual(found["parametrize"]["status"], m.status)

    def test_surfaces_without_front_have_scale_factors(self):
        n = 60
        z = 1 - (2 * np.arange(n) + 1) / n
        t = 2.4 * np.arange(n)
        cloud = np.column_stack([np.sqrt(1 - z * z) * np.cos(t), np.sqrt(1 - z * z) * np.sin(t), z])
        V, F = moebius()
        for s, cones in ((it.points(cloud), 6), (it.Surface(V, F), None)):
            m = s.uniformize(cones=cones)
            self.assertEqual((m.status, m.target, m.layout), ("done", "plane", None))
            self.assertIn("scale factors", m.no_layout)
            self.assertLess(m.proven_residual, 1e-9)
            if program.is_there() and cones:
                path = self.folder / "c.xyz"
                np.savetxt(path, cloud, fmt="%r")
                found, u = self.numbers_of_program("uniformize", path, "--cones", cones)
                np.testing.assert_allclose(m.u, u, atol=1e-9)

    def test_lengths_alone_are_doubled(self):
        V, F = grid(6)
        V[:, 2] = np.random.default_rng(5).uniform(-.3, .3, len(V))
        lengths = np.linalg.norm(V[F] - V[np.roll(F, -1, axis=1)], axis=2)
        m, n = it.Surface(V, F).uniformize(), it.Surface(None, F, lengths=lengths).uniformize()
        np.testing.assert_allclose(m.u, n.u, atol=1e-9)
        self.assertEqual((n.status, n.layout.points.shape[0]), ("done", 0))
        self.assertTrue(n.certificate["injective"])


class Words(unittest.TestCase):
    def test_turned_faces_are_inaccurate(self):
        random = np.random.default_rng(6)
        for spike, expected in ((0, "done"), (15, "inaccurate"), (50, "inaccurate")):
            V, F = grid()
            V[:, 2] = random.uniform(-.3, .3, len(V))
            V[40, 2] += spike
            for method in ("lscm", "spectral"):
                m = it.Surface(V, F).parametrize(method)
                x, y, z = (m.uv[m.surface.faces.T[k]] for k in range(3))
                area = np.cross(y - x, z - x)
                self.assertEqual((m.status, bool((area <= 0).any())), (expected, spike > 0))

    def test_remedies_are_of_python(self):
        V, F = np.array(CUBE[0], float), np.array(CUBE[1])
        two = it.Surface(np.vstack([V, V + 3]), np.vstack([F, F + len(V)]))
        points = it.points(np.random.default_rng(6).normal(size=(40, 3)))
        for message, call in (
                ("take the 2 components one by one", lambda: two.uniformize()),
                ("cones", lambda: two.uniformize()),
                ("cloud of points", lambda: points.cut())):
            with self.assertRaisesRegex(ValueError, message) as caught:
                call()
            for word in ("cut_open()", "change the angles", "repair"):
                self.assertNotIn(word, str(caught.exception))


if __name__ == "__main__":
    unittest.main()
