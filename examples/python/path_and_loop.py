# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A shortest path, a path that flips make locally shortest, and closed geodesics of a wavy torus.

Draws them, and cuts the surface along a loop. Usage: path_and_loop.py [picture.png]
"""

import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import intrinsic as it

n, m = 72, 36
i, j = (x.ravel() for x in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
u, v = 2 * np.pi * i / n, 2 * np.pi * j / m
r = 1 + 0.25 * np.cos(5 * u)
V = np.column_stack([(3 + r * np.cos(v)) * np.cos(u), (3 + r * np.cos(v)) * np.sin(u),
                     r * np.sin(v)])
a, b, c, d = ((i + k) % n * m + (j + l) % m for k, l in ((0, 0), (1, 0), (1, 1), (0, 1)))
F = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])

s = it.Surface(V, F)
start, end = 0, (n // 2) * m + m // 4
path = s.path(start, end)
flips = s.path(start, end, method="flips")
low, high = path.bounds
print(f"shortest path {path.length:.6f}, certainly within {high - low:.1e}; by flips "
      f"{flips.length:.6f}")
tube = s.loop([0, m // 3, 2 * m // 3])  # around the tube
hole = s.loop([0, n // 3 * m, 2 * n // 3 * m])  # around the hole
ray = s.trace(start, [0, 1, 1], 25)
cut = s.cut(s.network(loops=[[0, m // 3, 2 * m // 3]]))
print(f"around the tube {tube.length:.6f}, around the hole {hole.length:.6f}; cut open, the torus "
      f"has {len(cut.points) - len(V)} more vertices")

figure = plt.figure(figsize=(6, 5))
axes = figure.add_subplot(projection="3d")
axes.add_collection3d(Poly3DCollection(V[F], facecolor="#e0e4ea55"))
for curve, color, name in [(path, "C3", "shortest path"), (flips, "C1", "by flips"),
                           (tube, "C0", "around the tube"), (hole, "C2", "around the hole"),
                           (ray, "0.4", "geodesic in a direction")]:
    points = curve.points[np.r_[:len(curve), 0]] if curve.is_closed else curve.points
    axes.plot(*points.T, color=color, label=name, zorder=3)
axes.set(xlim=(-3, 3), ylim=(-3, 3), zlim=(-3, 3))
axes.view_init(60, 30)
axes.set_box_aspect((1, 1, 1), zoom=1.25)
axes.set_axis_off()
figure.legend(loc="upper right")
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "path_and_loop.png", dpi=150)
