# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The singularities of direction fields."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterator
    from numpy.typing import NDArray
    from ._types import Integers, Numbers


class Singularities:
    """Faces of the triangulation about which a field of directions turns.

    Their centres lie in faces of the user's mesh, `faces` of shape (k,), at `barycentric` of shape
    (k, 3); `points` of shape (k, 3) are their places in space. The field makes index / degree
    turns about each: `index` of shape (k,).

    `f[i]`, `f[:3]` and `f[f.index < 0]` are the `Singularities` of one number, of a slice, and of
    those that an array chooses.
    """

    faces: Integers
    barycentric: Numbers
    points: Numbers
    index: NDArray[np.int32]

    __slots__ = ("faces", "barycentric", "points", "index")

    def __init__(self, faces: Integers, barycentric: Numbers, points: Numbers,
                 index: NDArray[np.int32]) -> None:
        self.faces, self.barycentric, self.points, self.index = faces, barycentric, points, index

    def __len__(self) -> int:
        return len(self.faces)

    def __getitem__(self, which: Any) -> Singularities:
        rows = np.atleast_1d(np.arange(len(self))[which])
        return Singularities(*(getattr(self, name)[rows] for name in self.__slots__))

    def __iter__(self) -> Iterator[Singularities]:
        return (self[i] for i in range(len(self)))

    def __reduce__(self) -> Any:
        return Singularities, tuple(getattr(self, name) for name in self.__slots__)

    def __repr__(self) -> str:
        few = 6
        if 0 < len(self) <= few:
            return f"<intrinsic.Singularities: of index {', '.join(map(str, self.index))}>"
        return f"<intrinsic.Singularities: {len(self)}, sum of indices {int(self.index.sum())}>"

    def _add_to_page(self, contents):
        contents.add_marks(self.points, self.index, "singularities")
