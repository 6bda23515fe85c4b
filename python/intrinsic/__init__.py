# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Intrinsic triangulations of surfaces, with exact predicates.

>>> import intrinsic as it
>>> V = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
>>> s = it.Surface(V, [[0, 1, 2], [0, 2, 3]])
>>> s
<intrinsic.Surface: 4 vertices, 2 faces>
"""

from ._coarse import CoarseSurface
from ._core import __version__
from ._curve import Curve, Curves, Cut, Network
from ._distances import FarthestPoints, Voronoi
from ._isometries import Isometries, Isometry
from ._map import Failure, map
from ._operators import Operators
from ._points import Point
from ._sources import load, points, read
from ._subdivision import CommonSubdivision
from ._surface import Surface

__all__ = ["CoarseSurface", "CommonSubdivision", "Curve", "Curves", "Cut", "Failure",
           "FarthestPoints", "Isometries", "Isometry", "Network", "Operators", "Point", "Surface",
           "Voronoi", "__version__", "load", "map", "points", "read"]
