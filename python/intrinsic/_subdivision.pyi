# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
from typing import Any

import numpy as np
import scipy.sparse
from numpy.typing import NDArray

class CommonSubdivision:
    V: NDArray[np.float64] | None
    corners: NDArray[np.int64]
    begins: NDArray[np.int64]
    input_face: NDArray[np.int64]
    intrinsic_face: NDArray[np.int64]
    sheet: NDArray[np.int64]
    P_input: scipy.sparse.csr_matrix
    P_intrinsic: scipy.sparse.csr_matrix
    def __init__(self, parts: dict[str, Any]) -> None: ...
    @property
    def polygons(self) -> list[NDArray[np.int64]]: ...
    def triangles(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]: ...
    def to_pyvista(self) -> Any: ...
