# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The module of the package pygeodesic: exact distances and shortest paths."""

from . import geodesic

__version__ = "0.1.11"  # the one whose names these are

__all__ = ["geodesic"]
