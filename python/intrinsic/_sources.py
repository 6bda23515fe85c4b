# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of files, and of points alone."""

from __future__ import annotations

import errno
import os
from typing import TYPE_CHECKING

from . import _arrays, _core, _options
from ._arguments import suggesting
from ._surface import Surface

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from ._types import Arithmetic, FileDomain, Mollification, Path, Polygons, Progress


@suggesting
def read(path: Path, *, domain: FileDomain = "auto", arithmetic: Arithmetic | None = None,
         mollification: Mollification | None = None, polygons: Polygons = "fan",
         neighbors: int | None = None, progress: Progress = None) -> Surface:
    """Reads a mesh (OFF, OBJ, PLY, STL, TS), points (XYZ, PWN) or a triangulation (IDT).

    Options are those of `Surface`; `domain` may also be "points", which ignores faces, with
    `neighbors` of each point.
    """
    optional = {"arithmetic": arithmetic, "mollification": mollification}
    _arrays.expect_word(domain, "domain", _options.FILE_DOMAINS)
    _options.expect(polygons=polygons, **{name: x for name, x in optional.items() if x is not None})
    if neighbors is not None:
        neighbors = _options.number(neighbors, "neighbors")
    path = _arrays.file_name(path)
    if not os.path.exists(path):
        raise FileNotFoundError(errno.ENOENT, "the file does not exist", os.fsdecode(path))
    if os.fsdecode(path).lower().endswith(".npz"):
        raise ValueError(f"{os.fsdecode(path)}: intrinsic.Operators.load() reads operators; name a "
                         "mesh here")
    return Surface._of(_core.read(path, domain, arithmetic, mollification, polygons, neighbors,
                                  progress))


@suggesting
def load(path: Path) -> Surface:
    """Reads what `Surface.save()` has written."""
    return read(path)


@suggesting
def points(points: ArrayLike, *, neighbors: int = 30, arithmetic: Arithmetic = "exact",
           mollification: Mollification = "automatic") -> Surface:
    """Makes a surface of points near a surface in space, of shape (n, 3).

    The nearest `neighbors` of each point are triangulated around it; the union of the triangles is
    covered. Matrices have a row for each point.
    """
    _options.expect(arithmetic=arithmetic, mollification=mollification)
    neighbors = _options.number(neighbors, "neighbors")
    return Surface._of(_core.points(_arrays.points(points, "points"), neighbors,
                                    arithmetic == "exact", mollification))
