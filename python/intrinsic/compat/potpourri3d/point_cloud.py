# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Clouds of points."""

import numpy as np

import intrinsic
from intrinsic import _arrays, _core

from ._heat import VectorHeat


class PointCloudHeatSolver(VectorHeat):
    """Distances and vectors by heat on a cloud of points."""

    def __init__(self, P, t_coef=1.0):
        self.surface = intrinsic.points(P)
        self.t_coef = t_coef

    def compute_log_map(self, p_ind):
        """Returns the logarithmic map of a point, of shape (n, 2), in its axes X and Y."""
        return super().compute_log_map(p_ind)

    def compute_signed_distance(self, curves, cloud_normals, preserve_source_normals=False,
                                level_set_constraint="ZeroSet", soft_level_set_weight=-1):
        """Is not there: the surface of a cloud has no sides."""
        raise NotImplementedError(
            "clouds of points have no signed distances; make a mesh of them for "
            "MeshSignedHeatSolver, or take compute_distance_multisource() of the points of curves")


class PointCloudLocalTriangulation:
    """The triangles of each point among its 30 neighbours. They are decided exactly, so that
    `with_degeneracy_heuristic` changes nothing."""

    def __init__(self, P, with_degeneracy_heuristic=True):
        self.points = _arrays.points(P, "P")

    def get_local_triangulation(self):
        """Returns the triangles at each point, of shape (n, k, 3): the point first, then
        counterclockwise about it, seen from where the largest coordinate of its normal is positive.
        Points with fewer than k triangles have rows of -1 after theirs."""
        P, triangles = self.points, _core.triangles_at_points(self.points, 30)
        triangles = triangles[np.argsort(triangles[:, 0], kind="stable")]
        center, counts = triangles[:, 0], np.bincount(triangles[:, 0], minlength=len(P))
        normals = np.zeros_like(P)
        np.add.at(normals, center, np.cross(P[triangles[:, 1]] - P[center],
                                            P[triangles[:, 2]] - P[center]))
        largest = normals[np.arange(len(P)), np.abs(normals).argmax(axis=1)]
        seen_from_below = largest[center] < 0
        triangles[seen_from_below] = triangles[seen_from_below][:, [0, 2, 1]]
        result = np.full((len(P), counts.max(initial=0), 3), -1, dtype=np.int32)
        first = np.cumsum(counts) - counts
        result[center, np.arange(len(center)) - first[center]] = triangles
        return result
