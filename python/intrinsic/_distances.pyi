# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
from collections.abc import Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._curve import Curve
from ._curves import _Place, _Places, _Progress

_Method = Literal["exact", "heat"]
_Numbers = NDArray[np.float64]

class FarthestPoints(NamedTuple):
    vertices: NDArray[np.int64]
    radius: float

class Junctions(NamedTuple):
    points: _Numbers | None
    faces: NDArray[np.int64]
    barycentric: _Numbers
    corners: NDArray[np.int64]
    cells: list[list[int]]

class Voronoi(NamedTuple):
    labels: NDArray[np.int64]
    distances: _Numbers
    areas: _Numbers
    boundaries: list[Curve]
    junctions: Junctions
    status: str

class _Distances:
    def distance(self, sources: _Places, *, method: _Method = ..., targets: _Places | None = ...,
                 max_distance: float | None = ..., time_factor: float = ...,
                 progress: _Progress = ...) -> _Numbers: ...
    def distances(self, source_sets: Sequence[_Places] | ArrayLike, *, method: _Method = ...,
                  max_distance: float | None = ..., time_factor: float = ..., threads: int = ...,
                  out: NDArray[Any] | None = ..., progress: _Progress = ...) -> NDArray[Any]: ...
    def pair_distances(self, A: _Places, B: _Places, *, method: _Method = ..., threads: int = ...,
                       progress: _Progress = ...) -> _Numbers: ...
    def voronoi(self, sources: _Place | Sequence[_Places] | ArrayLike, *,
                tolerance: float | None = ..., progress: _Progress = ...) -> Voronoi: ...
    def farthest_points(self, n: int, *, start: int | ArrayLike = ...,
                        progress: _Progress = ...) -> FarthestPoints: ...
