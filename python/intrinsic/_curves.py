# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Geodesics, isolines and cuts."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from . import _arrays, _core, _options
from ._curve import Curve, Curves, Cut, Network
from ._points import expect_one, joined

if TYPE_CHECKING:
    from collections.abc import Iterable
    from numpy.typing import ArrayLike
    from ._types import CurveMethod, Place, Places, Progress


def _is_shortest(method):
    _arrays.expect_word(method, "method", ("exact", "flips"))
    return method == "exact"


def _direction(direction):
    """Returns a complex number, or three numbers."""
    if not isinstance(direction, (list, tuple)) and np.ndim(direction) == 0:
        try:
            z = np.nan if isinstance(direction, str) else complex(direction)
        except (TypeError, ValueError, OverflowError):
            z = np.nan
        if not np.isfinite(z):
            raise ValueError(f"direction is {_arrays.shortened(direction)}; give a vector, or a "
                             "finite complex number")
        return z
    if type(direction) is np.ndarray and direction.shape == (3,) and direction.dtype == np.float64:
        d = direction.tolist()
        if all(map(math.isfinite, d)):  # the usual case, as in `_arrays.number()`
            return d
    d = _arrays.numbers(direction, "direction")
    if d.shape == (2,):
        return complex(d[0], d[1])
    _arrays.expect_shape(d, "direction", (3,))
    return d.tolist()


