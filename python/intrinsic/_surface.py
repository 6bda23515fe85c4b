# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The class `Surface`."""

import threading

from . import _arrays, _core
from ._curves import _Curves
from ._distances import _Distances
from ._fields import _Fields
from ._maps import _Maps


class Surface(_Distances, _Curves, _Fields, _Maps):
    """A surface and an intrinsic triangulation of it. It never changes: methods return new ones.

    `V` are the vertices, of shape (n, 3), or (n, 2) in the plane. `F` are the faces: an array of
    shape (m, k), or a list of faces with different numbers of corners.
    """

    def __init__(self, V, F, *, domain="auto", arithmetic="exact", mollification="automatic"):
        points = _arrays.points(V, "V")
        corners, begins = _arrays.polygons(F, "F")
        self._set(_core.build(points, corners, begins, domain, arithmetic, mollification))

    def _set(self, core):
        self._core = core  # for the functions of _core, on the triangulation as it is
        self._delaunay = None
        self._lock = threading.Lock()

    @classmethod
    def _of(cls, core):
        surface = cls.__new__(cls)
        surface._set(core)
        return surface

    def _flipped(self):
        """Returns the object of _core that is Delaunay: this one, or one that it keeps."""
        if self._core.is_flipped:
            return self._core
        with self._lock:
            if self._delaunay is None:
                self._delaunay = _core.delaunay(self._core, None)
            return self._delaunay

    def delaunay(self, *, progress=None):
        """Returns the surface with edges flipped until all are Delaunay."""
        return Surface._of(_core.delaunay(self._core, progress))

    @property
    def faces(self):
        """The vertices of the faces, of shape (m, 3)."""
        return _core.faces(self._core)

    @property
    def lengths(self):
        """The lengths of the sides of faces, of shape (m, 3): from each corner to the next."""
        return _core.lengths(self._core)

    def laplacian(self):
        """Returns the cotangent Laplacian of the Delaunay triangulation, positive semidefinite."""
        return _arrays.sparse(_core.laplacian(self._flipped()), symmetric=True)

    def mass(self, kind="lumped"):
        """Returns the mass matrix: "lumped", "galerkin" or "voronoi"."""
        return _arrays.sparse(_core.mass(self._flipped(), kind), symmetric=True)

    def __repr__(self):
        return f"<intrinsic.Surface: {self._core.number_of_vertices} vertices, " \
               f"{self._core.number_of_faces} faces>"
