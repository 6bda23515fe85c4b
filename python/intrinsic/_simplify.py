# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces with fewer vertices, and a proof by how much lengths change."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from . import _arrays, _core, _options

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, Literal
    from numpy.typing import ArrayLike
    from ._coarse import CoarseSurface
    from ._types import Integers, Matrix, Numbers, Progress


class Stretch(NamedTuple):
    """By what lengths of curves are multiplied from the fine surface to the coarse one.

    `lower` and `upper` are proven for every curve, and so for every geodesic distance. They are 0
    and infinite where faces are too thin for doubles. On a cover they hold for its points, where
    copies of a vertex are different ones, and not for distances on the mesh. `mean_lower` and
    `mean_upper` are means of such bounds in faces, by area.
    """

    lower: float
    upper: float
    mean_lower: float
    mean_upper: float


class _Simplification:
    """The methods of `Surface` that make it coarse."""

    def simplify(self, vertices: float | str | None = None, *, stretch: float | None = None,
                 keep: ArrayLike | None = None,
                 cost: Literal["stretch", "curvature", "area", "balanced"]
                 | Callable[[Any], float] | ArrayLike = "stretch",
                 progress: Progress = None) -> CoarseSurface:
        """Returns a surface with fewer vertices, with a proof by how much lengths change.

        Vertices are made flat one by one: lengths of the edges at a vertex are multiplied by one
        factor until the angles at it sum to a full turn. Then it is removed.

        Parameters:
            vertices: how many are wanted, or a part of them such as "10%". By default a tenth, or
                with `stretch` as few as it allows.
            stretch: no length on the surface is multiplied by more than this, or by less than its
                inverse: with 1.05, all geodesic distances stay the same up to 5 percent.
            keep: vertices that stay, of shape (k,); edges that stay, pairs of vertices, of shape
                (k, 2); or a number: edges at which faces are folded by more degrees.
            cost: which vertices go first: those that stretch the surface least, "stretch", or those
                whose "curvature" or "area" moves least, times how far it has moved, or those that
                functions on the surface need least, "balanced", most accurate for operators; or
                values at vertices, of shape (n,) or (n, k) for several functions, that move in its
                place; or a function that gets a candidate, with the attributes `vertex`,
                `curvature`, `area`, `mean_length`, `squared_length` and `stretch`, and returns its
                cost. A vertex whose cost is not finite stays.
            progress: see `delaunay()`.
        """
        [found] = _simplified(self, _wanted(vertices), None, stretch, None, keep, cost, progress)
        return found

    def remove_flat_vertices(self, within: float = 0, *, keep: ArrayLike | None = None,
                             progress: Progress = None) -> CoarseSurface:
        """Returns the surface without its flat vertices.

        A vertex is flat if the angles at it sum to a full turn, on a border to half a turn: exactly
        with `within=0`, else up to so many radians. Then lengths change as `simplify()` says. CAD
        parts whose coordinates were rounded need `within=1e-6` or so.

        Parameters:
            within: in radians.
            keep, progress: see `simplify()`.
        """
        within = _options.number(within, "within")
        [found] = _simplified(self, (None, None), None, None, within, keep, "stretch", progress)
        return found

    def hierarchy(self, levels: int = 3, *, ratio: float = .25, keep: ArrayLike | None = None,
                  cost: str | ArrayLike | Callable[[Any], float] = "stretch",
                  progress: Progress = None) -> list[CoarseSurface]:
        """Returns coarser and coarser surfaces, in one run of `simplify()`.

        The vertices of a level are among those of the levels before. `kept`, `fine_places`,
        `stretch` and `prolongation` of each level are about this surface. The matrix from a level
        b to the level a before it is `b.prolongation[a.kept]`.

        Parameters:
            levels: how many at most; fewer where no other vertex can be removed.
            ratio: the part of the vertices that stays at each level.
            keep: what stays at all levels, see `simplify()`.
            cost: which vertices go first, see `simplify()`.
            progress: see `delaunay()`.
        """
        levels = _arrays.whole(levels, "levels", "a positive whole number", least=1)
        ratio = _arrays.number(ratio, "ratio", "a number between 0 and 1", lambda x: 0 < x < 1)
        return _simplified(self, (None, None), (levels, ratio), None, None, keep, cost,
                           progress)


def _wanted(vertices):
    """Returns a number of vertices, and a part of them: at least one is None."""
    if vertices is None:
        return None, None
    remedy = "a number of vertices, or a part such as \"10%\""
    if isinstance(vertices, str):
        try:
            part = float(vertices.removesuffix("%")) / 100 if vertices.endswith("%") else np.nan
        except ValueError:
            part = np.nan
        if not 0 < part <= 1:
            raise ValueError(f"vertices is {vertices!r}; give {remedy}")
        return None, part
    return _arrays.whole(vertices, "vertices", remedy, least=1), None


def _split(keep, count):
    """Returns the vertices to keep, and pairs or an angle for edges."""
    none = np.empty(0, dtype=np.int64)
    if keep is None or _arrays.is_single(keep):
        return none, *_options.kept(keep, count)
    keep = _arrays.indices(keep, "keep", count=count)
    if keep.ndim == 1:
        return keep, None, None
    return none, *_options.kept(keep, count)


def _cost(cost, count):
    """Returns the word of a cost, and a function or masses in place of it, or None."""
    if not callable(cost):
        if not isinstance(cost, str):
            return "stretch", None, _masses(cost, count)
        _arrays.expect_word(cost, "cost", ("stretch", "curvature", "area", "balanced"))
        return cost, None, None

    import inspect

    try:
        inspect.signature(cost).bind(None)
    except TypeError:
        raise TypeError("cost needs a function of one argument, a candidate") from None
    except ValueError:  # it has no signature
        pass

    def of_candidate(candidate):
        found = cost(candidate)
        try:
            return float(found)
        except (TypeError, ValueError):
            raise TypeError(f"cost has returned {found!r}; it needs a function that returns a "
                            "number") from None

    return "stretch", of_candidate, None


def _masses(values, count):
    values = _arrays.numbers(values, "cost")
    _arrays.expect_shape(values, "cost", (count,) if values.ndim == 1 else (count, None))
    if values.size == 0:
        raise ValueError("cost has no column; give the values of one function or more")
    return np.ascontiguousarray(values.reshape(count, -1).T)


def _simplified(surface, wanted, levels, stretch, within, keep, cost, progress):
    from ._coarse import CoarseSurface

    if stretch is not None:
        stretch = _options.number(stretch, "stretch")
    word, own, masses = _cost(cost, surface.number_of_vertices)
    vertices, ends, angle = _split(keep, surface.number_of_input_vertices)
    fine = surface._flipped() if keep is None or len(vertices) else _core.delaunay(
        surface._core, ends, angle, None)
    positions = None if fine.points is None else _core.positions(fine)
    found = _core.simplify(
        fine, *wanted, levels, np.inf if stretch is None else stretch, within,
        word, own, masses, vertices, ends, angle, positions, progress)
    return [CoarseSurface._of_simplification(core, facts, fine) for core, facts in found]
