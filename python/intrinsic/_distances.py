# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances on surfaces: on the Delaunay triangulation, exact ones on covers on the faces below."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, NamedTuple, overload

import numpy as np

from . import _arrays, _core, _options
from ._curve import Curve, Curves
from ._files import save_curves
from ._pages import _Shown
from ._points import expect_one, is_point, place_arrays, place_numbers

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any
    from numpy.typing import ArrayLike, NDArray
    from ._types import DistanceMethod, Integers, Numbers, Path, Place, Places, Progress


class FarthestPoints(NamedTuple):
    """Vertices that are far from each other, and a radius within which every vertex has one."""

    vertices: Integers
    radius: float

    def __repr__(self):
        return f"<intrinsic.FarthestPoints: {len(self.vertices)} vertices, " \
               f"radius {self.radius:.6g}>"

    def _add_to_page(self, contents):
        contents.add_marks(contents.surface.points[self.vertices])


class Junctions(NamedTuple):
    """Points where three or more cells meet: places as of a `Curve`, and the cells, clockwise."""

    points: Numbers | Any
    faces: Integers
    barycentric: Numbers
    corners: Integers
    cells: list[list[int]]

    def __repr__(self):
        return f"<intrinsic.Junctions: {len(self.cells)} points>"

    def _add_to_page(self, contents):
        contents.add_marks(self.points, name="junctions")


class _Cells(NamedTuple):
    labels: Integers
    distances: Numbers
    areas: Numbers
    boundaries: Curves
    junctions: Junctions
    status: str


class Voronoi(_Shown, _Cells):
    """A surface divided among sources: each point belongs to the nearest one.

    `labels` and `distances` have an entry per vertex: the number of the cell (-1 where no path
    leads to a source), and the distance. `areas` has one per cell. `boundaries` are curves with a
    cell on their `left` and one on their `right`.
    """

    _surface = None  # stays behind in pickles

    def __reduce__(self):
        return type(self), tuple(self)

    def save(self, path: Path) -> None:
        """Writes the boundaries to a file .vtp, .obj or .ply, each with its number."""
        save_curves(path, self.boundaries)

    def __repr__(self):
        return f"<intrinsic.Voronoi: {len(self.areas)} cells, {len(self.boundaries)} boundaries, " \
               f"{self.status}>"

    def _add_to_page(self, contents):
        contents.add_field("cell", self.labels)
        contents.add_field("distance", self.distances)
        for curve in self.boundaries:
            contents.add_curve(curve, -1)


def _method(method, max_distance, time_factor):
    _arrays.expect_word(method, "method", ("exact", "heat"))
    if method == "heat" and max_distance is not None:
        raise ValueError('max_distance is for method="exact": heat reaches all vertices at once')
    far = np.inf if max_distance is None else _options.number(max_distance, "max_distance")
    time_factor = _options.number(time_factor, "time_factor")
    if method == "exact" and time_factor != _core.defaults["time_factor"]:
        raise ValueError('time_factor is for method="heat": exact distances need no time')
    return _core.DistanceMethod(method == "exact", far, time_factor)


def _warn_of_cap(status):
    if status == "cap":
        warnings.warn("the surface is so thin that a search met its cap; distances beyond the part "
                      "that it searched are infinite", RuntimeWarning, stacklevel=4)


def _flat(source_sets):
    """Returns the points of all sets, and where each set ends."""
    sets = [[s] if is_point(s) else list(s)
            for s in _arrays.sequence(source_sets, "source_sets", "a sequence of sources")]
    return [p for s in sets for p in s], np.cumsum([len(s) for s in sets], dtype=np.int64).tolist()


