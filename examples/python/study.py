# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What doubles get wrong: thin tori flipped to Delaunay in doubles and exactly, as a data frame.

The statistics of a triangulation are a dict, of which pandas makes a row. The thinner the torus,
the less doubles know which edges are Delaunay. Usage: study.py [picture.png]
"""

import sys
from typing import Literal

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from numpy.typing import NDArray

import intrinsic as it

ARITHMETICS: tuple[Literal["double", "exact"], ...] = "double", "exact"


def thin_torus(thinness: float, n: int = 40,
               m: int = 12) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """A torus with places moved a little, and squeezed along an axis."""
    i, j = (x.ravel() for x in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    move = np.random.default_rng(0).normal(scale=0.2, size=(2, n * m))
    u, v = 2 * np.pi * (i + move[0]) / n, 2 * np.pi * (j + move[1]) / m
    V = np.column_stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u) * thinness,
                         np.sin(v) * thinness ** 2])
    a, b, c, d = ((i + k) % n * m + (j + l) % m for k, l in ((0, 0), (1, 0), (1, 1), (0, 1)))
    return V, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


rows = []
for exponent in range(0, 9):
    for arithmetic in ARITHMETICS:
        t = it.Surface(*thin_torus(10.0 ** -exponent), arithmetic=arithmetic).delaunay()
        row = pd.json_normalize(t.statistics).iloc[0]
        rows.append({"thinness": 10.0 ** -exponent, "arithmetic": arithmetic,
                     "flips": row["delaunay.flips"], "certificate": row["certificate"],
                     "least weight": row["quality.min_cotan_weight"]})
frame = pd.DataFrame(rows)
table = frame.pivot(index="thinness", columns="arithmetic", values=["flips", "least weight"])
print(table)

figure, axes = plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
table["flips"].plot(ax=axes[0], logx=True, marker="o", title="flips")
table["least weight"].plot(ax=axes[1], loglog=True, marker="o", title="least cotangent weight")
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "study.png", dpi=150)
