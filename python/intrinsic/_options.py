# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Options of surfaces, checked."""

import numpy as np

from . import _arrays

_WORDS = {
    "domain": ("auto", "manifold", "orientation-cover", "tufted", "closed"),
    "arithmetic": ("exact", "double"),
    "mollification": ("automatic", "none", "lengths", "squared"),
    "polygons": ("fan", "planar"),
}
FILE_DOMAINS = *_WORDS["domain"], "points"


def expect(**options):
    """Checks the words that options of a surface have."""
    for name, x in options.items():
        _arrays.expect_word(x, name, _WORDS[name])


def expect_correspondence(x):
    """Checks a correspondence: the module has one of those that the library has."""
    if isinstance(x, str) and x in ("signposts", "crossings"):
        raise ValueError(f'correspondence="{x}" exists in C++ and in the program, `intrinsic '
                         f'delaunay --correspondence {x}`; give "integer" in Python')
    _arrays.expect_word(x, "correspondence", ("integer",))


def minimum_angle(x):
    """Returns the least angle of faces, in degrees."""
    return _arrays.number(x, "min_angle", "an angle in degrees, at least 0 and below 60",
                          lambda x: 0 <= x < 60)


def kept(keep, vertices):
    """Returns pairs of vertices, and the angle from which edges are sharp, of which one is None.

    `vertices` is how many there are.
    """
    if keep is None:
        return None, None
    if _arrays.is_single(keep):
        return None, _arrays.number(keep, "keep", "pairs of vertices, or an angle in degrees",
                                    np.isfinite)
    return _arrays.indices(keep, "keep", (None, 2), vertices), None


def abstract_arrays(V, F, lengths, glue):
    """Returns the number of vertices, and arrays of faces, lengths, glued sides and points."""
    faces = _arrays.indices(F, "faces", (None, 3))
    points = None
    if V is None:
        vertices = int(faces.max()) + 1 if faces.size else 0
    elif _arrays.is_single(V):
        vertices = _arrays.whole(V, "points", "points, or how many vertices there are")
    else:
        points = _arrays.points(V, "points")
        vertices = len(points)
    faces = _arrays.indices(faces, "faces", count=vertices)
    lengths = _arrays.numbers(lengths, "lengths", (len(faces), 3))
    _arrays.refuse_first(lengths, lengths < 0, "lengths", "give lengths from 0")
    if glue is not None:
        glue = _arrays.indices(glue, "glue", (len(faces), 3, 2))
        if glue.size and not (-1 <= glue.min() and glue[..., 0].max() < len(faces)
                              and glue[..., 1].max() < 3):
            raise ValueError(f"glue has a side that does not exist; give faces below {len(faces)} "
                             "and sides from 0 to 2, or -1 for both")
    return vertices, faces, lengths, glue, points
