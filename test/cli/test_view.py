# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of --view: what is in the file. screenshots.py tests what it shows."""

import base64
import json
import math
import os
import re
import struct

from cli_support import Cli_test, grid, icosphere, main


class View_test(Cli_test):
    def view(self, mesh, *arguments):
        """The page, or a skipped test if the program was built without three.js."""
        run = self.run_program("delaunay", mesh, "--view", self.path("view.html"), *arguments)
        if run.code == 1 and "libjs-three" in run.err:
            self.assertFalse(os.path.exists(self.path("view.html")))
            self.skipTest("the program was built without three.js")
        self.assertEqual(run.code, 0, run.err)
        with open(self.path("view.html"), encoding="utf-8") as file:
            return file.read()

    def data(self, page, name, letter):
        found = re.findall(f'<script type="application/octet-stream;base64" id="{name}"[^>]*>'
                           "([A-Za-z0-9+/=]*)</script>", page)
        self.assertEqual(len(found), 1, name)
        content = base64.b64decode(found[0], validate=True)
        return [x for x, in struct.iter_unpack("<" + letter, content)]


class Page(View_test):
    def test_loads_nothing(self):
        page = self.view(self.write_off("sphere.off", *icosphere(1)))
        tags = re.findall(r"<(?:script|link|img|iframe|style|a)\b[^>]*>", page)
        for tag in tags:
            self.assertNotRegex(tag, r"\b(src|href)\s*=")
        self.assertNotIn("@import", page)
        self.assertIn("The above copyright notice and this permission notice", page)

    def test_title_is_escaped(self):
        page = self.view(self.write_off("a<b>&c.off", *icosphere(0)))
        self.assertIn("<title>a&lt;b&gt;&amp;c.off</title>", page)
        self.assertNotIn("a<b>", page)

    def test_data_is_consistent(self):
        points, faces = icosphere(1)
        points = [(x + 1e8, 3 * y, z / 50) for x, y, z in points]  # flat: many edges are flipped
        for correspondence in ("integer", "signposts", "crossings"):
            page = self.view(self.write_off("flat.off", points, faces),
                             "--correspondence", correspondence)
            point = self.data(page, "points", "f")
            triangle = self.data(page, "triangles", "I")
            source = self.data(page, "sources", "I")
            kind = self.data(page, "kinds", "B")
            self.assertEqual(len(point), 3 * len(kind))
            self.assertEqual(len(kind), max(triangle) + 1)
            self.assertEqual(kind.count(0), len(points))
            self.assertGreater(kind.count(2), 0)
            self.assertEqual(set(source[1::2]), set(range(len(faces))))
            self.assertEqual(len(set(source[0::2])), len(faces))
            self.assertEqual(len(self.data(page, "colors", "B")), len(triangle))
            for name in ("input-edges", "intrinsic-edges"):
                edges = self.data(page, name, "I")
                self.assertEqual(len(edges), 2 * len(self.data(page, name + "-room", "f")))
                self.assertGreaterEqual(len(edges), 2 * (len(points) + len(faces) - 2))
            self.assertLessEqual(max(map(abs, point)), 1)

    def test_covers_have_fronts_and_backs(self):
        points = [(0, 0, 0), (4, 0, 0), (0, 5, 0), (1, 1, 6), (-3, 2, -5)]
        faces = [(0, 1, 2), (0, 1, 3), (1, 0, 4), (2, 0, 3)]
        page = self.view(self.write_off("fins.off", points, faces))
        sheet = self.data(page, "sheets", "B")
        corner = self.data(page, "triangles", "I")
        source = self.data(page, "sources", "I")
        xyz = self.data(page, "points", "f")
        triangles = list(zip(*[iter(corner)] * 3))
        self.assertEqual(len(sheet), len(triangles))

        def normal(a, b, c):
            u, v = ([y - x for x, y in zip(a, p)] for p in (b, c))
            return [u[i] * v[j] - u[j] * v[i] for i, j in ((1, 2), (2, 0), (0, 1))]

        for t, triangle in enumerate(triangles):
            piece = normal(*(xyz[3 * v:3 * v + 3] for v in triangle))
            whole = normal(*(points[v] for v in faces[source[2 * t + 1]]))
            self.assertEqual(sheet[t] == 0, sum(a * b for a, b in zip(piece, whole)) > 0)
        for name in ("input-edges", "intrinsic-edges"):
            ends = list(zip(*[iter(self.data(page, name, "I"))] * 2))
            beside = self.data(page, name + "-sheets", "B")
            self.assertEqual(len(ends), len(beside))
            for side in (0, 1):
                shown = [set(e) for e, mask in zip(ends, beside) if mask >> side & 1]
                self.assertTrue(shown)
                for e in shown:
                    self.assertTrue(any(e <= set(triangle) for t, triangle in enumerate(triangles)
                                        if sheet[t] == side))
        plain = self.view(self.write_off("grid.off", *grid(2)))
        self.assertEqual(self.data(plain, "sheets", "B"), [])
        self.assertEqual(self.data(plain, "input-edges-sheets", "B"), [])

    def test_two_runs_write_the_same(self):
        mesh = self.write_off("grid.off", *grid(4))
        self.assertEqual(self.view(mesh), self.view(mesh))


