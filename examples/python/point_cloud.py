# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions, distances and vectors on points without faces, sampled from a torus with noise.

Usage: point_cloud.py [picture.png]
"""

import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import intrinsic as it

rng = np.random.default_rng(5)
u, v = rng.random((2, 3000)) * 2 * np.pi
r = 1 + 0.01 * rng.standard_normal(3000)
P = np.column_stack([(2.5 + r * np.cos(v)) * np.cos(u), (2.5 + r * np.cos(v)) * np.sin(u),
                     r * np.sin(v)])

s = it.points(P)
L, M = s.laplacian(), s.mass()
print(f"area {M.sum():.3f}; of the torus {4 * np.pi ** 2 * 2.5:.3f}")
values, functions = s.eigen(4)
print("eigenvalues:", np.round(values, 4))
source = int(np.argmax(P[:, 0]))
distance = s.distance(source, method="heat")
field = s.transport(source, [0.0, 0.0, 1.0])

figure = plt.figure(figsize=(12, 4))
pictures = ("eigenfunction 1", functions[:, 1]), ("distance by heat", distance), \
    ("transported vector", distance)
for k, (title, values) in enumerate(pictures):
    axes = figure.add_subplot(1, 3, k + 1, projection="3d")
    if k < 2:
        axes.scatter(*P.T, c=values, s=4, cmap="coolwarm" if k == 0 else "viridis")
    else:
        axes.scatter(*P.T, c="0.85", s=2)
        some = np.argsort(distance)[:1500:3]
        axes.quiver(*P[some].T, *field.vectors[some].T, length=0.25, linewidth=0.6)
    axes.set(title=title, xlim=(-3, 3), ylim=(-3, 3), zlim=(-3, 3))
    axes.view_init(45, 20)
    axes.set_box_aspect((1, 1, 1), zoom=1.4)
    axes.set_axis_off()
figure.subplots_adjust(0, 0, 1, 0.9, 0, 0)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "point_cloud.png", dpi=150)
