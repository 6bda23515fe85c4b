# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces that do not form a manifold: which surface is made of them, and that results have the rows of the file."""

import math
import os
import unittest

from cli_support import Cli_test, main

MESHES = os.environ.get("INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR", "")
FINS = ([(0, 0, 0), (4, 0, 0), (0, 5, 0), (1, 1, 6), (-3, 2, -5)],
        [(0, 1, 2), (0, 1, 3), (1, 0, 4), (2, 0, 3)])


def moebius_strip(n=9):
    points, faces = [], []
    for i in range(n):
        for side in (-1, 1):
            a = 2 * math.pi * i / n
            r = 3 + side * math.cos(a / 2)
            points.append((r * math.cos(a), r * math.sin(a), side * math.sin(a / 2)))
    for i in range(n):
        a, b = 2 * i, 2 * i + 1
        c, d = (a + 2, a + 3) if i + 1 < n else (1, 0)
        faces += [(a, c, b), (b, c, d)]
    return points, faces


def area(points, faces):
    result = 0
    for i, j, k in faces:
        u, v = ([y - x for x, y in zip(points[i], points[m])] for m in (j, k))
        normal = [u[a] * v[b] - u[b] * v[a] for a, b in ((1, 2), (2, 0), (0, 1))]
        result += math.hypot(*normal) / 2
    return result