class _Distances:
    def _places(self, points, name):
        core = self._core
        return place_arrays(points, name, core.number_of_vertices, core.number_of_input_faces)

    def _place(self, p, name):
        expect_one(p, name)
        core = self._core
        return place_numbers(p, name, core.number_of_vertices, core.number_of_input_faces)

    @overload
    def distance(self, sources: Places, *, method: DistanceMethod = ..., targets: None = ...,
                 max_distance: float | None = ..., time_factor: float = ..., flip: bool = ...,
                 progress: Progress = ...) -> Numbers: ...

    @overload
    def distance(self, sources: Places, *, method: DistanceMethod = ..., targets: Place,
                 max_distance: float | None = ..., time_factor: float = ..., flip: bool = ...,
                 progress: Progress = ...) -> float: ...

    @overload
    def distance(self, sources: Places, *, method: DistanceMethod = ..., targets: Places,
                 max_distance: float | None = ..., time_factor: float = ..., flip: bool = ...,
                 progress: Progress = ...) -> Numbers | Any: ...

    def distance(self, sources: Places, *, method: DistanceMethod = "exact",
                 targets: Places | None = None, max_distance: float | None = None,
                 time_factor: float = 1.0, flip: bool = True,
                 progress: Progress = None) -> Numbers | float:
        """Returns the distance of each vertex from the nearest source, of shape (n,).

        `sources` is a vertex, a `Point`, or a sequence of them. `method` is "exact", along shortest
        paths, or "heat", an approximation that is faster for many calls. With `targets`, the result
        has the distances of these points instead, a number if it is one point, and an exact search
        stops when it has them; `max_distance` ends it, too. Where no source is reached, the
        distance is infinite. The unit is that of the vertices. `time_factor`, for heat, is the time
        of its flow in squares of the mean edge: more is smoother. `flip` is that of `laplacian()`,
        and matters for heat.

        >>> s.distance(0)
        array([0.        , 1.        , 1.41421356, 1.        ])
        >>> s.distance([1, 3], targets=2)
        1.0
        """
        how = _method(method, max_distance, time_factor)
        ends = None if targets is None else self._places(targets, "targets")
        found, status = _core.distance(self._flipped(flip), self._places(sources, "sources"), ends,
                                       how, progress)
        _warn_of_cap(status)
        return float(found[0]) if targets is not None and is_point(targets) else found

    def distances(self, source_sets: Sequence[Places] | NDArray[Any], *,
                  method: DistanceMethod = "exact", max_distance: float | None = None,
                  time_factor: float = 1.0, threads: int = 0, out: NDArray[Any] | None = None,
                  flip: bool = True, progress: Progress = None) -> NDArray[Any]:
        """Returns the distances of all vertices from each of many sets of sources, of shape (k, n).

        `source_sets` has k elements, each what `distance()` takes as sources. `threads` is how many
        of them work, 0 for one per processor; results do not depend on it. `out` is an array of
        shape (k, n), of type float64 or float32 in C order, which may be a file that is mapped to
        memory: distances are written there.

        >>> s.distances([0, [1, 3]])
        array([[0.        , 1.        , 1.41421356, 1.        ],
               [1.        , 0.        , 1.        , 0.        ]])
        """
        how = _method(method, max_distance, time_factor)
        points, ends = _flat(source_sets)
        shape = len(ends), self._core.number_of_vertices
        if out is None:
            out = np.empty(shape)
        elif not isinstance(out, np.ndarray) or out.shape != shape:
            raise ValueError(f"out must be an array of the shape {shape}, not "
                             f"{getattr(out, 'shape', type(out).__name__)}")
        _warn_of_cap(_core.distances(self._flipped(flip), self._places(points, "source_sets"), ends,
                                     how, _arrays.whole(threads, "threads"), out, progress))
        return out

    def pair_distances(self, A: Places, B: Places, *, method: DistanceMethod = "exact",
                       threads: int = 0, flip: bool = True, progress: Progress = None) -> Numbers:
        """Returns the distance from each point of `A` to that of `B`, of shape (k,).

        One of them may be a single point. Pairs that begin with the same point share a search: let
        points that repeat be in `A`.

        >>> s.pair_distances([0, 1], 2)
        array([1.41421356, 1.        ])
        """
        how, threads = _method(method, None, 1), _arrays.whole(threads, "threads")
        a, b = self._places(A, "A"), self._places(B, "B")
        size = max(len(a[0]), len(b[0]))
        a, b = ([np.repeat(x, size, axis=0) if len(x) == 1 else x for x in p] for p in (a, b))
        if len(a[0]) != len(b[0]):
            raise ValueError(f"A has {len(a[0])} points and B {len(b[0])}; give as many")
        return _core.pair_distances(self._flipped(flip), a, b, how, threads, progress)

    def voronoi(self, sources: Place | Sequence[Places] | NDArray[Any], *,
                cell_tolerance: float | None = None, progress: Progress = None) -> Voronoi:
        """Divides the surface among sources by exact distances, and returns a `Voronoi`.

        Each element of `sources` is a point, or a set of points that share a cell. Boundaries are
        polylines within `cell_tolerance`, by default a thousandth of the mean edge.

        >>> s.voronoi([0, 2]).labels[[0, 2]]
        array([0, 1])
        """
        points, ends = _flat([sources] if is_point(sources) else sources)
        sizes = np.diff(np.array(ends, dtype=np.int64), prepend=0)
        if len(sizes) == 0 or not sizes.all():
            raise ValueError("each cell needs a source; give one at least")
        cell = np.repeat(np.arange(len(sizes)), sizes)
        if cell_tolerance is not None:
            cell_tolerance = _options.number(cell_tolerance, "cell_tolerance")
        found = _core.voronoi(self._flipped(), self._places(points, "sources"), cell.tolist(),
                              cell_tolerance, progress)
        places = found["junctions"]
        junctions = Junctions(places["points"], places["faces"], places["barycentric"],
                              places["corners"], found["cells_at_junctions"])
        result = Voronoi(found["labels"], found["distances"], found["areas"],
                         Curves(Curve(b, self) for b in found["boundaries"]), junctions,
                         found["status"])
        result._surface = self
        return result

    def farthest_points(self, n: int, *, start: int | ArrayLike = 0,
                        progress: Progress = None) -> FarthestPoints:
        """Returns `n` vertices that are far from each other, and the radius that they cover.

        `start`, one vertex or several, are the first ones. Each of the others is the farthest one
        from all before it, by exact distances.

        >>> s.farthest_points(2).vertices
        array([0, 2])
        """
        first = np.atleast_1d(_arrays.indices(start, "start"))
        n = _arrays.whole(n, "n")
        if n < len(first):
            raise ValueError(f"n is {n}, but start has {len(first)} vertices; give n above that")
        found, radius = _core.farthest_points(self._flipped(), self._places(first, "start"),
                                              n - len(first), progress)
        return FarthestPoints(np.concatenate([first, found]), radius)
