# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
from collections.abc import Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._curve import Curve, Network
from ._curves import _Place, _Places, _Progress

_Numbers = NDArray[np.float64]
_Integers = NDArray[np.int64]

class VectorField:
    coordinates: _Numbers
    def __len__(self) -> int: ...
    @property
    def lengths(self) -> _Numbers: ...
    @property
    def vectors(self) -> _Numbers: ...
    @property
    def axes(self) -> _Numbers: ...

class Frames:
    @property
    def vertices(self) -> _Numbers: ...
    @property
    def faces(self) -> _Numbers: ...
    @property
    def angles(self) -> _Numbers | None: ...
    def to_space(self, z: ArrayLike) -> _Numbers: ...

class Singularities(NamedTuple):
    faces: _Integers
    barycentric: _Numbers
    points: _Numbers
    index: NDArray[np.int32]

class DirectionField(VectorField):
    degree: int
    singularities: Singularities
    face_index: NDArray[np.int32]
    index_sum: int
    border_turns: int

class _Fields:
    def frames(self) -> Frames: ...
    def log_map(self, p: _Place, *, method: Literal["exact", "affine", "polar"] | None = ...,
                time_factor: float = ..., max_distance: float = ...,
                progress: _Progress = ...) -> _Numbers: ...
    def transport(self, points: _Places, vectors: ArrayLike, *, time_factor: float = ...,
                  progress: _Progress = ...) -> VectorField: ...
    def extend(self, points: _Places, values: ArrayLike, *, time_factor: float = ...,
               progress: _Progress = ...) -> _Numbers: ...
    def direction_field(self, degree: int = ..., *, align: float | None = ...,
                        fixed: tuple[_Places, ArrayLike] | None = ...,
                        progress: _Progress = ...) -> DirectionField: ...
    def signed_distance(self, curves: Curve | Network | _Places | ArrayLike
                        | Sequence[Curve | Network | _Places | ArrayLike], *,
                        time_factor: float = ..., progress: _Progress = ...) -> _Numbers: ...
    def connection_laplacian(self, degree: int = ...) -> Any: ...
