# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The module of the package pygeodesic: exact distances and shortest paths."""

from . import geodesic

__all__ = ["geodesic"]
