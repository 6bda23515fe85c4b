# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._curves import _Progress
from ._surface import Surface

_Numbers = NDArray[np.float64]
_Integers = NDArray[np.int64]
_Angle = float | str | Fraction

class PlaneMap:
    surface: Surface
    uv: _Numbers
    status: str
    certificate: dict[str, Any] | None
    distortion: dict[str, float] | None
    rounds: int
    inserted_vertices: int
    injective_on_input: bool | None
    original_vertex: NDArray[np.uint32] | None

class Layout(NamedTuple):
    points: _Numbers
    polygons: list[_Integers]
    uv: _Numbers
    weights: _Numbers
    vertices: _Integers
    input_faces: _Integers
    seams: _Integers

class ConformalMap:
    target: str
    u: _Numbers
    scale_factors: _Numbers
    status: str
    iterations: int
    flips: int
    residual: float
    proven_residual: float | None
    cones: dict[int, float]
    period: complex | None
    positions: _Numbers | None
    sphere: dict[str, Any] | None
    layout: Layout | None
    no_layout: str | None
    certificate: dict[str, Any] | None
    distortion: dict[str, float] | None

class _Maps:
    def parametrize(self, method: Literal["harmonic", "lscm", "spectral", "conformal"] = ..., *,
                    cut: Literal["auto"] | ArrayLike | None = ...,
                    start: Literal["input", "delaunay"] | None = ...,
                    progress: _Progress = ...) -> PlaneMap | ConformalMap: ...
    def uniformize(self, angles: Sequence[_Angle] | ArrayLike | None = ..., *,
                   cones: int | Mapping[int, _Angle] | None = ...,
                   target: Literal["plane", "sphere", "torus", "disk"] | None = ...,
                   start: Literal["input", "delaunay"] = ...,
                   progress: _Progress = ...) -> ConformalMap: ...
    def eigen(self, k: int, *, progress: _Progress = ...) -> tuple[_Numbers, _Numbers]: ...
    def deform(self, handles: ArrayLike | Mapping[int, ArrayLike],
               displacements: ArrayLike | None = ..., *,
               energy: Literal["biharmonic", "harmonic"] = ...,
               progress: _Progress = ...) -> _Numbers: ...
