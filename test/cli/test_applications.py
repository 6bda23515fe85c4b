# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands that solve something on the triangulation."""

import math
import os
import random
import shutil
import subprocess

from cli_support import Cli_test, beside, grid, icosphere, jittered_grid, main


class Applications(Cli_test):
    def setUp(self):
        super().setUp()
        self.points, self.faces = icosphere(3)
        self.sphere = self.write_off("sphere.off", self.points, self.faces)

    def data(self, page, name):
        """The attributes of the data of that name in a page."""
        with open(self.path(page), encoding="utf-8") as file:
            text = file.read()
        begin = text.index(f'id="{name}"')
        return text[begin:text.index(">", begin)]


class Programs(Applications):
    def test_program_of_applications_is_found(self):
        """Beside the program; if it is nowhere the message says how to build it, once the command line is in order."""
        os.mkdir(self.path("alone"))
        shutil.copy2(self.program, self.path("alone"))
        alone = [self.path("alone") + "/intrinsic", "distance", self.sphere]
        options = {"env": {"PATH": self.path("alone")}, "capture_output": True, "text": True}
        done = subprocess.run(alone + ["--source", "0"], **options)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("--target intrinsic-applications", done.stderr)
        done = subprocess.run(alone + ["--no-such-option"], **options)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("--no-such-option", done.stderr)

    def test_other_commands_go_back_to_the_program(self):
        program = os.path.join(os.path.dirname(self.program), "intrinsic-applications")
        outputs = [subprocess.run([p, "info", self.sphere], capture_output=True, text=True).stdout
                   for p in (program, self.program)]
        self.assertIn("642", outputs[0])
        self.assertEqual(outputs[0].splitlines()[:3], outputs[1].splitlines()[:3])


class Stored(Applications):
    def test_methods_go_on_from_stored_triangulations(self):
        """With the same results where Delaunay triangulations are unique, in and outside of files."""
        points, faces = jittered_grid(9)
        points = [(x, y, math.sin(x) * y / 3) for x, y, _ in points]
        mesh = self.write_off("g.off", points, faces)
        for arithmetic in ("exact", "double"):
            self.stats("delaunay", mesh, "--arithmetic", arithmetic, "-o", "t.idt")
            for command, *rest in (("distance", "--source", "3,5:0.25:0.25:0.5"),
                                   ("distance", "--source", "3", "--method", "heat"),
                                   ("eigen", "--count", "3"),
                                   ("logmap", "--source", "44"),
                                   ("parametrize", "--method", "harmonic")):
                self.stats(command, mesh, *rest, "--arithmetic", arithmetic, "-o", "a.txt")
                self.stats(command, "t.idt", *rest, "-o", "b.txt")
                for asked, stored in zip(self.read_rows("a.txt"), self.read_rows("b.txt"), strict=True):
                    for x, y in zip(asked, stored, strict=True):
                        self.assertLess(abs(x - y), 1e-7 * (1 + abs(x)))

    def test_results_are_drawn_on_the_stored_input(self):
        for arithmetic in ("exact", "double"):
            for scale in (1, 1e-30):
                points = [[scale * x for x in p] for p in self.points]
                mesh = self.write_off("s.off", points, self.faces)
                self.stats("refine", mesh, "--arithmetic", arithmetic, "--min-angle", "25", "-o",
                           "t.idt")
                self.stats("distance", "t.idt", "--source", "0", "--on", "input", "-o", "d.obj")
                with open(self.path("d.obj"), encoding="ascii") as file:
                    lines = [line.split() for line in file]
                drawn = [[float(x) for x in words[1:4]] for words in lines if words[0] == "v"]
                self.assertEqual(len(drawn), len(points))
                for p, q in zip(points, drawn):
                    self.assertLess(math.dist(p, q), 1e-14 * scale)
                self.assertEqual(sum(words[0] == "f" for words in lines), len(self.faces))


