# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points without faces: files of them, what is made of them, and what is reported and refused."""

import math
import os
import random
import unittest

from cli_support import Cli_test, main

MESHES = os.environ.get("INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR", "")
POINTS = os.path.join(os.path.dirname(MESHES), "points_3")


def sphere(n):
    """Points on a spiral: nearly as far from each other everywhere."""
    points = []
    for i in range(n):
        z = 1 - (2 * i + 1) / n
        r, a = math.sqrt(1 - z * z), i * math.pi * (3 - math.sqrt(5))
        points.append((r * math.cos(a), r * math.sin(a), z))
    return points


def rough_grid(n, seed=3):
    """A flat mesh whose inner vertices are not quite on a grid."""
    move = random.Random(seed)
    points = [(i + move.uniform(-.3, .3) * (0 < i < n), j + move.uniform(-.3, .3) * (0 < j < n), 0)
              for i in range(n + 1) for j in range(n + 1)]
    faces = []
    for i in range(n):
        for j in range(n):
            a = i * (n + 1) + j
            faces += [(a, a + n + 1, a + 1), (a + 1, a + n + 1, a + n + 2)]
    return points, faces


class Point_cloud(Cli_test):
    def write_xyz(self, name, points, rest=""):
        return self.write(name, "".join(" ".join(repr(float(x)) for x in p) + rest + "\n"
                                        for p in points))

    def check(self, stats, points):
        self.assertEqual(stats["domain"]["kind"], "points")
        self.assertEqual(stats["domain"]["sheets"], 6)
        self.assertEqual(stats["domain"]["vertices"], len(points))
        self.assert_certified(stats)
        self.assertGreaterEqual(stats["quality"]["min_cotan_weight"], 0)

    def check_laplacian(self, name, points):
        """Symmetric, as its file says, with rows that sum to zero and no positive entry but on the diagonal."""
        rows, columns, entries = self.read_matrix(name)
        self.assertEqual((rows, columns), (len(points), len(points)))
        sums, sizes = [0.0] * rows, [0.0] * rows
        for (i, j), x in entries.items():
            self.assertTrue(i == j or x < 0)
            sums[i] += x
            sizes[i] += abs(x)
        for s, size in zip(sums, sizes):
            self.assertLessEqual(abs(s), 1e-13 * size)
        return entries

    def test_spheres_have_nearly_their_area_and_energies(self):
        points = sphere(2000)
        stats = self.stats("laplacian", self.write_xyz("s.xyz", points), "-o", "l.mtx", "--mass",
                           "m.mtx")
        self.check(stats, points)
        self.check_laplacian("l.mtx", points)
        self.assertEqual(stats["domain"]["neighbors"], 30)
        self.assertEqual(stats["domain"]["border_points"], 0)
        self.assertAlmostEqual(stats["area"]["intrinsic"], 4 * math.pi, 1)
        mass = self.read_matrix("m.mtx")[2]
        self.assert_close(sum(mass.values()), stats["area"]["intrinsic"], 1e-12)
        # a coordinate is an eigenfunction for 2; its square has the mean 1/3
        for axis in "xyz":
            self.assert_close(stats["dirichlet"][axis], 2 / 3 * 4 * math.pi, 1e-2)

    def test_a_flat_cloud_has_the_laplacian_of_its_delaunay_triangulation(self):
        n = 14
        points, faces = rough_grid(n)
        mesh = self.write_off("m.off", points, faces)
        self.stats("laplacian", mesh, "-o", "mesh.mtx")
        stats = self.stats("laplacian", mesh, "-o", "points.mtx", "--domain", "points",
                           "--neighbors", "25")
        self.check(stats, points)
        a = self.read_matrix("mesh.mtx")[2]
        b = self.check_laplacian("points.mtx", points)
        inner = [i for i in range(len(points))
                 if all(3 <= c <= n - 3 for c in divmod(i, n + 1))]
        for i in inner:
            for j in range(len(points)):
                self.assertAlmostEqual(a.get((i, j), 0), b.get((i, j), 0), 11)

    def test_all_formats_and_commands_take_points(self):
        points = sphere(300)
        lists = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points)
        head = ("ply\nformat ascii 1.0\nelement vertex 300\nproperty double x\n"
                "property double y\nproperty double z\nend_header\n")
        files = [self.write_xyz("p.xyz", points), self.write_xyz("q.pwn", points, " 0 0 1"),
                 self.write_off("p.off", points, []), self.write("p.obj", lists),
                 self.write("p.ply", head + lists.replace("v ", ""))]
        traces = {self.stats("laplacian", f)["laplacian"]["trace"] for f in files}
        self.assertEqual(len(traces), 1)
        drawn = self.stats("delaunay", files[0], "-o", "s.ply", "--view", "v.html")
        self.assert_close(drawn["subdivision"]["area"], drawn["area"]["input"], 1e-9)
        refined = self.stats("refine", files[0], "--min-angle", "25", "-o", "r.vtp")
        self.check(refined, points)
        self.assertEqual(refined["refine"]["status"], "done")
        path = self.stats("geodesic", files[0], "--path", "0,299", "-o", "c.vtp")
        self.assertEqual(path["geodesic"]["status"], "geodesic")
        # between nearly opposite points, over chords
        self.assertLess(path["geodesic"]["length"], 4)
        self.assertGreater(path["geodesic"]["length"], 2.9)
        info = self.run_program("info", files[0])
        self.assertEqual(info.code, 0, info.err)
        self.assertIn("points", info.out)
        self.stats("delaunay", files[0], "-o", "t.idt")
        stored = self.stats("laplacian", "t.idt")
        self.assertEqual(stored["laplacian"]["trace"], drawn["laplacian"]["trace"])

    def in_space(self, row):
        """The vector of a row in space: two coordinates before two axes."""
        x, y = row[-8:-6]
        return [x * a + y * b for a, b in zip(row[-6:-3], row[-3:])]

    def test_transport_over_points_of_a_sphere_turns_vectors_along_great_circles(self):
        points = sphere(1000)
        cloud = self.write_xyz("s.xyz", points)
        self.write("v.txt", "0 30 2\n")
        stats = self.stats("transport", cloud, "--vectors", self.path("v.txt"), "-o", "t.txt")
        self.assertEqual(stats["transport"]["unknown_vertices"], 0)
        rows = self.read_rows("t.txt")
        p, v = points[0], self.in_space(rows[0])
        self.assertAlmostEqual(sum(a * b for a, b in zip(v, rows[0][-6:-3])),
                               2 * math.cos(math.pi / 6), 6)
        errors = []
        for q, row in zip(points, rows):
            cosine = sum(a * b for a, b in zip(p, q))
            if cosine < 0.3:  # at most 72 degrees away
                continue
            # by the least rotation that takes p to q
            along = sum(a * b for a, b in zip(v, q)) / (1 + cosine)
            turned = [a - along * (b + c) for a, b, c in zip(v, p, q)]
            errors.append(math.dist(turned, self.in_space(row)) / 2)
        # edges are 0.11 long, so that tangent planes are 0.03 off; heat errs as much
        self.assertLess(sum(errors) / len(errors), 0.05)
        self.stats("transport", cloud, "--vectors", self.path("v.txt"), "-o", "t.vtp",
                   "--view", "t.html")

    def test_fields_of_points_in_a_plane_are_constant(self):
        generator = random.Random(5)
        points = [(generator.uniform(0, 1), generator.uniform(0, 1), 0.0) for _ in range(300)]
        cloud = self.write_xyz("p.xyz", points)
        for degree in (1, 4):
            stats = self.stats("field", cloud, "--degree", str(degree), "-o", "f.txt")["field"]
            self.assertEqual((stats["degree"], stats["seam_edges"]), (degree, 0))
            vectors = [self.in_space(row) for row in self.read_rows("f.txt")]
            angles = [math.atan2(y, x) for x, y, _ in vectors]
            for angle in angles: # equal but for quarters of a turn
                difference = degree * (angle - angles[0]) / (2 * math.pi)
                self.assertAlmostEqual(difference, round(difference), 6)
        self.assert_fails(self.run_program("field", cloud, "--degree", "2", "--align", "1", "-o",
                                           "f.txt"), "p.xyz", "curvature", "--align")
        self.assert_fails(self.run_program("field", cloud, "--singularities", "q.vtp"), "p.xyz",
                          "--singularities")

    def test_duplicated_isolated_and_collinear_points_are_reported(self):
        points = rough_grid(6)[0]
        n = len(points)
        strange = points + [points[8]] * 3 + [points[20]]
        mesh = self.write_xyz("d.xyz", strange)
        stats = self.stats("laplacian", mesh, "-o", "l.mtx")
        self.check(stats, strange)
        self.assertEqual(stats["domain"]["duplicated_points"], 4)
        entries = self.check_laplacian("l.mtx", strange)
        self.assertFalse(any(i >= n and x != 0 for (i, _), x in entries.items()))
        self.assertIn("4 points at the place of another", self.run_program("info", mesh).out)
        # far on a line: among its neighbours, which lie on the line, a point has no triangle
        line = points + [(1000 + i, 3, 0) for i in range(20)]
        stats = self.stats("laplacian", self.write_xyz("l.xyz", line), "--neighbors", "5")
        self.check(stats, line)
        self.assertGreaterEqual(stats["domain"]["points_without_triangles"], 15)
        self.assertGreater(stats["domain"]["border_points"], 15)
        # more neighbours than there are points
        few = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, .5)]
        stats = self.stats("laplacian", self.write_xyz("f.xyz", few), "--neighbors", "1000")
        self.check(stats, few)
        self.assertEqual(stats["domain"]["neighbors"], 3)

    def test_what_cannot_be_a_surface_is_refused(self):
        for name, points in (("one", [(1, 2, 3)]), ("same", [(1, 2, 3)] * 50),
                             ("line", [(i, 2 * i, 3 * i) for i in range(50)])):
            run = self.run_program("delaunay", self.write_xyz(name + ".xyz", points))
            self.assert_fails(run, name + ".xyz: ", "make a triangle", "near a surface")
        for text, words in (("0 0 0\n1 0\n", (":2: ", "point 1", "fewer than three")),
                            ("0 0 0\n0 nan 1\n", (":2: ", "point 1", "not a finite")),
                            ("0 0 0\n1;2;3\n", (":2: ", "point 1", "spaces")),
                            ("# none\n", ("no points",))):
            self.assert_fails(self.run_program("info", self.write("b.xyz", text)), "b.xyz", *words)
        mesh = self.write_off("m.off", *rough_grid(2))
        self.assert_fails(self.run_program("info", mesh, "--neighbors", "9"), "--domain points")
        points = self.write_xyz("p.xyz", sphere(20))
        for kind in ("manifold", "tufted", "orientation-cover"):
            self.assert_fails(self.run_program("info", points, "--domain", kind), "no faces",
                              "point cloud")
        self.assertEqual(self.run_program("info", points, "--neighbors", "1").code, 2)
        self.stats("delaunay", points, "-o", "t.idt")
        self.assert_fails(self.run_program("info", "t.idt", "--neighbors", "9"), "stored")

    def test_faces_do_not_matter_where_points_are_asked_for(self):
        points = sphere(100)
        bad = self.write_off("b.off", points, [(0, 1, 1), (0, 1, 2), (0, 1, 3), (0, 1, 4)])
        self.assertEqual(self.stats("info", bad, "--domain", "points")["laplacian"],
                         self.stats("info", self.write_off("p.off", points, []))["laplacian"])

    @unittest.skipUnless(os.path.exists(os.path.join(POINTS, "kitten.off")),
                         "CGAL's data set is not installed")
    def test_kitten_has_a_certified_laplacian(self):
        stats = self.stats("laplacian", os.path.join(POINTS, "kitten.off"), "-o", "l.mtx")
        points = [()] * 5210
        self.check(stats, points)
        self.check_laplacian("l.mtx", points)

    @unittest.skipUnless(os.path.isdir(POINTS), "CGAL's data set is not installed")
    def test_point_sets_of_the_data_set(self):
        for name in sorted(os.listdir(POINTS)):
            path = os.path.join(POINTS, name)
            if not name.endswith((".xyz", ".pwn", ".off", ".ply")) or os.path.getsize(path) > 1e6:
                continue
            with self.subTest(points=name):
                stats = self.stats("laplacian", path, "--domain", "points", "--neighbors", "12")
                self.check(stats, [()] * stats["domain"]["vertices"])


if __name__ == "__main__":
    main()
