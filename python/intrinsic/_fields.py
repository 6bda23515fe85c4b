# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vectors on surfaces: logarithmic maps, transport, direction fields, signed distances."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from . import _arrays, _core, _options
from ._curve import Curve, Network
from ._pages import _Shown
from ._points import Point, is_point
from ._singularities import Singularities

if TYPE_CHECKING:
    from typing import Any, Literal
    from numpy.typing import ArrayLike, NDArray
    from ._types import Numbers, Place, Places, Progress, SignedCurves, Solver


class VectorField(_Shown):
    """A tangent vector at each vertex of a surface.

    `coordinates`, of shape (n, 2), are in the polar coordinates of the vertex: the real axis runs
    along the first edge there, and angles from it are scaled so that a full turn around the vertex
    is 2 pi, half a turn on the border. The other half of the circle has the vectors that point out
    of the surface. NaN where the vector is unknown. On a soup, where a vertex may have several
    tangent planes, they are in the first one in which the vector is known.
    """

    def __init__(self, core, field, neighbors):
        self._core, self._field, self._neighbors = core, field, neighbors

    @cached_property
    def coordinates(self) -> Numbers:
        """The vectors in the polar coordinates of each vertex, of shape (n, 2)."""
        return self._field.coordinates

    @property
    def _surface(self):
        from ._surface import Surface

        return Surface._of(self._core)

    def _add_to_page(self, contents):
        vectors = self.vectors
        contents.add_vectors(vectors if vectors.ndim == 3 else vectors[None])

    def __len__(self) -> int:
        return len(self.coordinates)

    def __repr__(self):
        return f"<intrinsic.{type(self).__name__}: {len(self)} vertices>"

    @property
    def lengths(self) -> Numbers:
        """The lengths of the vectors, of shape (n,)."""
        return np.hypot(self.coordinates[:, 0], self.coordinates[:, 1])

    @property
    def vectors(self) -> Numbers:
        """The vectors in space, of shape (n, 3), each in a face at its vertex. A vector in a face
        without area goes straight on to the plane of the nearest face that has one."""
        return _core.vectors_in_space(self._core, self._field, 0.0, self._neighbors)

    @property
    def axes(self) -> Numbers:
        """The unit vectors in space along the real axes, of shape (n, 3)."""
        return _core.field_axes_in_space(self._core, self._field, self._neighbors)


class Frames(_Shown):
    """The axes in which vectors have two coordinates: those of `Surface.transport()`, `log_map()`
    and others. Arrays are computed when they are asked for.
    """

    def __init__(self, surface, flip):
        self._surface, self._core = surface, surface._flipped(flip)
        self._neighbors = surface._cloud_neighbors()

    def __repr__(self):
        return f"<intrinsic.Frames: {self._core.number_of_vertices} vertices>"

    def _add_to_page(self, contents):
        contents.add_vectors(self.vertices.transpose(1, 0, 2))

    @property
    def vertices(self) -> Numbers:
        """Unit vectors in space with the angles 0 and 90 degrees in the polar coordinates of each
        vertex, see `VectorField`, of shape (n, 2, 3), each in a face there, or, if that has no
        area, in the plane of the nearest face that has one. They are orthogonal where the surface
        is flat.
        """
        return np.stack([_core.axes_in_space(self._core, angle, self._neighbors)
                         for angle in (0.0, np.pi / 2)], axis=1)

    @property
    def faces(self) -> Numbers:
        """Unit vectors in space along both axes of each face of the user's mesh, of shape
        (m, 2, 3): along its first side, and to the left of it. They are the axes of a `Point`.
        NaN for polygons with more corners, which have none.
        """
        V = _core.input_points(self._core)
        if not len(V):
            raise ValueError("this surface has lengths alone, so that it is not in space")
        triangles, polygons = _core.input_triangles(self._core)
        first, second = (V[triangles[:, k]] - V[triangles[:, 0]] for k in (1, 2))
        first /= np.linalg.norm(first, axis=1)[:, None]
        second -= np.sum(first * second, axis=1)[:, None] * first
        second /= np.linalg.norm(second, axis=1)[:, None]
        axes = np.full((self._surface.number_of_input_faces, 2, 3), np.nan)
        is_triangle = np.bincount(polygons, minlength=len(axes))[polygons] == 1
        axes[polygons[is_triangle]] = np.stack([first, second], axis=1)[is_triangle]
        return axes

    @property
    def angles(self) -> Numbers | Any:
        """The angles in radians of the sides of triangles in the polar coordinates of the vertices
        where they start, of shape (k, 3): of the sides of `Surface.faces` of `delaunay()`, or with
        `flip=False` of the surface. A vector
        z at a vertex i is parallel to z * exp(1j * (b + pi - a)) at the other end of a side, where
        a is the angle of the side at i, and b that of the side it is glued to. None for a cloud of
        points, whose tangent planes are not those of triangles.
        """
        return None if self._surface._is_cloud() else _core.side_angles(self._core)

    def to_space(self, z: ArrayLike) -> Numbers:
        """Takes a vector at each vertex, complex of shape (n,) or real of shape (n, 2), to space:
        of shape (n, 3), each in a face at its vertex, and as long as it was. NaN stays."""
        z = _arrays.array(z, "z", np.complex128)
        if z.ndim == 1 and z.dtype.kind in "ciuf":
            z = np.column_stack([z.real, z.imag])
        _arrays.expect_shape(z, "z", (self._surface.number_of_vertices, 2))
        if z.dtype.kind not in "iuf":
            raise ValueError(f"z has no numbers but {z.dtype}; give complex numbers, or pairs of "
                             "real ones")
        field = _core.field_of_coordinates(self._core, z)
        return _core.vectors_in_space(self._core, field, 0.0, self._neighbors)


