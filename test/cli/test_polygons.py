# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygons that are not planar: what becomes of them, and what is reported and written."""

import math

from cli_support import CUBE, Cli_test, main


def skew_rhombi(copies, height):
    """Rhombi, far apart; and the area of the planar ones by the cosine rule."""
    points, faces = [], []
    for k in range(copies):
        n = len(points)
        points += [(10 * k + 1.5, 0, height), (10 * k, 1, 0), (10 * k - 1.5, 0, height),
                   (10 * k, -1, 0)]
        faces.append((n, n + 1, n + 2, n + 3))
    square = 1.5 ** 2 + 1 + height ** 2
    a = math.acos(1 - 4 / (2 * square))
    b = math.acos(1 - 9 / (2 * square))
    return points, faces, copies * square * math.sin((a + math.pi - b) / 2), \
        (math.pi - a - b) / 2 * 180 / math.pi


def saddle(n):
    points = [(i / n, j / n, 4 * i * j / n / n) for j in range(-n, n + 1) for i in range(-n, n + 1)]
    w = 2 * n + 1
    faces = [(j * w + i, j * w + i + 1, j * w + i + w + 1, j * w + i + w)
             for j in range(2 * n) for i in range(2 * n)]
    return points, faces


class Polygons(Cli_test):
    def test_rhombi_become_planar(self):
        points, faces, area, change = skew_rhombi(3, 0.4)
        mesh = self.write_off("r.off", points, faces)
        for arithmetic in ("exact", "double"):
            stats = self.stats("delaunay", mesh, "--polygons", "planar", "--arithmetic", arithmetic)
            polygons = stats["polygons"]
            self.assertEqual([polygons[k] for k in ("planar", "flattened", "kept")], [0, 3, 0])
            self.assertAlmostEqual(polygons["max_angle_change_deg"], change, 9)
            for key in ("input", "intrinsic"):
                self.assert_close(stats["area"][key], area, 1e-12)
        self.assertNotIn("polygons", self.stats("delaunay", mesh))
        self.assertEqual(self.run_program("info", mesh, "--polygons", "curved").code, 2)

    def test_all_commands_take_them(self):
        points, faces = saddle(4)
        mesh = self.write_off("s.off", points, faces)
        option = ("--polygons", "planar")
        stats = self.stats("delaunay", mesh, *option, "-o", "s.ply", "--view", "s.html")
        self.assert_certified(stats)
        self.assertEqual(stats["polygons"]["flattened"], 64)
        self.assertEqual(stats["polygons"]["kept"], 0)
        refined = self.stats("refine", mesh, *option, "-o", "r.vtp", "--min-angle", "25")
        self.assert_close(refined["area"]["intrinsic"], stats["area"]["intrinsic"], 1e-12)
        self.assertGreaterEqual(refined["refine"]["satisfied_min_angle_deg"], 25 - 1e-9)
        tufted = self.stats("delaunay", mesh, *option, "--domain", "tufted")
        self.assert_certified(tufted)
        self.assert_close(tufted["area"]["intrinsic"], stats["area"]["intrinsic"], 1e-12)
        curve = self.stats("geodesic", mesh, *option, "--path", "0,80", "-o", "g.vtp")
        self.assertEqual(curve["polygons"]["flattened"], 64)
        self.assertEqual(self.stats("info", mesh, *option)["polygons"]["flattened"], 64)
        self.stats("delaunay", mesh, *option, "--arithmetic", "double", "-o", "d.ply")
        self.stats("delaunay", mesh, *option, "-o", "s.idt")
        stored = self.stats("delaunay", "s.idt")
        self.assertEqual(stored["delaunay"]["flips"], 0)
        self.assert_close(stored["laplacian"]["trace"], stats["laplacian"]["trace"], 1e-14)
        self.assert_fails(self.run_program("delaunay", "s.idt", *option), "--polygons")

    def test_stored_triangulations_know_the_polygons_of_their_file(self):
        points, faces = saddle(3)
        mesh = self.write_off("s.off", points, faces)
        for arithmetic in ("exact", "double"):
            for polygons in ("fan", "planar"):
                asked = self.stats("delaunay", mesh, "--polygons", polygons, "--arithmetic",
                                   arithmetic, "-o", "a.vtp")
                self.stats("delaunay", mesh, "--polygons", polygons, "--arithmetic", arithmetic,
                           "-o", "s.idt")
                stored = self.stats("delaunay", "s.idt", "-o", "b.vtp")
                self.assert_same_file("a.vtp", "b.vtp")  # with the face of the file under each
                for key in ("polygons", "triangulated_polygons"):
                    self.assertEqual(stored["input"][key], asked["input"][key])
                self.assertEqual(stored["input"]["polygons"], len(faces))

    def test_symmetric_surfaces_have_symmetric_laplacians(self):
        n = 5
        points, faces = saddle(n)
        mesh = self.write_off("s.off", points, faces)
        self.stats("laplacian", mesh, "--polygons", "planar", "-o", "l.mtx")
        _, _, entries = self.read_matrix("l.mtx")
        w = 2 * n + 1

        def image(v):  # a quarter of a turn
            j, i = divmod(v, w)
            return i * w + w - 1 - j

        for (i, j), x in entries.items():
            a, b = image(i), image(j)
            self.assertAlmostEqual(entries.get((a, b), entries.get((b, a), 0)), x, 11)

    def test_planar_polygons_stay_as_they_are(self):
        mesh = self.write_off("b.off", [(3 * x, 2 * y, z) for x, y, z in CUBE[0]], CUBE[1])
        one = self.stats("delaunay", mesh, "-o", "a.ply")
        other = self.stats("delaunay", mesh, "-o", "b.ply", "--polygons", "planar")
        self.assertEqual(other["polygons"], {"planar": 6, "flattened": 0, "kept": 0,
                                             "max_angle_change_deg": 0})
        self.assertEqual(one["delaunay"], other["delaunay"])
        self.assertEqual(one["area"], other["area"])
        self.assert_same_file("a.ply", "b.ply")


if __name__ == "__main__":
    main()
