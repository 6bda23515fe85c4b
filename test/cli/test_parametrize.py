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

    def test_progress_is_shown_also_if_edges_are_kept(self):
        mesh = self.write_off("g.off", *grid(4))
        for more in ((), ("--sharp-angle", "20"), ("--method", "lscm")):
            run = self.run_program("parametrize", mesh, "--progress", *more)
            self.assertEqual(run.code, 0, run.err)
            self.assertIn(": mapping: ", run.err)

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
        moebius = self.write_off("moebius.off", *self.moebius(6))
        border = self.write("border.txt", "0 2\n")
        self.assert_fails(self.run_program("parametrize", moebius, "--cut", border),
                          "border.txt", "one side only")
        none = self.write("none.txt", "0 8\n")
        self.assert_fails(self.run_program("parametrize", mesh, "--cut", none), "none.txt")
        self.assert_fails(self.run_program("parametrize", mesh, "--cut", "missing.txt"),
                          "missing.txt")

    def boxes_of_components(self, name):
        """The boxes in the plane of the parts of a surface that share vertices there."""
        _, places, corners = read_obj(self.path(name))
        parts = []
        for face in corners:
            found = {c for _, c in face}
            for part in [p for p in parts if p & found]:
                parts.remove(part)
                found |= part
            parts.append(found)
        return [[f(places[c][k] for c in part) for k in (0, 1) for f in (min, max)]
                for part in parts]

    def assert_disjoint(self, boxes):
        for i, (a, b, c, d) in enumerate(boxes):
            for e, f, g, h in boxes[:i]:
                self.assertTrue(b < e or f < a or d < g or h < c)

    def test_components_lie_beside_each_other(self):
        shapes = (torus(6, 5), icosphere(1), grid(3))
        points, faces = [], []
        for k, (more, others) in enumerate(shapes):
            faces += [[v + len(points) for v in f] for f in others]
            points += [(x + 9 * k, y, z) for x, y, z in more]
        mesh = self.write_off("m.off", points, faces)
        for method in ("harmonic", "lscm", "spectral"):
            stats = self.stats("parametrize", mesh, "--method", method, "--on", "input",
                               "-o", "m.obj")
            if method == "harmonic":
                self.assertTrue(stats["parametrize"]["injective"])
            elif method == "lscm":  # shrinks parts of the sphere to areas of any sign
                self.assertLess(stats["parametrize"]["flipped_faces"], len(shapes[1][1]) / 10)
            boxes = self.boxes_of_components("m.obj")
            self.assertEqual(len(boxes), len(shapes))
            self.assert_disjoint(boxes)

    def test_conformal_maps_of_disks(self):
        points, faces = grid(6)
        flat = self.write_off("flat.off", points, faces)
        bent = self.write_off("bent.off", [(x, y, math.hypot(x - 3, y - 3) / 2)
                                           for x, y, _ in points], faces)
        for mesh in (flat, bent):
            maps = {}
            for on in ("subdivision", "input"):
                stats = self.stats("parametrize", mesh, "--method", "conformal", "--on", on, "-o",
                                   "m.obj", "--view", "m.html")
                result = stats["parametrize"]
                self.assertEqual((result["status"], result["method"]), ("done", "conformal"))
                self.assertTrue(result["injective"] and result["border_is_simple"])
                self.assertLess(result["proven_residual"], 1e-9)
                found, places, corners = read_obj(self.path("m.obj"))
                maps[on] = {tuple(found[v]): places[c] for face in corners for v, c in face}
                if on == "input":
                    self.assertEqual((len(found), len(corners)), (len(points), len(faces)))
            for point, place in maps["input"].items():
                self.assertLess(math.dist(place, maps["subdivision"][point]), 1e-9)
            self.stats("parametrize", mesh, "--method", "conformal", "-o", "m.txt")
            rows = self.read_rows("m.txt")
            for a, b in zip(faces[0], faces[0][1:]):
                if mesh == flat:
                    self.assertAlmostEqual(math.dist(rows[a], rows[b]),
                                           math.dist(points[a], points[b]))
            self.assertEqual(stats["parametrize"]["max_scale_ratio"] == 1, mesh == flat)
        for start in ("delaunay", "input"):  # the same as that of uniformize
            stats = self.stats("uniformize", bent, "--start", start, "-o", "u.vtp")["conformal"]
            result = self.stats("parametrize", bent, "--method", "conformal", "--start", start,
                                "-o", "m.vtp")["parametrize"]
            for key in ("status", "start", "iterations", "flips", "residual", "max_scale_ratio",
                        "mean_quasi_conformal", "flipped_faces"):
                self.assertEqual(stats[key], result[key])
            with open(self.path("m.vtp"), "rb") as m, open(self.path("u.vtp"), "rb") as u:
                text = m.read()
                self.assertEqual(text, u.read())
            self.assertIn(b'Name="log_scale"', text)
        self.assertEqual(self.stats("parametrize", bent, "--method", "conformal")["parametrize"]
                         ["start"], "delaunay")
        self.stats("delaunay", bent, "-o", "bent.idt")
        self.stats("parametrize", "bent.idt", "--method", "conformal", "-o", "i.txt")
        for a, b in zip(rows, self.read_rows("i.txt")):
            self.assertLess(math.dist(a, b), 1e-9)
        two = self.write_off("two.off", points + [(x + 9, y, z) for x, y, z in points],
                             [list(f) for f in faces] + [[v + len(points) for v in f]
                                                         for f in faces])
        self.assertTrue(self.stats("parametrize", two, "--method", "conformal", "-o", "m.obj")
                        ["parametrize"]["injective"])
        self.assert_disjoint(self.boxes_of_components("m.obj"))

    def test_conformal_maps_of_other_surfaces_are_those_of_uniformize(self):
        points, faces = torus(6, 5)
        mesh = self.write_off("m.off", points, triangles(faces))
        self.assert_fails(self.run_program("parametrize", mesh, "--method", "conformal"),
                          "has handles", "uniformize")
        mesh = self.write_off("m.off", *icosphere(1))
        self.assert_fails(self.run_program("parametrize", mesh, "--method", "conformal"),
                          "the surface is closed", "uniformize")
        mesh = self.write_off("m.off", *self.moebius(6))
        self.assert_fails(self.run_program("parametrize", mesh, "--method", "conformal"),
                          "not an oriented manifold", "uniformize")
        self.stats("refine", self.write_off("g.off", *grid(2)), "--max-circumradius", "0.3", "-o",
                   "r.idt")
        self.assert_fails(self.run_program("parametrize", "r.idt", "--method", "conformal"),
                          "inserted", "start from the mesh")
        self.assertEqual(self.run_program("parametrize", mesh, "--start", "input").code, 2)
        for more in (("--cut", "auto"), ("--refine",), ("--sharp-angle", "20")):
            run = self.run_program("parametrize", mesh, "--method", "conformal", *more)
            self.assertEqual(run.code, 2)

    @staticmethod
    def moebius(n):
        """A strip of n squares with half a turn."""
        points = [(math.cos(2 * t) * (2 + r * math.cos(t)), math.sin(2 * t) * (2 + r * math.cos(t)),
                   r * math.sin(t)) for t in (math.pi * i / n for i in range(n)) for r in (-1, 1)]
        return points, [[2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2] for i in range(n - 1)] + [
            [2 * n - 2, 2 * n - 1, 0, 1]]

    def test_faces_that_form_no_oriented_manifold_are_mapped_once(self):
        leaf, squares = grid(2)
        points, faces = list(leaf), [list(f) for f in squares]
        for k in (1, 2):  # on the other leaves of the book only the line x = 0 is the same
            number = {v: v if x == 0 else len(points) + i
                      for i, (v, (x, _, _)) in enumerate(
                          sorted(enumerate(leaf), key=lambda e: e[1][0] == 0))}
            points += [(0, y, x) if k == 1 else (-x, y, 0)
                       for (x, y, _) in sorted(leaf, key=lambda p: p[0] == 0) if x != 0]
            faces += [[number[v] for v in (reversed(f) if k == 2 else f)] for f in squares]
        book = self.write_off("book.off", points, faces)
        for edges in ((), ("--sharp-angle", "20"), ("--metric", self.write(
                "scale.txt", "2\n" * len(points))), ("--arithmetic", "double")):
            stats = self.stats("parametrize", book, "--method", "lscm", "--on", "input", "-o",
                               "m.obj", *edges)
            self.assertTrue(stats["parametrize"]["injective"])
            self.assertLess(stats["parametrize"]["max_quasi_conformal"], 1 + 1e-6)
            self.assertEqual((stats["domain"]["kind"], stats["domain"]["sheets"]), ("sheet", 1))
            self.assertEqual(stats["cut"]["vertices"], len(points) + 6)
            boxes = self.boxes_of_components("m.obj")
            self.assertEqual((len(boxes), len(read_obj(self.path("m.obj"))[2])), (3, len(faces)))
            self.assert_disjoint(boxes)
        strip = self.write_off("strip.off", *self.moebius(8))
        stats = self.stats("parametrize", strip, "-o", "m.obj", "--on", "input",
                           "--sharp-angle", "1", "--view", "m.html")
        self.assertTrue(stats["parametrize"]["injective"])
        self.assertEqual(stats["cut"]["edges"], 1)
        self.assertEqual(len(read_obj(self.path("m.obj"))[1]), 18)


if __name__ == "__main__":
    main()