class DirectionField(VectorField):
    """Equivalent directions at each vertex, `degree` of them at equal angles: vectors, lines,
    crosses. `coordinates` are those of one of them, of length 1.

    `index_sum` is the sum of the indices of all `singularities`: `degree` times the Euler
    characteristic, and `border_turns`. `face_index` of shape (m,) has the index of each face of
    the triangulation. A cloud of points has no faces, and so no singularities.
    """

    degree: int
    singularities: Singularities
    face_index: NDArray[np.int32]
    index_sum: int
    border_turns: int

    def __init__(self, core, degree, found, neighbors):
        field, self.face_index, faces, weights, points, index, self.index_sum, \
            self.border_turns = found
        super().__init__(core, field, neighbors)
        self.degree = degree
        self.singularities = Singularities(faces, weights, points, index)

    def _add_to_page(self, contents):
        super()._add_to_page(contents)
        if len(self.singularities):
            self.singularities._add_to_page(contents)

    @property
    def vectors(self):
        """All directions as vectors in space, of shape (degree, n, 3)."""
        return np.stack([
            _core.vectors_in_space(self._core, self._field, 2 * np.pi * k / self.degree,
                                   self._neighbors) for k in range(self.degree)])


def _degree(x):
    return _options.number(x, "degree")


def _pair(fixed):
    """Returns points and vectors."""
    wanted = "a pair of points and vectors"
    pair = _arrays.sequence(fixed, "fixed", wanted)
    if len(pair) != 2 or isinstance(fixed, Point):
        raise ValueError(f"fixed is {_arrays.shortened(fixed)}; give {wanted}")
    return pair


def _curves(curves, places, count):
    """Returns what `_core` has of a `Curve`, arrays of places, or an array of vertices, for each
    curve; `places` makes arrays of points."""
    wanted = "a Curve, or lists of points"
    if isinstance(curves, (Curve, Network)):
        curves = [curves]
    if isinstance(curves, Point):
        raise ValueError(f"curves is one point; give {wanted}")
    curves = _arrays.sequence(curves, "curves", wanted)
    if curves and all(is_point(c) and not isinstance(c, Curve) for c in curves):
        curves = [curves]
    result = []
    for i, c in enumerate(curves):
        if isinstance(c, (Curve, Network)):
            result += [curve._way for curve in (c if isinstance(c, Network) else [c])]
            continue
        if is_point(c):
            raise ValueError(f"curves[{i}] is one point; give {wanted}")
        if isinstance(c, (list, tuple)) and any(isinstance(p, Point) for p in c):
            result.append(places(c, f"curves[{i}]"))
        else:
            result.append(_arrays.indices(c, f"curves[{i}]", (None,), count=count))
    counts = [len(r) if isinstance(r, np.ndarray) else len(r[0]) if isinstance(r, tuple) else 2
              for r in result]
    if max(counts, default=0) < 2:
        raise ValueError("curves has no curve; give a Curve, or lists of two or more points each")
    return result