class Eigen(Applications):
    def test_frequencies_of_a_sphere_are_those_of_spherical_harmonics(self):
        for arithmetic in ("exact", "double"):
            stats = self.stats("eigen", self.sphere, "--count", "9", "--arithmetic", arithmetic,
                               "-o", "e.txt")
            values = stats["eigen"]["values"]
            # l (l + 1) for l = 0, 1, 2, which masses at vertices lower by (frequency h)^2 / 4 of it
            # for edges of h = 0.16
            for got, wanted in zip(values, [0] + 3 * [2] + 5 * [6]):
                self.assertLess(abs(got - wanted), 0.0064 * wanted**2 + 1e-9)
            rows = self.read_rows("e.txt")
            self.assertEqual((len(rows), len(rows[0])), (len(self.points), 9))

    def test_is_written_where_it_is_asked_for(self):
        for on, options in (("subdivision", ()), ("input", ()), ("subdivision", ("--refine",)),
                            ("input", ("--refine", "--min-angle", "30"))):
            stats = self.stats("eigen", self.sphere, "--count", "2", "--on", on, "-o", "e.vtp",
                               *options)
            self.assertTrue(os.path.getsize(self.path("e.vtp")) > 0)
            self.assertEqual("subdivision" in stats, on == "subdivision")
        self.stats("eigen", self.sphere, "--count", "2", "--refine", "--max-circumradius", "0.05",
                   "--on", "input", "-o", "e.txt")
        self.assertEqual(len(self.read_rows("e.txt")), len(self.points))
        self.assert_fails(self.run_program("eigen", self.sphere, "--on", "intrinsic", "-o",
                                           "e.vtp"), "--on subdivision")

    def test_page_has_lines_of_equal_values(self):
        run = self.run_program("eigen", self.sphere, "--count", "3", "--view", "e.html")
        if run.code == 1 and "three.js" in run.err:
            self.skipTest("the program was built without three.js")
        self.assertEqual(run.code, 0, run.err)
        for k in range(3):
            self.assertIn(f'data-name="eigenfunction_{k}"', self.data("e.html", f"field-{k}"))
        self.assertIn('data-shown="1" data-isolines="20" data-edges="hidden"',
                      self.data("e.html", "settings"))

    def test_isolated_vertices_do_not_matter(self):
        mesh = self.write_off("isolated.off", self.points + [[9, 9, 9]], self.faces)
        values = self.stats("eigen", mesh, "--count", "5")["eigen"]["values"]
        self.assertLess(abs(values[0]), 1e-9)
        self.assertLess(abs(values[1] - 2), 0.04)  # it has no mode of its own

    def test_more_than_there_are_is_all(self):
        points, faces = jittered_grid(2)
        mesh = self.write_off("g.off", points, faces)
        self.assertEqual(self.stats("eigen", mesh, "--count", "50")["eigen"]["count"], len(points))
        self.assertEqual(self.run_program("eigen", mesh, "--count", "0").code, 2)


class Solver(Applications):
    def test_iterations_agree_with_factors(self):
        values = {solver: self.stats("eigen", self.sphere, "--count", "4", "--solver",
                                     solver)["eigen"]["values"]
                  for solver in ("auto", "direct", "iterative")}
        self.assertEqual(values["auto"], values["direct"])
        for x, y in zip(values["direct"], values["iterative"]):
            self.assertAlmostEqual(x, y, 9)

    def test_heat_is_not_iterated(self):
        for command in ("distance", "logmap", "transport"):
            result = self.run_program(command, self.sphere, "--solver", "iterative")
            self.assertEqual(result.code, 2)
            self.assertIn("smaller than the residual", result.err)
        self.stats("distance", self.sphere, "--source", "0", "--solver", "direct")

    def test_conformal_maps_are_not_iterated(self):
        result = self.run_program("parametrize", self.sphere, "--method", "conformal", "--solver",
                                  "iterative")
        self.assertEqual(result.code, 2)
        self.assertIn("are factored", result.err)


