# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `geodesic`: curves that are named, made geodesic, and written."""

import base64
import math
import os
import re
import struct
from math import dist as distance

from cli_support import CUBE, Cli_test, beside, grid, jittered_grid, main, shuffled


def prism(n, height):
    """A cylinder of n sides without ends, rows of vertices at integer heights; every side is 1 wide."""
    r = 0.5 / math.sin(math.pi / n)
    points = [(r * math.cos(2 * math.pi * i / n), r * math.sin(2 * math.pi * i / n), j)
              for j in range(height + 1) for i in range(n)]
    faces = []
    for j in range(height):
        for i in range(n):
            a, b = n * j + i, n * j + (i + 1) % n
            faces += [(a, b, b + n), (a, b + n, a + n)]
    return points, faces


class Geodesic_test(Cli_test):
    def geodesic(self, mesh, *arguments):
        return self.stats("geodesic", mesh, *arguments)["geodesic"]

    def assert_geodesic(self, g):
        self.assertEqual(g["status"], "geodesic")
        self.assertIs(g["certified"], True)
        self.assertLessEqual(g["length"], g["initial_length"] * (1 + 1e-12))

    def obj(self, name):
        """Points, and for each curve the numbers of its points."""
        points, curves = [], {}
        with open(self.path(name), encoding="ascii") as file:
            for words in map(str.split, file):
                if words[0] == "v":
                    points.append(tuple(map(float, words[1:])))
                elif words[:2] == ["#", "curve"]:
                    label = int(words[2])
                elif words[0] in "lp":
                    curves[label] = [int(i) - 1 for i in words[1:]]
        return points, curves

    def length(self, points, curve):
        return sum(distance(points[a], points[b]) for a, b in zip(curve, curve[1:]))


