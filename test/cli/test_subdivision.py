# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The common subdivision that `intrinsic delaunay` writes: a mesh with the shape of the input."""

import math
import os
import random

from cli_support import Cli_test, main

KINDS = ("integer", "crossings", "signposts")


def read_off(path):
    """Points and faces of an OFF file; colours after the vertices of a face are left out."""
    with open(path) as file:
        rows = [line.split() for line in file if line.strip() and not line.startswith("#")]
    assert rows[0] == ["OFF"]
    vertices, faces = int(rows[1][0]), int(rows[1][1])
    points = [tuple(map(float, row)) for row in rows[2:2 + vertices]]
    return points, [[int(x) for x in row[1:1 + int(row[0])]]
                    for row in rows[2 + vertices:2 + vertices + faces]]


def area(points, faces):
    total = 0.0
    for f in faces:
        for b, c in zip(f[1:], f[2:]):
            u = [points[b][k] - points[f[0]][k] for k in range(3)]
            v = [points[c][k] - points[f[0]][k] for k in range(3)]
            total += math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                u[0] * v[1] - u[1] * v[0]) / 2
    return total


def sheared_torus(n, m, shift):
    """A torus whose rows are joined with a shift, so that most edges are not Delaunay."""
    points = [((1 + 0.35 * math.cos(2 * math.pi * j / m)) * math.cos(2 * math.pi * i / n),
               (1 + 0.35 * math.cos(2 * math.pi * j / m)) * math.sin(2 * math.pi * i / n),
               0.35 * math.sin(2 * math.pi * j / m)) for j in range(m) for i in range(n)]
    faces = []
    for j in range(m):
        for i in range(n):
            a, b = j * n + i, j * n + (i + 1) % n
            c, d = ((j + 1) % m * n + (i + k + shift) % n for k in (1, 0))
            faces += [(a, b, c), (a, c, d)]
    return points, faces


def rough_square(n):
    """A square of a height field, with a border; coordinates are from a fixed sequence."""
    numbers = random.Random(7)
    points = [(i + 0.4 * numbers.random(), 5 * j, numbers.random()) for j in range(n)
              for i in range(n)]
    faces = []
    for j in range(n - 1):
        for i in range(n - 1):
            a = j * n + i
            faces += [(a, a + 1, a + n + 1), (a, a + n + 1, a + n)]
    return points, faces


class Subdivision(Cli_test):
    def check(self, mesh, points, faces, euler):
        counts = []
        for kind in KINDS:
            stats = self.stats("delaunay", mesh, "--correspondence", kind, "-o", "out.off")
            self.assertEqual(stats["correspondence"], kind)
            s = stats["subdivision"]
            self.assertEqual(s["vertices"] - s["edges"] + s["faces"], euler)
            p, f = read_off(self.path("out.off"))
            self.assertEqual((len(p), len(f)), (s["vertices"], s["faces"]))
            self.assert_close(area(p, f), area(points, faces), 1e-12)
            # each directed side once: a manifold, oriented as the input is
            sides = [(a, b) for g in f for a, b in zip(g, g[1:] + g[:1])]
            self.assertEqual(len(sides), len(set(sides)))
            # its vertices are those of the input, in order, and then crossings
            self.assertEqual(p[:len(points)], [tuple(float(x) for x in q) for q in points])
            counts.append((s["vertices"], s["edges"], s["faces"]))
        self.assertEqual(len(set(counts)), 1)
        self.assertGreater(counts[0][0], len(points))

    def test_closed_surface(self):
        points, faces = sheared_torus(24, 12, 5)
        self.check(self.write_off("torus.off", points, faces), points, faces, 0)

    def test_surface_with_border(self):
        points, faces = rough_square(9)
        self.check(self.write_off("square.off", points, faces), points, faces, 1)

    def test_vertices_and_faces_are_labelled_with_the_polygons_of_the_file(self):
        # rows of hexagons, quadrilaterals and triangles, so that numbers of polygons and triangles
        # differ
        points = [(i, j, 0.2 * (i * j % 3)) for j in range(4) for i in range(13)]
        polygons = []
        for j in range(3):
            a = 13 * j
            for i in range(0, 12, 6):
                b = a + i
                polygons += [[b, b + 1, b + 2, b + 15, b + 14, b + 13],
                             [b + 2, b + 3, b + 16, b + 15],
                             [b + 3, b + 4, b + 16], [b + 4, b + 17, b + 16],
                             [b + 4, b + 5, b + 6, b + 19, b + 18, b + 17]]
        mesh = self.write_off("polygons.off", points, polygons)
        for options in ([], ["--arithmetic", "double"], ["--correspondence", "crossings"]):
            stats = self.stats("refine", mesh, "-o", "out.ply", "--max-edge-length", "0.8", *options)
            self.assertGreater(stats["refine"]["insertions"], 50)
            ply = self.read_ply("out.ply")
            vertices, faces = ply["vertex"], ply["face"]
            around = [set() for _ in vertices]
            for face in faces:
                self.assertLess(face["input_face"], len(polygons))
                for v in face["vertex_indices"]:
                    around[v].add(face["input_face"])
            # each polygon is covered by the faces with its number
            self.assertEqual({face["input_face"] for face in faces}, set(range(len(polygons))))
            for vertex, labels in zip(vertices, around):
                if vertex["kind"] == 2:
                    self.assertEqual(vertex["input_face"], -1)
                else:
                    self.assertIn(vertex["input_face"], labels)
                if vertex["kind"] == 0:  # a corner of the polygon
                    p = (vertex["x"], vertex["y"])
                    self.assertIn(p, {points[i][:2] for i in polygons[vertex["input_face"]]})

    def test_all_formats(self):
        mesh = self.write_off("torus.off", *sheared_torus(24, 12, 5))
        for extension in ("ply", "obj", "off", "stl", "vtp"):
            run = self.run_program("delaunay", mesh, "-o", "out." + extension, "--quiet")
            self.assertEqual((run.code, run.out, run.err), (0, "", ""))
            self.assertGreater(os.path.getsize(self.path("out." + extension)), 1000)


if __name__ == "__main__":
    main()
