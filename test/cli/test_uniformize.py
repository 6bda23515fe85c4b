# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scale factors with which surfaces have prescribed angles."""

import json
import math

from cli_support import CUBE, Cli_test, grid, icosphere, main, read_obj, torus, triangles


def angle_sums(points, faces, u):
    """The angles around vertices with lengths scaled by exp((u_i + u_j)/2)."""
    sums = [0] * len(points)
    for face in faces:
        sides = [math.dist(points[i], points[j]) * math.exp((u[i] + u[j]) / 2)
                 for i, j in zip(face, face[1:] + face[:1])]
        for k in range(3):
            a, b, c = sides[k], sides[k - 1], sides[(k + 1) % 3]
            sums[face[k]] += math.acos((a * a + b * b - c * c) / (2 * a * b))
    return sums


def block_with_holes():
    """The surface of a block of unit cubes with two holes through it: genus 2."""
    cubes = {(x, y) for x in range(5) for y in range(3)} - {(1, 1), (3, 1)}
    quads = []
    for x, y in cubes:
        corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
        quads.append([(*c, 1) for c in corners])
        quads.append([(*c, 0) for c in reversed(corners)])
        for k, (i, j) in enumerate(((0, -1), (1, 0), (0, 1), (-1, 0))):
            if (x + i, y + j) not in cubes:
                a, b = corners[k], corners[(k + 1) % 4]
                quads.append([(*a, 0), (*b, 0), (*b, 1), (*a, 1)])
    points = sorted({p for q in quads for p in q})
    number = {p: i for i, p in enumerate(points)}
    return points, triangles([[number[p] for p in q] for q in quads])


