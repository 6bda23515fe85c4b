# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
from collections.abc import Callable, Iterable, Sequence
from typing import Literal

from numpy.typing import ArrayLike

from ._curve import Curve, Cut, Network
from ._points import Point

_Place = int | Point
_Places = _Place | Sequence[_Place] | ArrayLike
_Progress = Callable[[str, int], object] | None
_Method = Literal["exact", "flips"]

class _Curves:
    def path(self, a: _Place, b: _Place, *, through: _Places = ..., waypoints: bool = ...,
             method: _Method = ..., progress: _Progress = ...) -> Curve: ...
    def loop(self, points: _Places, *, waypoints: bool = ..., method: _Method = ...,
             progress: _Progress = ...) -> Curve: ...
    def network(self, paths: Iterable[_Places] = ..., loops: Iterable[_Places] = ..., *,
                waypoints: bool = ..., method: _Method = ..., certify: bool = ...,
                progress: _Progress = ...) -> Network: ...
    def trace(self, p: _Place, direction: complex | ArrayLike, length: float) -> Curve: ...
    def isolines(self, u: ArrayLike, levels: int | ArrayLike = ..., *,
                 progress: _Progress = ...) -> list[Curve]: ...
    def cut(self, curves: Network | Curve | Iterable[Curve] | None = ..., *,
            through: _Places = ..., progress: _Progress = ...) -> Cut: ...
