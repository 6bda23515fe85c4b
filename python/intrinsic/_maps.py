# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps to the plane, eigenfunctions, deformations."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import TYPE_CHECKING, overload

import numpy as np

from . import _arrays, _core, _options
from ._conformal_map import ConformalMap
from ._files import save_surface
from ._pages import _Shown

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any, Literal
    from numpy.typing import ArrayLike, NDArray
    from ._surface import Surface
    from ._types import Angle, Numbers, Path, Progress, Solver


class PlaneMap(_Shown):
    """A map of a surface to the plane, linear on the faces of `surface`, which is Delaunay.

    `uv`, of shape (n, 2), has the place of each vertex of `surface`: of those of the mesh, and of
    vertices that were inserted to make the map injective. Of a surface that was cut open,
    `original_vertex`, of shape (n,), is the vertex of the mesh that each is a copy of; else None.

    `certificate` is a dict: "injective", "flipped_faces", "degenerate_faces", "border_is_simple",
    exact for the numbers in `uv`; `injective_on_input` is the same answer for the triangles of the
    mesh. `distortion` is a dict; "mean_quasi_conformal" is 1 if angles stay the same. Ratios of
    areas are 1 where all areas scale alike: "min_area_ratio" and "max_area_ratio" are the least and
    the greatest, and "mean_area_ratio" the mean of each ratio or its inverse, whichever is greater:
    it may be more than the greatest ratio if most areas shrink. `status` is
    "done", or says why the map is not injective; of maps by "spectral" and "lscm" it is
    "inaccurate" if faces have turned over or have no area.
    """

    surface: Surface
    uv: Numbers
    status: str
    certificate: dict[str, Any] | Any
    distortion: dict[str, float] | Any
    rounds: int
    inserted_vertices: int
    injective_on_input: bool | None
    original_vertex: NDArray[np.uint32] | None

    def __init__(self, surface, uv, status, certificate, distortion, rounds, inserted):
        self.surface, self.uv, self.status = surface, uv, status
        self.certificate, self.distortion = certificate, distortion
        self.rounds, self.inserted_vertices = rounds, inserted
        self.injective_on_input = None
        self.original_vertex = None

    @property
    def _surface(self):
        return self.surface

    def save(self, path: Path, *, plain: bool = False) -> None:
        """Writes the surface with its places in the plane, `u` and `v`, to a file .obj, where they
        are texture coordinates, .ply or .vtp. `plain`: see `Surface.save()`."""
        save_surface(path, self.surface, zip("uv", self.uv.T), plain)

    def _add_to_page(self, contents):
        if contents.surface.number_of_vertices != len(self.uv):
            raise ValueError("the map is of another surface, which was cut open or refined; "
                             "let the map show itself: map.show()")
        contents.texture = self.uv

    def __repr__(self):
        return f"<intrinsic.PlaneMap: {len(self.uv)} vertices, {self.status}>"


_multiple = re.compile(r"\s*(\d+)?(?:/(\d+))?\s*\*?\s*pi\s*(?:/\s*(\d+))?\s*")


def _angle(x, name):
    """Returns an angle as radians, NaN if free, and as a multiple of pi, whose denominator is 0 if
    it is none."""
    if isinstance(x, Fraction):
        return 0.0, x.numerator, x.denominator
    if isinstance(x, str):
        if x == "free":
            return np.nan, 0, 0
        found = _multiple.fullmatch(x)
        if found:
            over, below = (int(g) if g else 1 for g in found.groups()[1:])
            angle = Fraction(int(found[1] or 1), over * below) if over * below else None
            if angle:
                return 0.0, angle.numerator, angle.denominator
    wanted = 'positive radians, "free", or a multiple of pi such as "3/2 pi"'
    return _arrays.number(x, name, wanted, lambda x: np.isnan(x) or 0 < x < np.inf), 0, 0


def _angle_arrays(angles, name, vertices):
    """Returns rows, radians, numerators and denominators."""
    if angles is None:
        angles = {}
    elif not isinstance(angles, dict):
        listed = _arrays.sequence(angles, name, "an angle for each vertex, or a dict")
        if len(listed) != vertices:
            raise ValueError(f"{name} has {len(listed)} angles; give one for each of {vertices} "
                             "vertices")
        angles = dict(enumerate(listed))
    rows = _arrays.indices(list(angles), f"{name}.keys()", (None,), count=vertices)
    parts = [_angle(x, f"the angle of vertex {v}") for v, x in angles.items()]
    radians, over, below = zip(*parts) if parts else ((), (), ())
    return (rows, np.array(radians, dtype=float), np.array(over, dtype=np.int64),
            np.array(below, dtype=np.int64))


