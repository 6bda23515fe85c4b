# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions of the package robust_laplacian: Laplacians of meshes and clouds of points.

Degenerate faces are treated exactly, so that `mollify_factor` is not needed: 0 leaves faces as they
are, and any other number treats those that flips cannot remove.
"""

import intrinsic


def _matrices(surface):
    """Returns the Laplacian and the mass matrix by columns: they are symmetric."""
    from scipy.sparse import csc_matrix

    return tuple(csc_matrix((m.data, m.indices, m.indptr), shape=m.shape)
                 for m in (surface.laplacian(), surface.mass()))


def _mollification(factor):
    if not factor >= 0:
        raise ValueError(f"mollify_factor is {factor}; give a number that is not negative")
    return "automatic" if factor > 0 else "none"


def mesh_laplacian(verts, faces, mollify_factor=1e-5):
    """Returns the Laplacian and the mass matrix of a triangle mesh, manifold or not, as sparse
    matrices of scipy: the Laplacian of its tufted cover, which has no negative weight."""
    surface = intrinsic.Surface(verts, faces, domain="closed",
                                mollification=_mollification(mollify_factor))
    return _matrices(surface)


def point_cloud_laplacian(points, mollify_factor=1e-5, n_neighbors=30):
    """Returns the Laplacian and the mass matrix of a cloud of points."""
    surface = intrinsic.points(points, neighbors=n_neighbors,
                               mollification=_mollification(mollify_factor))
    return _matrices(surface)