class Curves(Geodesic_test):
    def test_a_path_in_the_plane_is_straight(self):
        points, faces = jittered_grid(12)
        mesh = self.write_off("g.off", points, faces)
        a, b = 4 * 13 + 5, 9 * 13 + 7
        for arithmetic in ("exact", "double"):
            g = self.geodesic(mesh, "--path", f"{a},{b}", "--arithmetic", arithmetic,
                              "-o", "c.obj")
            self.assertEqual(g["status"], "geodesic")
            self.assertTrue(g["certified"])
            self.assert_close(g["length"], distance(points[a], points[b]), 1e-12)
            self.assertEqual(len(g["curves"]), 1)
            self.assertEqual(g["curves"][0]["length"], g["length"])
            self.assertFalse(g["curves"][0]["is_loop"])
            self.assertGreater(g["flips"], 0)
            where, curves = self.obj("c.obj")
            self.assertEqual(list(curves), [0])
            self.assertEqual((where[0], where[-1]), (points[a], points[b]))
            self.assert_close(self.length(where, curves[0]), g["length"], 1e-9)

    def test_opposite_corners_of_a_cube(self):
        mesh = self.write_off("c.off", *CUBE)
        g = self.geodesic(mesh, "--path", "0,7")
        self.assert_geodesic(g)
        self.assert_close(g["length"], math.sqrt(5), 1e-12)
        lower, upper = g["curves"][0]["length_bounds"]
        self.assertLess(lower * lower, 5)
        self.assertGreater(upper * upper, 5)
        self.assertLess(upper - lower, 1e-12)
        self.assertEqual(g["joints"], 0)

    def test_several_paths_that_do_not_cross(self):
        points, faces = grid(8)
        mesh = self.write_off("g.off", points, faces)
        pairs = [(9 * j, 9 * j + 8) for j in (0, 3, 8)]
        g = self.geodesic(mesh, *[x for a, b in pairs for x in ("--path", f"{a},{b}")], "-o", "c.obj")
        self.assert_geodesic(g)
        self.assertEqual(len(g["curves"]), 3)
        self.assertEqual(g["length"], 24)
        self.assertEqual(sorted(self.obj("c.obj")[1]), [0, 1, 2])

    def test_points_in_faces(self):
        points, faces = grid(6)
        mesh = self.write_off("g.off", points, faces)
        # the second line passes a vertex
        for one, other in (((0.25, 0.2, 0.55), (0.3, 0.25, 0.45)),
                           ((0.25, 0.25, 0.5), (0.25, 0.25, 0.5))):
            ends = [[sum(w * points[v][k] for w, v in zip(weights, faces[f])) for k in range(3)]
                    for f, weights in ((3, one), (61, other))]
            names = [f"{f}:" + ":".join(map(str, w)) for f, w in ((3, one), (61, other))]
            g = self.geodesic(mesh, "--path", ",".join(names), "-o", "c.obj")
            self.assert_geodesic(g)
            self.assert_close(g["length"], distance(*ends), 1e-9)
            where, _ = self.obj("c.obj")
            for p, q in zip(ends, (where[0], where[-1])):
                self.assertLess(distance(p, q), 1e-9)
        g = self.geodesic(mesh, "--path", "3:1:0:0,48")
        self.assert_close(g["length"], distance(points[faces[3][0]], points[48]), 1e-12)

    def test_points_in_faces_of_a_file_that_is_renumbered(self):
        points, faces = jittered_grid(257)  # smaller meshes keep their order
        *mixed, _, faces = shuffled(points, faces, 5)
        mesh = self.write_off("s.off", *mixed)
        weights = (0.5, 0.125, 0.375)
        ends = [tuple(sum(w * points[v][k] for w, v in zip(weights, faces[f])) for k in range(3))
                for f in (70000, 200)]
        stats = self.stats("geodesic", mesh, "--path",
                           "70000:0.5:0.125:0.375,200:0.5:0.125:0.375", "-o", "c.obj")
        self.assertTrue(stats["input"]["renumbered"])
        where, _ = self.obj("c.obj")
        self.assertLess(distance(where[0], ends[0]), 1e-9)
        self.assertLess(distance(where[-1], ends[1]), 1e-9)

    def test_waypoints_stay_and_other_points_only_lead(self):
        points, faces = grid(8)
        mesh = self.write_off("g.off", points, faces)
        a, b, c = 0, 4 * 9 + 8, 8 * 9
        free = self.geodesic(mesh, "--path", f"{a},{b},{c}")
        self.assert_geodesic(free)
        self.assert_close(free["length"], distance(points[a], points[c]), 1e-12)
        fixed = self.geodesic(mesh, "--path", f"{a},{b},{c}", "--waypoints")
        self.assert_geodesic(fixed)
        self.assert_close(fixed["length"],
                          distance(points[a], points[b]) + distance(points[b], points[c]), 1e-12)

    def test_curves_cross_and_touch(self):
        points, faces = jittered_grid(8)
        mesh = self.write_off("g.off", points, faces)

        def length(*way):
            return sum(distance(points[a], points[b]) for a, b in zip(way, way[1:]))

        with open(self.path("n.txt"), "w", encoding="ascii") as file:
            file.write("0 40 8 72\nloop 3 77 30\n20 60\n20 60\n")
        g = self.geodesic(mesh, "--network", self.path("n.txt"), "--waypoints")
        self.assert_geodesic(g)
        expected = [length(0, 40, 8, 72), length(3, 77, 30, 3), length(20, 60), length(20, 60)]
        for curve, exact in zip(g["curves"], expected):
            self.assert_close(curve["length"], exact, 1e-9)
        through = self.geodesic(mesh, "--path", "0,31,60,80", "--path", "8,72")
        self.assert_close(through["curves"][0]["length"], length(0, 80), 1e-9)
        self.assert_close(through["curves"][0]["initial_length"], length(0, 31, 60, 80), 1e-9)
        self.assert_close(through["curves"][1]["length"], length(8, 72), 1e-9)

    def test_loops_around_a_cylinder_and_loops_that_contract(self):
        mesh = self.write_off("p.off", *prism(7, 6))
        g = self.geodesic(mesh, "--loop", "14,30,18,26", "-o", "c.obj")
        self.assert_geodesic(g)
        self.assertTrue(g["curves"][0]["is_loop"])
        self.assert_close(g["length"], 7, 1e-12)
        where, curves = self.obj("c.obj")
        self.assertEqual(curves[0][0], curves[0][-1])
        self.assert_close(self.length(where, curves[0]), 7, 1e-9)
        g = self.geodesic(mesh, "--loop", "14,15,22", "-o", "c.obj")
        self.assertEqual(g["status"], "contracted")
        self.assertEqual(g["length"], 0)
        self.assertIn("vertex", g["curves"][0])
        where, curves = self.obj("c.obj")
        self.assertEqual(where, [prism(7, 6)[0][g["curves"][0]["vertex"]]])
        self.assertEqual(curves, {0: [0]})

    def test_a_bezier_curve_in_a_plane(self):
        points, faces = grid(8)
        mesh = self.write_off("g.off", points, faces)
        g = self.geodesic(mesh, "--bezier", "0,8,80", "-o", "c.obj")
        self.assert_geodesic(g)
        a, b, c = points[0], points[8], points[80]
        n = 10000
        exact = 0  # length of a parabola; the polygon of 5 rounds is longer by about 4^-5 of what that of none is
        for i in range(n):
            u = (i + 0.5) / n
            exact += math.hypot(*(2 * (1 - u) * (b[k] - a[k]) + 2 * u * (c[k] - b[k]) for k in range(3))) / n
        self.assert_close(g["length"], exact, 1e-3)
        self.assertGreaterEqual(g["length"], exact * (1 - 1e-9))

    def test_geodesics_from_one_vertex_in_a_plane(self):
        points, faces = grid(8)
        mesh = self.write_off("g.off", points, faces)
        g = self.geodesic(mesh, "--source", "0", "-o", "c.obj")
        self.assert_geodesic(g)
        self.assertEqual(len(g["curves"]), len(points) - 1)

    def test_a_network_has_junctions_where_ends_meet(self):
        points, faces = grid(8)
        mesh = self.write_off("g.off", points, faces)
        net = self.write("n.txt", "# three legs\n0 40\n40 8 # the second\n\n40 76\nloop 50 51 60\n")
        g = self.geodesic(mesh, "--network", net)
        self.assertEqual(g["status"], "geodesic")
        self.assertTrue(g["certified"])
        self.assertEqual([c["status"] for c in g["curves"]], ["geodesic"] * 3 + ["contracted"])
        self.assertEqual([c["is_loop"] for c in g["curves"]], [False] * 3 + [True])
        for c, (a, b) in zip(g["curves"], ((0, 40), (40, 8), (40, 76))):
            self.assert_close(c["length"], distance(points[a], points[b]), 1e-12)

    def test_edges_that_are_marked_or_sharp(self):
        mesh = self.write_off("c.off", *CUBE)
        g = self.geodesic(mesh, "--sharp-angle", "45")
        self.assert_geodesic(g)
        self.assertEqual((len(g["curves"]), g["flips"], g["length"]), (12, 0, 12))
        # a ring around the cube, and an edge beside it
        marked = self.write("m.txt", "0 1\n1 5\n5 4\n4 0\n2 3\n")
        g = self.geodesic(mesh, "--marked", marked)
        self.assertEqual([c["is_loop"] for c in g["curves"]], [False, True])
        self.assert_close(sum(c["initial_length"] for c in g["curves"]), 5, 1e-12)

    def test_shortening_stops_early(self):
        mesh = self.write_off("p.off", *prism(24, 12))
        ends = "--path", f"{24 * 6},{24 * 12 + 9},{24 * 6 + 12}"
        whole = self.geodesic(mesh, *ends)
        self.assert_geodesic(whole)
        part = (1 + whole["length"] / whole["initial_length"]) / 2
        g = self.geodesic(mesh, *ends, "--shorten-to", part)
        self.assertEqual(g["status"], "stopped")
        self.assertIs(g["certified"], False)
        self.assertLessEqual(g["length"], part * g["initial_length"])
        self.assertGreater(g["length"], whole["length"])
        g = self.geodesic(mesh, *ends, "--joint-angle", "120")
        self.assertEqual(g["status"], "stopped")
        self.assertLess(g["flips"], whole["flips"])


