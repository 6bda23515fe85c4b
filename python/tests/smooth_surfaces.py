# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A smooth sphere, torus and disk: triangles with vertices on them, which are divided into four as
often as asked for. The first vertices are always the same."""

import functools
from typing import Callable, NamedTuple

import numpy as np

from ten_surfaces import ball, disk, grid, sheet
from written import Written


def _unit(V):
    return V / np.linalg.norm(V, axis=1)[:, None]


class Smooth(NamedTuple):
    """`start`: triangles of a simple shape, in any dimension; `onto` moves vertices near that shape
    onto it; `shape` takes it to space."""

    start: Callable
    onto: Callable
    shape: Callable


def _start_of_torus(random):
    n, m = 8, 6
    a, b = (2 * np.pi * (x + random.uniform(-0.2, 0.2, n * m)) / k
            for x, k in zip(grid(n, m), (n, m)))
    return np.column_stack([np.cos(a), np.sin(a), np.cos(b), np.sin(b)]), \
        sheet(random, n, m, True, True)


def _start_of_disk(random):
    V, F = disk(random)
    return V[:, :2], F


def _border_onto_circle(x):
    sides = np.sort(np.vstack([x.F[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    sides, faces = np.unique(sides, axis=0, return_counts=True)
    V, border = x.V.copy(), np.unique(sides[faces == 1])
    V[border] = _unit(V[border])
    return V


def _egg(V):
    x, y, z = V.T
    return np.column_stack([1.2 * x, y, z * (0.8 + 0.2 * x)])


def _tube(V):
    x, y, u, v = V.T
    r = 1 + 0.4 * u + 0.1 * y
    return np.column_stack([r * x, r * y, 0.4 * v])


SMOOTH = {
    "sphere": Smooth(lambda random: ball(random, 42), lambda x: _unit(x.V), _egg),
    "torus": Smooth(_start_of_torus,
                    lambda x: np.hstack([_unit(x.V[:, :2]), _unit(x.V[:, 2:])]), _tube),
    "disk": Smooth(_start_of_disk, _border_onto_circle,
                   lambda V: np.column_stack([V, 0.4 * np.cos(2 * V[:, 0] + V[:, 1])])),
}


@functools.cache
def _divided(name, times):
    if times == 0:
        x = Written(name, *SMOOTH[name].start(np.random.default_rng(5)))
    else:
        x = _divided(name, times - 1).refined()
    x.V = SMOOTH[name].onto(x)
    return x


def smooth(name, times):
    """One of the surfaces, so many times divided, and the number of vertices that all have."""
    x = _divided(name, times)
    return Written(name, SMOOTH[name].shape(x.V), x.F.tolist()), x.base_size
