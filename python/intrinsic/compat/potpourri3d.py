# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions and classes of the package potpourri3d.

All solvers run on intrinsic Delaunay triangulations that exact predicates have made, so that
options such as `use_robust` change nothing. Tangent frames are those of this package.
"""

import numpy as np

import intrinsic
from intrinsic import _arrays, _core
from intrinsic._points import is_point

# ---- Files ---------------------------------------------------------------------------------------


def _polygon(triangles):
    """Returns the corners of the polygon that triangles make up."""
    sides = {(int(t[k]), int(t[(k + 1) % 3])) for t in triangles for k in range(3)}
    after = {i: j for i, j in sides if (j, i) not in sides}
    corners = [int(triangles[0][0])]
    while after[corners[-1]] != corners[0]:
        corners.append(after[corners[-1]])
    return corners


def read_polygon_mesh(filename):
    """Returns the points of a mesh file, of shape (n, 3), and its faces as a list of lists."""
    surface = intrinsic.read(filename)
    triangles, polygons = _core.input_triangles(surface._core)
    parts = np.split(triangles, np.flatnonzero(np.diff(polygons)) + 1)
    return surface.points, [_polygon(part) for part in parts]


def read_mesh(filename):
    """Returns the points of a mesh file, of shape (n, 3), and its faces, of shape (m, k)."""
    points, faces = read_polygon_mesh(filename)
    sizes = {len(face) for face in faces}
    if len(sizes) != 1:
        raise ValueError(f"{filename} has faces with {sorted(sizes)} corners; "
                         "read_polygon_mesh() reads it")
    return points, np.array(faces)


def read_point_cloud(filename):
    """Returns the points of a file, of shape (n, 3)."""
    return intrinsic.read(filename, domain="points").points


def write_mesh(V, F, filename, UV_coords=None, UV_type=None):
    """Writes a mesh to a file .obj or .off."""
    points = _arrays.points(V, "V")
    faces = [list(map(int, face)) for face in F]
    with open(filename, "w", encoding="utf-8") as file:
        if str(filename).endswith(".off") and UV_coords is None:
            file.write(f"OFF\n{len(points)} {len(faces)} 0\n")
            file.writelines("%.17g %.17g %.17g\n" % tuple(p) for p in points)
            file.writelines(f"{len(f)} {' '.join(map(str, f))}\n" for f in faces)
        elif str(filename).endswith(".obj"):
            _write_obj(file, points, faces, UV_coords, UV_type)
        else:
            raise ValueError(f"{filename}: give a name that ends with .obj, or .off without UV")


def _write_obj(file, points, faces, uv, kind):
    file.writelines("v %.17g %.17g %.17g\n" % tuple(p) for p in points)
    if uv is None:
        file.writelines(f"f {' '.join(str(v + 1) for v in f)}\n" for f in faces)
        return
    uv = _arrays.numbers(uv, "UV_coords", (None, 2))
    file.writelines("vt %.17g %.17g\n" % tuple(x) for x in uv)
    sizes = {"per-vertex": len(points), "per-face": len(faces),
             "per-corner": sum(map(len, faces))}
    if sizes.get(kind) != len(uv):
        raise ValueError(f"UV_coords has {len(uv)} rows with UV_type {kind!r}; give {sizes}")
    corner = 0
    for i, f in enumerate(faces):
        numbers = {"per-vertex": f, "per-face": [i] * len(f),
                   "per-corner": range(corner, corner + len(f))}[kind]
        corner += len(f)
        file.write("f " + " ".join(f"{v + 1}/{n + 1}" for v, n in zip(f, numbers)) + "\n")


def write_point_cloud(V, filename):
    """Writes points to a file .obj or .off."""
    write_mesh(V, [], filename)


# ---- Meshes --------------------------------------------------------------------------------------


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
    """Returns the two vertices of each edge, of shape (e, 2), in ascending order."""
    _, faces = _triangles(V, F)
    sides = np.sort(np.concatenate([faces[:, [c, (c + 1) % 3]] for c in range(3)]), axis=1)
    return np.unique(sides, axis=0)


class MarchingTrianglesSolver:
    """Finds lines on which functions have a value."""

    def __init__(self, V, F):
        self.surface = intrinsic.Surface(V, F)

    def marching_triangles(self, u, isoval=0.0):
        """Returns the lines as lists of barycentric points `(face, [a, b, c])`."""
        lines = self.surface.isolines(u, [isoval])
        return [[(int(f), [float(x) for x in b]) for f, b in zip(line.faces, line.barycentric)]
                for line in lines]


def marching_triangles(V, F, u, isoval=0.0):
    """Returns the lines on which a function has a value; see `MarchingTrianglesSolver`."""
    return MarchingTrianglesSolver(V, F).marching_triangles(u, isoval)


# ---- Distances -----------------------------------------------------------------------------------


class _HeatDistance:
    """Distances by heat on `surface`, with the time `t_coef`."""

    def compute_distance(self, v_ind):
        """Returns the distances of all vertices from one, of shape (n,)."""
        return self.compute_distance_multisource([v_ind])

    def compute_distance_multisource(self, v_inds):
        """Returns the distances of all vertices from the nearest of several, of shape (n,)."""
        return self.surface.distance(v_inds, method="heat", time_factor=self.t_coef)


class MeshHeatMethodDistanceSolver(_HeatDistance):
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


def _vertex_curves(curves):
    """Returns curves as lists of vertices; points may be `(vertex, [])`."""
    result = []
    for curve in curves:
        rows = []
        for p in curve:
            if is_point(p):
                rows.append(p)
            elif len(p) == 1 or len(p[1]) == 0:
                rows.append(p[0])
            else:
                raise ValueError("points of curves are vertices, (vertex, []); points in faces and "
                                 "on edges are not supported")
        result.append(rows)
    return result


class MeshSignedHeatSolver(_HeatDistance):
    """Signed distances from curves by heat."""

    def __init__(self, V, F, t_coef=1.0):
        self.surface = intrinsic.Surface(V, F)
        self.t_coef = t_coef

    def compute_distance(self, curves, is_signed=(), points=(), preserve_source_normals=False,
                         level_set_constraint="ZeroSet", soft_level_set_weight=-1):
        """Returns distances from curves through vertices, signed, and from points, unsigned. The
        distance at curves is zero (the constraint "ZeroSet")."""
        if level_set_constraint != "ZeroSet" or soft_level_set_weight >= 0:
            raise ValueError('the one constraint there is is "ZeroSet"')
        if len(is_signed) and not all(is_signed):
            raise ValueError("all curves are signed; give the vertices of others as points")
        found = self.surface.signed_distance(_vertex_curves(curves), time_factor=self.t_coef)
        if len(points):
            near = self.compute_distance_multisource(points)
            found = np.where(near < np.abs(found), near, found)
        return found


# ---- Vectors -------------------------------------------------------------------------------------


class _VectorHeat(_HeatDistance):
    """Vectors by heat on `surface`."""

    def extend_scalar(self, v_inds, values):
        """Extends values at vertices to all, of shape (n,)."""
        return self.surface.extend(v_inds, values, time_factor=self.t_coef)

    def get_tangent_frames(self):
        """Returns the axes X, Y and the normals at all vertices, three arrays of shape (n, 3)."""
        x, y = self.surface.frames().vertices.transpose(1, 0, 2)
        normals = self._normals(x, y)
        x = _unit(x - (x * normals).sum(axis=1)[:, None] * normals)
        return x, np.cross(normals, x), normals

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


def _unit(x):
    lengths = np.linalg.norm(x, axis=1, keepdims=True)
    return np.divide(x, lengths, out=np.zeros_like(x), where=lengths > 0)


class MeshVectorHeatSolver(_VectorHeat):
    """Vectors by heat on a triangle mesh."""

    def __init__(self, V, F, t_coef=1.0, useIntrinsicDelaunay=True):
        self.surface = intrinsic.Surface(V, F)
        self.t_coef = t_coef
        self._faces = _doubled_normals(V, F)

    def _normals(self, x, y):
        normals, faces = self._faces
        sums = np.zeros_like(x)
        for c in range(3):
            np.add.at(sums, faces[:, c], normals)
        return _unit(sums)

    def get_connection_laplacian(self):
        """Returns the Laplacian of tangent vectors, a complex sparse matrix of scipy."""
        return self.surface.connection_laplacian()


class PolygonMeshHeatSolver(_VectorHeat):
    """Distances and vectors by heat on a mesh of polygons."""

    def __init__(self, V, polygons, t_coef=1.0):
        self.surface = intrinsic.Surface(V, polygons)
        self.t_coef = t_coef

    def _normals(self, x, y):
        return _unit(np.cross(x, y))

    def compute_distance(self, v_inds):
        """Returns the distances of all vertices from the nearest of several, of shape (n,)."""
        return self.compute_distance_multisource(np.atleast_1d(v_inds))

    def compute_signed_distance(self, curves, level_set_constraint="ZeroSet"):
        """Returns signed distances from curves through vertices, zero there."""
        if level_set_constraint != "ZeroSet":
            raise ValueError('the one constraint there is is "ZeroSet"')
        return self.surface.signed_distance(curves, time_factor=self.t_coef)


# ---- Geodesics -----------------------------------------------------------------------------------


class EdgeFlipGeodesicSolver:
    """Geodesics by flips of edges. Flips end by proof, so that `max_iterations` is ignored."""

    def __init__(self, V, F):
        self.surface = intrinsic.Surface(V, F)

    @staticmethod
    def _expect_whole(max_relative_length_decrease):
        if max_relative_length_decrease is not None:
            raise ValueError("curves are shortened until they are geodesic; leave "
                             "max_relative_length_decrease out")

    def find_geodesic_path(self, v_start, v_end, max_iterations=None,
                           max_relative_length_decrease=None):
        """Returns the points of a geodesic between two vertices, of shape (k, 3)."""
        return self.find_geodesic_path_poly([v_start, v_end], max_iterations,
                                            max_relative_length_decrease)

    def find_geodesic_path_poly(self, v_list, max_iterations=None,
                                max_relative_length_decrease=None):
        """Returns the points of a geodesic between the ends of a list of vertices, around which it
        goes as the shortest paths along edges between them do."""
        self._expect_whole(max_relative_length_decrease)
        return self.surface.network([list(v_list)], method="flips")[0].points

    def find_geodesic_loop(self, v_list, max_iterations=None, max_relative_length_decrease=None):
        """Returns the points of a closed geodesic, the first one again at the end."""
        self._expect_whole(max_relative_length_decrease)
        points = self.surface.network((), [list(v_list)], method="flips")[0].points
        return np.concatenate([points, points[:1]])


class GeodesicTracer:
    """Geodesics from points in directions. `max_iterations` is ignored: they end by their
    length."""

    def __init__(self, V, F):
        self.surface = intrinsic.Surface(V, F)

    def _trace(self, p, direction):
        direction = _arrays.numbers(direction, "direction_xyz", (3,))
        return self.surface.trace(p, direction, np.linalg.norm(direction)).points

    def trace_geodesic_from_vertex(self, start_vert, direction_xyz, max_iterations=None):
        """Returns the points of the geodesic from a vertex, as long as its direction: (k, 3)."""
        return self._trace(start_vert, direction_xyz)

    def trace_geodesic_from_face(self, start_face, bary_coords, direction_xyz,
                                 max_iterations=None):
        """Returns the points of the geodesic from a point in a face."""
        return self._trace(intrinsic.Point(start_face, tuple(bary_coords)), direction_xyz)


# ---- Clouds of points ----------------------------------------------------------------------------


class PointCloudHeatSolver(_VectorHeat):
    """Distances and vectors by heat on a cloud of points."""

    def __init__(self, P, t_coef=1.0):
        self.surface = intrinsic.points(P)
        self.t_coef = t_coef

    def _normals(self, x, y):
        return _unit(np.cross(x, y))

    def compute_log_map(self, p_ind):
        """Returns the logarithmic map of a point, of shape (n, 2), in its axes X and Y."""
        return super().compute_log_map(p_ind)
