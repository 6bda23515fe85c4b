# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The types in signatures, for programs that check them: no other file of this package runs it.

Results that are None in rare cases, such as points of a surface that has only lengths, have types
such as `Numbers | Any`: programs need not rule out None where they know better."""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor as Executor
from fractions import Fraction
from os import PathLike
from typing import TYPE_CHECKING, Any, Literal, Optional, SupportsIndex, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import csr_matrix

from ._curve import Curve, Network
from ._points import Point

if TYPE_CHECKING:
    from typing_extensions import TypeAlias

Item = TypeVar("Item")
Result = TypeVar("Result")
Function = TypeVar("Function", bound=Callable[..., Any])
Numbers = NDArray[np.float64]
Integers = NDArray[np.int64]
Matrix: "TypeAlias" = csr_matrix
Place = Union[SupportsIndex, Point]
# Not ArrayLike: it is a sequence as well, and mypy finds no type for lists that may be both.
Places = Union[Place, Sequence[Place], NDArray[Any]]
Progress = Union[Callable[[str, int, Optional[int]], object], None]
Path = Union[str, PathLike[str]]
Angle = Union[float, str, Fraction]
Arithmetic = Literal["exact", "double"]
Mollification = Literal["automatic", "none", "lengths", "squared"]
Polygons = Literal["fan", "planar"]
Domain = Literal["auto", "manifold", "orientation-cover", "tufted", "closed"]
FileDomain = Union[Domain, Literal["points"]]
Solver = Literal["auto", "direct", "iterative"]
CurveMethod = Literal["exact", "flips"]
DistanceMethod = Literal["exact", "heat"]
SignedCurve = Union[Curve, Network, Places]
SignedCurves = Union[SignedCurve, Sequence[SignedCurve]]
