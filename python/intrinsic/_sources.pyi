# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
from os import PathLike
from typing import Literal

from numpy.typing import ArrayLike

from ._surface import Surface, _Arithmetic, _Mollification, _Polygons, _Progress

def read(path: str | PathLike[str], *,
         domain: Literal["auto", "manifold", "orientation-cover", "tufted", "closed",
                         "points"] = ...,
         arithmetic: _Arithmetic | None = ..., mollification: _Mollification | None = ...,
         polygons: _Polygons = ..., neighbors: int | None = ...,
         progress: _Progress | None = ...) -> Surface: ...
def load(path: str | PathLike[str]) -> Surface: ...
def points(P: ArrayLike, *, neighbors: int = ..., arithmetic: _Arithmetic = ...,
           mollification: _Mollification = ...) -> Surface: ...
