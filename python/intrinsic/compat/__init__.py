# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The names that users of other packages know: change one import to try this one.

>>> from intrinsic.compat import robust_laplacian
>>> from intrinsic.compat import potpourri3d as pp3d
>>> from intrinsic.compat.pygeodesic import geodesic
"""
