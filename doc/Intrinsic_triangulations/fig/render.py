# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws triangles and lines in space with a depth buffer: what is behind is hidden. Needs numpy, matplotlib and PIL."""
import numpy
from matplotlib import colormaps
from PIL import Image

FINE = 3  # pixels that are computed for one that is drawn, in either direction
BACKGROUND = 1.0


def read_off(file):
    """Points and triangles of a file that has nothing else."""
    with open(file, encoding="ascii") as f:
        words = " ".join(line.split("#")[0] for line in f).split()[1:]
    vertices, faces = int(words[0]), int(words[1])
    points = numpy.array(words[3:3 + 3 * vertices], float).reshape(-1, 3)
    rows = numpy.array(words[3 + 3 * vertices:3 + 3 * vertices + 4 * faces], int).reshape(-1, 4)
    return points, rows[:, 1:]


def read_lines(file):
    """Polylines of an OBJ file as `geodesics` writes them: lines of two points each."""
    points, lines = [], []
    with open(file, encoding="ascii") as f:
        for kind, *values in map(str.split, f):
            if kind == "v":
                points.append([float(x) for x in values])
            else:
                lines.append([points[int(i)] for i in values])
    return numpy.array(lines)


def rotation(turn, tilt):
    """Rows are right, up and towards the eye; z is up, angles are in degrees."""
    t, s = numpy.radians(turn), numpy.radians(tilt)
    right = numpy.array([numpy.cos(t), numpy.sin(t), 0])
    up = numpy.array([-numpy.sin(t) * numpy.sin(s), numpy.cos(t) * numpy.sin(s), numpy.cos(s)])
    return numpy.array([right, up, numpy.cross(right, up)])


class Picture:
    """A picture of what fits `points`."""

    def __init__(self, points, axes, width):
        seen = points @ axes.T
        low, high = seen.min(0), seen.max(0)
        self.axes, self.low, self.margin = axes, low, 4 * FINE
        self.scale = (width * FINE - 2 * self.margin) / (high - low)[0]
        height = int((high - low)[1] * self.scale + 2 * self.margin) // FINE
        self.color = numpy.full((height * FINE, width * FINE, 3), BACKGROUND)
        self.depth = numpy.full(self.color.shape[:2], -numpy.inf)

    def seen(self, points):
        """Pixels, downwards, and depth in pixels."""
        x, y, z = ((points @ self.axes.T - self.low) * self.scale).T
        return numpy.array([x + self.margin, self.color.shape[0] - self.margin - y, z]).T

    def triangles(self, points, faces, values, paint, edges=0.0):
        """Draws faces, lit from the eye. Values at vertices are interpolated, `paint` makes colours of them; edges are
        darker by a share."""
        at, light = self.seen(points), numpy.array([-0.35, 0.45, 0.82])
        for f in faces:
            n = numpy.cross(*(points[f[1:]] - points[f[0]])) @ self.axes.T
            if n[2] > 0:
                shade = 0.55 + 0.45 * max(0, n @ light / numpy.linalg.norm(n))
                self.triangle(at[f], lambda w, v=values[f], s=shade: s * paint(w @ v), edges)

    def triangle(self, p, paint, edges):
        x0, y0 = numpy.floor(p[:, :2].min(0)).astype(int)
        x1, y1 = numpy.ceil(p[:, :2].max(0)).astype(int) + 1
        x, y = numpy.meshgrid(numpy.arange(x0, x1) + 0.5, numpy.arange(y0, y1) + 0.5)
        (ax, ay), (bx, by) = p[1, :2] - p[0, :2], p[2, :2] - p[0, :2]
        area = ax * by - ay * bx
        if area == 0:
            return
        v = ((x - p[0, 0]) * by - (y - p[0, 1]) * bx) / area
        w = ((y - p[0, 1]) * ax - (x - p[0, 0]) * ay) / area
        weights = numpy.stack([1 - v - w, v, w], -1)
        depth = weights @ p[:, 2]
        window = numpy.s_[y0:y1, x0:x1]
        inside = (weights >= -1e-9).all(-1) & (depth > self.depth[window])
        color = paint(weights)
        if edges:
            lengths = numpy.linalg.norm(p[[2, 0, 1], :2] - p[[1, 2, 0], :2], axis=1)
            near = (weights * abs(area) / lengths).min(-1) < 0.25 * FINE
            color = numpy.where(near[..., None], color * (1 - edges), color)
        self.color[window][inside], self.depth[window][inside] = color[inside], depth[inside]

    def lines(self, lines, color, width):
        """Draws segments, pairs of points, where no face is before them."""
        radius = width * FINE / 2
        disc = numpy.arange(-int(radius), int(radius) + 1)
        offsets = [(i, j) for i in disc for j in disc if i * i + j * j <= radius * radius]
        for a, b in lines:
            a, b = self.seen(numpy.array([a, b]))
            steps = int(numpy.abs(b - a).max()) + 2
            for x, y, z in a + numpy.linspace(0, 1, steps)[:, None] * (b - a):
                i, j = int(y), int(x)
                if z > self.depth[i, j] - 2 * FINE:
                    for k, l in offsets:
                        self.color[i + k, j + l] = color

    def write(self, file):
        h, w = self.color.shape[:2]
        small = self.color.reshape(h // FINE, FINE, w // FINE, FINE, 3).mean((1, 3))
        image = Image.fromarray((255 * small.clip(0, 1)).round().astype("uint8"))
        image.quantize(96).save(file, optimize=True)


def grey(values):
    return numpy.repeat(values[..., None], 3, -1)


def bands(values, number=20):
    """Viridis, in which equal steps look equal, in bands: their borders are level lines."""
    return colormaps["viridis"](numpy.floor(values * number).clip(0, number - 1) / (number - 1))[..., :3]
