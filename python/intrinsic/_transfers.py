# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is on the input and on the triangulation: values, points, the common subdivision."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _arrays, _core
from ._points import place_arrays
from ._subdivision import CommonSubdivision

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Literal
    from numpy.typing import ArrayLike
    from ._points import Point
    from ._types import Integers, Numbers, Progress


class _Transfers:
    def to_input(self, u: ArrayLike, method: Literal["l2", "pointwise"] = "l2", *,
                 progress: Progress = None) -> Numbers:
        """Takes values at the vertices of the triangulation, of shape (n,) or (n, k), to those of
        the input: a row for each of them.

        `method` is "l2": the nearest function there, which keeps integrals; or "pointwise": the
        values at its vertices.
        """
        return self._transfer(u, method, True, self.number_of_vertices, progress)

    def from_input(self, u: ArrayLike, method: Literal["l2", "pointwise"] = "l2", *,
                   progress: Progress = None) -> Numbers:
        """Takes values at the vertices of the input to those of the triangulation. See
        `to_input()` for shapes and `method`."""
        return self._transfer(u, method, False, self.number_of_input_vertices, progress)

    def _transfer(self, u, method, to_input, size, progress):
        _arrays.expect_word(method, "method", ("l2", "pointwise"))
        values = _arrays.numbers(u, "u")
        if values.ndim not in (1, 2) or len(values) != size:
            raise ValueError(f"u has the shape {values.shape}; give a row for each of the {size} "
                             "vertices")
        result = _core.transfer(self._core, values, to_input, method == "l2", progress)
        return result[:, 0] if values.ndim == 1 else result

    def locate(self, points: int | Point | ArrayLike | Sequence[int | Point], *,
               on: Literal["triangulation", "input"] = "triangulation") -> tuple[Integers, Numbers]:
        """Finds where points of the input are on the triangulation, or the other way round.

        Parameters:
            points: vertices of the input, and `Point`s on its faces; on="input": `Point`s on the
                faces of the triangulation.
            on: "triangulation" or "input".

        Returns: their faces, of shape (k,), and barycentric coordinates there, (k, 3).
        """
        _arrays.expect_word(on, "on", ("triangulation", "input"))
        if on == "triangulation":
            return _core.locate(self._core, place_arrays(
                points, "points", self.number_of_vertices, self.number_of_input_faces))
        faces, weights, vertices = place_arrays(points, "points", 0, self.number_of_faces)
        return _core.locate_on_input(self._core, faces, weights)

    def common_subdivision(self, *, progress: Progress = None) -> CommonSubdivision:
        """Returns the coarsest mesh in which edges of the input and of the triangulation are paths.
        """
        return CommonSubdivision(_core.common_subdivision(self._core, progress), self)
