#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of the page of applications, and those of Delaunay meshes in space: runs the
program, and photographs its pages with Chromium.

usage: make_application_pictures.py INTRINSIC MESH_DIRECTORY EXTRINSIC_DELAUNAY

MESH_DIRECTORY has the meshes of CGAL's data set (Debian: libcgal-demo), EXTRINSIC_DELAUNAY is an
example. Needs Chromium and the Python package PIL.
"""

import os
import shutil
import subprocess
import sys
import tempfile

from PIL import Image

HERE = os.path.dirname(os.path.abspath(__file__))
PANEL = 360  # pixels on the left of each page
SIZE = (360, 300)

# name of the picture: command, mesh, options
PICTURES = {
    "distance": ("distance", "elephant.off", "--source", "100,900", "--method",
                 "heat", "--refine"),
    "signed_distance": ("distance", "elephant.off", "--curve", "100,900,1500", "--signed"),
    "transport": ("transport", "elephant.off", "--vectors", "{vectors}"),
    "logmap": ("logmap", "lion-head.off", "--source", "4000", "--method", "polar"),
    "cross_field": ("field", "lion-head.off", "--degree", "4"),
    "harmonic_map": ("parametrize", "lion-head.off"),
    "conformal_map": ("parametrize", "lion-head.off", "--method", "spectral"),
    "eigenfunction": ("eigen", "elephant.off", "--count", "6", "--refine"),
    "delaunay_by_flips": ("delaunay", "anchor.off"),
    "delaunay_in_space": ("delaunay", "{in_space}"), # nothing is flipped
    "deformation": ("edit", "elephant.off", "--handles", "{handles}", "--on", "input"),
}
FILES = {
    "vectors": "100 0\n",
    # the trunk is lifted, the legs stay
    "handles": "0 0.15 0.05 0\n100 0 0 0\n500 0 0 0\n900 0 0 0\n",
}


def photograph(chromium, page, picture):
    shot = picture + ".shot.png"
    subprocess.run([chromium, "--headless", "--no-sandbox", "--use-gl=angle",
                    "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                    "--ignore-gpu-blocklist", "--window-size=1400,1000",
                    "--virtual-time-budget=10000", "--screenshot=" + shot, "file://" + page],
                   check=True, capture_output=True)
    image = Image.open(shot).convert("RGB")
    width, height = image.size
    image = image.crop((PANEL, 0, width, height))
    room = min(image.width / SIZE[0], image.height / SIZE[1])
    w, h = int(SIZE[0] * room), int(SIZE[1] * room)
    left, top = (image.width - w) // 2, (image.height - h) // 2
    image = image.crop((left, top, left + w, top + h)).resize(SIZE, Image.LANCZOS)
    image.quantize(64).save(picture, optimize=True)
    os.remove(shot)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    program, meshes, extrinsic = sys.argv[1:]
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    if chromium is None:
        sys.exit("Chromium is not found (Debian: chromium)")
    with tempfile.TemporaryDirectory() as directory:
        paths = {}
        for name, text in FILES.items():
            paths[name] = os.path.join(directory, name + ".txt")
            with open(paths[name], "w", encoding="ascii") as file:
                file.write(text)
        paths["in_space"] = os.path.join(directory, "in_space.off")
        subprocess.run([extrinsic, os.path.join(meshes, "anchor.off"), paths["in_space"]],
                       check=True, stdout=subprocess.DEVNULL)
        for name, (command, mesh, *options) in PICTURES.items():
            page = os.path.join(directory, name + ".html")
            subprocess.run([program, command, os.path.join(meshes, mesh.format(**paths)),
                            "--view", page,
                            *(o.format(**paths) for o in options)], check=True)
            photograph(chromium, page, os.path.join(HERE, name + ".png"))
            print(name)


if __name__ == "__main__":
    main()
