# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The class `CoarseSurface`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _arrays, _core
from ._simplify import Stretch
from ._surface import Surface

if TYPE_CHECKING:
    from typing import Any
    from ._types import Integers, Matrix, Numbers


class CoarseSurface(Surface):
    """A surface with fewer vertices, as `simplify()` returns it, and how it lies on the fine one.

    It is a surface as any other. Its lengths define it; `points` are the places of its vertices on
    the fine surface, for pictures. The vertices of the fine surface have places on it.

    `kept`, of shape (n,), is the fine vertex of each coarse one. `stretch` is a `Stretch`, and
    `face_stretch`, of shape (m, 2), has the proven bounds in each face. `fine_places` are, for each
    fine vertex, a face, of shape (N,), and barycentric coordinates in it, of shape (N, 3); the face
    of an isolated vertex is -1. `prolongation`, of shape (N, n), takes functions from coarse to
    fine vertices; `vector_prolongation`, complex, tangent vectors in the polar coordinates of
    vertices, see `VectorField`. `status` is "done" if what was asked for is reached, "stalled" if
    no other vertex can be removed. `counts` is a dict: "removed" vertices, "flips", and why others
    stayed.
    """

    kept: Integers
    stretch: Stretch
    face_stretch: Numbers
    fine_places: tuple[Integers, Numbers]
    prolongation: Matrix
    status: str
    counts: dict[str, int]

    @classmethod
    def _of_simplification(cls, core, found, fine):
        surface = cls._of(core)
        surface.kept, surface.status = found["kept"], found["status"]
        surface.stretch, surface.face_stretch = Stretch(*found["stretch"]), found["face_stretch"]
        surface.fine_places = found["faces"], found["weights"]
        surface.prolongation = _arrays.sparse(found["prolongation"])
        surface.counts = found["counts"]
        surface._fine = fine
        surface._vector_prolongation = None
        return surface

    @property
    def vector_prolongation(self) -> Any:
        """Takes tangent vectors from coarse to fine vertices: a complex csr_matrix of shape (N, n),
        with a row for each copy of a vertex on a cover. Vectors are turned as the map between the
        surfaces turns edges."""
        if self._vector_prolongation is None:
            faces, weights = self.fine_places
            self._vector_prolongation = _arrays.sparse(_core.vector_prolongation(
                self._fine, self._flipped(), self.kept, faces, weights, tuple(self.stretch), None))
        return self._vector_prolongation

    def _kept_state(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items()
                if name in CoarseSurface.__annotations__ or name in ("_fine",
                                                                     "_vector_prolongation")}

    def __reduce__(self):
        return _restored, (self._core, self._kept_state())

    def __copy__(self):
        return _restored(_core.copy(self._core), self._kept_state())

    def __repr__(self):
        return f"<intrinsic.CoarseSurface: {self.number_of_vertices} vertices, " \
               f"{self.number_of_faces} faces, lengths times {self.stretch.lower:.4g} to " \
               f"{self.stretch.upper:.4g}>"


def _restored(core, found):
    surface = CoarseSurface._of(core)
    vars(surface).update(found)
    return surface
