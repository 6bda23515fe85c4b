# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances from a vertex of a wavy torus: along shortest paths, and by the flow of heat.

Draws both, with lines of equal distance, and the cells of six vertices that are far from each
other. Usage: distances.py [picture.png]
"""

import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d import Axes3D
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection
from numpy.typing import NDArray

import intrinsic as it


def wavy_torus(n: int = 72, m: int = 36) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    i, j = (x.ravel() for x in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    u, v = 2 * np.pi * i / n, 2 * np.pi * j / m
    r = 1 + 0.25 * np.cos(5 * u)
    V = np.column_stack([(3 + r * np.cos(v)) * np.cos(u), (3 + r * np.cos(v)) * np.sin(u),
                         r * np.sin(v)])
    a, b, c, d = ((i + k) % n * m + (j + l) % m for k, l in ((0, 0), (1, 0), (1, 1), (0, 1)))
    return V, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def draw(axes: Axes3D, title: str, V: NDArray[np.float64], F: NDArray[np.int64],
         values: NDArray[np.float64], lines: list[it.Curve], colors: str = "viridis") -> None:
    """Draws faces in colours, and lines where they are on faces that one sees."""
    color = plt.get_cmap(colors)(plt.Normalize()(values))
    axes.add_collection3d(Poly3DCollection(V[F], facecolors=color, edgecolors=color,
                                           linewidths=0.3, zorder=1))
    view = [np.cos(np.radians(55)) * np.cos(np.radians(30)),
            np.cos(np.radians(55)) * np.sin(np.radians(30)), np.sin(np.radians(55))]
    for line in lines:
        points = line.points[np.r_[:len(line), 0]] if line.is_closed else line.points
        a, b, c = s.points[s.faces[line.faces[:len(points) - 1]]].transpose(1, 0, 2)
        seen = np.cross(b - a, c - a) @ view > 0
        pieces = np.stack([points[:-1], points[1:]], axis=1)[seen]
        axes.add_collection3d(Line3DCollection(pieces, colors="black", linewidths=0.8, zorder=2))
    axes.computed_zorder = False
    axes.set(title=title, xlim=(-3, 3), ylim=(-3, 3), zlim=(-3, 3))
    axes.view_init(55, 30)
    axes.set_box_aspect((1, 1, 1), zoom=1.25)
    axes.set_axis_off()


V, F = wavy_torus()
s = it.Surface(V, F)
exact = s.distance(0)
heat = s.distance(0, method="heat")
print(f"heat is off by {np.abs(heat - exact).max() / exact.max():.2%} of the greatest distance")
far = s.farthest_points(6)
cells = s.voronoi(far.vertices)
pieces = s.cut(cells.boundaries)  # triangles that are in one cell each
label = np.zeros(pieces.number_of_components, dtype=int)
for k in range(len(label)):
    users = pieces.input_vertex[pieces.faces[pieces.component == k]]
    label[k] = np.bincount(cells.labels[users[users >= 0]]).argmax()

figure = plt.figure(figsize=(12, 4))
pictures = [("exact distances", V, F, exact[F].mean(axis=1), s.isolines(exact, 12)),
            ("by heat", V, F, heat[F].mean(axis=1), s.isolines(heat, 12)),
            ("cells of six vertices", pieces.points, pieces.faces, label[pieces.component],
             cells.boundaries, "Set2")]
for k, picture in enumerate(pictures):
    draw(figure.add_subplot(1, 3, k + 1, projection="3d"), *picture)
figure.subplots_adjust(0, 0, 1, 0.9, 0, 0)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "distances.png", dpi=150)