class Edit(Applications):
    def handles(self, rows):
        return self.write("handles.txt", "".join(" ".join(map(repr, r)) + "\n" for r in rows))

    def test_handles_that_move_alike_move_everything(self):
        file = self.handles([[0, 1, 2, 3], [5, 1, 2, 3]])
        for energy in ("harmonic", "biharmonic"):
            self.stats("edit", self.sphere, "--handles", file, "--energy", energy, "-o", "d.txt")
            for row in self.read_rows("d.txt"):
                self.assertLess(math.dist(row, (1, 2, 3)), 1e-9)

    def test_writes_the_deformed_mesh(self):
        file = self.handles([[0, 0.5, 0, 0], [7, 0, 0, 0], [9, 0, 0, 0]])
        stats = self.stats("edit", self.sphere, "--handles", file, "-o", "d.off", "--on", "input")
        self.assertEqual(stats["edit"]["handles"], 3)
        self.stats("edit", self.sphere, "--handles", file, "-o", "d.txt", "--on", "input")
        with open(self.path("d.off"), encoding="ascii") as out:
            rows = [list(map(float, line.split())) for line in out.readlines()[2:]]
        for p, d, q in zip(self.points, self.read_rows("d.txt"), rows):
            self.assertLess(math.dist([a + b for a, b in zip(p, d)], q), 1e-12)

    def test_refuses_files_that_make_no_sense(self):
        for rows, what in (([[0, 1, 2]], "three coordinates"), ([[99999, 0, 0, 0]], "no such"),
                           ([[0.5, 0, 0, 0]], "no such"),
                           ([[0, 0, 0, 0], [0, 1, 0, 0]], "on line 1")):
            self.assert_fails(self.run_program("edit", self.sphere, "--handles",
                                               self.handles(rows)), what)


