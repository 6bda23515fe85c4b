# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The types in signatures, for programs that check them: no other file of this package runs it."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from os import PathLike
from typing import Literal, Optional, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import csr_matrix

from ._curve import Curve, Network
from ._points import Point

Item = TypeVar("Item")
Result = TypeVar("Result")
Numbers = NDArray[np.float64]
Integers = NDArray[np.int64]
Matrix = csr_matrix
Place = Union[int, Point]
Places = Union[Place, Sequence[Place], ArrayLike]
Progress = Union[Callable[[str, int, Optional[int]], object], None]
Path = Union[str, PathLike[str]]
Angle = Union[float, str, Fraction]
Arithmetic = Literal["exact", "double"]
Mollification = Literal["automatic", "none", "lengths", "squared"]
Polygons = Literal["fan", "planar"]
Domain = Literal["auto", "manifold", "orientation-cover", "tufted", "closed"]
FileDomain = Union[Domain, Literal["points"]]
CurveMethod = Literal["exact", "flips"]
DistanceMethod = Literal["exact", "heat"]
SignedCurve = Union[Curve, Network, Places, ArrayLike]
SignedCurves = Union[SignedCurve, Sequence[SignedCurve]]
