# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Convex polyhedra of metrics."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _core, _options
from ._files import save_surface
from ._pages import _Shown

if TYPE_CHECKING:
    from typing import Any
    from ._surface import Surface
    from ._types import Integers, Numbers, Path, Progress


class ConvexPolyhedron(_Shown):
    """The convex polyhedron of a metric.

    `points` of shape (n, 3) are the places of the vertices of the surface, and `faces` of shape
    (m, 3) triangles between them, counterclockwise from outside. `flat_vertices` lie inside faces
    or edges. If `is_polygon`, it is a convex polygon, front and back, with z = 0.

    `status` is "done", or says what is missing; `error` is the largest difference between a length
    of an edge in space and in the metric, by the size of the polyhedron. `certificate` is a dict:
    if "proven", there is a polyhedron whose vertices are no farther than "within" from `points`,
    and whose surface has these lengths: exactly if "stretch" is 0, else no curve is longer or
    shorter by more than the factor 1 + "stretch". "convex_edges" are convex for certain,
    "flat_edges" are flat up to "within". A small stretch s may hide a height of about the square
    root of s, times the size. If it is infinite, nothing is proven, and `status` is "inaccurate".
    """

    points: Numbers
    faces: Integers
    flat_vertices: Integers
    is_polygon: bool
    status: str
    error: float
    steps: int
    certificate: dict[str, Any]

    def __init__(self, found, kind):
        self.__dict__.update(found)
        # front and back of a polygon may have the same edges
        self._surface = kind(self.points, self.faces,
                             domain="tufted" if self.is_polygon else "manifold")

    @property
    def surface(self) -> Surface:
        """The polyhedron as a surface in space."""
        return self._surface

    def save(self, path: Path, *, plain: bool = False) -> None:
        """Writes the polyhedron to a file .off, .ply, .obj, .stl or .vtp, see `Surface.save()`."""
        save_surface(path, self._surface, (), plain)

    def _add_to_page(self, contents):
        pass

    def __repr__(self):
        return f"<intrinsic.ConvexPolyhedron: {len(self.points)} vertices, {self.status}>"


class _Embedding:
    def embed(self, *, flat_within: float = 1e-10, progress: Progress = None) -> ConvexPolyhedron:
        """Finds the convex polyhedron whose surface has the lengths of this one: there is exactly
        one, up to motions, if the surface is a sphere without vertices of negative curvature.

        Only lengths are used, never points. Vertices whose angles sum to a full turn up to
        `flat_within`, in radians, are put on faces; the certificate says by how much that stretches
        the surface.

        Raises:
            ValueError: the surface is no sphere, or a vertex, which it names, has negative
                curvature.
            RuntimeError: the solver has stopped; it says at which stage, and what to do.

        >>> tetrahedron = Surface(4, [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]],
        ...                       lengths=[[1, 1, 1]] * 4)
        >>> tetrahedron.embed()
        <intrinsic.ConvexPolyhedron: 4 vertices, done>
        """
        within = _options.number(flat_within, "flat_within")
        return ConvexPolyhedron(_core.embed(self._core, within, progress), type(self))