class Distance(Applications):
    def distances(self, *options):
        stats = self.stats("distance", self.sphere, "-o", "d.txt", *options)
        return stats["distance"], [row[0] for row in self.read_rows("d.txt")]

    def test_on_a_sphere_is_near_the_angle_and_never_below_the_chord(self):
        for options in ((), ("--refine",), ("--arithmetic", "double")):
            stats, d = self.distances("--source", "0,50", "--method", "heat", *options)
            self.assertEqual((d[0], d[50]), (0, 0))
            self.assertEqual(stats["unreached_vertices"], 0)
            for p, x in zip(self.points, d):
                chord = min(math.dist(p, self.points[i]) for i in (0, 50))
                angle = 2 * math.asin(min(1, chord / 2))
                self.assertGreaterEqual(x, chord * (1 - 1e-12))
                # of first order in edges of 0.16; those between both sources are the worst
                self.assertLess(abs(x - angle), 0.16)

    def test_from_a_point_in_a_face_refined_about_it(self):
        stats, d = self.distances("--source", "7:0.2:0.3:0.5", "--refine", "--method", "heat")
        self.assertGreater(min(d[:len(self.points)]), 0)
        self.assertGreater(stats["max"], 2)
        run = self.run_program("distance", self.sphere, "--source", "7:0.2:0.3:0.5", "--refine",
                               "--adaptive")
        self.assert_fails(run, "about a vertex")
        self.distances("--source", "3", "--refine", "--adaptive", "--tolerance", "0.02")

    def test_has_the_sign_of_the_side_of_a_curve(self):
        points, faces = jittered_grid(8)  # rows of nine vertices
        self.sphere = self.write_off("g.off", points, faces)
        _, d = self.distances("--curve", "4,76", "--signed")
        left, right = d[0], d[8]
        self.assertLess(left * right, 0)
        _, whole = self.distances("--curve", "4,76")
        self.assertGreaterEqual(min(whole), 0)

    def cube(self):
        """Of side 2 about the origin: vertex x + 2 y + 4 z of its corners, faces of two triangles."""
        corners = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
        squares = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        return self.write_off("cube.off", corners,
                              [t for a, b, c, d in squares for t in ((a, b, c), (a, c, d))])

    def test_exact_on_a_cube_are_those_of_its_nets(self):
        self.sphere = self.cube()
        for options in ((), ("--arithmetic", "double"), ("--domain", "tufted"), ("--refine",)):
            stats, d = self.distances("--method", "exact", "--source", "0", *options)
            self.assertEqual((stats["method"], stats["status"], stats["reached"]),
                             ("exact", "done", None))
            self.assertNotIn("time", stats)
            for x, y in zip(d, [0, 2, 2, math.sqrt(8), 2, math.sqrt(8), math.sqrt(8), math.sqrt(20)]):
                self.assert_close(x, y, 1e-13)
            self.assert_close(stats["max"], max(d), 1e-13)

    def test_exact_from_points_in_faces_to_targets(self):
        """From the centre of a square to that of the next and of the opposite one."""
        self.sphere = self.cube()
        centres = ["0:0.5:0:0.5", "4:0.5:0:0.5", "2:0.5:0:0.5"]
        stats, _ = self.distances("--method", "exact", "--source", centres[0], "--targets",
                                  ",".join(centres[1:]), "--targets", "0,7")
        for x, y in zip(stats["targets"], [2, 4, math.sqrt(2), math.sqrt(10)], strict=True):
            self.assert_close(x, y, 1e-13)

    def test_exact_search_ends_early(self):
        points, faces = grid(16)  # convex, so that distances are those in the plane
        self.sphere = self.write_off("g.off", points, faces)
        for options in (("--max-distance", "3.01"), ("--targets", "2")):
            stats, d = self.distances("--method", "exact", "--source", "0", *options)
            known = [(p, x) for p, x in zip(points, d) if math.isfinite(x)]
            self.assertEqual(stats["unreached_vertices"], len(points) - len(known))
            self.assertGreater(stats["unreached_vertices"], len(points) / 2)
            for p, x in known:
                self.assert_close(x, math.dist(p, points[0]), 1e-12)
            self.assertLessEqual(stats["max"], stats["reached"])
            for p, x in zip(points, d):
                if abs(math.dist(p, points[0]) - stats["reached"]) > 1e-9:
                    self.assertEqual(math.isfinite(x), math.dist(p, points[0]) < stats["reached"])
        self.assert_close(stats["targets"][0], math.dist(points[0], points[2]), 1e-12)

    def test_exact_is_null_where_no_path_leads(self):
        points, faces = icosphere(0)
        n = len(points)
        self.sphere = self.write_off("two.off", *beside(points, faces, 9))
        stats, d = self.distances("--method", "exact", "--source", "0", "--targets", f"{n},1")
        self.assertEqual((stats["targets"][0], stats["unreached_vertices"]), (None, n))
        self.assert_close(stats["targets"][1], d[1], 0)

    def test_says_what_is_missing(self):
        for options in ((), ("--signed",), ("--source", "1", "--signed"), ("--curve", "1"),
                        ("--source", "1", "--time-factor", "0"),
                        ("--method", "heat", "--source", "1", "--targets", "2"),
                        ("--method", "heat", "--source", "1", "--max-distance", "2"),
                        ("--source", "1", "--time-factor", "2"),
                        ("--method", "exact", "--source", "1", "--max-distance", "-1"),
                        ("--method", "exact", "--curve", "1,2"),
                        ("--method", "exact", "--source", "1", "--time-factor", "2")):
            self.assertEqual(self.run_program("distance", self.sphere, *options).code, 2, options)
        self.assert_fails(self.run_program("distance", self.sphere, "--source", "9999"), "9999")


