# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The class `CommonSubdivision`."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from . import _arrays
from ._pages import _Shown

if TYPE_CHECKING:
    from typing import Any
    from ._surface import Surface
    from ._types import Integers, Matrix, Numbers


class CommonSubdivision(_Shown):
    """The coarsest mesh in which every edge of the input and of a triangulation is a path.

    Attributes:
        points: places of the vertices in space, of shape (n, 3); None if the surface has only
            lengths.
        corners: the vertices at all corners of its polygons, one polygon after the other.
        begins: where the corners of each polygon begin, and their number.
        input_face: the face of the user's mesh that each polygon is in.
        intrinsic_face: the triangle that each polygon is in.
        sheet: on a cover, the side of the input face, 0 or 1; else empty.
        P_input, P_intrinsic: scipy.sparse.csr_matrix that take values at vertices of the input, or
            of the triangulation, to those of the subdivision.
    """

    points: Numbers | Any
    corners: Integers
    begins: Integers
    input_face: Integers
    intrinsic_face: Integers
    sheet: Integers
    P_input: Matrix
    P_intrinsic: Matrix

    def __init__(self, parts: dict[str, Any], surface: Surface) -> None:
        self._surface = surface
        self.points = parts["points"] if parts["has_points"] else None
        self.corners = parts["corners"]
        self.begins = parts["begins"]
        self.input_face = parts["input_face"]
        self.intrinsic_face = parts["intrinsic_face"]
        self.sheet = parts["sheet"]
        self.P_input = _arrays.sparse(parts["P_input"])
        self.P_intrinsic = _arrays.sparse(parts["P_intrinsic"])

    def __getstate__(self):
        return {**vars(self), "_surface": None}  # the surface stays behind

    def _add_to_page(self, contents):
        pass  # pages show the triangulation on the common subdivision

    @property
    def polygons(self) -> list[Integers]:
        """The vertices of each polygon, counterclockwise: a list of arrays."""
        return np.split(self.corners, self.begins[1:-1])

    def triangles(self) -> tuple[Integers, Integers]:
        """Returns triangles of the polygons, fans from their first corners, and their polygons."""
        sizes = np.diff(self.begins) - 2
        polygon = np.repeat(np.arange(len(sizes)), sizes)
        first = self.begins[:-1][polygon]
        k = np.arange(len(polygon)) - np.repeat(np.cumsum(sizes) - sizes, sizes)
        at = np.column_stack([first, first + k + 1, first + k + 2])
        return self.corners[at], polygon

    def to_pyvista(self) -> Any:
        """Returns a pyvista.PolyData with `input_face` and `intrinsic_face`, if it is installed."""
        import pyvista

        sizes = np.diff(self.begins)
        faces = np.insert(self.corners, self.begins[:-1], sizes)
        mesh = pyvista.PolyData(self.points, faces)
        mesh.cell_data["input_face"] = self.input_face
        mesh.cell_data["intrinsic_face"] = self.intrinsic_face
        return mesh

    def __repr__(self):
        return f"<intrinsic.CommonSubdivision: {self.P_input.shape[0]} vertices, " \
               f"{len(self.input_face)} polygons>"
