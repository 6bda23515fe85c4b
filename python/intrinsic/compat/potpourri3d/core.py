# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of arrays."""

import numpy as np

from intrinsic import _arrays


def validate_mesh(V, F, force_triangular=False, test_indices=False):
    """Checks that points have the shape (n, 3), and faces three corners or more; exactly three with
    `force_triangular`; with `test_indices`, that their vertices exist. Raises ValueError."""
    points = _arrays.numbers(V, "V", (None, 3))
    _, begins = _arrays.polygons(F, "F", len(points) if test_indices else None)
    sizes = np.diff(begins)
    wrong = np.flatnonzero((sizes != 3) if force_triangular else (sizes < 3))
    if len(wrong):
        raise ValueError(f"F[{wrong[0]}] has {sizes[wrong[0]]} corners; give "
                         + ("triangles" if force_triangular else "three at least"))


def validate_points(V):
    """Checks that points have the shape (n, 3). Raises ValueError."""
    _arrays.numbers(V, "V", (None, 3))