class Vectors(Applications):
    def test_transport_keeps_lengths(self):
        file = self.write("v.txt", "0 90 2\n")
        self.stats("transport", self.sphere, "--vectors", file, "-o", "t.txt")
        for length, x, y, *axis in self.read_rows("t.txt"):
            self.assertLess(abs(length - 2), 1e-9)
            self.assertLess(abs(math.hypot(x, y) - 2), 1e-9)
            self.assertLess(abs(math.hypot(*axis) - 1), 1e-9)

    def test_logarithms_are_as_long_as_geodesics(self):
        for method in ("exact", "affine", "polar"):
            self.stats("logmap", self.sphere, "--source", "0", "--method", method, "-o", "l.txt")
            for p, (x, y) in zip(self.points, self.read_rows("l.txt")):
                angle = 2 * math.asin(min(1, math.dist(p, self.points[0]) / 2))
                if angle < 1.5:
                    self.assertLess(abs(math.hypot(x, y) - angle), 0.1)
        self.assertEqual(self.run_program("logmap", self.sphere, "--source", "0,1").code, 1)

    def test_logarithms_tell_what_is_torn_and_unknown(self):
        """The antipode of a sphere is torn; another component is unknown, and so are vectors there."""
        n = len(self.points)
        two = self.write_off("two.off", *beside(self.points, self.faces, 9))
        vectors = self.write("v.txt", "0 90 2\n")
        for method in ("exact", "affine", "polar"):
            stats = self.stats("logmap", two, "--source", "0", "--method", method, "-o",
                               "l.txt")["logmap"]
            self.assertEqual((stats["method"], stats["unknown_vertices"]), (method, n))
            for i, (x, y) in enumerate(self.read_rows("l.txt")):
                self.assertEqual((math.isnan(x), math.isnan(y)), (i >= n, i >= n))
        stats = self.stats("logmap", self.sphere, "--source", "0")["logmap"]
        self.assertEqual((stats["method"], stats["unknown_vertices"]), ("exact", 0))
        self.assertGreater(stats["torn_edges"], 0)
        self.assertGreater(stats["injectivity_radius"], 2)
        self.assertLess(stats["injectivity_radius"], math.pi)
        stats = self.stats("transport", two, "--vectors", vectors, "-o", "t.txt")["transport"]
        self.assertEqual(stats["unknown_vertices"], n)
        self.assertLess(abs(stats["longest"] - 2), 1e-9)

    def test_points_have_logarithms_and_conformal_maps(self):
        generator = random.Random(5)
        points = []
        while len(points) < 800:
            p = [generator.gauss(0, 1) for _ in range(3)]
            points.append([x / math.hypot(*p) for x in p])
        cloud = self.write("p.xyz", "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in points))
        stats = self.stats("logmap", cloud, "--source", "7", "-o", "l.txt")["logmap"]
        self.assertEqual((stats["method"], stats["unknown_vertices"]), ("affine", 0))
        errors = []
        for p, (x, y) in zip(points, self.read_rows("l.txt"), strict=True):
            angle = 2 * math.asin(min(1, math.dist(p, points[7]) / 2))
            if 0 < angle < 1.2:
                errors.append(abs(math.hypot(x, y) - angle) / angle)
        self.assertLess(sum(errors) / len(errors), 0.03)
        for method in ("exact", "polar"):
            self.assert_fails(self.run_program("logmap", cloud, "--source", "7", "--method",
                                               method), "leave out --method")
        disk = self.write("d.xyz", "".join(f"{x!r} {y!r} 3\n" for x, y, _ in points))
        self.stats("parametrize", disk, "--method", "spectral", "-o", "u.txt")
        uv = self.read_rows("u.txt")
        for i, j in ((0, 1), (4, 700), (30, 71)):
            self.assertLess(abs(math.dist(uv[i], uv[j]) - math.dist(points[i][:2], points[j][:2])),
                            1e-6)
        self.assert_fails(self.run_program("parametrize", disk), "--method spectral")

    def test_indices_of_fields_sum_to_the_euler_characteristic(self):
        for degree in (1, 2, 4, 6):
            stats = self.stats("field", self.sphere, "--degree", degree)["field"]
            self.assertEqual(stats["index_sum"], 2 * degree)
            self.stats("field", self.sphere, "--degree", degree, "--singularities", "s.obj")
            with open(self.path("s.obj"), encoding="ascii") as file:
                lines = file.read().splitlines()
            index = [int(line.split()[2]) for line in lines if line.startswith("# index")]
            self.assertEqual(sum(index), 2 * degree)
            self.assertEqual(len(index), stats["singular_faces"])
            self.assertEqual(sum(line.startswith("v ") for line in lines), len(index))
        points, faces = jittered_grid(5)
        mesh = self.write_off("g.off", points, faces)
        stats = self.stats("field", mesh, "--degree", "4")["field"]
        self.assertEqual(stats["index_sum"], 4 + stats["border_turns"])

    def test_files_have_directions_in_space(self):
        """All of them, tangent to the sphere, unit vectors at vertices and turned alike."""
        degree = 4
        for on in ("subdivision", "input"):
            stats = self.stats("field", self.sphere, "--degree", degree, "-o", "f.ply", "--on", on)
            ply = self.read_ply("f.ply")
            for element in ("vertex", "face"):
                for row in ply[element]:
                    all_of_it = [[row[f"direction_{k}_{c}"] for c in "xyz"]
                                 for k in range(degree)]
                    lengths = [math.hypot(*x) for x in all_of_it]
                    if element == "vertex":
                        self.assertLess(abs(lengths[0] - (0 if row.get("kind") == 2 else 1)), 1e-9)
                    for k in range(degree):  # the opposite, and one that is orthogonal
                        opposite, beside = all_of_it[(k + 2) % 4], all_of_it[(k + 1) % 4]
                        # at a vertex directions are in the planes of different faces, 0.15 from
                        # the mean plane
                        bound = 0.2 if element == "vertex" else 1e-9
                        self.assertLess(math.dist(all_of_it[k], [-x for x in opposite]), bound)
                        self.assertLess(abs(sum(x * y for x, y in zip(all_of_it[k], beside))),
                                        bound)
                        self.assertLess(abs(lengths[k] - lengths[0]), 1e-9)
                    if element == "face":
                        corners = [ply["vertex"][v] for v in row["vertex_indices"]]
                        a, b, c = ([p[x] for x in "xyz"] for p in corners[:3])
                        for p in (b, c):  # in the face, up to rounding
                            side = [x - y for x, y in zip(p, a)]
                            normal = [side[1] * all_of_it[0][2] - side[2] * all_of_it[0][1],
                                      side[2] * all_of_it[0][0] - side[0] * all_of_it[0][2],
                                      side[0] * all_of_it[0][1] - side[1] * all_of_it[0][0]]
                            other = [x - y for x, y in zip(b if p is c else c, a)]
                            self.assertLess(abs(sum(x * y for x, y in zip(normal, other))), 1e-9)
            if on == "input":
                self.assertEqual(sum(row["index"] for row in ply["face"]),
                                 stats["field"]["index_sum"])

    def test_vectors_in_text_are_those_of_files(self):
        """On a plane, what a row says of a vector is that vector."""
        points, faces = jittered_grid(6)
        points = [(x, y, 0) for x, y, _ in points]
        mesh = self.write_off("p.off", points, faces)
        sides = [(f[i], f[(i + 1) % 3]) for f in faces for i in range(3)]
        border = {v for s in sides if s[::-1] not in set(sides) for v in s}
        inner = next(v for v in range(len(points)) if v not in border)
        file = self.write("v.txt", f"{inner} 25 3\n")
        self.stats("transport", mesh, "--vectors", file, "-o", "t.txt")
        self.stats("transport", mesh, "--vectors", file, "-o", "t.ply", "--on", "input")
        rows, vertices = self.read_rows("t.txt"), self.read_ply("t.ply")["vertex"]
        angle = None
        for v, ((_, re, im, ex, ey, ez), row) in enumerate(zip(rows, vertices)):
            if v in border:
                continue  # angles there are scaled
            vector = complex(re, im) * complex(ex, ey)
            self.assertLess(abs(vector - complex(row["vector_x"], row["vector_y"])), 1e-9)
            self.assertEqual(ez, 0)
            angle = vector if angle is None else angle
            self.assertLess(abs(vector - angle), 1e-7)  # transport is exact in the plane

    def test_fields_follow_curvature(self):
        """Of an open cylinder the greatest curvature is around it; alone, the smoothest lines may turn as they like."""
        n, rows = 24, 12
        points = [[math.cos(2 * math.pi * (k + 0.5 * (i % 2)) / n),
                   math.sin(2 * math.pi * (k + 0.5 * (i % 2)) / n), 0.25 * i]
                  for i in range(rows) for k in range(n)]
        faces = []
        for i in range(rows - 1):
            for k in range(n):
                a, b = n * i + k, n * i + (k + 1) % n
                c, d = a + n, b + n
                faces += [[a, b, c], [b, d, c]] if i % 2 == 0 else [[a, d, c], [a, b, d]]
        mesh = self.write_off("c.off", points, faces)
        for degree in (2, 4):
            stats = self.stats("field", mesh, "--degree", degree, "--align", "1", "-o", "f.txt")
            self.assertEqual(stats["field"]["alignment"], 1)
            self.assertEqual(stats["field"]["singular_faces"], 0)
        # directions are those of curvature, however strongly it is followed; lines have no sign
        fields = []
        for options in (("--align", "0.1"), ("--align", "100"), ()):
            self.stats("field", mesh, "--degree", "2", "-o", "f.txt", *options)
            fields.append([complex(x, y) ** 2 for x, y, *_ in self.read_rows("f.txt")][3 * n:-3 * n])
        self.assertLess(max(abs(a - b) for a, b in zip(fields[0], fields[1])), 1e-3)
        self.assertGreater(max(abs(a - b) for a, b in zip(fields[0], fields[2])), 1e-2)
        for options in (("--degree", "3", "--align", "1"), ("--degree", "2", "--align", "-1")):
            self.assertEqual(self.run_program("field", mesh, *options).code, 2)


class Parametrize(Applications):
    def test_flat_disks_keep_their_angles(self):
        points, faces = jittered_grid(6)
        mesh = self.write_off("g.off", points, faces)
        for method in ("harmonic", "spectral", "lscm"):
            stats = self.stats("parametrize", mesh, "--method", method, "-o", "p.txt")["parametrize"]
            self.assertTrue(stats["injective"])
            if method != "harmonic":
                self.assertLess(stats["max_quasi_conformal"], 1 + 1e-6)
        self.stats("parametrize", mesh, "-o", "p.obj", "--on", "input")
        with open(self.path("p.obj"), encoding="ascii") as file:
            lines = file.read().split("\n")
        self.assertEqual(sum(line.startswith("vt ") for line in lines), len(points))

    def test_harmonic_maps_are_made_injective(self):
        """Vertices close above others: weights of their other edges are lost beside that of the short one, until edges are split."""
        points, faces = jittered_grid(8)
        for f in (20, 47, 90):
            a, b, c = faces[f]
            tip = len(points)
            points.append((points[a][0], points[a][1], 1e-6))
            faces[f] = [a, b, tip]
            faces += [[b, c, tip], [c, a, tip]]
        mesh = self.write_off("g.off", points, faces)
        stats = self.stats("parametrize", mesh, "-o", "p.txt", "--on", "intrinsic")["parametrize"]
        self.assertEqual((stats["injective"], stats["status"]), (True, "done"))
        self.assertGreater(stats["inserted_vertices"], 0)
        self.assertGreater(stats["rounds"], 0)
        self.assertEqual(len(self.read_rows("p.txt")), len(points) + stats["inserted_vertices"])
        stats = self.stats("parametrize", mesh, "-o", "q.txt", "--on", "input")["parametrize"]
        uv = self.read_rows("q.txt")
        self.assertEqual(uv, self.read_rows("p.txt")[:len(points)])
        area = [(uv[b][0] - uv[a][0]) * (uv[c][1] - uv[a][1])
                - (uv[b][1] - uv[a][1]) * (uv[c][0] - uv[a][0]) for a, b, c in faces]
        self.assertEqual(stats["injective_on_input"], min(area) > 0)
        # edges that are kept are not split
        stats = self.stats("parametrize", mesh, "--sharp-angle", "5")["parametrize"]
        self.assertEqual(stats["inserted_vertices"], 0)


if __name__ == "__main__":
    main()
