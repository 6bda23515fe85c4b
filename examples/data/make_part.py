#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a filleted L-bracket meshed as CAD exporters do it: python3 make_part.py > part.off

All points lie on a grid of 2^-16 mm: mirrored points are mirrored exactly, walls are made of exact
rectangles, and all tests below are exact, on integers. No Steiner points: planar faces are
ear-clipped, cylinders and fillets are strips as long as the part.
"""
import math
import sys

GRID = 1 << 16  # grid steps per millimetre
vertex_of, points, triangles = {}, [], []


def vertex(point):
    """Returns the index of a grid point; equal points share one vertex."""
    if point not in vertex_of:
        vertex_of[point] = len(points)
        points.append(point)
    return vertex_of[point]


def circle(cx, cy, r, n):
    """n points, n divisible by 8, counterclockwise; mirrored exactly at axes and diagonals."""
    def cosine(k):
        k = min(k % n, -k % n)
        return -cosine(n // 2 - k) if 4 * k > n else round(GRID * r * math.cos(2 * math.pi * k / n))
    return [(GRID * cx + cosine(k), GRID * cy + cosine(k - n // 4)) for k in range(n)]


def side(a, b, c):
    """Twice the signed area of abc: positive if c is to the left of ab."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def within(a, b, p):
    """Whether p, collinear with ab, lies on the closed segment ab."""
    return all(min(a[x], b[x]) <= p[x] <= max(a[x], b[x]) for x in (0, 1))


def blocks(a, b, c, d):
    """Whether segment cd meets segment ab elsewhere than in an end point common to both."""
    if {a, b} & {c, d}:
        return any(p not in (a, b) and side(a, b, p) == 0 and within(a, b, p) for p in (c, d))
    s, t, u, v = side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)
    tests = (s, (a, b, c)), (t, (a, b, d)), (u, (c, d, a)), (v, (c, d, b))
    touches = [within(*w) for x, w in tests if x == 0]
    return any(touches) if touches else (s > 0) != (t > 0) and (u > 0) != (v > 0)


def in_corner(ring, i, p):
    """Whether p lies strictly inside the corner of the ring at position i."""
    a, b, c = ring[i - 1], ring[i], ring[(i + 1) % len(ring)]
    left = side(a, b, p) > 0, side(b, c, p) > 0
    return all(left) if side(a, b, c) > 0 else any(left)


def bridged(ring, holes):
    """Joins clockwise holes to a counterclockwise ring by their shortest admissible bridges."""
    loops = sorted((h[::-1] for h in holes), key=lambda h: -max(h)[0])
    for number, hole in enumerate(loops):
        start = hole.index(max(hole))
        p = hole[start]
        walls = [(w[j - 1], w[j]) for w in [ring] + loops[number:] for j in range(len(w))]
        near = sorted(range(len(ring)), key=lambda i: (math.dist(p, ring[i]), i))
        i = next(i for i in near if in_corner(ring, i, p)
                 and not any(blocks(p, ring[i], c, d) for c, d in walls))
        ring = ring[:i + 1] + hole[start:] + hole[:start + 1] + ring[i:]
    return ring


def ears(ring):
    """Cuts ears off a ring in its own order (nothing is optimised) and yields triangles."""
    ring, i, refused = list(ring), 0, 0
    while len(ring) > 3:
        n = len(ring)
        a, b, c = ring[i], ring[(i + 1) % n], ring[(i + 2) % n]
        if side(a, b, c) > 0 and not any(
                side(a, b, p) >= 0 and side(b, c, p) >= 0 and side(c, a, p) >= 0
                for p in ring if p not in (a, b, c)):
            yield a, b, c
            del ring[(i + 1) % n]
            i, refused = i - (i == n - 1), 0  # stay at a: fans of slivers around one corner
        else:
            i, refused = (i + 1) % n, refused + 1
            assert refused < n, "the ring is not a simple polygon"
    yield tuple(ring)


def flat(outer, holes, lift, up):
    """Meshes a planar face; lift maps the plane to space, up tells which side is outside."""
    for a, b, c in ears(bridged(outer, holes)):
        triangles.append([vertex(lift(p)) for p in ((a, b, c) if up else (a, c, b))])


def wall(loop, low, high, skip=()):
    """Strip between two lifts of a counterclockwise loop; swapped lifts turn it inside out."""
    for i, p in enumerate(loop):
        q = loop[(i + 1) % len(loop)]
        if (p, q) not in skip:
            a, b, c, d = (vertex(x) for x in (low(p), low(q), high(q), high(p)))
            triangles.extend(([a, b, c], [a, c, d]))


def at_x(x): return lambda p: (GRID * x, p[0], p[1])
def at_y(y): return lambda p: (p[1], GRID * y, p[0])
def at_z(z): return lambda p: (p[0], p[1], GRID * z)
def mm(*loop): return [(GRID * u, GRID * v) for u, v in loop]


def build():
    # The profile in the plane (z, x), counterclockwise: two plates 10 mm thick, fillets 12 and 22.
    inner, outer = circle(22, 22, 12, 64)[32:49], circle(22, 22, 22, 64)[32:49]
    profile = outer + mm((80, 0), (80, 10)) + inner[::-1] + mm((10, 120), (0, 120))
    starts = mm((22, 0), (80, 10), (10, 22), (0, 120))
    ends = mm((80, 0), (22, 10), (10, 120), (0, 22))
    wall(profile, at_y(0), at_y(80), {*zip(starts, ends)})
    flat(profile, [], at_y(0), False)
    flat(profile, [], at_y(80), True)
    # The base: four bolt holes, twelve pin holes on an integer circle, and a boss with a bore.
    bolts = [circle(x, y, 4, 64) for x in (34, 108) for y in (12, 68)]
    pins = [circle(71 + x, 40 + y, 1.5, 24) for x in range(-20, 21) for y in range(-20, 21)
            if x * x + y * y == 400]
    boss, bore = circle(71, 40, 14, 128), circle(71, 40, 6, 96)
    plate = mm((22, 0), (120, 0), (120, 80), (22, 80))
    flat(plate, bolts + pins + [boss], at_z(10), True)
    flat(plate, bolts + pins + [bore], at_z(0), False)
    flat(boss, [bore], at_z(26), True)
    wall(boss, at_z(10), at_z(26))
    for loop, top in [(h, 10) for h in bolts + pins] + [(bore, 26)]:
        wall(loop, at_z(top), at_z(0))
    # The upright: six counterbored holes.
    centres = [(y, z) for y in (12, 40, 68) for z in (36, 66)]
    wide, narrow = ([circle(y, z, r, 64) for y, z in centres] for r in (7, 4))
    plate = mm((0, 22), (80, 22), (80, 80), (0, 80))
    flat(plate, wide, at_x(10), True)
    flat(plate, narrow, at_x(0), False)
    for big, small in zip(wide, narrow):
        flat(big, [small], at_x(6), True)
        wall(big, at_x(10), at_x(6))
        wall(small, at_x(6), at_x(0))


build()
sys.stdout.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
sys.stdout.writelines("%.17g %.17g %.17g\n" % tuple(c / GRID for c in p) for p in points)
sys.stdout.writelines("3 %d %d %d\n" % tuple(t) for t in triangles)
