# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The intrinsic Delaunay triangulation of a machine part full of slivers.

Draws the faces of the file, those of the Delaunay triangulation on the same surface, and how large
the angles of both are. Usage: sliver_part.py [picture.png]
"""

import sys
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d import Axes3D
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from numpy.typing import NDArray

import intrinsic as it

PART = Path(__file__).parent.parent / "data" / "part.off"


def angles(t: it.Surface) -> NDArray[np.float64]:
    """The angles of all triangles, in degrees, of shape (m, 3)."""
    a, b, c = (np.roll(t.lengths, -k, axis=1) for k in range(3))  # a from the corner, b opposite
    cosine = (a ** 2 + c ** 2 - b ** 2) / np.maximum(2 * a * c, 1e-300)
    result: NDArray[np.float64] = np.degrees(np.arccos(np.clip(cosine, -1, 1)))
    return result


def draw(axes: Axes3D, title: str, c: it.CommonSubdivision, number: NDArray[np.int64]) -> None:
    """Faces of a common subdivision, in the colour of what they are a part of."""
    colors = plt.get_cmap("tab20")(np.random.default_rng(1).permutation(number.max() + 1) % 20)
    axes.add_collection3d(Poly3DCollection([c.points[p] for p in c.polygons], facecolors=colors[number]))
    low, high = c.points.min(axis=0), c.points.max(axis=0)
    axes.set(title=title, xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    axes.set_box_aspect(high - low, zoom=1.1)
    axes.set_axis_off()


s = it.read(PART)
t = s.delaunay()
c = t.common_subdivision()
print(f"{t.statistics['delaunay']['flips']} flips; certificate: {t.certificate}")
figure = plt.figure(figsize=(12, 4))
draw(figure.add_axes((0, 0, 0.33, 0.9), projection="3d"), "faces of the file", c, c.input_face)
draw(figure.add_axes((0.33, 0, 0.33, 0.9), projection="3d"), "Delaunay, on the same surface", c,
     c.intrinsic_face)
axes = figure.add_axes((0.73, 0.15, 0.25, 0.75))
axes.hist([angles(s).ravel(), angles(t).ravel()], bins=36, label=["file", "Delaunay"])
axes.set(xlabel="angle in degrees", ylabel="number", yscale="log")
axes.legend()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "sliver_part.png", dpi=150)
