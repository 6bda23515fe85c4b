#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes `conformal_maps.png` beside itself, surfaces with a checkerboard and their layouts in the
plane: make_conformal_figures.py PATH_OF_intrinsic MESHES, where MESHES is the directory of CGAL's
data set. Needs only Python 3."""
import math
import os
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from make_map_figures import RED, SIZE, Picture, fit, light_of, middle, read_obj, seen

HERE = os.path.dirname(os.path.abspath(__file__))
LIGHT, DARK = (250, 246, 236), (84, 124, 168)
SQUARES = 40  # along the longer side of a layout


def clipped(corners, k, least):
    """The parts of a polygon of corners (eye, plane, place) on both sides of place[k] = least."""
    parts = [], []
    for p, q in zip(corners, corners[1:] + corners[:1]):
        x, y = p[2][k] - least, q[2][k] - least
        parts[x >= 0].append(p)
        if (x < 0) != (y < 0):
            cut = [[v + x / (x - y) * (w - v) for v, w in zip(s, t)] for s, t in zip(p, q)]
            parts[0].append(cut)
            parts[1].append(cut)
    return parts


def squares(corners, size):
    """The parts of a polygon in the squares of a checkerboard, each with its colour."""
    column = math.floor(min(c[2][0] for c in corners) / size)
    while len(corners) > 2:
        column += 1
        strip, corners = clipped(corners, 0, column * size)
        row = math.floor(min((c[2][1] for c in strip), default=0) / size)
        while len(strip) > 2:
            row += 1
            part, strip = clipped(strip, 1, row * size)
            if len(part) > 2:
                yield part, DARK if (column + row) % 2 else LIGHT


def draw(picture, file, left, turn, tilt):
    points, places, faces = read_obj(file)
    places = [(u, -v) for u, v in places]
    square = max(max(p[k] for p in places) - min(p[k] for p in places) for k in (0, 1)) / SQUARES
    eye = seen(points, turn, tilt)
    panel, plane = fit(eye, left), fit(places, left + SIZE)
    other = {}  # places at the ends of an edge, in the face on the other side
    for face in faces:
        for (v, s), (w, t) in zip(face, face[1:] + face[:1]):
            other[w, v] = (t, s)
    for face in sorted(faces, key=lambda f: middle(eye, [v for v, _ in f])[2]):
        light = light_of(eye, [v for v, _ in face])
        for part, shade in squares([[panel[v], plane[c], places[c]] for v, c in face], square):
            picture.polygon([p[1] for p in part], shade)
            if light > 0:
                picture.polygon([p[0] for p in part],
                                [round(s * (0.5 + 0.5 * light)) for s in shade])
        for (v, s), (w, t) in zip(face, face[1:] + face[:1]):
            if other.get((v, w)) != (s, t):
                picture.line(plane[s], plane[t], RED, 1)
                if light > 0 and (v, w) in other:
                    picture.line(panel[v], panel[w], RED, 1.5)


def main():
    intrinsic, meshes = map(os.path.abspath, sys.argv[1:3])
    picture = Picture(4 * SIZE, SIZE)
    with tempfile.TemporaryDirectory() as scratch:
        file = os.path.join(scratch, "map.obj")
        for i, (command, turn, tilt) in enumerate([
                (("uniformize", "elephant.off", "--cones", "8"), -10, 75),
                (("parametrize", "lion-head.off", "--method", "conformal"), 0, 90)]):
            subprocess.run([intrinsic, command[0], os.path.join(meshes, command[1]), *command[2:],
                            "-o", file], check=True)
            draw(picture, file, 2 * i * SIZE, turn, tilt)
    picture.write(os.path.join(HERE, "conformal_maps.png"))


if __name__ == "__main__":
    main()
