# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators for networks on surfaces, and features that do not depend on the triangulation.

Features of the kind that DiffusionNet has: a signal spread for some times, and the lengths of its
gradients. They are compared on a mesh and on the same surface divided into slivers. Usage:
learning.py [picture.png]
"""

import sys
import tempfile
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from numpy.typing import NDArray

import intrinsic as it

Numbers = NDArray[np.float64]


def torus(n: int, m: int) -> tuple[Numbers, NDArray[np.int64]]:
    i, j = (x.ravel() for x in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    u, v = 2 * np.pi * i / n, 2 * np.pi * j / m
    V = np.column_stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)])
    a, b, c, d = ((i + k) % n * m + (j + l) % m for k, l in ((0, 0), (1, 0), (1, 1), (0, 1)))
    return V, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def with_slivers(V: Numbers, F: NDArray[np.int64]) -> tuple[Numbers, NDArray[np.int64]]:
    """The same surface: each face divided at a point that is near one of its sides."""
    inside = np.einsum("k,fkc->fc", [0.45, 0.549, 0.001], V[F])
    new = len(V) + np.arange(len(F))
    return np.concatenate([V, inside]), np.concatenate(
        [np.column_stack([F[:, k], F[:, (k + 1) % 3], new]) for k in range(3)])


# [features]
def features(o: it.Operators, signal: Numbers, times: Numbers) -> Numbers:
    """The signal after some times, and the lengths of its gradients: of shape (n, 2 t)."""
    spectrum = o.eigenfunctions.T @ (o.mass * signal)
    spread = o.eigenfunctions @ (np.exp(-np.outer(o.eigenvalues, times)) * spectrum[:, None])
    lengths = np.hypot(o.gradient_x @ spread, o.gradient_y @ spread)
    return np.concatenate([spread, lengths], axis=1)
# [features]


def signal(V: Numbers) -> Numbers:
    waves: Numbers = np.sin(4 * np.arctan2(V[:, 1], V[:, 0])) + V[:, 2]
    return waves


times = np.array([0.05, 0.5])
V, F = torus(60, 20)
# [cache]
with tempfile.TemporaryDirectory() as folder:
    o = it.Surface(V, F).operators(k=64, cache=folder)  # computed once, and kept
    again = it.Surface(V, F).operators(k=64, cache=folder)
    file, = Path(folder).iterdir()
    with np.load(file) as arrays:
        print("keys:", ", ".join(sorted(arrays)))
assert np.array_equal(o.eigenfunctions, again.eigenfunctions)
# [cache]
expected = features(o, signal(V), times)
bad_V, bad_F = with_slivers(V, F)
s = it.Surface(bad_V, bad_F)

figure = plt.figure(figsize=(12, 4))
pictures = [("even faces", V, F, expected)]
for title, flip in ("slivers, as they are", False), ("slivers, Delaunay", True):
    found = features(s.operators(k=64, flip=flip), signal(bad_V), times)
    error = np.linalg.norm(found[:len(V)] - expected, axis=0) / np.linalg.norm(expected, axis=0)
    print(f"{title}: features differ by", ", ".join(f"{x:.1%}" for x in error))
    pictures.append((title, bad_V, bad_F, found))
for k, (title, V, F, x) in enumerate(pictures):
    axes = figure.add_subplot(1, 3, k + 1, projection="3d")
    color = plt.get_cmap("viridis")(plt.Normalize(0, expected[:, 2].max())(x[F, 2].mean(axis=1)))
    axes.add_collection3d(Poly3DCollection(V[F], facecolors=color, edgecolors=color, linewidths=0.2))
    axes.set(title=title, xlim=(-3, 3), ylim=(-3, 3), zlim=(-3, 3))
    axes.view_init(50, 20)
    axes.set_box_aspect((1, 1, 1), zoom=1.3)
    axes.set_axis_off()
figure.subplots_adjust(0, 0, 1, 0.9, 0, 0)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "learning.png", dpi=150)
