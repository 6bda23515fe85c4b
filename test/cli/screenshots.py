# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What pages show in a browser: screenshots by Chromium of each kind of page. `.ci/run` runs it,
and not the tests, since it takes minutes.

usage: screenshots.py --intrinsic PROGRAM
"""

import math
import os
import shutil
import struct
import subprocess
import unittest
import zlib

from cli_support import Cli_test, grid, icosphere, main

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
BACKGROUND = (0xf4, 0xf5, 0xf7)
KEPT = os.environ.get("KEEP_SCREENSHOTS")  # a directory, to look at them


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


class Screenshot:
    """The pixels of a page, without its panel."""

    def __init__(self, path, left):
        width, height, step, rows = read_png(path)
        self.rows = [[tuple(row[i:i + 3]) for i in range(left * step, width * step, step)]
                     for row in rows[:height]]
        self.pixels = [p for row in self.rows for p in row]

    def share(self, holds):
        return sum(map(holds, self.pixels)) / len(self.pixels)

    def background(self):
        return self.share(lambda p: p == BACKGROUND)

    def dark(self):
        """The share of dark pixels among those of the model."""
        return self.share(lambda p: max(p) < 60) / (1 - self.background())

    def like(self, color, distance=40):
        return self.share(lambda p: max(abs(a - b) for a, b in zip(p, color)) < distance)

    def hues(self):
        """How many different hues cover a thousandth of the picture each."""
        counts = {}
        for r, g, b in self.pixels:
            if max(r, g, b) - min(r, g, b) > 40:
                angle = math.atan2(math.sqrt(3) * (g - b), 2 * r - g - b)
                key = round(angle * 9 / math.pi)
                counts[key] = counts.get(key, 0) + 1
        return sum(n > 0.001 * len(self.pixels) for n in counts.values())


@unittest.skipUnless(CHROMIUM, "there is no Chromium")
class Pictures(Cli_test):
    def screenshot(self, *arguments, name="view", size=(900, 600), left=310, edit=None, anchor=""):
        if arguments:
            run = self.run_program(*arguments, "--view", self.path("view.html"))
            self.assertEqual(run.code, 0, run.err)
        if edit:
            with open(self.path("view.html"), encoding="utf-8") as file:
                page = file.read()
            self.assertIn(edit[0], page)
            self.write("view.html", page.replace(*edit))
        shot = self.path("shot.png")
        if os.path.exists(shot):
            os.remove(shot)
        command = [CHROMIUM, "--headless=new", "--no-sandbox", "--use-gl=angle",
                   "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars",
                   "--user-data-dir=" + self.path("profile"), "--screenshot=" + shot,
                   f"--window-size={size[0]},{size[1]}", "--virtual-time-budget=3000",
                   "--enable-logging=stderr", "file://" + self.path("view.html") + anchor]
        done = subprocess.run(command, capture_output=True, text=True, timeout=240)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([x for x in done.stderr.split("\n") if "CONSOLE" in x and "rror" in x], [])
        if KEPT:
            shutil.copy(shot, os.path.join(KEPT, f"{self.id().split('.')[-1]}_{name}.png"))
        picture = Screenshot(shot, left)
        self.assertGreater(picture.background(), 0.1)
        self.assertLess(picture.background(), 0.9)
        return picture

    def sphere(self, levels=3, stretch=(1, 1, 1)):
        points, faces = icosphere(levels)
        return self.write_off("sphere.off", [[x * s for x, s in zip(p, stretch)] for p in points],
                              faces)

    def test_triangulations_have_many_colours_and_dark_edges(self):
        picture = self.screenshot("delaunay", self.sphere(2))
        self.assertGreater(picture.hues(), 4)
        self.assertGreater(picture.dark(), 0.02)

    def test_fields_have_the_colours_of_the_map_and_isolines(self):
        picture = self.screenshot("distance", self.sphere(), "--source", "0", "--method", "exact")
        self.assertGreater(picture.hues(), 3)
        self.assertGreater(picture.dark(), 0.05)
        self.assertLess(picture.dark(), 0.45)

    def test_cells_have_a_colour_each_and_borders(self):
        sphere = self.sphere()
        picture = self.screenshot("distance", sphere, "--source", "0,1,2,3,4", "--method", "exact",
                                  "--voronoi", self.path("cells.obj"))
        self.assertGreater(picture.hues(), 2)
        self.assertGreater(picture.dark(), 0.002)
        self.assertLess(picture.dark(), 0.08)  # not black with speckles

    def test_constants_have_one_colour_and_no_isolines(self):
        sphere = self.sphere()
        self.write("one.txt", "1.5\n" * 642)
        run = self.run_program("view", sphere, self.path("one.txt"), "-o", self.path("view.html"))
        self.assertEqual(run.code, 0, run.err)
        picture = self.screenshot()
        self.assertLess(picture.dark(), 0.005)
        self.assertEqual(picture.hues(), 1)

    def test_each_face_has_the_colour_of_its_value(self):
        sphere = self.sphere()
        self.write("faces.txt", "".join(f"{i // 256}\n" for i in range(1280)))
        run = self.run_program("view", sphere, self.path("faces.txt"), "-o", self.path("view.html"))
        self.assertEqual(run.code, 0, run.err)
        self.assertGreater(self.screenshot().hues(), 2)

    def test_curves_are_seen_from_where_the_page_opens(self):
        sphere = self.sphere(3, (1, 1, 1.5))
        for name, ends in ("front", "0,3"), ("aside", "4,6"), ("below", "8,9"):
            picture = self.screenshot("geodesic", sphere, "--path", ends, name=name)
            self.assertGreater(picture.like((0xe6, 0x19, 0x4b)), 0.001)

    def test_hidden_curves_shine_through(self):
        sphere = self.sphere(3)
        self.screenshot("geodesic", sphere, "--path", "0,3", name="all")
        before = self.screenshot(name="turned", edit=(
            "controls.update();\n  draw();", "camera.position.negate(); camera.lookAt(target);\n"
            "  controls.update();\n  draw();"))
        pale = before.share(lambda p: p[0] - p[1] > 12 and p[0] - p[1] < 120)
        self.assertGreater(pale, 0.0005)

    def test_maps_show_the_model_and_its_layout_beside_each_other(self):
        mesh = self.write_off("grid.off", *grid(12))
        picture = self.screenshot("parametrize", mesh)
        half = len(picture.rows[0]) // 2
        for part in (0, half), (half, 2 * half):
            shares = [sum(p != BACKGROUND for row in picture.rows for p in row[slice(*part)])
                      / (half * len(picture.rows))]
            self.assertGreater(shares[0], 0.2)
        below = self.screenshot(name="narrow", size=(500, 900), left=0)
        for rows in below.rows[:450], below.rows[500:]:
            self.assertGreater(sum(p != BACKGROUND for row in rows for p in row), 0.15 * 450 * 500)

    def test_logarithms_end_at_the_radius(self):
        n = 24
        turn = [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n)) for i in range(n)]
        points = [(x, y, z / 4) for z in range(-24, 25) for x, y in turn]
        faces = [f for z in range(48) for i in range(n) for j in [(i + 1) % n] for f in
                 ((n * z + i, n * z + j, n * z + n + i), (n * z + j, n * z + n + j, n * z + n + i))]
        tube = self.write_off("tube.off", points, faces)
        picture = self.screenshot("logmap", tube, "--source", str(n * 24))
        half = len(picture.rows[0]) // 2
        layout = [row[half:] for row in picture.rows[40:-90]]  # without texts and axes
        inside = [(x, y) for y, row in enumerate(layout) for x, p in enumerate(row)
                  if p != BACKGROUND and max(p) - min(p) < 12 and 40 < p[0] < 225]
        width = max(x for x, _ in inside) - min(x for x, _ in inside)
        height = max(y for _, y in inside) - min(y for _, y in inside)
        self.assertLess(abs(width - height), 0.3 * height)  # a disk, and not the long strip

    def test_fields_of_directions_have_lines_and_singularities(self):
        picture = self.screenshot("field", self.sphere(), "--degree", "4")
        self.assertGreater(picture.dark(), 0.02)
        self.assertGreater(picture.like((214, 25, 28)), 0.0005)

    def test_transported_vectors_are_arrows(self):
        self.write("vectors.txt", "0 30\n")
        picture = self.screenshot("transport", self.sphere(), "--vectors", self.path("vectors.txt"))
        self.assertGreater(picture.dark(), 0.01)
        self.assertLess(picture.dark(), 0.3)

    def test_layouts_with_cones(self):
        picture = self.screenshot("uniformize", self.sphere(2), "--cones", "4")
        self.assertGreater(picture.dark() + picture.like((110, 110, 112), 30), 0.02)

    def test_cut_surfaces(self):
        sphere = self.sphere()
        picture = self.screenshot("cut", sphere, "--source", "0", "--levels", "3")
        self.assertGreater(picture.hues(), 1)

    def test_shows_fronts_and_backs_of_a_cover_in_the_same_place(self):
        mesh = self.write_off("grid.off", *grid(4))
        fronts = self.screenshot("delaunay", mesh, "--domain", "tufted", name="fronts")
        backs = self.screenshot(name="backs", edit=('<option value="1">',
                                                    '<option value="1" selected>'))
        pairs = list(zip(fronts.pixels, backs.pixels))
        different = sum(max(abs(x - y) for x, y in zip(p, q)) > 40 for p, q in pairs)
        silhouettes = sum((p == BACKGROUND) != (q == BACKGROUND) for p, q in pairs)
        self.assertGreater(different, 0.05 * len(pairs))  # colours of other faces
        self.assertLess(silhouettes, 0.001 * len(pairs))

    def test_the_panel_is_folded_in_a_narrow_window(self):
        picture = self.screenshot("delaunay", self.sphere(2), size=(500, 800), left=0)
        white = picture.share(lambda p: min(p) > 250)
        self.assertLess(white, 0.12)

    def test_a_picture_alone(self):
        picture = self.screenshot("delaunay", self.sphere(2), left=0, anchor="#picture")
        self.assertLess(picture.share(lambda p: min(p) > 250), 0.01)

    def test_opacity_smoothness_and_scale(self):
        mesh = self.sphere()
        self.screenshot("distance", mesh, "--source", "0", "--method", "exact", name="linear")
        linear = self.screenshot(name="linear")
        logarithmic = self.screenshot(name="log", edit=(
            'id="logarithmic">', 'id="logarithmic" checked>'))
        self.assertNotEqual(linear.pixels, logarithmic.pixels)


if __name__ == "__main__":
    main()
