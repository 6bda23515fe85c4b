#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes pictures of geodesic curves, beside itself: make_curve_pictures.py PATH_OF_intrinsic MESHES

MESHES is the directory of CGAL's data set.
"""
import collections
import os
import subprocess
import sys
import tempfile

import numpy

sys.dont_write_bytecode = True
import render

HERE = os.path.dirname(os.path.abspath(__file__))
RED, BLUE, WIDTH = (0.70, 0.15, 0.12), (0.15, 0.30, 0.60), 380


def tree(start, neighbours):
    """The parents in a tree of shortest ways, in number of steps."""
    parent, queue = {start: None}, collections.deque([start])
    while queue:
        v = queue.popleft()
        for w in neighbours(v):
            if w not in parent:
                parent[w] = v
                queue.append(w)
    return parent


def way(parent, v):
    """From v to the root."""
    result = [v]
    while parent[result[-1]] is not None:
        result.append(parent[result[-1]])
    return result


def tree_and_cotree(faces, root):
    """A tree of vertices, and the edges that neither it nor a tree of faces has: two for each handle."""
    sides = collections.defaultdict(list)
    around = collections.defaultdict(list)
    for f, corners in enumerate(faces):
        for a, b in zip(corners, numpy.roll(corners, -1)):
            sides[frozenset((a, b))].append(f)
            around[a].append(b)
    parent = tree(root, around.__getitem__)
    used = {frozenset(pair) for pair in parent.items() if pair[1] is not None}
    edges_of = collections.defaultdict(list)
    for e, (f, g) in sides.items():
        if e not in used:
            edges_of[f].append((g, e))
            edges_of[g].append((f, e))
    over = tree(0, lambda f: [g for g, _ in edges_of[f]])
    crossed = set()
    for f, g in over.items():
        if g is not None:
            crossed.add(next(e for h, e in edges_of[f] if h == g))
    return parent, [tuple(e) for e in sides if e not in used and e not in crossed]


def closed_ways(faces, root):
    """Closed curves that generate the fundamental group, without the way from the root and back to it."""
    parent, edges = tree_and_cotree(faces, root)
    for a, b in edges:
        p, q = way(parent, a), way(parent, b)
        while len(p) > 1 and len(q) > 1 and p[-2] == q[-2]:
            p.pop()
            q.pop()
        yield p[::-1] + q[:-1]


def curves(program, mesh, options, scratch):
    """Points of the curves that the program writes, in pairs."""
    out = os.path.join(scratch, "curves.obj")
    subprocess.run([program, "geodesic", mesh, *options, "-o", out], check=True)
    points, pairs = [], []
    with open(out, encoding="ascii") as f:
        for kind, *values in map(str.split, f):
            if kind == "v":
                points.append([float(x) for x in values])
            elif kind == "l":
                pairs += [(int(a) - 1, int(b) - 1) for a, b in zip(values, values[1:])]
    points = numpy.array(points)
    return [(points[a], points[b]) for a, b in pairs]


class Drawing:
    def __init__(self, mesh, axes):
        self.points, self.faces = render.read_off(mesh)
        self.picture = render.Picture(self.points, axes, WIDTH)
        self.picture.triangles(self.points, self.faces, numpy.full(len(self.points), 0.88),
                               render.grey, 0.12)

    def add(self, lines, color, width=1.5):
        self.picture.lines(lines, color, width)

    def write(self, name):
        self.picture.write(os.path.join(HERE, name + ".png"))


def draw_loops(program, mesh, axes, scratch):
    """Closed geodesics in many classes: shortened from generators of the fundamental group at several roots."""
    drawing = Drawing(mesh, axes)
    count = len(drawing.points)
    for root in range(0, count, count // 6):
        for loop in closed_ways(drawing.faces, root):
            file = os.path.join(scratch, "loop.txt")
            with open(file, "w", encoding="ascii") as f:
                f.write("loop " + " ".join(map(str, loop)) + "\n")
            drawing.add(curves(program, mesh, ["--network", file], scratch), RED)
    drawing.write("geodesic_loops")


def draw_seams(program, mesh, axes, scratch):
    """A cut that makes a disk of the surface: as it is found along edges, and geodesic."""
    drawing = Drawing(mesh, axes)
    parent, edges = tree_and_cotree(drawing.faces, 0)
    marked = {frozenset(e) for e in edges}
    for e in edges:
        for v in e:
            line = way(parent, v)
            marked |= {frozenset(pair) for pair in zip(line, line[1:])}
    degree = collections.Counter(v for e in marked for v in e)
    while ends := [e for e in marked if any(degree[v] == 1 for v in e)]:  # twigs cut nothing
        for e in ends:
            marked.remove(e)
            degree.subtract(e)
    file = os.path.join(scratch, "marked.txt")
    with open(file, "w", encoding="ascii") as f:
        f.writelines("%d %d\n" % tuple(e) for e in marked)
    for name, stop in (("seams_before", ["--shorten-to", "1"]), ("seams_after", [])):
        picture = Drawing(mesh, axes)
        picture.add(curves(program, mesh, ["--marked", file, *stop], scratch), RED, 2)
        picture.write(name)


def draw_bezier(program, mesh, axes, controls, scratch):
    """A Bezier curve and the geodesics between its control points."""
    drawing = Drawing(mesh, axes)
    names = ",".join(map(str, controls))
    drawing.add(curves(program, mesh, ["--path", names, "--waypoints"], scratch), BLUE, 0.9)
    drawing.add(curves(program, mesh, ["--bezier", names], scratch), RED, 2)
    drawing.write("bezier_curve")


def draw_flow(program, mesh, axes, stations, scratch):
    """A zigzag that gets shorter and shorter (Figure 37 of the course)."""
    drawing = Drawing(mesh, axes)
    names = ",".join(map(str, stations))
    shares = (1, 0.9, 0.8, 0.7, 0.6, 0)
    for i, share in enumerate(shares):
        t = i / (len(shares) - 1)
        color = tuple((1 - t) * a + t * b for a, b in zip(BLUE, RED))
        stop = ["--shorten-to", str(share)] if share else []
        drawing.add(curves(program, mesh, ["--path", names, *stop], scratch), color, 1.1)
    drawing.write("shortening_flow")


def nearest(mesh, axes, places):
    """Vertices that are seen at shares of the width and height of the model, nearest to the eye."""
    points, _ = render.read_off(mesh)
    seen = points @ axes.T
    low, size = seen.min(0), numpy.ptp(seen, axis=0)
    result = []
    for x, y in places:
        off = numpy.hypot(*(seen[:, :2] - low[:2] - size[:2] * (x, y)).T) / size[:2].max()
        result.append(int((off - 0.3 * (seen[:, 2] - low[2]) / size[:2].max()).argmin()))
    return result


def main():
    program, meshes = (os.path.abspath(path) for path in sys.argv[1:3])
    eight, elephant = (os.path.join(meshes, name) for name in ("eight.off", "elephant.off"))
    right, up, back = render.rotation(30, 20)
    lying = numpy.array([-up, right, back])  # the model stands: it is laid down
    side = numpy.array([[0.8, 0, 0.6], [0.1, 0.98, -0.13], [-0.6, 0.16, 0.79]])
    with tempfile.TemporaryDirectory() as scratch:
        draw_loops(program, elephant, side, scratch)
        draw_seams(program, eight, lying, scratch)
        draw_bezier(program, eight, lying,
                    nearest(eight, lying, [(0.05, 0.3), (0.3, 0.95), (0.6, 0.05), (0.95, 0.7)]), scratch)
        draw_flow(program, elephant, side,
                  nearest(elephant, side, [(0.82, 0.78), (0.7, 0.56), (0.78, 0.4), (0.57, 0.53), (0.62, 0.22),
                                           (0.42, 0.47), (0.45, 0.15), (0.25, 0.4)]), scratch)


if __name__ == "__main__":
    main()
