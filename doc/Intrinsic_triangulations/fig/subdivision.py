# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads common subdivisions, as `intrinsic ... -o FILE.ply` writes them, and draws them in space."""
import math
import struct

TYPES = {"double": "d", "float": "f", "int": "i", "uint": "I", "uchar": "B"}


def read_ply(file):
    """Returns for each element a list of dictionaries from property to value."""
    with open(file, "rb") as f:
        elements, line = [], ""
        while line != "end_header":
            line = f.readline().decode().strip()
            words = line.split()
            if words[0] == "element":
                elements.append((words[1], int(words[2]), []))
            if words[0] == "property":
                elements[-1][2].append(words[1:])
        data, at, result = f.read(), 0, {}

        def take(kind):
            nonlocal at
            value, = struct.unpack_from("<" + TYPES[kind], data, at)
            at += struct.calcsize("<" + TYPES[kind])
            return value

        for name, count, properties in elements:
            result[name] = []
            for _ in range(count):
                row = {}
                for p in properties:
                    if p[0] == "list":
                        row[p[3]] = [take(p[2]) for _ in range(take(p[1]))]
                    else:
                        row[p[1]] = take(p[0])
                result[name].append(row)
        return result


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    n = math.sqrt(sum(x * x for x in a))
    return [x / n for x in a]


class View:
    """Parallel projection; `turn` about the vertical axis and `tilt` from above, in degrees."""

    def __init__(self, turn, tilt, scale, origin):
        t, s = math.radians(turn), math.radians(tilt)
        self.right = [math.cos(t), math.sin(t), 0]
        self.up = [-math.sin(t) * math.sin(s), math.cos(t) * math.sin(s), math.cos(s)]
        self.back = cross(self.right, self.up)  # towards the eye
        self.light = unit([b + 0.5 * u - 0.4 * r for b, u, r in zip(self.back, self.up, self.right)])
        self.scale, self.origin = scale, origin

    def __call__(self, p):
        x = sum(a * b for a, b in zip(self.right, p))
        y = sum(a * b for a, b in zip(self.up, p))
        return self.origin[0] + self.scale * x, self.origin[1] - self.scale * y


class Surface:
    """A common subdivision in space. Faces of later layers hide those of earlier ones."""

    def __init__(self, file, layer):
        ply = read_ply(file)
        self.vertices, self.faces, self.edges = ply["vertex"], ply["face"], ply["edge"]
        self.points = [(v["x"], v["y"], v["z"]) for v in self.vertices]
        self.layers = [self.layer_of(f, layer) for f in self.faces]
        self.sides = {}
        for i, f in enumerate(self.faces):
            c = f["vertex_indices"]
            for a, b in zip(c, c[1:] + c[:1]):
                self.sides.setdefault(frozenset((a, b)), []).append(i)

    def layer_of(self, face, layer):
        corners = [self.points[v] for v in face["vertex_indices"]]
        return layer([sum(c) / len(corners) for c in zip(*corners)])

    def normal(self, face):
        p = [self.points[v] for v in face["vertex_indices"]]
        n = [0, 0, 0]
        for a, b in zip(p[1:], p[2:]):
            n = [x + y for x, y in zip(n, cross([u - v for u, v in zip(a, p[0])],
                                                [u - v for u, v in zip(b, p[0])]))]
        return unit(n)

    def draw(self, drawing, view, colour, strokes):
        """`colour(face)` is red, green, blue; `strokes` are pairs of a label of edges and a style."""
        normals = [self.normal(f) for f in self.faces]
        front = [sum(a * b for a, b in zip(n, view.back)) > 1e-9 for n in normals]
        for layer in sorted(set(self.layers)):
            groups = {}
            for f, n, visible, at in zip(self.faces, normals, front, self.layers):
                if visible and at == layer:
                    light = 0.62 + 0.38 * max(0, sum(a * b for a, b in zip(n, view.light)))
                    shade = "#" + "".join(f"{round(c * light / 4) * 4:02x}" for c in colour(f))
                    groups.setdefault(shade, []).append(
                        [view(self.points[v]) for v in f["vertex_indices"]])
            for shade, polygons in groups.items():
                drawing.polygons(polygons, shade)
            for label, style in strokes:
                drawing.lines(self.visible_edges(view, label, layer, front), **style)

    def visible_edges(self, view, label, layer, front):
        lines = []
        for e in self.edges:
            ends = e["vertex1"], e["vertex2"]
            layers = [self.layers[i] for i in self.sides[frozenset(ends)] if front[i]]
            if e[label] >= 0 and layers and max(layers) == layer:
                lines.append([view(self.points[v]) for v in ends])
        return lines
