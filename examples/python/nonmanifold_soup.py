# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Eigenfunctions and distances on triangles that make no manifold: four bent fins at one edge.

Every method works on a cover of the triangles, made behind the scenes; results have one number per
vertex as always. Usage: nonmanifold_soup.py [picture.png]
"""

import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from numpy.typing import NDArray

import intrinsic as it


def fins(count: int = 4, n: int = 16) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Strips of n by n squares, glued at their first column of vertices."""
    r, z = (x.ravel() for x in np.meshgrid(np.arange(n + 1) / n, np.arange(n + 1) / n,
                                           indexing="ij"))
    i = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
    a, b, c, d = i[:-1, :-1].ravel(), i[1:, :-1].ravel(), i[1:, 1:].ravel(), i[:-1, 1:].ravel()
    strip = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    places, faces = [], []
    for k in range(count):
        angle = 2 * np.pi * k / count + 0.9 * r ** 2
        places.append(np.column_stack([r * np.cos(angle), r * np.sin(angle), z]))
        number = np.where(r == 0, np.arange(len(r)), np.arange(len(r)) + k * len(r))
        faces.append(number[strip])
    used, F = np.unique(np.concatenate(faces), return_inverse=True)
    return np.concatenate(places)[used], F.reshape(-1, 3)


V, F = fins()
s = it.Surface(V, F)
L = s.laplacian()
print(f"{len(V)} vertices; the greatest entry off the diagonal of the Laplacian is "
      f"{(L - np.diag(L.diagonal())).max():.1e}")
values, functions = s.eigen(6)
print("eigenvalues:", np.round(values, 4))
distance = s.distance(int(np.argmax(V[:, 0] - V[:, 2])))
figure = plt.figure(figsize=(12, 4))
pictures = ("eigenfunction 2", functions[:, 2]), ("eigenfunction 5", functions[:, 5]), \
    ("exact distance", distance)
for k, (title, u) in enumerate(pictures):
    axes = figure.add_subplot(1, 3, k + 1, projection="3d")
    color = plt.get_cmap("viridis" if k == 2 else "coolwarm")(plt.Normalize()(u[F].mean(axis=1)))
    axes.add_collection3d(Poly3DCollection(V[F], facecolors=color, edgecolors=color,
                                           linewidths=0.3))
    axes.set(title=title, xlim=(-1, 1), ylim=(-1, 1), zlim=(-0.5, 1.5))
    axes.view_init(35, 25)
    axes.set_box_aspect((1, 1, 1), zoom=1.6)
    axes.set_axis_off()
figure.subplots_adjust(0, 0, 1, 0.9, 0, 0)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "nonmanifold_soup.png", dpi=150)