class Refinement(Geodesic_test):
    def vertices(self, name):
        """Position and `curve` of the vertices of a PLY file."""
        return [((v["x"], v["y"], v["z"]), v["curve"]) for v in self.read_ply(name)["vertex"]]

    def test_refinement_keeps_curves(self):
        points, faces = jittered_grid(9)
        mesh = self.write_off("g.off", points, faces)
        a, b = 23, 76
        along = [points[b][k] - points[a][k] for k in range(2)]
        stats = self.stats("geodesic", mesh, "--path", "5:0.5:0.25:0.25,9", "--path", f"{a},{b}",
                           "--refine", "--min-angle", "25", "--max-edge-length", "0.3",
                           "--subdivision", "-o", "s.ply")
        self.assert_geodesic(stats["geodesic"])
        self.assert_certified(stats)
        self.assertGreater(stats["refine"]["segment_splits"], 0)
        self.assertEqual(stats["refine"]["unsatisfied"]["refused"], 0)
        on_curve = [p for p, curve in self.vertices("s.ply") if curve == 1]
        self.assertGreater(len(on_curve), 5)
        for x, y, _ in on_curve:
            off = along[0] * (y - points[a][1]) - along[1] * (x - points[a][0])
            self.assertLess(abs(off), 1e-9)
        steps = sorted(on_curve)
        self.assertEqual((steps[0], steps[-1]), tuple(sorted((points[a], points[b]))))
        self.assertLessEqual(max(distance(p, q) for p, q in zip(steps, steps[1:])), 0.3 + 1e-9)

    def test_optimization_keeps_curves(self):
        points, faces = jittered_grid(9)
        mesh = self.write_off("g.off", points, faces)
        stats = self.stats("geodesic", mesh, "--path", "23,76", "--path", "0,9", "--refine", "--odt-length",
                           "0.2", "--arithmetic", "double", "--subdivision", "-o", "s.ply")
        self.assertGreater(stats["odt"]["splits"] + stats["odt"]["moves"], 0)
        on_curve = sorted(p for p, curve in self.vertices("s.ply") if curve == 0)
        a, b = points[23], points[76]
        self.assertEqual((on_curve[0], on_curve[-1]), tuple(sorted((a, b))))
        for x, y, _ in on_curve:
            self.assertLess(abs((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])), 1e-9)
        self.assertGreater(len(on_curve), 10)

    def test_without_curves_edges_would_not_be_there(self):
        points, faces = jittered_grid(5)
        mesh = self.write_off("g.off", points, faces)
        stats = self.stats("geodesic", mesh, "--path", "7,29", "--subdivision", "-o", "s.ply")
        self.assertNotIn("delaunay", stats)
        self.assertGreaterEqual(len([1 for _, c in self.vertices("s.ply") if c == 0]), 2)


