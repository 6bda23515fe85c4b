# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps of surfaces that are cut open."""

import math

from cli_support import Cli_test, grid, icosphere, main, read_obj, torus, triangles


class Parametrize(Cli_test):
    def seams(self, faces):
        """The edges whose corners have other places on the other side."""
        sides = {}
        for face in faces:
            for (v, s), (w, t) in zip(face, face[1:] + face[:1]):
                sides.setdefault((min(v, w), max(v, w)), []).append((s, t) if v < w else (t, s))
        self.assertTrue(all(len(s) == 2 for s in sides.values()))  # the surface is closed
        return [e for e, (s, t) in sides.items() if s != t]

    def check_map(self, points, faces, out, stats):
        """The file has the mesh, with these triangles if they are given, and places that turn each
        face counterclockwise. Returns the edges on the seams."""
        self.assertEqual(stats["input"]["vertices"], len(points))
        found, places, corners = read_obj(out)
        self.assertEqual(len(found), len(points))
        order = {tuple(round(x, 9) for x in p): i for i, p in enumerate(points)}
        number = [order[tuple(round(x, 9) for x in p)] for p in found]
        if faces:
            self.assertEqual(sorted(sorted(number[v] for v, _ in f) for f in corners),
                             sorted(map(sorted, faces)))
        areas = []
        for face in corners:
            (x, y), (z, w), (s, t) = (places[c] for _, c in face[:3])
            areas.append((z - x) * (t - y) - (w - y) * (s - x))
        if stats["parametrize"]["injective_on_input"]:
            self.assertGreater(min(areas), 0)
        seams = self.seams(corners)
        self.assertEqual(len(seams), stats["cut"]["edges"])
        self.assertEqual(len(places), stats["cut"]["vertices"])
        return [(number[v], number[w]) for v, w in seams]

    def test_closed_surfaces_are_cut_and_keep_their_faces(self):
        for points, faces in (icosphere(2), (torus(12, 8)[0], triangles(torus(12, 8)[1]))):
            mesh = self.write_off("m.off", points, faces)
            for method in ("harmonic", "lscm", "spectral"):
                stats = self.stats("parametrize", mesh, "--method", method, "--on", "input",
                                   "-o", "m.obj")
                if method == "harmonic":
                    self.assertTrue(stats["parametrize"]["injective"])
                self.check_map(points, faces, self.path("m.obj"), stats)

    def test_polygons_stay_whole(self):
        points, faces = torus(10, 6)
        mesh = self.write_off("m.off", points, faces)
        edges = {tuple(sorted(e)) for f in faces for e in zip(f, f[1:] + f[:1])}
        for more in ((), ("--polygons", "planar")):
            stats = self.stats("parametrize", mesh, "--on", "input", "-o", "m.obj", *more)
            cut = self.check_map(points, [], self.path("m.obj"), stats)
            self.assertLessEqual({tuple(sorted(e)) for e in cut}, edges)
        stats = self.stats("parametrize", mesh, "-o", "m.ply", "--view", "m.html")
        with open(self.path("m.ply"), "rb") as file:
            self.assertIn(b"property list uchar float texcoord", file.read(3000))
        self.stats("parametrize", mesh, "-o", "m.txt", "--on", "input")
        with open(self.path("m.txt"), encoding="ascii") as file:
            rows = [line.split() for line in file]
        self.assertEqual(len(rows), stats["cut"]["vertices"])
        self.assertEqual([int(float(r[2])) for r in rows[:len(points)]], list(range(len(points))))

    def test_a_cylinder_is_unrolled(self):
        n, m = 8, 5
        points = [(math.cos(2 * math.pi * x / n), math.sin(2 * math.pi * x / n), y)
                  for y in range(m) for x in range(n)]
        faces = [[n * y + x, n * y + (x + 1) % n, n * y + n + (x + 1) % n, n * y + n + x]
                 for y in range(m - 1) for x in range(n)]
        mesh = self.write_off("m.off", points, faces)
        stats = self.stats("parametrize", mesh, "--method", "lscm")
        self.assertLess(stats["parametrize"]["max_quasi_conformal"], 1 + 1e-6)
        self.assertEqual(stats["cut"]["edges"], m - 1)
        self.assertAlmostEqual(stats["cut"]["length"], m - 1)
        # the same along edges of a file, with constraints and a metric
        edges = self.write("cut.txt", "".join(f"{n * y} {n * y + n}\n" for y in range(m - 1)))
        scale = self.write("scale.txt", "2\n" * len(points))
        for more in ((), ("--sharp-angle", "10"), ("--metric", scale)):
            stats = self.stats("parametrize", mesh, "--method", "lscm", "--cut", edges, *more)
            self.assertLess(stats["parametrize"]["max_quasi_conformal"], 1 + 1e-6)
            self.assertEqual(stats["cut"]["edges"], m - 1)

    def test_refuses_what_does_not_become_a_disk(self):
        points, faces = torus(6, 5)
        mesh = self.write_off("m.off", points, faces)
        loop = self.write("cut.txt", "".join(f"{x} {(x + 1) % 6}\n" for x in range(6)))
        self.assert_fails(self.run_program("parametrize", mesh, "--cut", loop), "cut.txt",
                          "1 component, 0 handles and 2 borders")
        none = self.write("none.txt", "0 8\n")
        self.assert_fails(self.run_program("parametrize", mesh, "--cut", none), "none.txt")
        self.assert_fails(self.run_program("parametrize", mesh, "--cut", "missing.txt"),
                          "missing.txt")
        more, others = grid(2)
        two = self.write_off("two.off", points + [(x + 9, y, z) for x, y, z in more],
                             triangles(faces) + [[v + 30 for v in f] for f in others])
        self.assert_fails(self.run_program("parametrize", two), "not connected")


if __name__ == "__main__":
    main()
