# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of triangles and polygons."""

import numpy as np

import intrinsic
from intrinsic import _arrays

from ._elements import Elements, numbered_edges
from ._heat import HeatDistance, VectorHeat, expect_zero_set, unit

# ---- Areas, edges, the Laplacian -----------------------------------------------------------------


def _triangles(V, F):
    points, faces = _arrays.points(V, "V"), _arrays.indices(F, "F", (None, 3), count=len(V))
    return points, faces


def _doubled_normals(V, F):
    points, faces = _triangles(V, F)
    i, j, k = (points[faces[:, c]] for c in range(3))
    return np.cross(j - i, k - i), faces


def face_areas(V, F):
    """Returns the area of each triangle, of shape (m,)."""
    return np.linalg.norm(_doubled_normals(V, F)[0], axis=1) / 2


def vertex_areas(V, F):
    """Returns a third of the area of the triangles at each vertex, of shape (n,)."""
    areas = np.repeat(face_areas(V, F) / 3, 3)
    return np.bincount(np.ravel(F), weights=areas, minlength=len(V))


def _vertex_normals(V, F):
    """Returns the normals of faces, and of vertices: means weighted by the angles of faces."""
    normals, faces = _doubled_normals(V, F)
    normals, points = unit(normals), np.asarray(V, dtype=float)
    sums = np.zeros_like(points)
    for c in range(3):
        i, j, k = (points[faces[:, (c + s) % 3]] for s in range(3))
        cosines = (unit(j - i) * unit(k - i)).sum(axis=1)
        np.add.at(sums, faces[:, c], np.arccos(np.clip(cosines, -1, 1))[:, None] * normals)
    return normals, unit(sums)


def cotan_laplacian(V, F, denom_eps=0.0):
    """Returns the cotangent Laplacian of the triangles as they are, not of the Delaunay
    triangulation: positive semidefinite, a sparse matrix of scipy. `denom_eps` is added to the
    quadruple area in the denominator of cotangents."""
    from scipy.sparse import coo_matrix

    points, faces = _triangles(V, F)
    rows, columns, weights = [], [], []
    for c in range(3):
        i, j, k = (faces[:, (c + s) % 3] for s in range(3))
        a, b = points[i] - points[k], points[j] - points[k]
        area = np.linalg.norm(np.cross(a, b), axis=1)
        half_cotangents = (a * b).sum(axis=1) / (2 * (area + denom_eps))
        for p, q, sign in ((i, j, -1), (j, i, -1), (i, i, 1), (j, j, 1)):
            rows.append(p)
            columns.append(q)
            weights.append(sign * half_cotangents)
    n = len(points)
    return coo_matrix((np.concatenate(weights), (np.concatenate(rows), np.concatenate(columns))),
                      shape=(n, n)).tocsr()


def edges(V, F):
    """Returns the two vertices of each edge, of shape (e, 2), in the order in which triangles have
    them first. Points on edges are given by these numbers."""
    return numbered_edges(_triangles(V, F)[1])[0]


class _WithElements:
    """A surface of triangles whose elements have numbers."""

    def __init__(self, V, F):
        self.surface = intrinsic.Surface(V, F)
        self._given, self._found = F, None

    @property
    def _elements(self):
        if self._found is None:
            self._found = Elements(self.surface, self._given)
        return self._found


class MeshMarchingTrianglesSolver(_WithElements):
    """Finds lines on which functions have a value."""

    def marching_triangles(self, u, isoval=0.0):
        """Returns the lines as lists of points on edges, `(edge, [t])`, and at vertices,
        `(vertex, [])`. Smaller values are on their left; those that are closed end where they
        start."""
        element, result = self._elements.element, []
        for line in self.surface.isolines(np.ravel(u), [isoval]):
            points = [element(*p) for p in zip(line.faces, line.corners, line.barycentric)][::-1]
            result.append(points + points[:1] if line.is_closed else points)
        return result


MarchingTrianglesSolver = MeshMarchingTrianglesSolver


def marching_triangles(V, F, u, isoval=0.0):
    """Returns the lines on which a function has a value; see `MeshMarchingTrianglesSolver`."""
    return MeshMarchingTrianglesSolver(V, F).marching_triangles(u, isoval)


# ---- Distances -----------------------------------------------------------------------------------


class MeshHeatMethodDistanceSolver(HeatDistance):
    """Distances by heat on a triangle mesh, manifold or not."""

    def __init__(self, V, F, t_coef=1.0, use_robust=True):
        self.surface = intrinsic.Surface(V, F)
        self.t_coef = t_coef


def compute_distance(V, F, v_ind):
    """Returns the distances of all vertices from one."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance(v_ind)


def compute_distance_multisource(V, F, v_inds):
    """Returns the distances of all vertices from the nearest of several."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance_multisource(v_inds)


class MeshFastMarchingDistanceSolver(_WithElements):
    """Distances from points, exact where fast marching approximates them. Signed ones, from curves,
    are by heat."""

    def compute_distance(self, curves, distances=(), sign=False):
        """Returns the distances of all vertices from the nearest of the points of curves, of shape
        (n,). `distances`, a list for each curve, are what is added to that from each point."""
        points = [self._elements.point(p) for curve in curves for p in curve]
        added = np.zeros(len(points))
        begins = np.cumsum([0, *map(len, curves)])
        for curve, begin, values in zip(curves, begins, distances):
            values = _arrays.numbers(values, "distances")[:len(curve)]
            added[begin:begin + len(values)] = values
        if sign:
            if added.any():
                raise ValueError("signed distances are zero on curves; leave distances out")
            return self.surface.signed_distance([self._elements.curve(c) for c in curves])
        return np.min([x + self.surface.distance([p for p, y in zip(points, added) if y == x])
                       for x in np.unique(added)], axis=0)