class Files(Geodesic_test):
    def test_formats_of_curves(self):
        mesh = self.write_off("g.off", *grid(5))
        self.geodesic(mesh, "--path", "0,34", "-o", "c.vtp")
        with open(self.path("c.vtp"), encoding="ascii") as file:
            text = file.read()
        self.assertIn('NumberOfLines="1"', text)
        self.assertIn('Name="curve"', text)
        self.geodesic(mesh, "--path", "0,34", "-o", "c.ply")
        with open(self.path("c.ply"), "rb") as file:
            self.assertIn(b"element edge", file.read())
        self.geodesic(mesh, "--path", "0,34", "-o", "t.idt")
        self.assertEqual(self.stats("info", self.path("t.idt"))["input"]["vertices"], 36)

    def test_subdivision_with_curves_as_vtp(self):
        mesh = self.write_off("g.off", *grid(5))
        self.geodesic(mesh, "--path", "0,34", "-o", "s.vtp", "--subdivision")
        with open(self.path("s.vtp"), encoding="ascii") as file:
            text = file.read()
        self.assertIn('Name="curve"', text)
        self.assertIn("intrinsic_face", text)

    def test_the_page_has_curves_before_and_after(self):
        points, faces = grid(6)
        mesh = self.write_off("g.off", points, faces)
        run = self.run_program("geodesic", mesh, "--path", "0,46", "--loop", "4,5,12",
                               "--view", "v.html")
        if run.code == 1 and "libjs-three" in run.err:
            self.skipTest("the program was built without three.js")
        self.assertEqual(run.code, 0, run.err)
        with open(self.path("v.html"), encoding="utf-8") as file:
            page = file.read()

        def data(name, letter):
            code = re.search(f'id="{name}"[^>]*>([A-Za-z0-9+/=]*)</script>', page)[1]
            return [x for x, in struct.iter_unpack("<" + letter, base64.b64decode(code))]

        for name, labels in (("curves", [0]), ("initial-curves", [0, 1])):
            sizes = data(name + "-sizes", "i")
            self.assertEqual(len(data(name, "f")), 3 * sum(map(abs, sizes)))
            self.assertEqual(data(name + "-labels", "i"), labels)
            self.assertEqual([size < 0 for size in sizes], [label == 1 for label in labels])
        self.assertIn("curves: geodesic", page)

    def test_two_runs_write_the_same(self):
        mesh = self.write_off("g.off", *jittered_grid(9))
        for name in ("a.vtp", "b.vtp"):
            self.geodesic(mesh, "--path", "0,77", "--path", "30,99", "-o", name)
        self.assert_same_file("a.vtp", "b.vtp")


