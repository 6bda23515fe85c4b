# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves on surfaces as objects."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, SupportsIndex, overload

import numpy as np

from ._files import save_curves, save_surface
from ._pages import _Shown
from ._points import Point

if TYPE_CHECKING:
    from ._surface import Surface
    from ._types import Integers, Matrix, Numbers, Path


class Curve(_Shown):
    """A curve over the faces of the user's mesh, straight between its n points.

    - `points`: the points in space, of shape (n, 3); None if the surface has no coordinates.
    - `faces`: for each point the face of the mesh in which the curve goes on; for the last one of a
      curve that is not closed the face where it ends.
    - `corners` and `barycentric`, of shape (n, 3): the vertices at the corners of these faces (in a
      polygon, of a triangle in it), and the weights of these vertices that give the point.
    - `vertices`: the vertex at each point, or -1.
    - `length`, and `bounds`: two numbers between which the exact length certainly is.
    - `is_closed`: whether the last point is joined to the first one.
    - `status`: "done"; "border" if a traced curve has ended there; "contracted" if a loop has
      shrunk to a point; "inaccurate" if rounding may have misled the curve.

    Paths and loops have `initial_length`, that of the shortest paths that they were made of;
    isolines have `level` and `number_of_level`, and boundaries of cells `left` and `right`. For
    other curves these are None.
    """

    points: Numbers | Any
    faces: Integers
    corners: Integers
    barycentric: Numbers
    vertices: Integers
    length: float
    bounds: tuple[float, float]
    is_closed: bool
    status: str
    initial_length: float | None
    level: float | None
    number_of_level: int | None
    left: int | None
    right: int | None

    __slots__ = ("points", "faces", "corners", "barycentric", "vertices", "length", "bounds",
                 "is_closed", "status", "initial_length", "level", "number_of_level", "left",
                 "right", "_way", "_surface")

    _parts = tuple((name, name.lstrip("_")) for name in __slots__ if name != "_surface")

    def __init__(self, parts, surface=None):
        for name, part in self._parts:
            setattr(self, name, parts.get(part))
        self._surface = surface

    def __reduce__(self):
        return type(self), ({part: getattr(self, name) for name, part in self._parts},)

    def _add_to_page(self, contents):
        contents.add_curve(self)

    def save(self, path: Path) -> None:
        """Writes the curve to a file .vtp, .obj or .ply."""
        save_curves(path, [self])

    def places(self) -> list[Point]:
        """Returns the points as a list of `Point`s; they have no sense in faces with more than
        three corners."""
        return [Point(int(f), tuple(b)) for f, b in zip(self.faces, self.barycentric)]

    def __len__(self) -> int:
        return len(self.faces)

    def __repr__(self):
        if self.status == "contracted":
            return "<intrinsic.Curve: a loop that has shrunk to a point>"
        kind = "closed curve" if self.is_closed else "curve"
        points = "1 point" if len(self) == 1 else f"{len(self)} points"
        status = "" if self.status in (None, "done") else f", {self.status}"
        return f"<intrinsic.Curve: {kind} of {points}, length {self.length:.6g}{status}>"


class Curves(_Shown, list[Curve]):
    """A list of `Curve`s of one surface.

    `length` is that of all, and `lengths`, of shape (k,), are those of each.
    """

    @property
    def _surface(self):
        return self.__dict__.get("_of") or next((c._surface for c in self), None)

    def __getstate__(self):
        return {}  # the surface stays behind

    @overload
    def __getitem__(self, i: SupportsIndex) -> Curve: ...

    @overload
    def __getitem__(self, i: slice) -> Curves: ...

    def __getitem__(self, i):
        found = super().__getitem__(i)
        return self._like(found) if isinstance(i, slice) else found

    def __add__(self, other):
        return self._joined(other, lambda: [*self, *other])

    def __radd__(self, other):
        return self._joined(other, lambda: [*other, *self])

    def _joined(self, other, join):
        """Returns the curves of two lists, as `Curves` unless their surfaces differ."""
        if not isinstance(other, list) or not all(isinstance(c, Curve) for c in other):
            return NotImplemented
        curves = join()
        surfaces = {id(x): x for x in (self._surface, getattr(other, "_surface", None),
                                       *(c._surface for c in curves)) if x is not None}
        return curves if len(surfaces) > 1 else self._like(curves, *surfaces.values())

    def copy(self) -> Curves:
        """Returns another list of the same curves."""
        return self._like(self)

    def _like(self, curves, surface=None):
        """Returns some curves as `Curves` of the same surface, or of another one."""
        result = Curves(curves)
        result._of = surface or self._surface
        return result

    def _add_to_page(self, contents):
        for curve in self:
            contents.add_curve(curve, curve.number_of_level)

    def save(self, path: Path) -> None:
        """Writes the curves to a file .vtp, .obj or .ply, each with its number."""
        save_curves(path, self)

    @property
    def length(self) -> float:
        """The length of all curves."""
        return sum(c.length for c in self)

    @property
    def lengths(self) -> Numbers:
        """The length of each curve."""
        return np.array([c.length for c in self], dtype=float)

    def __repr__(self):
        return f"<intrinsic.Curves: {len(self)} curves, length {self.length:.6g}>"


