# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results in files of other programs."""

import os

from . import _arrays, _core


def save_curves(path, curves):
    """Writes curves to a file .vtp, .obj or .ply, each with its number."""
    for curve in curves:
        if curve.points is None:
            raise ValueError("the surface has lengths and no points, so that curves have no places")
    _core.save_curves(os.fsdecode(_arrays.file_name(path)),
                      [(c.points, c.is_closed, i) for i, c in enumerate(curves)])


def save_surface(path, surface, values=(), plain=False):
    """Writes the mesh of a surface to a file .ply, .obj, .off, .stl or .vtp, with values at its
    vertices, pairs of a name and numbers, where the format has them."""
    _core.save_surface(surface._core, os.fsdecode(_arrays.file_name(path)), list(values), plain)
