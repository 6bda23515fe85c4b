# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The logarithmic map of a vertex of a bumpy sphere, as a checkerboard on the surface.

Around the vertex squares are as large as on the plane; the map tears behind it, where several
paths are shortest. Usage: log_map.py [picture.png]
"""

import sys
from typing import Literal

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from numpy.typing import NDArray

import intrinsic as it

METHODS: tuple[Literal["exact", "affine"], ...] = "exact", "affine"


def bumpy_sphere(n: int = 48) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Rings of 2 n vertices between two poles."""
    t, p = np.meshgrid(np.pi * np.arange(1, n) / n, np.pi * np.arange(2 * n) / n, indexing="ij")
    r = 1 + 0.08 * np.cos(5 * p) * np.sin(t) ** 3
    V = np.stack([r * np.sin(t) * np.cos(p), r * np.sin(t) * np.sin(p), r * np.cos(t)], axis=-1)
    i = np.arange((n - 1) * 2 * n).reshape(n - 1, 2 * n)
    a, b, c, d = i[:-1], i[1:], np.roll(i[1:], -1, 1), np.roll(i[:-1], -1, 1)
    north, south = np.full(2 * n, i.size), np.full(2 * n, i.size + 1)
    faces = [(a, b, c), (a, c, d), (north, i[0], np.roll(i[0], -1)),
             (south, np.roll(i[-1], -1), i[-1])]
    F = np.concatenate([np.stack([np.ravel(x) for x in f], axis=1) for f in faces])
    return np.concatenate([V.reshape(-1, 3), [[0, 0, 1], [0, 0, -1]]]), F


V, F = bumpy_sphere()
s = it.Surface(V, F)
source = 20 * 96 + 17
figure = plt.figure(figsize=(9, 4.5))
for k, method in enumerate(METHODS):
    uv = s.log_map(source, method=method)
    lengths = np.hypot(*uv.T)
    print(f"{method}: the farthest vertex is {lengths.max():.4f} away")
    at = uv[F].mean(axis=1)
    board = np.floor(at / 0.2).astype(int).sum(axis=1) % 2
    colors = plt.cm.viridis(lengths[F].mean(axis=1) / lengths.max())
    colors[:, :3] *= 0.55 + 0.45 * board[:, None]
    axes = figure.add_subplot(1, 2, k + 1, projection="3d")
    axes.add_collection3d(Poly3DCollection(V[F], facecolors=colors, edgecolors=colors,
                                           linewidths=0.3))
    axes.set(title=f"method {method}", xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))
    x, y, z = V[source]
    axes.view_init(np.degrees(np.arctan2(z, np.hypot(x, y))) + 15,
                   np.degrees(np.arctan2(y, x)) + 20)
    axes.set_box_aspect((1, 1, 1), zoom=1.3)
    axes.set_axis_off()
figure.subplots_adjust(0, 0, 1, 0.9, 0, 0)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "log_map.png", dpi=150)