class Bound(View_test):
    def test_pages_are_thinned_out_to_their_limit_and_say_so(self):
        points, faces = icosphere(5)
        mesh = self.write_off("sphere.off", points, faces)
        whole = self.view(mesh)
        self.assertNotIn("thinned out", whole)
        self.assertGreater(len(whole), 2.5e6)
        run = self.run_program("delaunay", mesh, "--view", self.path("thin.html"), "--view-limit", "2")
        self.assertEqual(run.code, 0, run.err)
        self.assertIn("thin.html: thinned out: ", run.err)
        self.assertIn("--view-limit", run.err)
        with open(self.path("thin.html"), encoding="utf-8") as file:
            thin = file.read()
        self.assertIn("thinned out", thin)
        self.assertLess(len(thin.encode()), 2e6)
        self.assertGreater(len(thin.encode()), 1.5e6)
        triangle = self.data(thin, "triangles", "I")
        self.assertEqual(max(triangle) + 1, len(self.data(thin, "kinds", "B")))
        self.assertIn(f"{len(triangle) // 3} of {len(faces)} pieces", run.err)

    def test_geodesics_to_all_vertices(self):
        points, faces = icosphere(4)
        points = [(x, 3 * y, z) for x, y, z in points]
        mesh = self.write_off("long.off", points, faces)
        run = self.run_program("geodesic", mesh, "--source", "0", "--view", self.path("view.html"),
                               "--view-limit", "3", "--stats", "-", "--records",
                               self.path("curves.jsonl"))
        if run.code == 1 and "libjs-three" in run.err:
            self.skipTest("the program was built without three.js")
        self.assertEqual(run.code, 0, run.err)
        self.assertLess(os.path.getsize(self.path("view.html")), 3e6)
        stats, n = run.json(), len(points) - 1
        self.assertEqual(stats["records"], {"geodesic.curves": n})
        self.assertEqual(len(stats["geodesic"]["curves"]), 1000)
        with open(self.path("curves.jsonl"), encoding="utf-8") as file:
            records = [json.loads(line) for line in file]
        self.assertEqual([r.pop("number") for r in records], list(range(n)))
        self.assertEqual({r.pop("list") for r in records}, {"geodesic.curves"})
        self.assertEqual(records[:1000], stats["geodesic"]["curves"])
        with open(self.path("view.html"), encoding="utf-8") as file:
            page = file.read()
        self.assertEqual(self.data(page, "initial-curves", "f"), [])  # they are no other
        sizes = self.data(page, "curves-sizes", "i")
        self.assertEqual(len(self.data(page, "curves", "f")), 3 * sum(map(abs, sizes)))
        self.assertEqual(len(self.data(page, "curves-labels", "i")), len(sizes))