class _Curves:
    def path(self, a: Place, b: Place, *, through: Places = (), waypoints: bool = False,
             method: CurveMethod = "exact", progress: Progress = None) -> Curve:
        """Returns a geodesic from `a` to `b` as a `Curve`.

        With `method` "exact", it is a shortest path. With "flips" it is found by flips from a
        shortest path along edges: it is locally shortest, often longer, and found faster. `through`
        are points between the ends. They choose the way around holes and handles; with `waypoints`,
        the path stays at them, and consists of shortest paths from each to the next. On soups,
        shortest paths are those on your faces, any number of which meet at an edge; paths that are
        shortened (by "flips", and with `through` but without `waypoints`) stay on the double cover.

        >>> s.path(0, 2).length
        1.4142135623730951
        """
        expect_one(a, "a")
        expect_one(b, "b")
        places = joined(*(self._places(x, name)
                          for name, x in (("a", a), ("through", through), ("b", b))))
        return self._alone((places, False), waypoints, method, progress)

    def loop(self, points: Places, *, waypoints: bool = False, method: CurveMethod = "exact",
             progress: Progress = None) -> Curve:
        """Returns a closed geodesic as a `Curve`: shortest paths from each of the points to the
        next, and from the last to the first, are shortened together.

        A loop that goes around nothing shrinks to a point: its status is "contracted". On soups,
        loops stay on the double cover. See `path()` for the options.
        """
        loop = self._curve_through(points, "points", 3), True
        return self._alone(loop, waypoints, method, progress)

    def network(self, paths: Iterable[Places] = (), loops: Iterable[Places] = (), *,
                waypoints: bool = False, method: CurveMethod = "exact", certify: bool = False,
                progress: Progress = None) -> Network:
        """Returns several geodesics as a `Network`: paths first, then loops.

        Each path and each loop is a sequence of points, see `path()` and `loop()`. By the method
        "exact" each curve is found as if the others were not there; by "flips" curves do not cross
        others. Ends that several curves share stay where they are. `certify` asks for a proof that
        all curves are geodesic: on soups, shortest paths within the faces, where `obstacle` says
        what could not be proven; other curves on the double cover.
        """
        curves = [(self._curve_through(points, f"{kind}[{i}]", least), kind == "loops")
                  for kind, lists, least in (("paths", paths, 2), ("loops", loops, 3))
                  for i, points in
                  enumerate(_arrays.sequence(lists, kind, "a sequence of curves"))]
        if not curves:
            raise ValueError("a network needs a curve; give paths or loops")
        return Network(self._found(curves, waypoints, method, certify, True, progress), self)

    def _curve_through(self, points, name, least):
        places = self._places(points, name)
        if len(places[0]) < least:
            raise ValueError(f"{name} has {len(places[0])} points; give {least} at least")
        return places

    def _alone(self, curve, waypoints, method, progress):
        """Returns a path or a loop, along which nothing is cut unless it is inserted again."""
        found = self._found([curve], waypoints, method, False, False, progress)
        return Curve(found["curves"][0], self)

    def _found(self, curves, waypoints, method, certify, keeps_edges, progress):
        is_shortest = _is_shortest(method)
        options = (is_shortest, _arrays.flag(waypoints, "waypoints"),
                   _arrays.flag(certify, "certify"), keeps_edges)
        # The shortest path of two points is as short on each triangulation, and found sooner on the
        # Delaunay one.
        are_shortest = is_shortest and not keeps_edges and all(
            not is_loop and len(places[0]) == 2 for places, is_loop in curves)
        return _core.curves(self._flipped(are_shortest, progress), curves, *options, progress)

    def trace(self, p: Place, direction: complex | ArrayLike, length: float) -> Curve:
        """Returns the geodesic from a point in a direction as a `Curve`: the exponential map.

        `direction` is a vector in space, which is projected to the face of `p`, or at a vertex or
        on an edge into the face that is nearest to it. Or it is a complex number: in a face, the
        real axis runs along its first side; at a vertex, see `frames()`. Its size does not matter,
        but is not zero. `length` is in units of the vertices. The curve is straight across edges,
        goes through vertices with equal angles on both sides, and ends at the border.

        >>> s.trace(0, [1, 0.5, 0], 0.5).points[-1]
        array([0.4472136, 0.2236068, 0.       ])
        """
        far = _arrays.not_negative(length, "length", "; a curve ends at a border by itself, and "
                                   "nowhere without one")
        direction = _direction(direction)
        core = self._flipped() if isinstance(direction, complex) else self._core
        return Curve(_core.trace(core, self._place(p, "p"), direction, far), self)

    def isolines(self, u: ArrayLike, levels: int | ArrayLike = 10, *,
                 progress: Progress = None) -> Curves:
        """Returns the lines on which a function has given values, as a list of `Curve`s.

        `u` has a number per vertex, and is linear in the faces of this triangulation. It may be
        infinite. `levels` are the values, or how many there are between the least and the greatest
        value of `u`, evenly. Larger values are on the left of a line. On surfaces that are not
        manifolds, or have one side, each line comes once; it may be in several parts.

        >>> line, = s.isolines([0, 1, 2, 1], [0.5])
        >>> round(line.length, 12)
        0.707106781187
        """
        values = _arrays.numbers(u, "u", (self._core.number_of_vertices,), may_be_infinite=True)
        if _arrays.is_single(levels):
            count = _options.number(levels, "levels")
            levels = _core.even_levels(values, count)
        else:
            levels = _arrays.numbers(levels, "levels", (None,))
        lines = Curves(Curve(line, self)
                       for line in _core.isolines(self._core, values, levels, progress))
        lines._of = self  # also if there are none
        return lines

    def cut(self, curves: Network | Curve | Iterable[Curve] | None = None, *, through: Places = (),
            progress: Progress = None) -> Cut:
        """Cuts the surface open along curves, and returns the pieces as a `Cut`.

        `curves` is a `Network`, a `Curve` of this surface, or a sequence of curves, which may cross
        each other: paths, loops, isolines, traced geodesics, boundaries of cells. Without curves,
        each component becomes a disk: the surface is cut along short geodesics, which pass through
        the vertices `through`.
        """
        users = self._core.number_of_input_vertices
        places = self._places(through, "through")
        if curves is not None and len(places[0]):
            raise ValueError("through is of cuts to disks; give it without curves")
        if curves is None:
            return Cut(_core.cut_to_disks(self._core, places, progress), users)
        if isinstance(curves, Network) and curves._edges is not None:
            return Cut(_core.cut_network(self._core, curves._edges), users)
        if isinstance(curves, Curve):
            curves = [curves]
        curves = _arrays.sequence(curves, "curves", "a Curve, a Network, or a sequence of curves")
        for i, curve in enumerate(curves):
            if not isinstance(curve, Curve):
                raise ValueError(f"curves[{i}] is not a Curve; give what path(), isolines() and "
                                 "others return")
        return Cut(_core.cut_ways(self._core, [c._way for c in curves], progress), users)