class _Maps:
    @overload
    def parametrize(self, method: Literal["harmonic", "lscm", "spectral"] = ..., *,
                    cut: Literal["auto"] | ArrayLike | None = ..., solver: Solver = ...,
                    flip: bool = ..., progress: Progress = ...) -> PlaneMap: ...

    @overload
    def parametrize(self, method: Literal["conformal"], *,
                    start: Literal["input", "delaunay"] | None = ..., flip: bool = ...,
                    progress: Progress = ...) -> ConformalMap: ...

    def parametrize(self, method: Literal["harmonic", "lscm", "spectral", "conformal"] = "harmonic",
                    *, cut: Literal["auto"] | ArrayLike | None = None,
                    start: Literal["input", "delaunay"] | None = None, solver: Solver = "auto",
                    flip: bool = True, progress: Progress = None) -> PlaneMap | ConformalMap:
        """Maps a surface to the plane: a `PlaneMap`.

        `method` is "harmonic": to the unit disk, made injective by insertions of vertices;
        "spectral" or "lscm": as conformal as possible with a free border; or "conformal":
        discretely conformal, with scale 1 on the border, see `uniformize()`, whose `start` it
        has and whose `ConformalMap` it returns. Clouds of points have the method "spectral".

        `cut` is "auto" to cut any surface open to disks along short curves, the default if it is no
        disk, or an array of edges of shape (k, 2), as pairs of vertices. Of faces that form no
        oriented manifold, each is mapped once, and edges of more than two faces are cut.

        `solver` is "direct"; or "iterative", in less memory, up to a residual of 1e-10; "auto"
        takes that for harmonic maps from a million vertices on.
        """
        _arrays.expect_word(method, "method", ("harmonic", "lscm", "spectral", "conformal"))
        _options.expect(solver=solver)
        if method == "conformal":
            if solver == "iterative":
                raise ValueError('solver="iterative" is not for conformal maps, whose matrices '
                                 'change in each step; leave it out with method="conformal"')
            if start == "delaunay" and not _arrays.flag(flip, "flip"):
                raise ValueError('flip=False starts from the triangles of the mesh; leave it out '
                                 'with start="delaunay"')
            return self._conformal_map_of_disk(
                cut, start or ("delaunay" if flip else "input"), progress)
        if start is not None:
            raise ValueError(f'start="{start}" is of conformal maps; give it with '
                             'method="conformal"')
        is_cloud = self._is_cloud()
        if is_cloud and (cut is not None or not _arrays.flag(flip, "flip")):
            raise ValueError("a cloud of points has no faces to be cut open, or kept; leave cut "
                             "and flip out")
        if cut is None and not is_cloud and not self._is_disk():
            cut = "auto"
        surface, original = (self, None) if is_cloud else self._cut_open(cut, progress)
        core = self._core if is_cloud else surface._flipped(flip)
        if method == "harmonic":  # which inserts vertices
            core = _core.copy(core)
        *found, inserted, is_injective = _core.parametrize(core, method, self._cloud_neighbors(),
                                                           solver, progress)
        # the triangulation on whose faces the map is linear, and certified
        mapped = surface if is_cloud else type(self)._of(core)
        result = PlaneMap(mapped, *found, inserted)
        result.original_vertex = original
        result.injective_on_input = is_injective
        return result

    def _conformal_map_of_disk(self, cut, start, progress):
        if cut is not None:
            raise ValueError('method="conformal" maps disks as they are; leave cut out, or take '
                             "uniformize(), which cuts any surface open")
        _core.expect_disks(self._core)
        return self.uniformize(target="plane", start=start, progress=progress)

    def uniformize(self, angles: Sequence[Angle] | ArrayLike | None = None, *,
                   cones: int | Mapping[int, Angle] | None = None,
                   target: Literal["plane", "sphere", "torus", "disk"] | None = None,
                   start: Literal["input", "delaunay"] = "delaunay",
                   progress: Progress = None) -> ConformalMap:
        """Finds scale factors with which the surface has prescribed angles, and lays it out: a
        `ConformalMap`.

        `angles` has one for each vertex, in radians, NaN where the vertex keeps its scale, or as
        strings: "3/2 pi", "free"; `fractions.Fraction` is a multiple of pi, which is checked
        exactly. `cones` is the number of vertices, to be chosen, with other angles than a full
        turn, or a dict from vertices to angles. A border is free: the surface is doubled.

        `target` is "plane", "sphere", "torus", or "disk": that of Poincaré, for surfaces with
        handles and, with a geodesic border, others; by default what the surface allows. `start` is
        "delaunay": lengths of the triangles of the intrinsic Delaunay triangulation are scaled; or
        "input": those of the triangles of the mesh.
        """
        _arrays.expect_word(start, "start", ("input", "delaunay"))
        if angles is not None and cones is not None:
            raise ValueError("give angles or cones, not both")
        core = self._flipped() if start == "delaunay" else self._core
        if target is not None:
            _arrays.expect_word(target, "target", ("plane", "sphere", "torus", "disk"))
        if target in ("sphere", "torus") and (angles is not None or cones is not None):
            raise ValueError(f'target="{target}" has no cones; leave angles and cones out')
        count = None
        if cones is not None and not isinstance(cones, dict):
            count = int(_arrays.indices(cones, "cones", ()))
            if count < 0 or target == "disk":
                raise ValueError(f"cones is {count}; give a number of cones of a flat surface, or "
                                 "a dict")
        given = (cones, "cones") if isinstance(cones, dict) else (angles, "angles")
        arrays = _angle_arrays(*given, core.number_of_input_vertices)
        return ConformalMap(_core.uniformize(core, target, start == "input", count, *arrays,
                                             progress), self)

    def eigen(self, count: int = 10, *, solver: Solver = "auto", flip: bool = True,
              progress: Progress = None) -> tuple[Numbers, Numbers]:
        """Returns the `count` smallest eigenvalues of the Laplacian, of shape (count,), in
        1 / area, and the eigenfunctions, of shape (n, count), orthonormal in the mass matrix. There
        are as many as vertices. If `count` is larger, up to 1000 vertices have all of them; on
        larger surfaces it is an error. `solver` is "direct"; or "iterative", in less memory but
        more time, up to a residual of 1e-8; "auto" takes that beyond five million vertices."""
        _options.expect(solver=solver)
        count = _options.number(count, "count")
        return _core.eigen(self._flipped(flip), count, solver, progress)

    def deform(self, handles: ArrayLike | Mapping[int, ArrayLike],
               displacements: ArrayLike | None = None, *,
               energy: Literal["biharmonic", "harmonic"] = "biharmonic",
               solver: Solver = "auto", flip: bool = True,
               progress: Progress = None) -> Numbers:
        """Moves some vertices, and the others with them, as smoothly as possible. Returns the
        displacements of all vertices, of shape (n, d).

        `handles` are vertices, and `displacements`, of shape (k, d), how far they move; or
        `handles` is a dict from vertices to displacements. d is 3 in space, and may be any number.
        The same handles may move many times: that is fast. `energy` is "biharmonic", smooth at
        handles too, or "harmonic", which stays within the range of displacements. Components
        without a handle do not move. `solver` is "direct"; or "iterative", in less memory, up to a
        residual of 1e-10; "auto" takes that beyond five million vertices.
        """
        _options.expect(solver=solver)
        _arrays.expect_word(energy, "energy", ("biharmonic", "harmonic"))
        if isinstance(handles, dict) != (displacements is None):
            raise ValueError("displacements are missing; give them, or a dict of handles"
                             if displacements is None else
                             "displacements are given twice; give them alone, or a dict of handles")
        if displacements is None:
            handles, displacements = list(handles), list(handles.values())
        core = self._flipped(flip)
        rows = _arrays.indices(handles, "handles", (None,), count=core.number_of_vertices)
        if len(rows) == 0:
            raise ValueError("handles is empty; give a vertex at least, and how far it moves")
        moved = _arrays.numbers(displacements, "displacements")
        if moved.ndim != 2 or len(moved) != len(rows):
            raise ValueError(f"displacements has the shape {moved.shape}; give a row for each of "
                             f"{len(rows)} handles")
        return _core.deform(core, rows, moved, energy, solver, progress)

    def _is_disk(self):
        found = self.report["input"]
        return (found["components"], found["genus"], found["boundary_loops"]) == (1, 0, 1)

    def _is_cloud(self):
        return _core.sheets(self._core) > 2

    def _cut_open(self, cut, progress):
        """Returns the surface, cut open, and the vertex that each of its vertices is a copy of."""
        if cut is None:
            return self, None
        if isinstance(cut, str):
            if cut != "auto":
                raise ValueError(f'cut="{cut}" does not exist; give "auto" or an array of edges')
            cut = None
        else:
            cut = _arrays.indices(cut, "cut", (None, 2), count=self._core.number_of_input_vertices)
        core, original = _core.cut_open(self._core, cut, progress)
        return type(self)._of(core), original
