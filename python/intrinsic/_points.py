# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points on a surface: vertices, and places in faces."""

from typing import NamedTuple

import numpy as np

from . import _arrays


class Point(NamedTuple):
    """A place in a face of the user's mesh, which is a triangle.

    `barycentric` are the weights of its corners, in the order in which the face lists them; they
    sum to 1. In a face that was turned around, since it disagreed with its neighbours, the second
    and the third corner change places, as they do in `Surface.faces`.
    """

    face: int
    barycentric: tuple


def is_point(x):
    """Tells whether something is one point: the number of a vertex, or a `Point`."""
    return isinstance(x, Point) or _arrays.is_single(x)


def expect_one(x, name):
    """Checks that something is one point."""
    if not is_point(x):
        raise ValueError(f"{name} has several points; give one")


def place_arrays(points, name, vertices, faces):
    """Returns numbers of faces, barycentric coordinates and numbers of vertices of points.

    `points` is a point, or a sequence of points: numbers of vertices and `Point`s, mixed. A point
    that is a vertex has the face -1, and one in a face the vertex -1. `vertices` and `faces` are
    how many there are.
    """
    if isinstance(points, Point):
        return _mixed_places([(name, points)], vertices, faces)
    if isinstance(points, (list, tuple)) and any(isinstance(p, Point) for p in points):
        named = [(f"{name}[{i}]", p) for i, p in enumerate(points)]
        return _mixed_places(named, vertices, faces)
    shape = () if _arrays.is_single(points) else (None,)
    try:
        vertex = np.atleast_1d(_arrays.indices(points, name, shape, count=vertices))
    except ValueError:
        _expect_points(points, name)
        raise
    return np.full(len(vertex), -1), np.zeros((len(vertex), 3)), vertex


def _expect_points(points, name):
    """Refuses a list in which something is no point."""
    if isinstance(points, (list, tuple)):
        for i, p in enumerate(points):
            if not _arrays.is_single(p):
                raise ValueError(f"{name}[{i}] is {_arrays.shortened(p)}; give the number of a "
                                 "vertex, or an intrinsic.Point(face, barycentric)") from None


def joined(*parts):
    """Returns the places of several results of `place_arrays()` in one."""
    return tuple(np.concatenate(arrays) for arrays in zip(*parts))


def place_numbers(p, name, vertices, faces):
    """Returns the same of one point as numbers: arrays of one take longer than a short trace."""
    if isinstance(p, Point):
        return (_index(p.face, name + ".face", faces),
                _weights(p.barycentric, name + ".barycentric"), -1)
    return -1, (0., 0., 0.), _index(p, name, vertices)


def _mixed_places(points, vertices, faces):
    """Returns the arrays of points and their names."""
    return tuple(map(np.array, zip(*(place_numbers(p, here, vertices, faces)
                                     for here, p in points))))


def _index(x, name, count):
    if type(x) is int and 0 <= x < count:  # needs no array, which takes longer than a short trace
        return x
    return int(_arrays.indices(x, name, (), count=count))


def _weights(x, name):
    if not (type(x) is tuple and len(x) == 3 and all(type(w) is float for w in x)):
        x = _arrays.numbers(x, name, (3,)).tolist()
    if not (min(x) >= 0 and abs(x[0] + x[1] + x[2] - 1) <= 1e-6):
        raise ValueError(f"{name} is {tuple(x)}; give three weights that are not negative and sum "
                         "to 1")
    return x
