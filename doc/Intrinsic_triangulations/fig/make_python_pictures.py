#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of the Python gallery, and those of the README: the pages that `html()` returns,
photographed with Chromium.

usage: make_python_pictures.py MESH_DIRECTORY [NAME...]

MESH_DIRECTORY has the meshes of CGAL's data set (Debian: libcgal-demo). Needs the module intrinsic,
Chromium and the Python package PIL.
"""

import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image

import intrinsic as it

HERE = os.path.dirname(os.path.abspath(__file__))
SIZE = (360, 300)
MOST_BYTES = 60000

# name of the picture: mesh, and the result that shows itself, or what the surface shows
PICTURES = {
    "py_delaunay": ("anchor.off", lambda s: s.delaunay()),
    "py_refine": ("anchor.off", lambda s: s.refine(min_angle=30)),
    "py_distance": ("elephant.off", lambda s: s.html(s.distance(100), marks=100)),
    "py_voronoi": ("elephant.off", lambda s: s.html(
        s.voronoi(s.farthest_points(12).vertices), marks=s.farthest_points(12).vertices)),
    "py_farthest_points": ("elephant.off", lambda s: s.html(
        s.distance(s.farthest_points(12).vertices), s.farthest_points(12))),
    "py_path": ("elephant.off", lambda s: s.path(100, 1500)),
    "py_network": ("elephant.off", lambda s: s.network(
        [[100, v] for v in s.farthest_points(9, start=100).vertices[1:]])),
    "py_trace": ("elephant.off", lambda s: s.html(
        [s.trace(900, np.exp(2j * np.pi * k / 12), 0.3) for k in range(12)], marks=900)),
    "py_isolines": ("elephant.off", lambda s: s.isolines(s.distance(100), 12)),
    "py_cut": ("elephant.off", lambda s: s.cut(s.isolines(s.distance(100), 4))),
    "py_log_map": ("elephant.off", lambda s: s.html(s.log_map(900), marks=900)),
    "py_transport": ("elephant.off", lambda s: s.html(s.transport(900, [1, 0]), marks=900)),
    "py_extend": ("elephant.off", lambda s: s.html(
        s.extend([100, 900, 1500, 2000], [0., 1., 2., 3.]), marks=[100, 900, 1500, 2000])),
    "py_direction_field": ("lion-head.off", lambda s: s.direction_field(4)),
    "py_signed_distance": ("elephant.off", lambda s: s.html(
        s.signed_distance(s.loop([100, 900, 1500])), s.loop([100, 900, 1500]))),
    "py_parametrize": ("lion-head.off", lambda s: s.parametrize()),
    "py_uniformize": ("elephant.off", lambda s: s.uniformize(cones=8)),
    "py_eigen": ("elephant.off", lambda s: s.html(s.eigen(8)[1][:, 7])),
    "py_deform": ("elephant.off", lambda s: it.Surface(
        s.points + s.deform({0: [0.15, 0.05, 0], 100: [0, 0, 0], 500: [0, 0, 0], 900: [0, 0, 0]}),
        s.faces)),
    "py_points": ("elephant.off", lambda s: it.points(s.points)),
}


def photograph(chromium, page, picture, directory):
    shot, file = os.path.join(directory, "shot.png"), os.path.join(directory, "page.html")
    with open(file, "w", encoding="utf-8") as out:
        out.write(page)
    subprocess.run([chromium, "--headless=new", "--no-sandbox", "--use-gl=angle",
                    "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars",
                    "--user-data-dir=" + os.path.join(directory, "profile"),
                    f"--window-size={3 * SIZE[0]},{3 * SIZE[1]}", "--virtual-time-budget=5000",
                    "--screenshot=" + shot, "file://" + file + "#picture"],
                   check=True, capture_output=True, timeout=300)
    image = Image.open(shot).convert("RGB").resize(SIZE, Image.LANCZOS)
    for colors in 128, 64, 32:
        image.quantize(colors).save(picture, optimize=True)
        if os.path.getsize(picture) < MOST_BYTES:
            return


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    if chromium is None:
        sys.exit("Chromium is not found (Debian: chromium)")
    with tempfile.TemporaryDirectory() as directory:
        for name in sys.argv[2:] or PICTURES:
            mesh, show = PICTURES[name]
            shown = show(it.read(os.path.join(sys.argv[1], mesh)))
            page = shown if isinstance(shown, str) else shown.html()
            photograph(chromium, page, os.path.join(HERE, name + ".png"), directory)
            print(name)


if __name__ == "__main__":
    main()