class Domain(Cli_test):
    def check(self, stats, points, faces):
        self.assertEqual(stats["certificate"], "exact")
        self.assertEqual(stats["delaunay"]["probable_zero"], 0)
        self.assertEqual(stats["domain"]["vertices"], len(points))
        for key in ("input", "intrinsic"):
            self.assert_close(stats["area"][key], area(points, faces), 1e-12)

    def check_laplacian(self, name, points, stats):
        rows, columns, entries = self.read_matrix(name)
        self.assertEqual((rows, columns), (len(points), len(points)))
        for (i, j), x in entries.items():
            if i != j:
                self.assertLess(x, 0)
        for i in range(rows):
            row = [x for (a, _), x in entries.items() if a == i]
            self.assertLessEqual(abs(sum(row)), 1e-13 * sum(abs(x) for x in row))
        self.assert_close(sum(entries.get((i, i), 0) for i in range(rows)),
                          stats["laplacian"]["trace"], 1e-12)
        for k, axis in enumerate("xyz"):
            energy = -sum(x * (points[i][k] - points[j][k]) ** 2
                          for (i, j), x in entries.items() if i < j)
            self.assertAlmostEqual(energy, stats["dirichlet"][axis], 9)

    def test_three_faces_at_an_edge_have_a_tufted_cover(self):
        mesh = self.write_off("fins.off", *FINS)
        stats = self.stats("laplacian", mesh, "-o", "l.mtx", "--mass", "m.mtx")
        self.assertEqual(stats["domain"],
                         {"kind": "tufted", "reason": "edge (0, 1) has 3 faces (0, 1, 2)",
                          "sheets": 2, "vertices": 5, "nonmanifold_edges": 1,
                          "unoriented_edges": 1})
        self.assertEqual(stats["input"]["faces"], 8)
        self.assertEqual(stats["input"]["boundary_edges"], 0)
        self.check(stats, *FINS)
        self.check_laplacian("l.mtx", FINS[0], stats)
        _, _, mass = self.read_matrix("m.mtx")
        self.assert_close(sum(mass.values()), area(*FINS), 1e-12)

    def test_one_sided_surfaces_have_a_double_cover(self):
        points, faces = moebius_strip()
        mesh = self.write_off("m.off", points, faces)
        stats = self.stats("laplacian", mesh, "-o", "l.mtx")
        self.assertEqual(stats["domain"]["kind"], "orientation-cover")
        self.assertIn("one side", stats["domain"]["reason"])
        self.assertEqual(stats["input"]["boundary_loops"], 2)
        self.assertEqual(stats["input"]["components"], 1)
        self.check(stats, points, faces)
        tufted = self.stats("laplacian", mesh, "-o", "t.mtx", "--domain", "tufted")
        self.assertEqual(tufted["domain"]["kind"], "tufted")
        self.assertEqual(tufted["input"]["boundary_edges"], 0)
        self.check(tufted, points, faces)
        self.check_laplacian("t.mtx", points, tufted)

    def test_what_is_asked_for_is_made_or_refused(self):
        mesh = self.write_off("fins.off", *FINS)
        for kind in ("manifold", "orientation-cover"):
            self.assert_fails(self.run_program("info", mesh, "--domain", kind),
                              "fins.off: edge (0, 1) has 3 faces (0, 1, 2)")
        self.assertEqual(self.run_program("info", mesh, "--domain", "round").code, 2)
        strip = self.write_off("m.off", *moebius_strip())
        self.assert_fails(self.run_program("delaunay", strip, "--domain", "manifold"), "one side")
        square = self.write_off("s.off", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)],
                                [(0, 1, 2), (0, 2, 3)])
        self.assertEqual(self.stats("info", square)["domain"]["kind"], "manifold")
        for kind in ("manifold", "orientation-cover", "tufted"):
            self.assertEqual(self.stats("info", square, "--domain", kind)["domain"]["kind"], kind)

    def test_polygons_may_be_repeated(self):
        points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
        mesh = self.write_off("q.off", points, [(0, 1, 2, 3)] * 5)
        stats = self.stats("delaunay", mesh, "-o", "s.ply")
        self.assertEqual(stats["domain"]["kind"], "tufted")
        self.assert_close(stats["area"]["intrinsic"], 5, 1e-12)
        self.assert_close(stats["subdivision"]["area"], 5, 1e-12)

    def test_reasons_and_refusals_name_faces_of_the_file(self):
        points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, -1, 0),
                  (1, -1, 0)]
        faces = [(2, 3, 5), (0, 1, 2, 3), (0, 1, 1, 0), (0, 1, 5, 4), (0, 1, 7, 6)]
        mesh = self.write_off("q.off", points, faces)
        stats = self.stats("delaunay", mesh, "-o", "s.ply")
        words = "edge (0, 1) has 3 faces (1, 3, 4)"
        self.assertEqual(stats["domain"]["reason"], words)
        self.assertEqual(stats["input"]["faces_with_repeated_vertices"], 1)
        self.assert_fails(self.run_program("info", mesh, "--domain", "manifold"), words)
        # both diagonals of a square are edges of other faces
        mesh = self.write_off("d.off", points, [(0, 1, 2, 3), (0, 2, 4), (1, 3, 5)])
        self.assertRegex(self.stats("info", mesh)["domain"]["reason"],
                         r"edge \(\d, \d\), a diagonal of face 0, has 3 faces \(0, 0, [12]\)")
        # a strip of quadrilaterals with a triangle before it
        points, _ = moebius_strip()
        quads = [(2 * i, (2 * i + 2) % 18, (2 * i + 3) % 18, 2 * i + 1) for i in range(8)]
        corners = [(9, 18, 19)] + quads + [(16, 1, 0, 17)]
        strip = self.write_off("m.off", points + [(9, 9, 9), (9, 8, 8)], corners)
        stats = self.stats("info", strip)
        self.assertEqual(stats["domain"]["kind"], "orientation-cover")
        numbers = [int(w.strip(",")) for w in stats["domain"]["reason"].replace(":", "").split()
                   if w.strip(",").isdigit()]
        self.assertEqual(len(numbers), 2)
        shared = set(corners[numbers[0]]) & set(corners[numbers[1]])
        self.assertEqual(len(shared), 2, numbers)

    def test_faces_that_list_a_vertex_twice_are_left_out_on_every_domain(self):
        points, faces = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1)], [(0, 1, 2), (0, 2, 3)]
        clean = self.write_off("c.off", points, faces)
        mesh = self.write_off("r.off", points,
                              [(0, 1, 1), faces[0], (4, 4, 4), (0, 2, 4, 2, 3, 3), (1, 2, 1, 2)])
        for kind in ("auto", "manifold", "orientation-cover", "tufted", "closed"):
            a = self.stats("laplacian", clean, "--domain", kind, "-o", "a.mtx")
            b = self.stats("laplacian", mesh, "--domain", kind, "-o", "b.mtx")
            self.assertEqual(b["input"]["faces_with_repeated_vertices"], 4)
            self.assertEqual(a["input"]["faces_with_repeated_vertices"], 0)
            self.assertEqual(self.read_matrix("a.mtx"), self.read_matrix("b.mtx"))
            if kind == "closed":  # its reason names a face
                del a["domain"]["reason"], b["domain"]["reason"]
            self.assertEqual(a["domain"], b["domain"])
        self.assertIn("4 faces listed a vertex twice", self.run_program("info", mesh).out)
        run = self.run_program("geodesic", mesh, "--path", "0:0.3:0.3:0.4,3")
        self.assert_fails(run, "face 0", "three different vertices")
        run = self.run_program("geodesic", mesh, "--path", "1:0.3:0.3:0.4,3")
        self.assertEqual(run.code, 0, run.err)

    def test_a_surface_without_border_is_a_cover_only_if_it_must_be(self):
        tetrahedron = ([(0, 0, 0), (3, 0, 0), (0, 4, 0), (0, 0, 5)],
                       [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])
        for (points, faces), kind, sheets in ((tetrahedron, "manifold", 1), (FINS, "tufted", 2),
                                              ((tetrahedron[0], tetrahedron[1][1:]), "tufted", 2)):
            mesh = self.write_off("m.off", points, faces)
            closed = self.stats("laplacian", mesh, "--domain", "closed", "-o", "c.mtx")
            tufted = self.stats("laplacian", mesh, "--domain", "tufted", "-o", "t.mtx")
            self.assertEqual(closed["domain"]["kind"], kind)
            self.assertEqual(closed["domain"]["sheets"], sheets)
            self.assertEqual(closed["input"]["boundary_edges"], 0)
            self.check(closed, points, faces)
            self.check_laplacian("c.mtx", points, closed)
            self.assert_close(closed["laplacian"]["trace"], tufted["laplacian"]["trace"], 1e-12)

    def test_covers_are_refined_stored_and_transferred_to(self):
        for points, faces in (FINS, moebius_strip()):
            mesh = self.write_off("m.off", points, faces)
            stats = self.stats("refine", mesh, "--min-angle", "25", "-o", "r.ply")
            self.check(stats, points, faces)
            self.assertEqual(stats["refine"]["status"], "done")
            self.assert_close(stats["subdivision"]["area"], area(points, faces), 1e-9)
            stored = self.stats("delaunay", mesh, "-o", "t.idt")
            again = self.stats("laplacian", "t.idt", "-o", "l.mtx")
            self.assertEqual(again["domain"]["kind"], "stored")
            for key in ("sheets", "vertices"):
                self.assertEqual(again["domain"][key], stored["domain"][key])
            self.assertEqual(self.read_matrix("l.mtx")[0], len(points))
            self.assertEqual(again["laplacian"]["trace"], stored["laplacian"]["trace"])
            self.write("f.txt", "\n".join(str(p[0]) for p in points) + "\n")
            moved = self.stats("transfer", mesh, "f.txt", "-o", "g.txt")
            with open(self.path("g.txt"), encoding="ascii") as file:
                self.assertEqual(len(file.read().split()), len(points))
            self.assertLess(moved["transfer"]["L2_distance"][0], area(points, faces))
            refused = self.run_program("info", "t.idt", "--domain", "tufted")
            self.assertEqual(refused.code, 1)

    def test_geodesics_run_on_covers(self):
        points, faces = moebius_strip()
        mesh = self.write_off("m.off", points, faces)
        stats = self.stats("geodesic", mesh, "--path", "0,9", "-o", "c.vtp")
        self.assertEqual(stats["geodesic"]["status"], "geodesic")
        self.assertTrue(stats["geodesic"]["certified"])

    def assert_lengths(self, mesh, *curves):
        """Of curves, each an option, its points, other options, and the length."""
        for *arguments, length in curves:
            g = self.stats("geodesic", mesh, "--domain", "tufted", *arguments,
                           "-o", "c.vtp")["geodesic"]
            self.assertEqual(g["status"], "geodesic", arguments)
            # an angle of pi is not told from a smaller one
            straight_at_0 = "vertex 0, " in g.get("obstacle", "") and arguments == ["--path", "1,2"]
            self.assertTrue(g["certified"] or straight_at_0, (arguments, g.get("obstacle")))
            self.assertEqual(len(g["curves"]), 1, arguments)
            self.assert_close(g["length"], length, 1e-11)

    def test_paths_on_covers_go_between_any_copies_of_their_points(self):
        points = [(0, 0, 0)] + [tuple(s * (k == axis) for k in range(3))
                                for axis in range(3) for s in (1, -1)]
        faces = [(0, i, j) for i in range(1, 7) for j in range(i + 1, 7) if i % 2 == 0 or j > i + 1]
        axes = self.write_off("a.off", points, faces)
        inside = "0:0.2:0.4:0.4"
        self.assert_lengths(
            axes, ("--path", "0,1", 1), ("--path", "1,0", 1), ("--path", "1,2", 2),
            ("--path", "2,0,4", math.sqrt(2)), ("--path", "2,0,4", "--waypoints", 2),
            ("--path", inside + ",0", math.sqrt(0.32)),
            # face 0 is in the first quadrant, face 1 in the fourth: across their edge
            ("--path", inside + ",1:0.2:0.4:0.4", 0.8),
            ("--loop", "1,3,2,4", 4 * math.sqrt(2)))

    def test_paths_on_covers_pass_a_vertex_at_which_parts_meet(self):
        corner = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
        points = [(0, 0, 0)] + corner + [tuple(-x for x in p) for p in corner]
        faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
        faces += [tuple(v + 3 if v else 0 for v in reversed(f)) for f in faces]
        self.assert_lengths(
            self.write_off("t.off", points, faces), ("--path", "1,4", 2), ("--path", "1,0,4", 2),
            ("--path", "1,4,2", "--waypoints", 4), ("--path", "1,5,2", math.sqrt(2)),
            ("--path", "0:0.2:0.4:0.4,4:0.4:0.4:0.2", 2 * math.sqrt(0.32)))

    @unittest.skipUnless(MESHES and os.path.isdir(MESHES), "CGAL's data set is not installed")
    def test_tufted_covers_of_closed_meshes_have_their_laplacian(self):
        # blobby-shuffled.off has faces that disagree
        for name in ("elephant.off", "cheese.off", "anchor_dense.off", "blobby-shuffled.off"):
            mesh = os.path.join(MESHES, name)
            if not os.path.exists(mesh):
                continue
            one = self.stats("laplacian", mesh, "-o", "one.mtx")
            self.assertEqual(one["domain"]["kind"], "manifold")
            both = self.stats("laplacian", mesh, "-o", "both.mtx", "--domain", "tufted")
            self.assertEqual(both["certificate"], "exact")
            a, b = self.read_matrix("one.mtx")[2], self.read_matrix("both.mtx")[2]
            self.assertEqual(a.keys(), b.keys(), name)
            for key, x in a.items():
                # each weight is right to 1e-12 of itself or of 1; a diagonal entry sums positive
                # weights
                self.assertLessEqual(abs(x - b[key]), 4e-12 * max(1, abs(x)))

    @unittest.skipUnless(MESHES and os.path.isdir(MESHES), "CGAL's data set is not installed")
    def test_every_mesh_of_the_data_set_has_a_certified_tufted_laplacian(self):
        count = 0
        for name in sorted(os.listdir(MESHES)):
            if not name.endswith((".off", ".obj", ".ply", ".stl", ".ts")) or name == "b9.ply":
                continue  # the last one is a point set
            with self.subTest(mesh=name):
                mesh = os.path.join(MESHES, name)
                tufted = self.stats("laplacian", mesh, "--domain", "tufted")
                self.assertEqual(tufted["certificate"], "exact")
                self.assertEqual(tufted["delaunay"]["probable_zero"], 0)
                self.assertEqual(tufted["input"]["boundary_edges"], 0)
                self.assertGreaterEqual(tufted["quality"]["min_cotan_weight"], 0)
                count += 1
                one = self.stats("laplacian", mesh)
                self.assert_close(one["area"]["input"], tufted["area"]["input"], 1e-12)
                self.assert_close(one["area"]["intrinsic"], tufted["area"]["intrinsic"], 1e-12)
                if one["input"]["boundary_edges"] == 0:
                    self.assert_close(one["laplacian"]["trace"], tufted["laplacian"]["trace"],
                                      4e-12)
        self.assertGreater(count, 130)


if __name__ == "__main__":
    main()
