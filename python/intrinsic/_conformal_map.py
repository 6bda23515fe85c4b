# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Discrete conformal maps to the plane, tori, the sphere and Poincaré's disk."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ._arguments import nearest
from ._files import save_surface
from ._pages import _PageContents, _Shown

if TYPE_CHECKING:
    from typing import Any
    from ._types import Integers, Numbers, Path


class Layout(NamedTuple):
    """The layout of a surface in the plane: the pieces of faces of the mesh between edges of the
    flat triangulation, cut open to disks.

    `points` of shape (k, 3) and `polygons`, a list of arrays, are the pieces on the mesh; `uv` of
    shape (k, 2) their places in the plane, and `weights` of shape (k,) the third homogeneous
    coordinates: (u q, v q, q) is linear on the faces of the mesh. `vertices` of shape (k,) are
    those of the mesh, or -1 at crossings of edges, and `input_faces` the faces of the mesh.
    `seams` of shape (s, 2) are the ends of the edges that were cut.
    """

    points: Numbers
    polygons: list[Integers]
    uv: Numbers
    weights: Numbers
    vertices: Integers
    input_faces: Integers
    seams: Integers

    def __repr__(self):
        return f"<intrinsic.Layout: {len(self.uv)} vertices, {len(self.polygons)} pieces, " \
               f"{len(self.seams)} seams>"


class ConformalMap(_Shown):
    """A discrete conformal map: lengths become exp((u_i + u_j) / 2) times lengths.

    `u` and `scale_factors`, exp(u / 2), have the shape (n,). `status` is "done" if angles are the
    prescribed ones, "inaccurate" if rounding has turned over pieces then, and "stalled" or "cap" if
    the solver ended before. `residual` is the largest difference of the angles that
    `scale_factors` give, in radians, and `proven_residual` a proven bound of it, with
    `scale_factors` and with `u` as well: a large u has fewer digits. On a sphere both are of the
    plane that is projected. `cones` is a dict from vertices to their angles. `target` is "plane",
    "sphere", "torus" or "disk".

    On a sphere `points` of shape (n, 3) are the vertices; of a torus, `period` is a complex
    number. `layout` is a `Layout`, with `certificate` and `distortion` as those of a `PlaneMap`;
    None where `no_layout` says why there is none: a sphere is not in the plane, a Möbius strip or
    a cloud of points has no front, and a solver that stalled may leave triangles without a shape.

    | target | layout, certificate, distortion | points, sphere | period |
    |---|---|---|---|
    | "plane" | if the surface has a front | None | None |
    | "torus" | if the surface has a front | None | there |
    | "disk" | if the surface has a front | None | None |
    | "sphere" | None | there | None |
    """

    target: str
    u: Numbers
    scale_factors: Numbers
    status: str
    iterations: int
    flips: int
    residual: float
    proven_residual: float | Any
    cones: dict[int, float]
    period: complex | Any
    points: Numbers | Any
    sphere: dict[str, Any] | Any
    layout: Layout | Any
    no_layout: str | None
    certificate: dict[str, Any] | Any
    distortion: dict[str, float] | Any

    def __init__(self, found, surface):
        self._surface = surface
        sphere = found.pop("sphere", None)
        layout = found.pop("layout", None)
        self.no_layout = None
        self.certificate = self.distortion = self.points = None
        self.__dict__.update(found)
        self.sphere = sphere
        if sphere is not None:
            self.points = sphere.pop("positions")
            self.no_layout = "a sphere has no layout in the plane; its places are points"
        self.layout = None if layout is None else _layout(layout)

    if not TYPE_CHECKING:  # for which unknown names are errors
        def __getattr__(self, name):
            if name in dir(type(self)):  # a property of a subclass has raised: raise its error
                return object.__getattribute__(self, name)
            if name.startswith("_"):  # which pickle and copy look for before there is anything
                raise AttributeError(name)
            if name == "uv":
                why = self.no_layout or "the places are layout.uv, of the pieces of faces in layout"
                raise AttributeError(f"a ConformalMap has no uv: {why}")
            found = nearest(name, [*vars(self), "save", "show", "html"])
            raise AttributeError(f"a ConformalMap has no {name}" +
                                 (f"; did you mean {found}?" if found else ""))

    def __getstate__(self):
        return {**vars(self), "_surface": None}  # stays behind: layouts need none

    def _pieces(self):
        """Returns the pieces of the layout as a surface."""
        from ._surface import Surface

        return Surface(self.layout.points, self.layout.polygons)

    def save(self, path: Path, *, plain: bool = False) -> None:
        """Writes the pieces of the layout, cut open, with their places in the plane, `u` and `v`,
        to a file .obj, where they are texture coordinates, .ply or .vtp. `plain`: see
        `Surface.save()`."""
        if self.layout is None:
            raise ValueError(f"{self.no_layout or 'the map has no layout'}; save its points or u")
        save_surface(path, self._pieces(), zip("uv", self.layout.uv.T), plain)

    def _page_contents(self):
        if self.layout is None or not len(self.layout.points):
            return super()._page_contents()
        contents = _PageContents(self._pieces())
        contents.texture, contents.is_disk = self.layout.uv, self.target == "disk"
        place = dict(zip(self.layout.vertices.tolist(), self.layout.points))
        for ends in self.layout.seams.tolist():
            contents.curves.append((np.array([place[v] for v in ends]), False, 0))
        if self.cones:
            contents.add_marks([place[v] for v in self.cones], name="cones")
        return contents

    def _add_to_page(self, contents):
        contents.add_field("logarithm of scale", self.u)
        if self.points is not None:
            x, y, z = self.points.T
            contents.add_field("longitude", np.degrees(np.arctan2(y, x)))
            contents.add_field("latitude", np.degrees(np.arcsin(np.clip(z, -1, 1))))

    def __repr__(self):
        return f"<intrinsic.ConformalMap to the {self.target}: {len(self.u)} vertices, " \
               f"{self.status}>"


def _layout(parts):
    begins = parts["begins"].astype(np.int64)
    polygons = np.split(parts["corners"].astype(np.int64), begins[1:-1])
    return Layout(parts["points"], polygons, parts["uv"], parts["weights"], parts["vertices"],
                  parts["input_faces"].astype(np.int64), parts["seams"].astype(np.int64))