class MeshSignedHeatSolver(_WithElements, HeatDistance):
    """Signed distances from curves by heat."""

    def __init__(self, V, F, t_coef=1.0):
        super().__init__(V, F)
        self.t_coef = t_coef

    def compute_distance(self, curves, curve_signs=(), points=(), preserve_source_normals=False,
                         level_set_constraint="ZeroSet", soft_level_set_weight=-1):
        """Returns distances from curves, positive on their left, as this solver has them there and
        no other, and from points, unsigned. Each point of a curve is in one face with the next one;
        the distance there is zero (the constraint "ZeroSet")."""
        expect_zero_set(level_set_constraint, soft_level_set_weight, preserve_source_normals)
        if len(curve_signs) and not all(curve_signs):
            raise NotImplementedError("curve_signs has a curve without a sign; give its points as "
                                      "points, and curves with signs alone as curves")
        found = -self.surface.signed_distance([self._elements.curve(c) for c in curves],
                                              time_factor=self.t_coef)
        if len(points):
            near = self.compute_distance_multisource([self._elements.point(p) for p in points])
            found = np.where(near < np.abs(found), near, found)
        return found


# ---- Vectors -------------------------------------------------------------------------------------


class MeshVectorHeatSolver(VectorHeat):
    """Vectors by heat on a triangle mesh."""

    def __init__(self, V, F, t_coef=1.0, use_intrinsic_delaunay=True, useIntrinsicDelaunay=True):
        self.surface = intrinsic.Surface(V, F)
        self.t_coef = t_coef
        self._mesh = V, F

    def _normals(self, x, y):
        return _vertex_normals(*self._mesh)[1]

    def get_connection_laplacian(self):
        """Returns the Laplacian of tangent vectors, a complex sparse matrix of scipy."""
        return self.surface.connection_laplacian().tocsc()


class PolygonMeshHeatSolver(VectorHeat):
    """Distances and vectors by heat on a mesh of polygons."""

    def __init__(self, V, F, t_coef=1.0):
        self.surface = intrinsic.Surface(V, F)
        self.t_coef = t_coef

    def compute_distance(self, v_inds):
        """Returns the distances of all vertices from the nearest of several, of shape (n,)."""
        return self.compute_distance_multisource(np.atleast_1d(v_inds))

    def compute_signed_distance(self, curves, level_set_constraint="ZeroSet"):
        """Returns signed distances from curves through vertices, zero there."""
        expect_zero_set(level_set_constraint)
        return self.surface.signed_distance(curves, time_factor=self.t_coef)


# ---- Geodesics -----------------------------------------------------------------------------------


class EdgeFlipGeodesicSolver:
    """Geodesics by flips of edges. Flips end by proof, with curves that are geodesic, so that
    `max_iterations` and `max_relative_length_decrease` are ignored."""

    def __init__(self, V, F, t_coef=1.0):
        self.surface = intrinsic.Surface(V, F)

    def find_geodesic_path(self, v_start, v_end, max_iterations=None,
                           max_relative_length_decrease=None):
        """Returns the points of a geodesic between two vertices, of shape (k, 3)."""
        return self.find_geodesic_path_poly([v_start, v_end])

    def find_geodesic_path_poly(self, v_list, max_iterations=None,
                                max_relative_length_decrease=None):
        """Returns the points of a geodesic between the ends of a list of vertices, around which it
        goes as the shortest paths along edges between them do."""
        return self.surface.network([list(v_list)], method="flips")[0].points

    def find_geodesic_loop(self, v_list, max_iterations=None, max_relative_length_decrease=None):
        """Returns the points of a closed geodesic, the first one again at the end."""
        points = self.surface.network((), [list(v_list)], method="flips")[0].points
        return np.concatenate([points, points[:1]])


class GeodesicTracer:
    """Geodesics from points in directions. `max_iterations` is ignored: they end by their
    length."""

    def __init__(self, V, F, t_coef=1.0):
        self.surface = intrinsic.Surface(V, F)
        self._normals = _vertex_normals(V, F)

    def _trace(self, p, direction, normal):
        direction = _arrays.numbers(direction, "direction_xyz", (3,))
        length = np.linalg.norm(direction - (direction @ normal) * normal)
        return self.surface.trace(p, direction, length).points

    def trace_geodesic_from_vertex(self, start_vert, direction_xyz, max_iterations=None):
        """Returns the points of the geodesic from a vertex, of shape (k, 3). It is as long as its
        direction, projected along the normal there."""
        return self._trace(start_vert, direction_xyz, self._normals[1][start_vert])

    def trace_geodesic_from_face(self, start_face, bary_coords, direction_xyz,
                                 max_iterations=None):
        """Returns the points of the geodesic from a point in a face."""
        p = intrinsic.Point(start_face, tuple(bary_coords))
        return self._trace(p, direction_xyz, self._normals[0][start_face])
