# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What solvers by heat have in common."""

import numpy as np

from intrinsic import _arrays


def unit(x):
    """Returns vectors divided by their lengths; those without length stay zero."""
    lengths = np.linalg.norm(x, axis=1, keepdims=True)
    return np.divide(x, lengths, out=np.zeros_like(x), where=lengths > 0)


class HeatDistance:
    """Distances by heat on `surface`, with the time `t_coef`."""

    def compute_distance(self, v_ind):
        """Returns the distances of all vertices from one, of shape (n,)."""
        return self.compute_distance_multisource([v_ind])

    def compute_distance_multisource(self, v_inds):
        """Returns the distances of all vertices from the nearest of several, of shape (n,)."""
        return self.surface.distance(v_inds, method="heat", time_factor=self.t_coef)


class VectorHeat(HeatDistance):
    """Vectors by heat on `surface`."""

    _frames = None

    def extend_scalar(self, v_inds, values):
        """Extends values at vertices to all, of shape (n,)."""
        return self.surface.extend(v_inds, values, time_factor=self.t_coef)

    def get_tangent_frames(self):
        """Returns the axes X, Y and the normals at all vertices, three arrays of shape (n, 3)."""
        if self._frames is None:
            x, y = self.surface.frames().vertices.transpose(1, 0, 2)
            normals = self._normals(x, y)
            x = unit(x - (x * normals).sum(axis=1)[:, None] * normals)
            self._frames = x, np.cross(normals, x), normals
        return self._frames

    def _normals(self, x, y):
        return unit(np.cross(x, y))

    def transport_tangent_vector(self, v_ind, vector):
        """Transports a vector, given in the axes X and Y of a vertex, to all: shape (n, 2)."""
        return self.transport_tangent_vectors([v_ind], [vector])

    def transport_tangent_vectors(self, v_inds, vectors):
        """Transports vectors, each to where its vertex is the nearest: shape (n, 2)."""
        vectors = _arrays.numbers(vectors, "vectors", (None, 2))
        return self.surface.transport(v_inds, vectors, time_factor=self.t_coef).coordinates

    def compute_log_map(self, v_ind, strategy="AffineLocal"):
        """Returns the logarithmic map of a vertex, of shape (n, 2), in its axes X and Y."""
        methods = {"VectorHeat": "polar", "AffineLocal": "affine", "AffineAdaptive": "affine"}
        if strategy not in methods:
            raise ValueError(f"strategy is {strategy!r}; give one of {list(methods)}")
        return self.surface.log_map(v_ind, method=methods[strategy], time_factor=self.t_coef)


def expect_zero_set(level_set_constraint, soft_level_set_weight=-1, preserve_source_normals=False):
    """Checks options of signed distances: curves are at distance zero, whatever else is wanted."""
    if str(level_set_constraint).lower() != "zeroset" or soft_level_set_weight >= 0:
        raise NotImplementedError(
            f"level_set_constraint is {level_set_constraint!r} with the weight "
            f'{soft_level_set_weight}; give "ZeroSet" without a weight: curves are at zero')
    if preserve_source_normals:
        raise NotImplementedError("normals of curves diffuse with all others; leave "
                                  "preserve_source_normals out")
