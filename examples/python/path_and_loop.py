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
from matplotlib.collections import PolyCollection

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
curves = [(path, "C3", "shortest path"), (flips, "C1", "by flips"),
          (tube, "C0", "around the tube"), (hole, "C2", "around the hole"),
          (ray, "k", "geodesic in a direction")]

# Faces that look away are left out. The others and the pieces of curves are painted from far to
# near, a piece after the faces about it.
high, aside = np.radians(60), np.radians(30)
near = np.array([np.cos(high) * np.cos(aside), np.cos(high) * np.sin(aside), np.sin(high)])
right = np.array([-np.sin(aside), np.cos(aside), 0])
view = np.column_stack([right, np.cross(near, right), near])
seen = V @ view  # to the right, up, and towards the viewer
normals = np.cross(seen[F[:, 1]] - seen[F[:, 0]], seen[F[:, 2]] - seen[F[:, 0]])
light = normals[:, 2] / np.linalg.norm(normals, axis=1)
faces = np.flatnonzero(light > 0)
shapes = [(seen[F[f], 2].mean(), seen[F[f], :2], str(0.6 + 0.35 * light[f])) for f in faces]
for curve, color, name in curves:
    points = (curve.points[np.r_[:len(curve), 0]] if curve.is_closed else curve.points) @ view
    shapes += [(points[k:k + 2, 2].mean() + 0.4, points[k:k + 2, :2], color)
               for k in range(len(points) - 1) if light[curve.faces[k]] > 0]
shapes.sort(key=lambda shape: float(shape[0]))

figure, axes = plt.subplots(figsize=(6, 6.2), layout="constrained")
colors = [color for _, _, color in shapes]
widths = [0.3 if len(corners) == 3 else 2 for _, corners, _ in shapes]
axes.add_collection(PolyCollection([corners for _, corners, _ in shapes], facecolors=colors,
                                   edgecolors=colors, linewidths=widths))
for _, color, name in curves:
    axes.plot([], [], color=color, label=name)
axes.set(xlim=(-4.3, 4.3), ylim=(-4, 5.4), aspect="equal")
axes.set_axis_off()
axes.legend(loc="upper center", ncols=2)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "path_and_loop.png", dpi=150)