class Uniformize(Cli_test):
    def scale(self, mesh, *arguments):
        stats = self.stats("uniformize", mesh, "-o", "u.txt", *arguments)
        return stats, [row[0] for row in self.read_rows("u.txt")]

    def test_isolated_vertices_are_left_out_of_layouts(self):
        points, faces = grid(4)
        mesh = self.write_off("g.off", [*points, (5, 5, 5)], faces)
        stats = self.stats("uniformize", mesh, "-o", "g.obj")["conformal"]
        self.assertEqual((stats["status"], stats["injective"]), ("done", True))
        free = self.write("c.txt", "12 free\n6 5/2pi\n")  # a free vertex inside is a cone
        stats = self.stats("uniformize", mesh, "--cones", free, "-o", "g.obj")["conformal"]
        self.assertEqual((stats["status"], stats["flipped_faces"]), ("done", 0))

    def test_angles_are_the_prescribed_ones(self):
        points, faces = icosphere(2)
        faces = [list(f) for f in faces]
        mesh = self.write_off("s.off", points, faces)
        angles = [x + 0.02 * math.sin(7 * i) for i, x in
                  enumerate(angle_sums(points, faces, [0] * len(points)))]
        angles[0] += math.pi * len(faces) - math.fsum(angles)
        file = self.write("a.txt", "# radians\n" + "".join(f"{x!r}\n" for x in angles))
        for arithmetic in ("exact", "double"):
            stats, u = self.scale(mesh, "--angles", file, "--arithmetic", arithmetic)
            result = stats["conformal"]
            self.assertEqual(result["status"], "done")
            self.assertEqual(result["flips"], 0)  # so that lengths in space can be scaled
            self.assertLess(abs(math.fsum(u)), 1e-12)
            for found, wanted in zip(angle_sums(points, faces, u), angles):
                self.assertLess(abs(found - wanted), 1e-10)
            if arithmetic == "exact":
                self.assertLess(result["proven_residual"], 1e-9)
                self.assertGreater(result["proven_residual"], 0)
            else:
                self.assertIsNone(result["proven_residual"])
            self.assertGreater(stats["seconds"]["uniformize"], 0)

    def test_cones_are_chosen_or_listed(self):
        mesh = self.write_off("s.off", *icosphere(3))
        stats, u = self.scale(mesh, "--cones", "8")
        result = stats["conformal"]
        self.assertEqual((result["status"], result["cones"]), ("done", 8))
        self.assertEqual([c["angle"] for c in result["cone_angles"]], [1.5 * math.pi] * 8)
        file = self.write("c.txt", "".join(f"{c['vertex']} 3/2pi\n" for c in result["cone_angles"]))
        self.assertEqual(self.scale(mesh, "--cones", file)[1], u)
        result = self.scale(mesh, "--cones", "20x")[0]["conformal"]
        self.assertGreaterEqual(result["cones"], 3)
        self.assertLess(result["max_scale_ratio"], 30)
        _, other = self.scale(mesh, "--cones", file, "--start", "input")
        self.assertLess(max(abs(x - y) for x, y in zip(u, other)), 0.1)

    def test_cones_of_clouds_have_the_curvature_of_all_sheets(self):
        for n in range(40, 46):  # spirals; their covers have shares of faces of all kinds
            z = [1 - (2 * i + 1) / n for i in range(n)]
            points = [(math.sqrt(1 - x * x) * math.cos(2.4 * i),
                       math.sqrt(1 - x * x) * math.sin(2.4 * i), x) for i, x in enumerate(z)]
            cloud = self.write_off("c.off", points, [])
            result = self.scale(cloud, "--domain", "points", "--cones", "6")[0]["conformal"]
            self.assertEqual((result["status"], result["cones"]), ("done", 6))
            self.assertLess(result["proven_residual"], 1e-9)

    def test_planar_disks_stay_as_they_are(self):
        points, faces = grid(5)
        stats, u = self.scale(self.write_off("g.off", points, faces))
        self.assertEqual(u, [0] * len(points))
        self.assertEqual(stats["conformal"]["iterations"], 0)
        file = self.write("a.txt", "free\n" * len(points))
        self.assertEqual(self.scale("g.off", "--angles", file)[1], u)

    def layout(self, mesh, *arguments):
        """The corners of the pieces in space and in the plane; all turn counterclockwise."""
        result = self.stats("uniformize", mesh, "-o", "x.obj", *arguments)["conformal"]
        start = arguments[-1] if "--start" in arguments else "delaunay"
        self.assertEqual((result["status"], result["start"]), ("done", start))
        self.assertEqual((result["flipped_faces"], result["degenerate_faces"]), (0, 0))
        self.assertTrue(result["locally_injective"])
        points, places, faces = read_obj(self.path("x.obj"))
        for face in faces:
            z = [complex(*places[c]) for _, c in face]
            self.assertGreater(sum((a.conjugate() * b).imag for a, b in zip(z, z[1:] + z[:1])), 0)
        return result, points, places, faces

    def test_layouts_in_the_plane_keep_the_shape_of_flat_surfaces(self):
        for shape, arguments in ((CUBE, ("--cones", "8")), (grid(6), ())):
            mesh = self.write_off("flat.off", *shape)
            result, x, places, corners = self.layout(mesh, *arguments)
            self.assertTrue(result["injective"])
            self.assertLess(abs(result["mean_quasi_conformal"] - 1), 1e-9)
            self.assertLess(abs(result["max_scale_ratio"] - 1), 1e-9)
            for face in corners:
                for (v, s), (w, t) in zip(face, face[1:] + face[:1]):
                    self.assertLess(
                        abs(math.dist(x[v], x[w]) - math.dist(places[s], places[t])), 1e-9)

    def test_layouts_in_the_plane(self):
        mesh = self.write_off("s.off", *icosphere(3))
        sphere = icosphere(3)[0]
        result, x, places, _ = self.layout(mesh, "--cones", "8", "--view", "x.html")
        for p, q in zip(sphere, x):  # vertices keep their order
            self.assertLess(math.dist(p, q), 1e-12)
        self.assertLess(result["mean_quasi_conformal"], 1.5)
        self.assertGreater(len(places), len(x))
        with open(self.path("x.html"), encoding="utf-8") as file:
            self.assertIn("checks", file.read())
        disk = self.write_off("d.off", *grid(6))
        result, x, places, _ = self.layout(disk, "--cones", "2")
        self.assertEqual((result["cones"], len(x) >= 49, len(places) > len(x)), (2, True, True))
        moebius = [(math.cos(t / 3) * (2 + r * math.cos(t / 6)),
                    math.sin(t / 3) * (2 + r * math.cos(t / 6)), r * math.sin(t / 6))
                   for t in map(lambda i: i * math.pi, range(6)) for r in (-1, 1)]
        strip = [[2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2] for i in range(5)] + [[10, 11, 0, 1]]
        self.assert_fails(self.run_program("uniformize", self.write_off("m.off", moebius, strip),
                                           "-o", "m.obj"), "not oriented alike", "scale factors")
        self.stats("uniformize", mesh, "--cones", "8", "-o", "x.vtp")
        with open(self.path("x.vtp"), encoding="utf-8") as file:
            text = file.read()
        self.assertIn('Name="homogeneous_uv"', text)
        self.assertIn('NumberOfComponents="3"', text)

    def test_layouts_from_both_starts(self):
        points, faces = torus(12, 8)
        faces = triangles(faces)
        sheared = [(x + 2 * z, y, z) for x, y, z in points]  # far from Delaunay
        disk = self.write_off("d.off", [(x, y, x * x / 9) for x, y, _ in grid(6)[0]], grid(6)[1])
        sizes = []
        for mesh in (self.write_off("t.off", sheared, faces), disk):
            for start in ("delaunay", "input"):
                result, x, places, corners = self.layout(mesh, "--cones", "4", "--start", start)
                sizes.append(len(corners))
                area = 0
                for face in corners:  # their sides are on the faces of the mesh: the same area
                    a, *rest = (x[v] for v, _ in face)
                    for b, c in zip(rest, rest[1:]):
                        p, q = ([s - t for s, t in zip(y, a)] for y in (b, c))
                        area += math.hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
                                           p[0] * q[1] - p[1] * q[0])
                sizes.append(area)
        for delaunay, given in ((sizes[1], sizes[3]), (sizes[5], sizes[7])):
            self.assertLess(abs(delaunay / given - 1), 1e-9)
        self.assertGreater(sizes[0], len(faces))

    def test_tori_repeat(self):
        points, faces = torus(12, 8)
        result, _, places, corners = self.layout(self.write_off("t.off", points, triangles(faces)))
        self.assertEqual((result["target"], result["cones"]), ("torus", 0))
        x, y = result["period"]
        self.assertLess(abs(x) * abs(x - 0.5), 1e-9)
        self.assertGreaterEqual(math.hypot(x, y), 1 - 1e-9)
        found = {}
        for v, c in {corner for face in corners for corner in face}:
            found.setdefault(v, []).append(places[c])
        self.assertGreater(max(map(len, found.values())), 1)
        for copies in found.values():
            for place in copies:
                for a, b in zip(place, copies[0]):
                    self.assertLess(abs(a - b - round(a - b)), 1e-6)

    def test_spheres_become_round(self):
        points, faces = icosphere(2)
        mesh = self.write_off("s.off", [(x, y, 3 * z) for x, y, z in points], faces)
        stats, u = self.scale(mesh)
        result = stats["conformal"]
        self.assertEqual((result["status"], result["target"]), ("done", "sphere"))
        self.assertTrue(result["injective"])
        self.assertEqual(len(u), len(points))
        self.assertEqual(result["largest_u"], max(u))
        self.stats("uniformize", mesh, "-o", "x.obj", "--view", "x.html")
        for p in read_obj(self.path("x.obj"))[0][:len(points)]:
            self.assertLess(abs(math.hypot(*p) - 1), 1e-12)
        result = self.layout(mesh, "--target", "plane", "--cones", "3")[0]
        self.assertEqual((result["target"], result["cones"]), ("plane", 3))

    def test_stored_refined_spheres_become_round(self):
        points, faces = icosphere(1)
        mesh = self.write_off("s.off", [(x, y, 3 * z) for x, y, z in points], faces)
        self.stats("refine", mesh, "--max-circumradius", "0.2", "-o", "r.idt")
        for name in ("x.obj", "x.off", "x.vtp"):
            result = self.stats("uniformize", "r.idt", "-o", name, "--view", "x.html")["conformal"]
            self.assertEqual((result["status"], result["target"]), ("done", "sphere"))
        for p in read_obj(self.path("x.obj"))[0][:len(points)]:
            self.assertLess(abs(math.hypot(*p) - 1), 1e-12)

    def test_covers_with_border_are_closed(self):
        points, faces = grid(3)
        mesh = self.write_off("g.off", [(x, y, x * y / 9) for x, y, _ in points], faces)
        _, u = self.scale(mesh)
        self.assertGreater(max(u) - min(u), 1e-3)
        for domain in ("orientation-cover", "closed", "tufted"):
            for x, y in zip(u, self.scale(mesh, "--domain", domain)[1]):
                self.assertLess(abs(x - y), 1e-9)

    def test_a_solver_that_stops_says_so(self):
        points, faces = torus(16, 10)  # scales differ by 1e68: no layout in doubles
        mesh = self.write_off("t.off", [(1e4 * x, y, z) for x, y, z in points], triangles(faces))
        run = self.run_program("uniformize", mesh, "-o", "u.txt", "--stats", "s.json")
        self.assertEqual(run.code, 0)
        with open(self.path("s.json"), encoding="utf-8") as file:
            status = json.load(file)["conformal"]["status"]
        self.assertEqual("t.off: the solver has stopped" in run.err, status != "done")
        self.assertNotIn("not flat", run.err)
        two = self.write_off("two.off", [*points, *((x + 9, y, z) for x, y, z in icosphere(1)[0])],
                             [*triangles(faces), *([v + len(points) for v in f]
                                                   for f in icosphere(1)[1])])
        self.assert_fails(self.run_program("uniformize", two), "two.off", "cones",
                          "take the 2 components one by one")

    def disk(self, mesh, *arguments):
        """The statistics of a layout in the disk, and the places of the pieces."""
        result = self.stats("uniformize", mesh, "-o", "x.obj", *arguments)["conformal"]
        self.assertEqual((result["status"], result["target"]), ("done", "disk"))
        self.assertLess(result["proven_residual"], 1e-9)
        self.assertEqual(result["flipped_geodesic_faces"], 0)
        self.assertLess(max(result["seam_error"], result["relation_error"]), 1e-6)
        _, places, faces = read_obj(self.path("x.obj"))
        radius = max(math.hypot(*p) for p in places)
        self.assertLess(abs(2 * math.atanh(radius) - result["radius"]), 1e-6)
        for a, b, c, d in result["generators"]:
            self.assertLess(abs(math.hypot(a, b)**2 - math.hypot(c, d)**2 - 1), 1e-6)
        return result, places, faces

    def test_surfaces_of_genus_2_become_hyperbolic(self):
        points, faces = block_with_holes()
        mesh = self.write_off("b.off", points, faces)
        result, places, corners = self.disk(mesh, "--view", "x.html")
        self.assertGreaterEqual(len(result["generators"]), 4)
        for a, *_ in result["generators"]:  # no motion of the group has a fixed point
            self.assertGreater(abs(a), 1)
        klein = [[2 * p[k] / (1 + p[0]**2 + p[1]**2) for k in (0, 1)] for p in places]
        for face in corners:  # straight and counterclockwise in Klein's model
            z = [complex(*klein[c]) for _, c in face]
            self.assertGreater(sum((a.conjugate() * b).imag for a, b in zip(z, z[1:] + z[:1])), 0)
        with open(self.path("x.html"), encoding="utf-8") as file:
            self.assertIn('data-disk="1"', file.read())
        # the same surface in another unit
        _, u = self.scale(mesh)
        large = self.write_off("l.off", [[100 * x for x in p] for p in points], faces)
        _, v = self.scale(large)
        for x, y in zip(u, v):
            self.assertLess(abs(x - y - math.log(100)), 1e-8)
        self.assert_fails(self.run_program("uniformize", mesh, "--target", "plane"), "b.off",
                          "Gauss and Bonnet", "too small by")
        file = self.write("c.txt", "0 pi\n5 3/2pi\n")
        self.assertEqual(self.disk(mesh, "--target", "disk", "--cones", file)[0]["cones"], 2)

    def test_borders_become_geodesics(self):
        points, faces = grid(9)
        hole = lambda f: any(all(i <= points[v][0] <= i + 1 and 4 <= points[v][1] <= 5 for v in f)
                             for i in (2, 6))
        faces = [f for f in faces if not hole(f)]
        result = self.disk(self.write_off("g.off", points, faces), "--target", "disk")[0]
        self.assertEqual(result["cones"], 36 + 2 * 4)  # all vertices of the border

    def test_stored_triangulations(self):
        points, faces = grid(4)
        disk = self.write_off("d.off", [(x, y, x * x / 9) for x, y, _ in points], faces)
        for mesh, arguments in ((self.write_off("s.off", *icosphere(1)), ("--view", "x.html")),
                                (disk, ())):
            self.stats("refine", mesh, "--max-circumradius", "0.2", "-o", "r.idt")
            self.stats("delaunay", mesh, "-o", "d.idt")
            _, u = self.scale(mesh, "--start", "input")
            _, v = self.scale("r.idt", "--start", "input", *arguments)
            self.assertEqual(len(u), len(v))  # there are no values at inserted vertices
            for x, y in zip(u, v):
                self.assertLess(abs(x - y), 1e-9)
            for x, y in zip(self.scale(mesh)[1], self.scale("d.idt")[1]):
                self.assertLess(abs(x - y), 1e-9)

    def test_bad_angles_are_refused(self):
        mesh = self.write_off("cube.off", *CUBE)
        refused = lambda *a: self.run_program("uniformize", mesh, *a)
        for target in ("plane", "torus"):
            self.assert_fails(refused("--target", target), "cube.off", "Gauss and Bonnet",
                              "too large by", "(4 pi)")
        self.assert_fails(refused("--target", "disk"), "Gauss and Bonnet", "(-4 pi)",
                          "take the target sphere")
        self.assert_fails(refused("--target", "disk", "--cones", "8"), "list cones", "file")
        self.assert_fails(refused("--target", "sphere", "--cones", "8"), "leave --angles and")
        self.assert_fails(refused("--cones", "2"), "place at least 3")
        self.stats("refine", mesh, "--max-circumradius", "0.3", "-o", "r.idt")
        self.assert_fails(self.run_program("uniformize", "r.idt", "--start", "delaunay"),
                          "inserted", '"input"')
        for text, words in (("pi\n", ("has 1 angles", "8 vertices")),
                            ("-1\n" * 8, ("a.txt:1:", "not positive")),
                            ("xpi\n" * 8, ("a.txt:1:", "3/2pi")),
                            ("1 2\n" * 8, ("a.txt:1:",)),
                            ("3pi/2\n" * 7 + "pi\n", ("too small by", "(0.5 pi)"))):
            self.assert_fails(refused("--angles", self.write("a.txt", text)), *words)
        for text, words in (("8 pi\n", ("c.txt:1:",)), ("1 0\n", ("c.txt:1:", "not positive"))):
            self.assert_fails(refused("--cones", self.write("c.txt", text)), *words)
        file = self.write("a.txt", "3pi/2\n" * 8)
        self.assertEqual(self.scale(mesh, "--angles", file)[1], [0] * 8)
        run = refused("--angles", file, "--cones", "8")
        self.assertEqual(run.code, 2)


if __name__ == "__main__":
    main()
