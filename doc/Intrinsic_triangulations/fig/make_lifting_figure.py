#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes `lifting.svg` beside itself from the output of the example `lift_to_light_cone`:
make_lifting_figure.py FILE. Needs only Python 3."""
import math
import os
import sys

sys.dont_write_bytecode = True
from drawing import BLUE, GREY, INK, RED, Drawing

HERE = os.path.dirname(os.path.abspath(__file__))
SIZE, MOST, TILT = 165, 7, math.radians(52)  # of a panel; the greatest time; of the view


def seen(p):
    """The place in the left panel of a point of space-time, and how near it is."""
    x, y, t = (c * SIZE / MOST for c in p)
    return (175 + x, 330 - math.sin(TILT) * y - math.cos(TILT) * 1.35 * t), -y


def flat(p):
    """The place in the right panel: Klein's disk, seen from the origin."""
    return 540 + SIZE * p[0] / p[2], 190 - SIZE * p[1] / p[2]


def clipped(corners):
    """The part of a triangle up to the greatest time."""
    part = []
    for p, q in zip(corners, [*corners[1:], corners[0]]):
        if p[2] <= MOST:
            part.append(p)
        if (p[2] <= MOST) != (q[2] <= MOST):
            s = (MOST - p[2]) / (q[2] - p[2])
            part.append(tuple(a + s * (b - a) for a, b in zip(p, q)))
    return part


def shade(corners):
    """Lighter where the triangle is higher."""
    height = min(1, sum(p[2] for p in corners) / 3 / (3 * MOST))
    return "#%02x%02x%02x" % tuple(round(a + (b - a) * height)
                                   for a, b in zip((84, 140, 200), (236, 243, 250)))


def circle(place, steps=180):
    return [place((math.cos(a), math.sin(a)))
            for a in (2 * math.pi * i / steps for i in range(steps + 1))]


def cone(drawing):
    rim = circle(lambda c: seen((MOST * c[0], MOST * c[1], MOST))[0])
    tip, sides = seen((0, 0, 0))[0], (min(rim), max(rim))
    drawing.polygons([[sides[0], tip, sides[1]], rim], "#f4f8fc")
    drawing.lines([[sides[0], tip, sides[1]]], GREY)
    drawing.lines([rim], GREY, 1, "12 12")


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        points = [tuple(map(float, line.split())) for line in file]
    triangles = [points[i:i + 3] for i in range(0, len(points), 3)]
    drawing = Drawing(720, 390)
    cone(drawing)
    low = [(f, part) for f in triangles if len(part := clipped(f)) > 2]
    # the far ones first
    for corners, part in sorted(low, key=lambda f: sum(seen(p)[1] for p in f[1]) / len(f[1])):
        drawing.polygons([[seen(p)[0] for p in part]], shade(corners), INK, 0.5)
    for corners in triangles:
        drawing.polygons([[flat(p) for p in corners]], shade(corners), INK, 0.5)
    first = triangles[0]
    for place in (lambda p: seen(p)[0], flat):
        drawing.lines([[place(p) for p in (*first, first[0])]], RED, 2)
    drawing.lines([circle(lambda c: (540 + SIZE * c[0], 190 - SIZE * c[1]))], BLUE, 1.2)
    drawing.text(175, 375, "lifted triangles on the light cone", 13)
    drawing.text(540, 375, "the same, seen from the origin", 13)
    drawing.write(os.path.join(HERE, "lifting.svg"))


if __name__ == "__main__":
    main()
