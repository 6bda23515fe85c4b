#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes `folded_strip.svg` beside itself, a thin strip of needles, flipped in doubles with a
tolerance and by `intrinsic`: make_folded_strip.py PATH_OF_intrinsic. Needs only Python 3."""
import os
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "..", "benchmark", "Intrinsic_operators"))
from drawing import INK, RED, Drawing
from thin_strip import Flat_triangulation, folded, strip

POWER, TOLERANCE, SEED = 9, 1e-5, 2


def exact_triangles(intrinsic, points, faces):
    """Those of the intrinsic Delaunay triangulation, by numbers of points."""
    with tempfile.TemporaryDirectory() as scratch:
        mesh, file = os.path.join(scratch, "in.off"), os.path.join(scratch, "out.idt")
        with open(mesh, "w", encoding="utf-8") as out:
            print("OFF", len(points), len(faces), 0, file=out)
            for p in points:
                print(*p, 0, file=out)
            for f in faces:
                print(3, *f, file=out)
        subprocess.run([intrinsic, "delaunay", mesh, "-o", file], check=True)
        with open(file, encoding="utf-8") as lines:
            rows = [line.split() for line in lines]

    def section(name):
        at = next(i for i, row in enumerate(rows) if row[0] == name)
        return rows[at + 1:at + 1 + int(rows[at][1])]
    name = [int(row[0]) for row in section("input_vertices")]
    return [[name[int(v)] for v in row[3:6]] for row in section("faces")]


def draw_strip(drawing, left, title, lattice, triangles):
    place = [(left + x * 0.026, 170 - y * 0.026) for x, y in lattice]
    corners = [[place[v] for v in t] for t in triangles]
    wrong = folded(lattice, triangles)
    drawing.polygons(corners, "#f7ead0", INK, 0.7)
    drawing.polygons([[place[v] for v in t] for t in wrong], RED, RED, 0.7)
    drawing.text(left + 156, 196, f"{title}: {len(wrong) or 'none'} folded", 14)


def draw_folded_strip(intrinsic):
    lattice, points, faces = strip(POWER, SEED)
    rounded = Flat_triangulation(points, faces)
    rounded.make_delaunay(TOLERANCE, 20000)
    drawing = Drawing(680, 210)
    draw_strip(drawing, 14, "doubles, tolerance 1e-5", lattice, rounded.triangles())
    draw_strip(drawing, 354, "exact decisions", lattice, exact_triangles(intrinsic, points, faces))
    drawing.write(os.path.join(HERE, "folded_strip.svg"))


def main():
    draw_folded_strip(os.path.abspath(sys.argv[1]))


if __name__ == "__main__":
    main()
