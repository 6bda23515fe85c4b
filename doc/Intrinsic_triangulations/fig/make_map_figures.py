#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes `cut_maps.png`, surfaces that are cut open and their maps to a disk, beside itself:
make_map_figures.py PATH_OF_intrinsic MESHES, where MESHES is the directory of CGAL's data set.
Needs only Python 3."""
import math
import os
import struct
import subprocess
import sys
import tempfile
import zlib

sys.dont_write_bytecode = True
from meshes import write_sheared_torus

HERE = os.path.dirname(os.path.abspath(__file__))
SIZE = 250  # pixels of a panel
FINE = 3  # pixels that are painted for one of the picture, in either direction
RED = (179, 38, 30)


def read_obj(file):
    """Positions, places in the plane, and faces of pairs of both."""
    points, places, faces = [], [], []
    with open(file, encoding="ascii") as lines:
        for kind, *words in filter(None, map(str.split, lines)):
            if kind == "f":
                faces.append([tuple(int(i) - 1 for i in w.split("/")) for w in words])
            elif kind in ("v", "vt"):
                (points if kind == "v" else places).append([float(x) for x in words])
    return points, places, faces


def seen(points, turn, tilt):
    """To the right, downwards, and towards the eye; z is up, angles are in degrees."""
    a, b = math.radians(turn), math.radians(tilt)
    result = []
    for x, y, z in points:
        right, back = x * math.cos(a) + y * math.sin(a), -x * math.sin(a) + y * math.cos(a)
        result.append((right, -(z * math.cos(b) + back * math.sin(b)),
                       z * math.sin(b) - back * math.cos(b)))
    return result


class Picture:
    """Polygons and lines, later ones in front."""

    def __init__(self, width, height):
        self.size = (width * FINE, height * FINE)
        self.rows = [bytearray(b"\xff" * (3 * self.size[0])) for _ in range(self.size[1])]

    def polygon(self, points, shade):
        points = [(x * FINE, y * FINE) for x, y in points]
        for y in range(max(0, math.ceil(min(p[1] for p in points) - 0.5)), self.size[1]):
            cuts = sorted(a[0] + (y + 0.5 - a[1]) * (b[0] - a[0]) / (b[1] - a[1])
                          for a, b in zip(points, points[1:] + points[:1])
                          if (a[1] <= y + 0.5) != (b[1] <= y + 0.5))
            if not cuts:
                break
            for left, right in zip(cuts[::2], cuts[1::2]):
                begin, end = max(0, math.floor(left)), min(self.size[0], math.ceil(right))
                self.rows[y][3 * begin:3 * end] = bytes(shade) * max(0, end - begin)

    def line(self, a, b, shade, width):
        length = math.hypot(b[0] - a[0], b[1] - a[1]) or 1
        x, y = (width / 2 * (b[k] - a[k]) / length for k in (0, 1))
        self.polygon([(a[0] - x + y, a[1] - y - x), (b[0] + x + y, b[1] + y - x),
                      (b[0] + x - y, b[1] + y + x), (a[0] - x - y, a[1] - y + x)], shade)

    def write(self, file):
        width, height = (n // FINE for n in self.size)
        data = bytearray()
        for y in range(height):
            data.append(0)
            rows = self.rows[FINE * y:FINE * (y + 1)]
            for x in range(width):
                for k in range(3):
                    total = sum(sum(row[3 * FINE * x + k:3 * FINE * (x + 1):3]) for row in rows)
                    data.append(min(255, 4 * round(total / FINE ** 2 / 4)))
        with open(file, "wb") as out:
            out.write(b"\x89PNG\r\n\x1a\n")
            for kind, part in ((b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)),
                               (b"IDAT", zlib.compress(bytes(data), 9)), (b"IEND", b"")):
                out.write(struct.pack(">I", len(part)) + kind + part +
                          struct.pack(">I", zlib.crc32(kind + part)))


def color(place):
    """The hue goes around the disk, and colours are pale in the middle."""
    u, v = place
    hue, pale = math.atan2(v, u), 1 - min(1, math.hypot(u, v))
    shades = [200 + 47 * math.cos(hue - k * 2 * math.pi / 3) for k in range(3)]
    return [min(255, round(c + pale * (250 - c))) for c in shades]


def middle(points, corners):
    return [sum(points[c][k] for c in corners) / len(corners) for k in range(len(points[0]))]


def fit(points, left):
    """Into a panel."""
    low = [min(p[k] for p in points) for k in (0, 1)]
    high = [max(p[k] for p in points) for k in (0, 1)]
    scale = (SIZE - 16) / max(high[0] - low[0], high[1] - low[1])
    return [(left + SIZE / 2 + scale * (p[0] - (low[0] + high[0]) / 2),
             SIZE / 2 + scale * (p[1] - (low[1] + high[1]) / 2)) for p in points]


def light_of(points, corners):
    """How much a face is turned to the eye; negative if it is turned away."""
    a, b, c = (points[v] for v in corners[:3])
    p, q = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
    n = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
    return -n[2] / max(math.hypot(*n), 1e-30)


def painted_by_place(corners, _):
    yield corners, color(middle([c[2] for c in corners], range(len(corners))))


def draw(picture, file, left, turn, tilt, painted=painted_by_place, width=1.5):
    """Draws a surface, and its map beside it. `painted(corners, size)` yields the parts of a face
    with their colours: polygons of corners (eye, plane, place), `size` being that of the map."""
    points, places, faces = read_obj(file)
    places = [(u, -v) for u, v in places]
    size = max(max(p[k] for p in places) - min(p[k] for p in places) for k in (0, 1))
    eye = seen(points, turn, tilt)
    panel, plane = fit(eye, left), fit(places, left + SIZE)
    other = {}  # places at the ends of an edge, in the face on the other side
    for face in faces:
        for (v, s), (w, t) in zip(face, face[1:] + face[:1]):
            other[w, v] = (t, s)
    for face in sorted(faces, key=lambda f: middle(eye, [v for v, _ in f])[2]):
        light = light_of(eye, [v for v, _ in face])
        for part, shade in painted([[panel[v], plane[c], places[c]] for v, c in face], size):
            picture.polygon([p[1] for p in part], shade)
            if light > 0:
                picture.polygon([p[0] for p in part],
                                [round(s * (0.5 + 0.5 * light)) for s in shade])
        for (v, s), (w, t) in zip(face, face[1:] + face[:1]):
            if other.get((v, w)) != (s, t):
                picture.line(plane[s], plane[t], RED, width)
                if light > 0 and (v, w) in other:
                    picture.line(panel[v], panel[w], RED, width + 0.5)


def main():
    intrinsic, meshes = map(os.path.abspath, sys.argv[1:3])
    picture = Picture(4 * SIZE, SIZE)
    with tempfile.TemporaryDirectory() as scratch:
        torus, file = os.path.join(scratch, "torus.off"), os.path.join(scratch, "map.obj")
        write_sheared_torus(torus, 32, 24)
        for i, (mesh, turn, tilt) in enumerate([(torus, 20, 40),
                                                (os.path.join(meshes, "elephant.off"), -10, 75)]):
            subprocess.run([intrinsic, "parametrize", mesh, "--on", "input", "-o", file],
                           check=True)
            draw(picture, file, 2 * i * SIZE, turn, tilt)
    picture.write(os.path.join(HERE, "cut_maps.png"))


if __name__ == "__main__":
    main()