class Errors(Geodesic_test):
    def setUp(self):
        super().setUp()
        points, faces = beside(*grid(4), 9)
        self.mesh = self.write_off("g.off", points + [(5, 5, 5)], faces)

    def assert_refused(self, arguments, *words):
        self.assert_fails(self.run_program("geodesic", self.mesh, *arguments, "-o", "c.vtp"), *words)
        self.assertFalse(os.path.exists(self.path("c.vtp")))

    def test_elements_that_do_not_exist(self):
        self.assert_refused(("--path", "0,51"), "--path 0,51", "vertex 51", "g.off", "from 0 to 50")
        self.assert_refused(("--loop", "0,1,64:1:0:0"), "face 64", "from 0 to 63")

    def test_vertices_without_faces(self):
        self.assert_refused(("--path", "0,50"), "vertex 50", "isolated", "choose another")

    def test_points_in_different_components(self):
        self.assert_refused(("--path", "3,30"), "vertex 3", "vertex 30", "components")

    def test_marked_edges_that_a_curve_crosses(self):
        with open(self.path("e.txt"), "w", encoding="ascii") as file:
            file.write("10 11\n11 12\n12 13\n13 14\n")
        self.assert_refused(("--marked", self.path("e.txt"), "--path", "2,22"), "--path 2,22",
                            "crosses", "vertex 12", "waypoints")

    def test_points_twice(self):
        self.assert_refused(("--path", "3,3"), "vertex 3", "both ends", "another end")

    def test_files_that_are_malformed(self):
        for text, line, words in (("0 1\n2 x\n", 2, ("number of a vertex",)),
                                  ("\n0 99\n", 2, ("vertex 99", "from 0 to 50")),
                                  ("0\n", 1, ("two vertices",)),
                                  ("0 5\nloop 1 2\n", 2, ("three vertices",))):
            net = self.write("n.txt", text)
            self.assert_refused(("--network", net), f"n.txt:{line}:", *words)
        self.assert_refused(("--network", self.write("n.txt", "# none\n")), "n.txt", "no curves")
        self.assert_refused(("--network", "missing.txt"), "missing.txt")
        marked = self.write("m.txt", "0 1\n0 24\n")
        self.assert_refused(("--marked", marked), "m.txt:2", "no edge")
        self.assert_refused(("--sharp-angle", "90"), "no edge is marked")

    def test_polygons_have_no_barycentric_coordinates(self):
        mesh = self.write_off("c.off", *CUBE)
        run = self.run_program("geodesic", mesh, "--path", "1:0.5:0.5:0,7")
        self.assert_fails(run, "face 1", "polygon")

    def test_misuse(self):
        for arguments, words in (((), ("no curve", "--path")),
                                 (("--path", "1"), ("too few points",)),
                                 (("--source", "0", "--path", "1,2"), ("without other curves",)),
                                 (("--loop", "1,2"), ("too few points",)),
                                 (("--path", "1,b"), ("not a point",)),
                                 (("--path", "1,2:0.5:0.5"), ("not a point",)),
                                 (("--path", "1,2:0.5:0.5:0.5"), ("sum to 1",)),
                                 (("--path", "1,2:1.5:-0.5:0"), ("not a point",)),
                                 (("--path", "0,1", "-o", "c.off"), ("--subdivision",)),
                                 (("--path", "0,1", "-o", "c.xyz"), ("not offered",)),
                                 (("--path", "0,1", "--subdivision"), ("-o",)),
                                 (("--path", "0,1", "--shorten-to", "1.5"), ("--shorten-to",)),
                                 (("--path", "0,1", "--min-angle", "20"), ("--refine",)),
                                 (("--path", "0,1", "--correspondence", "none"),
                                  ("--correspondence",))):
            run = self.run_program("geodesic", self.mesh, *arguments)
            self.assertEqual(run.code, 2, (arguments, run.err))
            for word in words:
                self.assertIn(word, run.err)

    def test_a_stored_triangulation_has_the_points_of_its_mesh(self):
        """In the plane, where geodesics are straight whatever was flipped or inserted before."""
        points, faces = jittered_grid(8)
        mesh = self.write_off("g.off", points, faces)
        weights, face = (0.5, 0.25, 0.25), 37
        inside = [sum(w * points[v][c] for w, v in zip(weights, faces[face])) for c in range(3)]
        way = f"10,{face}:{':'.join(map(str, weights))},70"
        straight = distance(points[10], inside) + distance(inside, points[70])
        for arithmetic in ("exact", "double"):
            for command in (("delaunay",), ("refine", "--min-angle", "25")):
                stored = self.stats(command[0], mesh, *command[1:], "--arithmetic", arithmetic,
                                    "-o", "t.idt")
                through = self.geodesic("t.idt", "--path", way, "--waypoints")
                self.assert_close(through["length"], straight, 1e-9)
                g = self.geodesic("t.idt", "--path", way, "-o", "c.obj")
                self.assertEqual(g["status"], "geodesic")
                self.assert_close(g["length"], distance(points[10], points[70]), 1e-9)
                where, curves = self.obj("c.obj")
                self.assertLess(distance(where[curves[0][0]], points[10]), 1e-12)
                self.assertLess(distance(where[curves[0][-1]], points[70]), 1e-12)
                self.assertGreater(stored["delaunay"]["flips"], 0)

    def test_faces_of_stored_polygons_are_those_of_the_file(self):
        square = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0.5, 0)]
        mesh = self.write_off("s.off", square, [(0, 1, 2, 3), (1, 4, 2)])
        self.stats("delaunay", mesh, "-o", "s.idt")
        for file in (mesh, "s.idt"):
            g = self.geodesic(file, "--path", "1:0:1:0,1:0.5:0:0.5")
            self.assert_close(g["length"], 1, 1e-12)
            self.assert_fails(self.run_program("geodesic", file, "--path", "0:1:0:0,4"),
                              "face 0", "polygon")
            self.assertEqual(self.run_program("geodesic", file, "--path", "2:1:0:0,4").code, 1)


if __name__ == "__main__":
    main()