class _Fields:
    def _cloud_neighbors(self):
        """Returns how many neighbors of each point are triangulated, if it is a cloud of points."""
        return self.report["domain"].get("neighbors", 30) if self._is_cloud() else 30

    def frames(self, *, flip: bool = True) -> Frames:
        """Returns the axes in which vectors have coordinates, as `Frames`: of vertices, of faces of
        the user's mesh, and the angles of sides of the Delaunay triangulation. Fields that were
        made with `flip=False` have those of `frames(flip=False)`."""
        return Frames(self, flip)

    def log_map(self, p: Place, *, method: Literal["exact", "affine", "polar"] | None = None,
                time_factor: float = 1.0, max_distance: float = np.inf, flip: bool = True,
                progress: Progress = None) -> Numbers:
        """Returns the logarithmic map of a point: for each vertex the vector at `p` along the
        shortest path to it, as long as the path; of shape (n, 2), in the units of the mesh.

        Vectors at a vertex are in its polar coordinates, see `VectorField`; those at a `Point` are
        along the first side of its face, and to the left of it; at a corner of the face, angles
        from the middle of the corner are those on the surface. NaN where no path leads, or, of
        exact maps, beyond `max_distance`. `method` is "exact" (by default), "affine" or "polar" (by
        heat: fast for many points; `time_factor` is its time in squares of the mean edge). Clouds
        of points have the method "affine".
        """
        if method is not None:
            _arrays.expect_word(method, "method", ("exact", "affine", "polar"))
        return _core.log_map(self._flipped(flip), self._place(p, "p"), method,
                             _options.number(time_factor, "time_factor"),
                             _options.number(max_distance, "max_distance"),
                             self._cloud_neighbors(), progress)

    def transport(self, points: Places, vectors: ArrayLike, *, time_factor: float = 1.0,
                  flip: bool = True, progress: Progress = None) -> VectorField:
        """Transports vectors from points to all vertices, each from the nearest point: the vector
        heat method. Returns a `VectorField`.

        `vectors`, of shape (k, 2), are in the polar coordinates of vertices, see `VectorField`, or,
        at a `Point`, along the first side of its face and to the left of it; or of shape (k, 3) in
        space, and are projected to a face. (At the border the planes of the first and the last face
        go on beyond it, so that vectors may point out of the surface.) One point
        takes one vector. `time_factor` is the time of the heat flow in squares of the mean edge:
        more is smoother.
        """
        vectors = _arrays.numbers(vectors, "vectors")
        if is_point(points) and vectors.ndim == 1:
            vectors = vectors[None, :]
        if vectors.ndim != 2:
            _arrays.expect_shape(vectors, "vectors", (None, 2))
        core = self._flipped(flip)
        field = _core.transport(core, self._places(points, "points"), vectors,
                                _options.number(time_factor, "time_factor"),
                                self._cloud_neighbors(), progress)
        return VectorField(core, field, self._cloud_neighbors())

    def extend(self, points: Places, values: ArrayLike, *, time_factor: float = 1.0,
               flip: bool = True, progress: Progress = None) -> Numbers:
        """Extends values at points, of shape (k,), to all vertices, of shape (n,): near the value
        of the nearest point, smoothly, never beyond the extremes. NaN where no path leads to a
        point. `time_factor` is the time of the heat flow in squares of the mean edge."""
        values = np.atleast_1d(_arrays.numbers(values, "values"))
        return _core.extend(self._flipped(flip), self._places(points, "points"), values,
                            _options.number(time_factor, "time_factor"), self._cloud_neighbors(),
                            progress)

    def direction_field(self, degree: int = 4, *, align: float | None = None,
                        fixed: tuple[Places, ArrayLike] | None = None, solver: Solver = "auto",
                        flip: bool = True, progress: Progress = None) -> DirectionField:
        """Returns the smoothest field of directions: `degree` 1 for vectors, 2 for lines, 4 for
        crosses; a `DirectionField`.

        With `align`, a number that is not negative, it follows the directions of curvature, for
        even degrees: 0 gives the smoothest of such fields, more is closer to them. `fixed` is a
        pair of vertices and directions there, as for `transport()`. `solver` is "direct"; or
        "iterative", in less memory, up to a residual of 1e-10; "auto" takes that beyond five
        million vertices.
        """
        _options.expect(solver=solver)
        core = self._flipped(flip)
        points, vectors = _pair(fixed) if fixed is not None else ([], np.zeros((0, 2)))
        vectors = _arrays.numbers(vectors, "fixed[1]")
        if vectors.ndim == 1 and vectors.size:
            vectors = vectors[None, :]
        if align is not None:
            align = _options.number(align, "align")
        degree = _degree(degree)
        found = _core.direction_field(core, degree, align, self._places(points, "fixed[0]"),
                                      vectors, self._cloud_neighbors(), solver, progress)
        return DirectionField(core, degree, found, self._cloud_neighbors())

    def signed_distance(self, curves: SignedCurves, *, time_factor: float = 1.0,
                        flip: bool = True, progress: Progress = None) -> Numbers:
        """Returns signed distances from curves, of shape (n,): negative on their left, positive on
        their right, by heat.

        `curves` is a list of points, or a `Curve` of `path()`, `isolines()` and others, a
        `Network`, or a list of such curves. From each vertex in a list to the next one, a curve
        follows the shortest way along edges; if there are `Point`s in it, each point is in one face
        with the next one, and the curve is straight there. A loop ends at its first point.
        `time_factor` is the time of the heat flow in squares of half the mean edge: more is
        smoother, and bridges wider gaps. Infinite where no path leads to a curve. The surface must
        be oriented: covers are refused.
        """
        rows = _curves(curves, self._places, self._core.number_of_vertices)
        return _core.signed_distance(self._flipped(flip), rows,
                                     _options.number(time_factor, "time_factor"),
                                     progress)

    def connection_laplacian(self, degree: int = 1, *, flip: bool = True) -> Any:
        """Returns the Laplacian of tangent vectors, a complex, Hermitian csr_matrix of shape
        (n, n): in the polar coordinates of vertices, see `VectorField`, for the powers of vectors
        that stand for `degree` directions. On a cover it has a row for each copy of a vertex."""
        return _arrays.sparse(_core.connection_laplacian(self._flipped(flip), _degree(degree)))
