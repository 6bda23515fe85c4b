# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program `intrinsic` on meshes of the data set, and reads what it writes.

Both are found beside the package in the build tree, or by the variables INTRINSIC_PROGRAM and
INTRINSIC_MESHES. With INTRINSIC_TWENTY_MESHES=1, tests that compare a few meshes compare all that
they can take of the twenty below.
"""

import json
import os
import re
import subprocess
from pathlib import Path

import numpy as np

import intrinsic
from support import With_folder

BUILD = Path(intrinsic.__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("INTRINSIC_PROGRAM", BUILD / "bin" / "intrinsic"))
MESHES = Path(os.environ.get("INTRINSIC_MESHES", BUILD / "cgal_data" / "data" / "meshes"))

# With one border; closed, of genus 0 to 4, some of polygons; with more borders, or faces that
# disagree; of several parts.
DISKS = ("nefertiti.off", "patch-13.off", "patch-30.off", "blob.off", "mushroom.off")
CLOSED = ("hand.off", "rotor.off", "anchor.off", "double-torus-example.off", "eight.off",
          "elephant.off", "mpi.off", "cross_quad.off", "cube-meshed.off")
CONNECTED = DISKS + CLOSED + ("head.off", "mech-holes-shark.off", "double-torus-3-holes.off",
                              "oblong-shuffled.off")
TWENTY = CONNECTED + ("ALSTOM_TEST4.off", "bones.off")


def some(few, many):
    """Returns names of meshes: a few, or all that a test can take if the environment asks so."""
    return many if os.environ.get("INTRINSIC_TWENTY_MESHES") == "1" else few


def is_there():
    """Tells whether the program and the meshes are there."""
    return PROGRAM.exists() and (MESHES / "elephant.off").exists()


def mesh(name):
    """Returns the path, the vertices and the faces of a mesh of the data set."""
    path = MESHES / name
    words = re.sub(r"#.*", "", path.read_text()).split()
    vertices, faces = int(words[1]), int(words[2])
    V = np.array(words[4:4 + 3 * vertices], dtype=float).reshape(-1, 3)
    begin, F = 4 + 3 * vertices, []
    for _ in range(faces):
        end = begin + 1 + int(words[begin])
        F.append([int(v) for v in words[begin + 1:end]])
        begin = end
    return path, V, F


def run(command, path, *options):
    """Runs a command and returns its statistics."""
    result = subprocess.run([PROGRAM, command, path, *map(str, options), "--stats", "-"],
                            capture_output=True, text=True)
    if result.returncode != 0:
        raise RuntimeError(result.stderr)
    return json.loads(result.stdout)


def polylines(path):
    """Reads the points of polylines from an OBJ file; closed ones end with their first point."""
    points, lines = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words and words[0] == "v":
            points.append([float(x) for x in words[1:4]])
        if words and words[0] == "l":
            lines.append([int(x) - 1 for x in words[1:]])
    points = np.array(points)
    return [points[line] for line in lines]


def surface(path):
    """Reads the vertices and the faces, as lists, of an OFF file that has a line for each element,
    also with colours."""
    lines = [line.split() for line in path.read_text().splitlines()]
    lines = [words for words in lines if words and not words[0].startswith("#")]
    begin = 1 if len(lines[0]) == 1 else 0
    vertices, faces = int(lines[begin][0]), int(lines[begin][1])
    rows = lines[begin + 1:]
    V = np.array([words[:3] for words in rows[:vertices]], dtype=float)
    return V, [[int(v) for v in words[1:1 + int(words[0])]]
               for words in rows[vertices:vertices + faces]]


class Comparison(With_folder):
    """Has a folder of its own for what the program writes."""

    def numbers_of_program(self, command, path, *options):
        """Runs a command that writes numbers, and returns its statistics and these."""
        out = self.folder / "x.txt"
        return run(command, path, *options, "-o", out), np.genfromtxt(out)