class Network(_Shown, Sequence[Curve]):
    """Geodesics, as a sequence of `Curve`s, along edges of a triangulation of their surface.

    `curves` is the list of them, `length` that of all, `lengths` those of each, `status` "done", or
    what ended the work, `flips` how many edges were flipped, `certified` whether the curves are
    proven to be geodesic (None: this was not asked for), and `obstacle` why a path on the faces of
    a soup is not, or None. `Surface.cut()` cuts along them.
    """

    curves: list[Curve]
    status: str
    flips: int
    certified: bool | None
    obstacle: str | None

    __slots__ = ("curves", "status", "flips", "certified", "obstacle", "_edges", "_surface")

    def __init__(self, parts, surface):
        self.curves = [Curve(c, surface) for c in parts["curves"]]
        self._surface = surface
        self.status = parts["status"]
        self.flips = parts["flips"]
        self.certified = parts["is_certified"]
        self.obstacle = parts["obstacle"]
        self._edges = parts["edges"]

    def __getstate__(self):
        return self.curves, self.status, self.flips, self.certified, self.obstacle

    def __setstate__(self, state):
        self.curves, self.status, self.flips, self.certified, self.obstacle = state
        self._edges = self._surface = None  # stay behind: cuts insert the curves again

    def _add_to_page(self, contents):
        for curve in self.curves:
            contents.add_curve(curve)

    def save(self, path: Path) -> None:
        """Writes the curves to a file .vtp, .obj or .ply, each with its number."""
        save_curves(path, self.curves)

    @property
    def length(self) -> float:
        """The length of all curves."""
        return sum(c.length for c in self.curves)

    @property
    def lengths(self) -> Numbers:
        """The length of each curve."""
        return np.array([c.length for c in self.curves], dtype=float)

    def __len__(self) -> int:
        return len(self.curves)

    @overload
    def __getitem__(self, i: int) -> Curve: ...

    @overload
    def __getitem__(self, i: slice) -> list[Curve]: ...

    def __getitem__(self, i):
        return self.curves[i]

    def __repr__(self):
        return f"<intrinsic.Network: {len(self)} curves, length {self.length:.6g}>"


class Cut(_Shown):
    """A surface cut open: triangles, and where all their parts come from.

    The first vertices are those of the user's mesh, with their numbers; then come points where
    curves cross edges or end in faces, then copies.

    - `surface`: the `Surface` of the pieces.
    - `points` (n, 3) and `faces` (m, 3): its vertices and triangles.
    - `original_vertex` (n,): the vertex before the cut that each vertex is a copy of.
    - `input_vertex` (n,): the user's vertex that each vertex is, or is a copy of; -1: none.
    - `input_face` (m,): the user's face that each triangle is in.
    - `component` (m,): the connected component of each triangle, from 0.
    - `curve_of_side` (m, 3): one more than the number of the curve along the side from each corner
      to the next; 0: none.
    - `interpolation`: the sparse matrix that takes values at the user's vertices to all vertices.
    """

    points: Numbers | Any
    faces: Integers
    original_vertex: Integers
    input_vertex: Integers
    input_face: Integers
    component: Integers
    curve_of_side: Integers
    interpolation: Matrix

    def __init__(self, parts, users):
        from scipy.sparse import coo_matrix

        for name in ("points", "faces", "original_vertex", "input_vertex", "input_face",
                     "component", "curve_of_side"):
            setattr(self, name, parts[name])
        rows, columns, weights = parts["interpolation"]
        shape = len(self.original_vertex), users
        self.interpolation = coo_matrix((weights, (rows, columns)), shape=shape).tocsr()
        self._pieces = None

    @property
    def surface(self) -> Surface:
        """The pieces as a `Surface`."""
        if self.points is None:
            raise ValueError("the surface has lengths and no points, so that its pieces have no "
                             "places")
        if self._pieces is None:
            from ._surface import Surface

            self._pieces = Surface(self.points, self.faces)
        return self._pieces

    @property
    def _surface(self):
        return None if self.points is None else self.surface

    def _component_of_vertex(self):
        component = np.zeros(len(self.original_vertex), dtype=np.int64)
        component[self.faces] = self.component[:, None]
        return component

    def save(self, path: Path, *, plain: bool = False) -> None:
        """Writes the pieces to a file .ply, .obj, .off, .stl or .vtp; .ply and .vtp have the
        number of the component at each vertex. `plain`: see `Surface.save()`."""
        save_surface(path, self.surface, [("component", self._component_of_vertex())], plain)

    def _add_to_page(self, contents):
        contents.add_field("component", self._component_of_vertex())
        face, side = np.nonzero(self.curve_of_side)
        ends = self.faces[face, side], self.faces[face, (side + 1) % 3]
        for i, j, label in zip(*ends, self.curve_of_side[face, side]):
            contents.curves.append((self.points[[i, j]], False, int(label) - 1))

    @property
    def number_of_components(self) -> int:
        """How many pieces there are."""
        return int(self.component.max()) + 1

    def __repr__(self):
        return f"<intrinsic.Cut: {len(self.original_vertex)} vertices, {len(self.faces)} faces, " \
               f"{self.number_of_components} components>"
