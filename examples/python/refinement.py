# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A source of heat on a torus of thin triangles: Delaunay, refined, and adapted.

Refined triangles have no angle below 25 degrees; adapted ones are small where the solution needs
it. Usage: refinement.py [picture.png]
"""

import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d import Axes3D
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from numpy.typing import NDArray
from scipy.sparse.linalg import spsolve

import intrinsic as it


def torus(n: int = 60, m: int = 8) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    i, j = (x.ravel() for x in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    u, v = 2 * np.pi * i / n, 2 * np.pi * j / m
    V = np.column_stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)])
    a, b, c, d = ((i + k) % n * m + (j + l) % m for k, l in ((0, 0), (1, 0), (1, 1), (0, 1)))
    return V, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def heat_of_source(t: it.Surface, source: int = 0) -> NDArray[np.float64]:
    """Solves L u = delta - 1/area, up to a constant, for a source at a vertex."""
    L, M = t.laplacian(), t.mass()
    b = -M.diagonal() / M.diagonal().sum()
    b[source] += 1
    u = np.zeros(len(b))
    u[1:] = spsolve(L[1:, 1:].tocsc(), b[1:])
    return u - float(M.diagonal() @ u / M.diagonal().sum())


def draw(axes: Axes3D, title: str, t: it.Surface) -> None:
    c = t.common_subdivision()
    u = c.P_intrinsic @ heat_of_source(t)
    triangles, _ = c.triangles()
    faces = Poly3DCollection(c.points[triangles], cmap="inferno", edgecolors="gray", linewidths=0.2)
    faces.set_array(u[triangles].mean(axis=1))
    faces.set_clim(u.min(), np.quantile(u, 0.995))  # the source itself is a pole
    axes.add_collection3d(faces)
    axes.set(title=f"{title}: {t.number_of_vertices} vertices", xlim=(-3, 3), ylim=(-3, 3),
             zlim=(-3, 3))
    axes.view_init(50, -30)
    axes.set_box_aspect((1, 1, 1), zoom=1.2)
    axes.set_axis_off()


s = it.Surface(*torus())
pictures = [("Delaunay", s.delaunay()), ("refined", s.refine(min_angle=25)),
            ("adapted", s.adapt(0, tolerance=0.02))]
figure = plt.figure(figsize=(12, 4))
for k, (title, t) in enumerate(pictures):
    draw(figure.add_subplot(1, 3, k + 1, projection="3d"), title, t)
    quality = t.statistics["quality"]
    print(f"{title}: least angle {quality['min_angle_deg']:.3g} degrees, least weight "
          f"{quality['min_cotan_weight']:.3g}")
figure.subplots_adjust(0, 0, 1, 0.9, 0, 0)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "refinement.png", dpi=150)
