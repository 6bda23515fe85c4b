# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of --view: what is in the file, and, where there is Chromium, what it shows."""

import base64
import json
import os
import re
import shutil
import struct
import subprocess
import unittest
import zlib

from cli_support import Cli_test, grid, icosphere, main

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
BACKGROUND = (0xf4, 0xf5, 0xf7)


def read_png(path):
    """Width, height and rows of pixels (3 or 4 bytes each) of a PNG of 8 bits without interlace."""
    with open(path, "rb") as file:
        data = file.read()
    at, idat = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        chunk = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, bits, color, _, _, interlace = struct.unpack(">IIBBBBB", chunk)
            assert bits == 8 and interlace == 0 and color in (2, 6)
        elif kind == b"IDAT":
            idat += chunk
        at += size + 12
    step = 3 if color == 2 else 4
    raw, rows, above = zlib.decompress(idat), [], bytes(width * step)
    for y in range(height):
        begin = y * (width * step + 1)
        method, row = raw[begin], bytearray(raw[begin + 1:begin + 1 + width * step])
        for i in range(len(row)):
            left = row[i - step] if i >= step else 0
            up, corner = above[i], above[i - step] if i >= step else 0
            if method == 1:
                row[i] = (row[i] + left) & 255
            elif method == 2:
                row[i] = (row[i] + up) & 255
            elif method == 3:
                row[i] = (row[i] + (left + up) // 2) & 255
            elif method == 4:
                p = left + up - corner
                a, b, c = abs(p - left), abs(p - up), abs(p - corner)
                row[i] = (row[i] + (left if a <= b and a <= c else up if b <= c else corner)) & 255
        rows.append(bytes(row))
        above = row
    return width, height, step, rows


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


@unittest.skipUnless(CHROMIUM, "there is no Chromium")
class Picture(View_test):
    def screenshot(self):
        command = [CHROMIUM, "--headless=new", "--no-sandbox", "--use-gl=angle",
                   "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars",
                   "--user-data-dir=" + self.path("profile"),
                   "--screenshot=" + self.path("shot.png"), "--window-size=900,600",
                   "--virtual-time-budget=3000", "--enable-logging=stderr",
                   "file://" + self.path("view.html")]
        done = subprocess.run(command, capture_output=True, text=True, timeout=120)
        self.assertEqual([x for x in done.stderr.split("\n") if "CONSOLE" in x and "rror" in x], [])
        return read_png(self.path("shot.png"))

    def test_shows_a_sphere_in_many_colours(self):
        self.view(self.write_off("sphere.off", *icosphere(2)))
        width, height, step, rows = self.screenshot()
        pixels = [tuple(row[i:i + 3]) for row in rows[:height] for i in range(0, width * step, step)]
        colors = {}
        for p in pixels:
            colors[p] = colors.get(p, 0) + 1
        self.assertGreater(colors.get(BACKGROUND, 0), 0.2 * len(pixels))
        vivid = [p for p in colors if max(p) - min(p) > 40]
        self.assertGreater(len(vivid), 50)
        self.assertGreater(sum(colors[p] for p in vivid), 0.1 * len(pixels))
        dark = sum(n for p, n in colors.items() if max(p) < 60)
        self.assertGreater(dark, 0.01 * len(pixels))  # intrinsic edges

    def test_shows_fronts_and_backs_of_a_cover_in_the_same_place(self):
        page = self.view(self.write_off("grid.off", *grid(4)), "--domain", "tufted")
        pictures = [self.screenshot()]
        self.write("view.html", page.replace('<option value="1">', '<option value="1" selected>'))
        pictures.append(self.screenshot())
        different = silhouettes = 0
        width, height, step, fronts = pictures[0]
        for a, b in zip(fronts[:height], pictures[1][3]):
            for i in range(400 * step, width * step, step):  # beside the panel
                p, q = tuple(a[i:i + 3]), tuple(b[i:i + 3])
                different += max(abs(x - y) for x, y in zip(p, q)) > 40
                silhouettes += (p == BACKGROUND) != (q == BACKGROUND)
        self.assertGreater(different, 0.05 * width * height)  # colours of other faces
        self.assertLess(silhouettes, 0.001 * width * height)


if __name__ == "__main__":
    main()