class Files(View_test):
    """The command view, and pages of functions."""

    def test_shows_values_and_curves_of_files(self):
        mesh = self.write_off("grid.off", *grid(4))
        self.write("height.txt", "".join(f"{0.5 * i} {i % 3}\n" for i in range(25)))
        self.write("line.obj", "v 0 0 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\n# level 7\nl 1 2 3\nl 1 3 4 1\n")
        run = self.run_program("view", mesh, self.path("height.txt"), self.path("line.obj"), "-o",
                               self.path("view.html"))
        self.assertEqual((run.code, run.err), (0, ""))
        self.assertIn(self.path("view.html") + ": a page for the browser", run.out)
        with open(self.path("view.html"), encoding="utf-8") as file:
            page = file.read()
        self.assertEqual(re.findall(r'data-classes="(\d)"', page), ["0", "1"])
        self.assertEqual(self.data(page, "curves-sizes", "i"), [3, -3])
        self.assertEqual(self.data(page, "curves-labels", "i"), [7, 1])
        self.assertEqual(len(self.data(page, "points", "f")), 75)

    def test_shows_what_commands_write_for_curves(self):
        mesh = self.write_off("grid.off", *grid(4))
        shown = []
        for name in ("curves.vtp", "curves.obj", "curves.ply"):
            written = self.run_program("geodesic", mesh, "--path", "0,14", "--path", "4,20,9",
                                       "--loop", "6,8,18", "--waypoints", "-o", self.path(name))
            self.assertEqual(written.code, 0, written.err)
            run = self.run_program("view", mesh, self.path(name), "-o", self.path("view.html"))
            self.assertEqual((run.code, run.err), (0, ""))
            with open(self.path("view.html"), encoding="utf-8") as file:
                page = file.read()
            shown.append([self.data(page, key, letter) for key, letter in (
                ("curves", "f"), ("curves-sizes", "i"), ("curves-labels", "i"))])
        self.assertEqual(shown[0][2], [0, 1, 2])
        self.assertEqual(shown, shown[:1] * 3)
        for name in ("cut.vtp", "cut.ply"):
            self.run_program("cut", mesh, "--path", "0,24", "-o", self.path(name))
            self.assert_fails(self.run_program("view", mesh, self.path(name)), name, "surface")

    def test_shows_distances_that_are_infinite(self):
        points, faces = grid(4)
        mesh = self.write_off("two.off", points + [(x, y, 9) for x, y, _ in points],
                              faces + [tuple(v + 25 for v in f) for f in faces])
        written = self.run_program("distance", mesh, "--source", "0", "-o", self.path("d.txt"))
        self.assertEqual(written.code, 0, written.err)
        with open(self.path("d.txt"), encoding="utf-8") as file:
            self.assertIn("inf", file.read())
        run = self.run_program("view", mesh, self.path("d.txt"), "-o", self.path("view.html"))
        self.assertEqual((run.code, run.err), (0, ""))
        with open(self.path("view.html"), encoding="utf-8") as file:
            values = self.data(file.read(), "field-0", "f")
        self.assertEqual(len(values) - sum(map(math.isfinite, values)), 25)
        lines = self.stats("cut", mesh, "--values", self.path("d.txt"), "--levels", "2",
                           "-o", self.path("c.ply"))["isolines"]
        self.assertEqual(len(lines["levels"]), 2)

    def test_shows_values_of_faces(self):
        mesh = self.write_off("grid.off", *grid(4))
        self.write("area.txt", "".join(f"{0.5 * i} {i % 3}\n" for i in range(32)))
        run = self.run_program("view", mesh, self.path("area.txt"), "-o", self.path("view.html"))
        self.assertEqual((run.code, run.err), (0, ""))
        with open(self.path("view.html"), encoding="utf-8") as file:
            page = file.read()
        self.assertEqual(re.findall(r'data-classes="(\d)"', page), ["0", "1"])
        corner, source = self.data(page, "triangles", "I"), self.data(page, "sources", "I")[1::2]
        value = self.data(page, "field-0", "f")
        self.assertEqual(len(corner), 3 * len(source))
        for i, v in enumerate(corner):
            self.assertAlmostEqual(value[v], source[i // 3] / 31, places=6)
        self.assertEqual(len(set(corner)), len(corner))

    def test_without_a_name_the_page_is_temporary(self):
        run = self.run_program("view", self.write_off("grid.off", *grid(2)))
        self.assertEqual(run.code, 0, run.err)
        path = re.search(r"^written +(.*): a page for the browser$", run.out, re.MULTILINE)[1]
        self.addCleanup(os.remove, path)
        self.assertTrue(os.path.basename(path).startswith("intrinsic-grid-"))
        with open(path, encoding="utf-8") as file:
            self.assertIn("<title>grid.off</title>", file.read())

    def test_says_what_is_wrong_with_a_file(self):
        mesh = self.write_off("grid.off", *grid(2))
        self.assert_fails(self.run_program("view", mesh, self.write("few.txt", "1\n2\n")), "few.txt")
        self.assert_fails(self.run_program("view", mesh, self.write("bad.obj", "v 0 0 0\nl 1 2\n")),
                          "bad.obj", "line 2")
        self.assert_fails(self.run_program("view", mesh, self.write("none.obj", "v 0 0 0\n")),
                          "none.obj", "elements l")

    def test_transferred_functions(self):
        mesh = self.write_off("grid.off", *grid(3))
        self.write("f.txt", "".join(f"{i * i}\n" for i in range(16)))
        run = self.run_program("transfer", mesh, self.path("f.txt"), "--view", self.path("view.html"))
        self.assertEqual(run.code, 0, run.err)
        with open(self.path("view.html"), encoding="utf-8") as file:
            page = file.read()
        self.assertEqual(re.findall('data-name="([^"]*)"', page),
                         ["field_on_input", "field_on_intrinsic"])
        self.assertIn('data-shown="1"', page)

    def test_plain_files_have_no_labels(self):
        mesh = self.write_off("grid.off", *grid(3))
        for name, options in ("plain.ply", ["--plain"]), ("all.ply", []):
            self.assertEqual(self.run_program("delaunay", mesh, "-o", self.path(name), *options).code, 0)
        plain, whole = self.read_ply("plain.ply"), self.read_ply("all.ply")
        self.assertEqual((set(plain), set(whole)), ({"vertex", "face"}, {"vertex", "face", "edge"}))
        self.assertEqual(set(plain["vertex"][0]), {"x", "y", "z"})
        self.assertEqual(set(plain["face"][0]), {"vertex_indices"})
        run = self.run_program("distance", mesh, "--source", "0", "--on", "input", "-o", self.path("d.ply"))
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(set(self.read_ply("d.ply")["vertex"][0]), {"x", "y", "z", "distance"})
        run = self.run_program("geodesic", mesh, "--path", "0,15", "--subdivision", "--plain", "-o",
                               self.path("g.ply"))
        self.assertEqual((run.code, set(self.read_ply("g.ply"))), (0, {"vertex", "face"}), run.err)
        self.run_program("delaunay", mesh, "-o", self.path("plain.off"), "--plain")
        with open(self.path("plain.off"), encoding="ascii") as file:
            self.assertEqual({len(line.split()) for line in file.read().splitlines()[-3:]}, {4})


class Arguments(Cli_test):
    def test_the_page_needs_a_correspondence(self):
        mesh = self.write_off("grid.off", *grid(2))
        run = self.run_program("delaunay", mesh, "--view", "v.html", "--correspondence", "none")
        self.assertNotEqual(run.code, 0)
        self.assertIn("--correspondence", run.err)
        self.assertFalse(os.path.exists(self.path("v.html")))

    def test_the_page_cannot_be_written(self):
        mesh = self.write_off("grid.off", *grid(2))
        self.assert_fails(self.run_program("delaunay", mesh, "--view", "missing/v.html"), "v.html")


if __name__ == "__main__":
    main()
