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
from make_map_figures import SIZE, Picture, draw

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
    """The parts of a polygon in the squares of a checkerboard, each with its colour; `size` is that
    of the board."""
    size /= SQUARES
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
            draw(picture, file, 2 * i * SIZE, turn, tilt, squares, 1)
    picture.write(os.path.join(HERE, "conformal_maps.png"))


if __name__ == "__main__":
    main()
