#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the figures of the manual that are SVG, beside itself: make_figures.py PATH_OF_intrinsic"""
import math
import os
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from drawing import BLUE, Drawing
from meshes import write_block, write_sheared_torus
from subdivision import Surface, View
import schematics

HERE = os.path.dirname(os.path.abspath(__file__))
HOLES = [(17, 15, 9, 24), (44, 25, 6, 16)]  # centre, radius, segments
ONE_HOLE = [(22, 19, 11, 8)]
FACE = (222, 226, 232)


def is_outside(holes):
    """Layers of faces by their centres: walls of holes are drawn first."""
    return lambda p: all(math.hypot(p[0] - x, p[1] - y) > r + 1e-6 for x, y, r, _ in holes)


def pale(face):
    return [round(0.62 * face[c] + 0.38 * 255) for c in ("red", "green", "blue")]


INPUT = ("input_edge", {"stroke": "#333", "width": 0.7})
INTRINSIC = ("intrinsic_edge", {"stroke": "#111", "width": 1.1})
BLUE_INPUT = ("input_edge", {"stroke": BLUE, "width": 0.9})
THIN = ("input_edge", {"stroke": "#fff", "width": 0.6})


def draw_crossings(drawing, surface, view):
    """Crossings on faces that are seen."""
    corners = {v for f, at in zip(surface.faces, surface.layers)
               if at and sum(a * b for a, b in zip(surface.normal(f), view.back)) > 1e-9
               for v in f["vertex_indices"]}
    for kind, fill in ((2, "#fff"), (0, "#222")):
        drawing.dots([view(surface.points[v]) for v in sorted(corners)
                      if surface.vertices[v]["kind"] == kind], 2.2, fill, "#222")


def panels(file, rows, size=330, crossings=False):
    """Draws views of surfaces side by side, with captions."""
    drawing = Drawing(size * len(rows), round(size * 0.865))
    for i, (surface, colour, strokes, caption) in enumerate(rows):
        view = View(-32, 48, size / 78.5, (size * (i + 0.312), size * 0.77))
        surface.draw(drawing, view, colour, strokes)
        if crossings and i == len(rows) - 1:
            draw_crossings(drawing, surface, view)
        drawing.text(size * (i + 0.5), size * 0.84, caption, 14)
    drawing.write(os.path.join(HERE, file))


def main():
    intrinsic = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as scratch:
        mesh, file = os.path.join(scratch, "in.off"), os.path.join(scratch, "out.ply")

        def run(command, holes):
            if holes:
                write_block(mesh, holes)
            else:
                write_sheared_torus(mesh)
            subprocess.run([intrinsic, command, mesh, "-o", file], check=True)
            return Surface(file, is_outside(holes))

        delaunay, coarse = run("delaunay", HOLES), run("delaunay", ONE_HOLE)
        refined, torus = run("refine", HOLES), run("delaunay", [])
    panels("delaunay.svg", [
        (delaunay, lambda f: FACE, [INPUT], "the mesh"),
        (delaunay, pale, [THIN, INTRINSIC], "its intrinsic Delaunay triangulation")])
    panels("common_subdivision.svg", [
        (coarse, lambda f: FACE, [INPUT], "the mesh"),
        (coarse, pale, [INTRINSIC], "intrinsic Delaunay"),
        (coarse, lambda f: (246, 246, 246), [BLUE_INPUT, INTRINSIC], "common subdivision")],
        260, crossings=True)
    panels("refinement.svg", [
        (refined, pale, [("intrinsic_edge", {"stroke": "#111", "width": 0.6})],
         "angles of at least 30 degrees")])
    schematics.draw_all(HERE, torus)


if __name__ == "__main__":
    main()
