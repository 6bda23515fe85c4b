# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Isometries of surfaces, and their hashes."""

from __future__ import annotations

import reprlib
from collections.abc import Sequence
from typing import TYPE_CHECKING

from . import _core
from ._points import place_arrays

if TYPE_CHECKING:
    from typing import Literal
    from numpy.typing import ArrayLike
    from ._points import Point
    from ._surface import Surface
    from ._types import Integers, Numbers, Progress


class Isometry:
    """A map of a surface to another one, or to itself, that keeps all lengths.

    Attributes:
        vertices: the vertex to which each vertex is mapped, -1 for flat vertices: see `points()`.
            On a cover, it is that of the first copy of the vertex.
        reverses_orientation: whether a part of the surface is mapped to its mirror image.
    """

    vertices: Integers
    reverses_orientation: bool

    def __init__(self, isometries: Isometries, number: int) -> None:
        self._isometries, self._number = isometries, number
        self._map = isometries._found.map(number)
        self.vertices = isometries._found.images_of_vertices(self._map)
        self.reverses_orientation = self._map.reverses_orientation

    def points(self, points: int | Point | ArrayLike | Sequence[int | Point]) \
            -> tuple[Integers, Numbers]:
        """Returns where points are mapped: the faces of the other mesh, of shape (k,), and
        barycentric coordinates there, (k, 3).

        `points` are vertices of the mesh and `Point`s on its faces.
        """
        core = self._isometries._surface._core
        places = place_arrays(points, "points", core.number_of_input_vertices,
                              core.number_of_input_faces)
        return self._isometries._found.images_of_points(self._map, core, places)

    def __reduce__(self):
        return Isometry, (self._isometries, self._number)

    def __repr__(self) -> str:
        kind = "with mirror images" if self.reverses_orientation else "without mirror images"
        return f"<intrinsic.Isometry: {kind}>"


class _Maps(Sequence):
    def __init__(self, isometries):
        self._isometries = isometries

    def __len__(self):
        return self._isometries._found.size

    def __getitem__(self, i):
        if isinstance(i, slice):
            return [self[k] for k in range(*i.indices(len(self)))]
        number = i + len(self) if i < 0 else i
        if not 0 <= number < len(self):
            raise IndexError(f"there are {len(self)} maps, and none has the number {i}")
        return Isometry(self._isometries, number)


class Isometries:
    """The answer whether two surfaces are isometric, and all isometries: `len()` is their number.

    Attributes:
        answer: "isometric" or "not_isometric", by proof; "isometric_within": lengths differ by
            rounding; or "undecided".
        maps: the isometries, a sequence of `Isometry`, each computed when it is asked for.
        largest_difference: the largest relative difference of lengths for the first map; 0 if
            surfaces are isometric, infinity if they are not.
        note: what is arbitrary, or undecided, and why, that covers are compared, or that
            mollification has changed lengths; mostly empty.
    """

    answer: Literal["isometric", "isometric_within", "not_isometric", "undecided"]
    maps: Sequence[Isometry]
    largest_difference: float
    note: str

    def __init__(self, surface: Surface, other: Surface, progress: Progress = None) -> None:
        self._surface, self._other = surface, other
        self._found = found = _core.isometries(surface._core, other._core, progress)
        self.answer, self.note = found.answer, found.note
        self.largest_difference = found.largest_difference
        self.maps = _Maps(self)

    def __reduce__(self):  # what was found is found again
        return Isometries, (self._surface, self._other)

    def __len__(self) -> int:
        return len(self.maps)

    def __bool__(self) -> bool:
        return self.answer == "isometric"

    def __repr__(self) -> str:
        return f"<intrinsic.Isometries: {self.answer}, {len(self)} maps>"


class _Isometries:
    def isometries(self, other: Surface | None = None, *, progress: Progress = None) -> Isometries:
        """Finds all isometries to another surface, mirror images included; by default the
        symmetries of this one. They are maps of the surfaces: triangulations and numbers of
        vertices do not matter, and neither do flat vertices.

        Parameters:
            other: the other surface.
            progress: see `delaunay()`.

        >>> cube = it.Surface([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)],
        ...                   [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6],
        ...                    [0, 2, 6, 4], [1, 5, 7, 3]])
        >>> cube.isometries()
        <intrinsic.Isometries: isometric, 48 maps>
        """
        if not (other is None or isinstance(other, _Isometries)):
            raise ValueError(f"other is {reprlib.repr(other)}; give a surface, or None")
        return Isometries(self, self if other is None else other, progress)

    def hash(self, *, progress: Progress = None) -> int:
        """Returns a number that is the same for all isometric surfaces, also of other
        triangulations. Unequal numbers prove that surfaces are not isometric; equal ones prove
        nothing. See `delaunay()` for `progress`."""
        return _core.hash(self._core, progress)
