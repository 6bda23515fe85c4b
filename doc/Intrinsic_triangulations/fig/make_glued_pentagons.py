#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what the example glued_pentagons writes: glued_pentagons.png.

Usage: make_glued_pentagons.py PENTAGONS.obj
"""

import sys
from pathlib import Path

import matplotlib
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402: the backend comes first
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # noqa: E402

EYE = 35, -60  # degrees
TO_EYE = np.array([np.cos(np.radians(EYE[0])) * np.cos(np.radians(EYE[1])),
                   np.cos(np.radians(EYE[0])) * np.sin(np.radians(EYE[1])),
                   np.sin(np.radians(EYE[0]))])


def solids(path):
    """The points and faces of each polyhedron in the file."""
    lines = [line.split() for line in Path(path).read_text().splitlines()]
    V = np.array([w[1:] for w in lines if w[0] == "v"], float)
    F = np.array([w[1:] for w in lines if w[0] == "f"], int) - 1
    pairs = np.vstack([F[:, [0, 1]], F[:, [1, 2]]])
    number, label = connected_components(
        coo_matrix((np.ones(len(pairs)), pairs.T), shape=(len(V), len(V))), directed=False)
    order = np.unique(label, return_index=True)[1].argsort()
    for k in order:
        yield V[label == k], V[F[label[F[:, 0]] == k]]


def draw(axes, points, faces):
    axes.set_axis_off()
    normals = np.cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 0])
    length = np.linalg.norm(normals, axis=1)
    faces, normals = faces[length > 1e-9], (normals.T / length)[:, length > 1e-9].T
    seen = normals @ TO_EYE > 1e-9
    faces, normals = faces[seen], normals[seen]
    light = .55 + .45 * normals @ np.array([.3, -.5, .81])
    axes.add_collection3d(Poly3DCollection(
        faces, facecolors=plt.cm.YlGnBu_r(.25 + .5 * np.clip(light, 0, 1)), edgecolors="none"))
    sharp = {}
    for face, normal in zip(faces, normals):
        for a, b in zip(face, np.roll(face, -1, axis=0)):
            key = frozenset((tuple(np.round(a, 9)), tuple(np.round(b, 9))))
            sharp.setdefault(key, []).append(normal)
    for key, two in sharp.items():
        if len(key) == 2 and (len(two) < 2 or two[0] @ two[1] < 1 - 1e-9):
            axes.plot(*np.array(sorted(key)).T, color="#102030", linewidth=.8)
    centre, size = (points.max(axis=0) + points.min(axis=0)) / 2, .5
    axes.set_xlim(centre[0] - size, centre[0] + size)
    axes.set_ylim(centre[1] - size, centre[1] + size)
    axes.set_zlim(centre[2] - size, centre[2] + size)
    axes.view_init(*EYE)


def main():
    all_of_them = list(solids(sys.argv[1]))
    rows = -(-len(all_of_them) // 5)
    figure = plt.figure(figsize=(12, 3 * rows))
    for k, (points, faces) in enumerate(all_of_them):
        draw(figure.add_subplot(rows, 5, k + 1, projection="3d", box_aspect=(1, 1, 1)), points, faces)
    figure.subplots_adjust(0, 0, 1, 1, 0, 0)
    figure.savefig(Path(__file__).with_name("glued_pentagons.png"), dpi=100)


if __name__ == "__main__":
    main()
