# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Options of surfaces, checked."""

import numpy as np

from . import _arrays, _core

_WORDS = {
    "domain": ("auto", "manifold", "orientation-cover", "tufted", "closed"),
    "arithmetic": ("exact", "double"),
    "mollification": ("automatic", "none", "lengths", "squared"),
    "polygons": ("fan", "planar"),
    "solver": ("auto", "direct", "iterative"),
}
FILE_DOMAINS = *_WORDS["domain"], "points"


def expect(**options):
    """Checks the words that options have."""
    for name, x in options.items():
        _arrays.expect_word(x, name, _WORDS[name])


def expect_correspondence(x):
    """Checks a correspondence: the module has one of those that the library has."""
    if isinstance(x, str) and x in ("signposts", "crossings"):
        raise ValueError(f'correspondence="{x}" exists in C++ and in the program, `intrinsic '
                         f'delaunay --correspondence {x}`; give "integer" in Python')
    _arrays.expect_word(x, "correspondence", ("integer",))


def number(x, option, name=None):
    """Returns a number that an option may be, by the table that the program has, too."""
    allowed = _core.ranges[option]
    least, most = allowed["least"], np.inf if allowed["most"] is None else allowed["most"]
    found = _arrays.number(x, name or option, allowed["description"], lambda x: (
        least <= x <= most and not (allowed["positive"] and x == 0)
        and not (allowed["whole"] and x != np.floor(x))))
    return int(found) if allowed["whole"] else found


def kept(keep, vertices):
    """Returns pairs of vertices, and the angle from which edges are sharp, of which one is None.

    `vertices` is how many there are.
    """
    if keep is None:
        return None, None
    if _arrays.is_single(keep):
        return None, number(keep, "sharp_angle", "keep")
    return _arrays.indices(keep, "keep", (None, 2), vertices), None


def abstract_arrays(points, faces, lengths, glue):
    """Returns the number of vertices, and arrays of faces, lengths, glued sides and points."""
    faces = _arrays.indices(faces, "faces", (None, 3))
    vertices = int(faces.max()) + 1 if faces.size else 0
    if points is not None and _arrays.is_single(points):
        vertices = _arrays.whole(points, "points", "points, or how many vertices there are")
        points = None
    elif points is not None:
        points = _arrays.points(points, "points")
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
