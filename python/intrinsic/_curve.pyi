# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
from collections.abc import Sequence
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix

from ._points import Point
from ._surface import Surface

class Curve:
    points: NDArray[np.float64] | None
    faces: NDArray[np.int64]
    corners: NDArray[np.int64]
    barycentric: NDArray[np.float64]
    vertices: NDArray[np.int64]
    length: float
    bounds: tuple[float, float]
    is_closed: bool
    status: str
    initial_length: float | None
    level: float | None
    number_of_level: int | None
    left: int | None
    right: int | None
    def places(self) -> list[Point]: ...
    def __len__(self) -> int: ...

class Network(Sequence[Curve]):
    curves: list[Curve]
    status: str
    flips: int
    certified: bool | None
    obstacle: str | None
    @property
    def length(self) -> float: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, i: int) -> Curve: ...
    @overload
    def __getitem__(self, i: slice[Any, Any, Any]) -> list[Curve]: ...

class Cut:
    points: NDArray[np.float64] | None
    faces: NDArray[np.int64]
    original_vertex: NDArray[np.int64]
    input_vertex: NDArray[np.int64]
    input_face: NDArray[np.int64]
    component: NDArray[np.int64]
    curve_of_side: NDArray[np.int64]
    interpolation: csr_matrix
    @property
    def surface(self) -> Surface: ...
    @property
    def number_of_components(self) -> int: ...
