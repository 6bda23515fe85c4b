# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The meshes of the figures, as OFF files."""
import contextlib
import io
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                "../../../examples/data"))
sys.dont_write_bytecode = True
with contextlib.redirect_stdout(io.StringIO()):
    import make_part as cad  # its functions mesh a part as CAD exporters do it


def write_off(file, points, triangles):
    with open(file, "w", encoding="ascii") as out:
        out.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
        out.writelines("%.17g %.17g %.17g\n" % tuple(p) for p in points)
        out.writelines("3 %d %d %d\n" % tuple(t) for t in triangles)


def write_block(file, holes):
    """A block of 60 x 40 x 14 with holes (centre, radius, segments); planar faces are ear-clipped."""
    for container in (cad.points, cad.triangles, cad.vertex_of):
        container.clear()
    outer = cad.mm((0, 0), (60, 0), (60, 40), (0, 40))
    circles = [cad.circle(*h) for h in holes]
    cad.flat(outer, circles, cad.at_z(14), True)
    cad.flat(outer, circles, cad.at_z(0), False)
    cad.wall(outer, cad.at_z(0), cad.at_z(14))
    for c in circles:
        cad.wall(c, cad.at_z(14), cad.at_z(0))
    write_off(file, [[c / cad.GRID for c in p] for p in cad.points], cad.triangles)


def write_sheared_torus(file, n=16, k=12, shift=3, radius=0.4):
    """An uneven torus, each of whose n rings of k vertices is joined to the next with a shift."""
    def point(u, v):
        a = 2 * math.pi * u / n + 0.09 * math.sin(5 * v + 2 * u)
        b = 2 * math.pi * v / k + 0.13 * math.sin(7 * u + 3 * v)
        r = 1 + radius * math.cos(b)
        return r * math.cos(a), r * math.sin(a), radius * math.sin(b)

    triangles = []
    for u in range(n):
        for v in range(k):
            a, d = u * k + v, u * k + (v + 1) % k
            b, c = ((u + 1) % n * k + (v + shift + x) % k for x in (0, 1))
            triangles += [(a, b, c), (a, c, d)]
    write_off(file, [point(u, v) for u in range(n) for v in range(k)], triangles)
