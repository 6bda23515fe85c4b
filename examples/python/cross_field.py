# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The smoothest crosses on a rounded cube, and crosses that follow its curvature.

Red and blue points are the centres about which they turn: a quarter turn each, eight on balance.
Usage: cross_field.py [picture.png]
"""

import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection
from numpy.typing import NDArray

import intrinsic as it


def rounded_cube(n: int = 10) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """A cube with n by n squares on each side, rounded and stretched."""
    sides = np.arange(n + 1) / n * 2 - 1
    x, y = (a.ravel() for a in np.meshgrid(sides, sides, indexing="ij"))
    i = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
    a, b, c, d = i[:-1, :-1].ravel(), i[1:, :-1].ravel(), i[1:, 1:].ravel(), i[:-1, 1:].ravel()
    face = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    places: list[NDArray[np.float64]] = []
    faces = []
    for axis in range(3):
        for sign in (-1, 1):
            side = np.roll(np.column_stack([x, y, np.full(len(x), sign)]), axis + 1, axis=1)
            faces.append((face if sign > 0 else face[:, ::-1]) + len(places) * len(x))
            places.append(side)
    V, number = np.unique(np.concatenate(places).round(9), axis=0, return_inverse=True)
    V *= [1.4, 1.0, 0.8] / np.linalg.norm(V, ord=6, axis=1)[:, None]
    return V, number.ravel()[np.concatenate(faces)]


V, F = rounded_cube()
s = it.Surface(V, F)
normal = np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]])
elevation, azimuth = np.radians([25, 35])
view = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth),
                 np.sin(elevation)])
seen = np.zeros(len(V), dtype=bool)
seen[F[normal @ view > 0]] = True  # the others are behind
figure = plt.figure(figsize=(10, 5))
for k, align in enumerate((None, 1.0)):
    field = s.direction_field(4, align=align)
    singular = field.singularities
    print(f"align={align}: {len(singular)} singularities, sum of indices {field.index_sum}")
    size = 0.07
    crosses = np.stack([V + size * d for d in field.vectors] + [V] * 4)
    lines = [(crosses[j + 4][v], crosses[j][v]) for j in range(4) for v in np.flatnonzero(seen)]
    axes = figure.add_subplot(1, 2, k + 1, projection="3d")
    axes.computed_zorder = False
    axes.add_collection3d(Poly3DCollection(V[F], facecolor="white", edgecolor="0.85",
                                           linewidth=0.3, zorder=1))
    axes.add_collection3d(Line3DCollection(lines, colors="0.2", linewidths=0.8, zorder=2))
    front = seen[F[singular.faces]].all(axis=1)
    axes.scatter(*singular.points[front].T, c=singular.index[front], cmap="coolwarm", vmin=-1,
                 vmax=1, s=40, zorder=3, depthshade=False)
    axes.set(title="smoothest" if align is None else "along curvature", xlim=(-1, 1),
             ylim=(-1, 1), zlim=(-1, 1))
    axes.view_init(25, 35)
    axes.set_box_aspect((1, 1, 1), zoom=1.0)
    axes.set_axis_off()
figure.subplots_adjust(0, 0, 1, 0.9, 0, 0)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "cross_field.png", dpi=150)
