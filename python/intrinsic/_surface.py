# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The class `Surface`."""

from __future__ import annotations

import os
import threading
from typing import TYPE_CHECKING

from . import _arguments, _arrays, _core, _options, _pickles  # noqa: F401: pickles are registered
from ._curves import _Curves
from ._distances import _Distances
from ._embedding import _Embedding
from ._fields import _Fields
from ._files import save_surface
from ._isometries import _Isometries
from ._maps import _Maps
from ._operators import _Learning
from ._pages import _Pages
from ._simplify import _Simplification
from ._transfers import _Transfers

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any, Literal
    from numpy.typing import ArrayLike
    from ._types import (Arithmetic, Domain, Integers, Matrix, Mollification, Numbers, Path,
                         Polygons, Progress)


# Names that other libraries have for what a surface has.
_OTHER_NAMES = {"V": "points", "vertices": "points", "F": "faces", "triangles": "faces",
                "edges": "faces, lengths and glue", "n_vertices": "number_of_vertices",
                "n_faces": "number_of_faces", "area": "mass().sum()", "geodesic": "path",
                "shortest_path": "path", "heat_distance": "distance", "flip": "delaunay",
                "eigenfunctions": "eigen", "write": "save", "plot": "show"}


class Surface(_Distances, _Curves, _Fields, _Maps, _Transfers, _Learning, _Simplification,
              _Isometries, _Embedding, _Pages):
    """A surface, and an intrinsic triangulation of it: at first the faces themselves.

    A surface never changes. `delaunay()`, `refine()` and `adapt()` return new ones; what is
    computed by matrices flips edges behind the scenes, once. Vertices keep their numbers, and
    those that are inserted follow them; all results are in the units of the vertices.

    Parameters:
        points: vertices, of shape (n, 3), or (n, 2) in the plane; of any type of numbers. With
            `lengths` it may be None, or the number of vertices.
        faces: their vertices, of shape (m, k), or a list of faces of different sizes.
        lengths: for an abstract surface, the lengths of the sides of triangles, of shape (m, 3):
            from each corner to the next. They need not fit into space. Around an edge with more
            than two faces, these are in the order of their numbers.
        glue: with `lengths`, which sides are glued, of shape (m, 3, 2): the other face and its
            side, or -1. By default, sides with the same ends are.
        domain: what is made of faces: "manifold", or a cover if that cannot be:
            "orientation-cover", "tufted"; "closed" is the first of them without border.
        arithmetic: "exact", or "double", which is not faster by much.
        correspondence: "integer", which says where edges run on the mesh.
        mollification: of faces without area: "automatic", "none", "lengths" or "squared".
        polygons: what is made of polygons that are not planar: "fan" or "planar".

    Raises:
        ValueError: names the element and the remedy.

    >>> s = Surface([[0, 0, 0], [2, 0, 0], [1, .2, 0], [1, -.2, 0]], [[0, 1, 2], [1, 0, 3]])
    >>> s.delaunay().faces.tolist()
    [[2, 3, 1], [3, 2, 0]]
    >>> round(s.mass().sum(), 12)
    0.4
    """

    def __init__(self, points: ArrayLike | None, faces: ArrayLike | Sequence[ArrayLike], *,
                 lengths: ArrayLike | None = None, glue: ArrayLike | None = None,
                 domain: Domain = "auto", arithmetic: Arithmetic = "exact",
                 correspondence: Literal["integer"] = "integer",
                 mollification: Mollification = "automatic", polygons: Polygons = "fan") -> None:
        _options.expect_correspondence(correspondence)
        if isinstance(domain, str) and domain == "points":
            raise ValueError('domain="points" ignores faces; give the points to '
                             "intrinsic.points(points)")
        _options.expect(domain=domain, arithmetic=arithmetic, mollification=mollification,
                        polygons=polygons)
        exact = arithmetic == "exact"
        if lengths is None:
            if glue is not None:
                raise ValueError("glue needs lengths; give them, or leave glue out")
            points = _arrays.points(points, "points")
            corners, begins = _arrays.polygons(faces, "faces", len(points))
            if len(begins) == 1:
                raise ValueError("faces has no faces; give some, or make a surface of points alone "
                                 "with intrinsic.points(points)")
            self._set(_core.build(points, corners, begins, domain, exact, mollification, polygons))
            return
        if polygons != "fan":
            raise ValueError("polygons is of faces between points; with lengths, faces are "
                             "triangles: leave it out")
        arrays = _options.abstract_arrays(points, faces, lengths, glue)
        self._set(_core.build_abstract(*arrays, domain, exact, mollification))

    def _set(self, core):
        self._core = core  # for functions of _core on the triangulation as it is
        self._delaunay = None
        self._lock = threading.RLock()  # a handler of a signal may come here while it is held

    if not TYPE_CHECKING:  # for which unknown names are errors
        def __getattr__(self, name):
            if name in dir(type(self)):  # a property of a subclass has raised: raise its error
                return object.__getattribute__(self, name)
            if name.startswith("_"):  # which copy and notebooks look for
                raise AttributeError(name)
            names = [n for n in (*dir(type(self)), *vars(self)) if not n.startswith("_")]
            found = _OTHER_NAMES.get(name) or _arguments.nearest(name, names)
            raise AttributeError(f"a {type(self).__name__} has no {name}" +
                                 (f"; did you mean {found}?" if found else ""))

    @classmethod
    def _of(cls, core):
        surface = cls.__new__(cls)
        surface._set(core)
        return surface

    def _flipped(self, flip=True, progress=None):
        """Returns the object of _core that is Delaunay: this one, or one that it keeps; without
        `flip` this one as it is."""
        if not _arrays.flag(flip, "flip") or self._core.is_flipped:
            return self._core
        self._core.expect_free()  # else another thread may hold the lock, and wait for this one
        with self._lock:
            if self._delaunay is None:
                self._delaunay = _core.delaunay(self._core, None, None, progress)
            return self._delaunay

    # ---- Better triangulations ------------------------------------------------------------------

    def delaunay(self, *, keep: ArrayLike | None = None, progress: Progress = None) -> Surface:
        """Returns the surface with edges flipped until all are Delaunay.

        Parameters:
            keep: edges that are not flipped: pairs of vertices, of shape (k, 2); or a number:
                edges at which faces are folded by more degrees.
            progress: called at the first step, and then about ten times in a second, with what is
                being done, how far that is, and how far it will be or None, such as
                ("flipping to Delaunay", 1234, None). What it raises ends the work, as Ctrl-C does.
        """
        return Surface._of(_core.delaunay(self._core, *self._kept(keep), progress))

    def refine(self, *, min_angle: float = 25, max_edge_length: ArrayLike | None = None,
               max_circumradius: float | None = None, max_insertions: int | None = None,
               order: Literal["first", "largest", "worst"] = "first",
               conforming: bool = False, keep: ArrayLike | None = None,
               odt_length: float | None = None, progress: Progress = None) -> Surface:
        """Returns the Delaunay triangulation with vertices inserted until faces meet criteria.

        Parameters:
            min_angle: least angle of faces in degrees, from 0 to 59; up to 30 refinement always
                ends. Faces that cannot have it are in `statistics["refine"]`.
            max_edge_length: largest length of edges, in units of the vertices: a number, or one
                for each vertex of the input, of shape (n,).
            max_circumradius: of faces, in units of the vertices.
            max_insertions: cap on their number.
            order: which face comes next: "first" come, "largest" or "worst".
            conforming: whether kept edges that are not Delaunay are split.
            keep, progress: see `delaunay()`.
            odt_length: then moves the inserted vertices to an optimal Delaunay triangulation with
                edges up to this length; best with arithmetic="double".
        """
        _arrays.expect_word(order, "order", ("first", "largest", "worst"))
        sizes, longest = None, max_edge_length
        if longest is not None and not _arrays.is_single(longest):
            sizes, longest = _arrays.numbers(longest, "max_edge_length",
                                             (self.number_of_input_vertices,)), None
            if len(sizes) and not sizes.min() > 0:
                raise ValueError(f"max_edge_length[{sizes.argmin()}] is {sizes.min()}; give "
                                 "positive lengths")
        if longest is not None:
            longest = _options.number(longest, "max_edge_length")
        if max_circumradius is not None:
            max_circumradius = _options.number(max_circumradius, "max_circumradius")
        if max_insertions is not None:
            max_insertions = _options.number(max_insertions, "max_insertions")
        odt = 0. if odt_length is None else _options.number(odt_length, "odt_length")
        return Surface._of(_core.refine(self._core, _options.number(min_angle, "min_angle"), sizes,
                                        longest, max_circumradius, max_insertions, order,
                                        _arrays.flag(conforming, "conforming"),
                                        *self._kept(keep), odt, progress))

    def adapt(self, source: int = 0, *, heat_time: float = 0, tolerance: float = 0.01,
              max_vertices: int = 100000, min_angle: float = 25, keep: ArrayLike | None = None,
              progress: Progress = None) -> Surface:
        """Returns the surface refined where a function with a pole at a vertex needs it.

        Parameters:
            source: the vertex. The function is its harmonic Green's function, for which the
                surface must be connected.
            heat_time: if it is positive, the function is the heat kernel at that time, in squares
                of the mean edge: from 1e-100 to where heat has spread evenly.
            tolerance: the estimated error in the L2 norm at which refinement ends, in units of the
                root of the area, or of the norm of the kernel.
            max_vertices: cap on the number of vertices.
            min_angle, keep, progress: see `refine()`.
        """
        source = int(_arrays.indices(source, "source", (), count=self.number_of_input_vertices))
        return Surface._of(_core.adapt(
            self._core, source, _options.number(heat_time, "heat_time"),
            _options.number(tolerance, "tolerance"),
            _options.number(max_vertices, "max_vertices"), _options.number(min_angle, "min_angle"),
            *self._kept(keep), progress))

    def _kept(self, keep):
        return _options.kept(keep, self.number_of_input_vertices)

    # ---- The triangulation ----------------------------------------------------------------------

    @property
    def number_of_vertices(self) -> int:
        """How many vertices there are, those that were inserted included."""
        return self._core.number_of_vertices

    @property
    def number_of_faces(self) -> int:
        """How many triangles there are; on a cover, those of all sheets."""
        return self._core.number_of_faces

    @property
    def number_of_input_vertices(self) -> int:
        """How many vertices the user's mesh has."""
        return self._core.number_of_input_vertices

    @property
    def number_of_input_faces(self) -> int:
        """How many faces the user's mesh has."""
        return self._core.number_of_input_faces

    @property
    def faces(self) -> Integers:
        """The vertices of the triangles, of shape (m, 3) and type int64."""
        return _core.faces(self._core)

    @property
    def lengths(self) -> Numbers:
        """The lengths of the sides of triangles, of shape (m, 3): from each corner to the next."""
        return _core.lengths(self._core)

    @property
    def glue(self) -> Integers:
        """The triangle and the side that each side is glued to, of shape (m, 3, 2); -1: none."""
        return _core.glue(self._core)

    @property
    def points(self) -> Numbers | Any:
        """The places of all vertices in space, of shape (n, 3); None if there are only lengths."""
        return None if self._core.points is None else _core.positions(self._core)

    @property
    def report(self) -> dict[str, Any]:
        """What the input is and what was done to it, a dict as in statistics."""
        return _core.report(self._core)

    @property
    def statistics(self) -> dict[str, Any]:
        """What was found and done, a dict with the keys of `intrinsic --stats`.

        Matrices make stored values more accurate: if you ask after them, last digits may differ.
        """
        return _core.statistics(self._core)

    @property
    def certificate(self) -> Literal["exact", "interval", "none"]:
        """How sure it is that the triangulation is Delaunay: "exact", all edges that are not kept
        are proven to be; "interval", the same but for probable ties; or "none"."""
        return self.statistics["certificate"]

    # ---- Matrices -------------------------------------------------------------------------------

    def laplacian(self, *, flip: bool = True) -> Matrix:
        """Returns the cotangent Laplacian, a scipy.sparse.csr_matrix of shape (n, n).

        It is positive semidefinite: minus that of libigl. It has a row for each vertex, zero if no
        face has the vertex. Before `delaunay()` it is that of the Delaunay triangulation all the
        same, which has no negative weights inside. With `flip=False`, here and in other methods, it
        is that of the triangulation as it is: of the faces of the mesh.
        """
        return _arrays.sparse(_core.laplacian(self._flipped(flip)), symmetric=True)

    def mass(self, kind: Literal["lumped", "galerkin", "voronoi"] = "lumped", *,
             flip: bool = True) -> Matrix:
        """Returns the mass matrix, a scipy.sparse.csr_matrix of shape (n, n).

        `kind` is "lumped": diagonal, a third of the area of the faces at each vertex, or on a cloud
        of points the same as "voronoi", since nothing chooses the diagonals of its squares;
        "galerkin": the integrals of products of hat functions, which depend on such diagonals; or
        "voronoi": diagonal, the signed area of the cell between the vertex, the midpoints of its
        edges and the circumcenters of its faces, which is negative where these lie beyond their
        faces. The sum of the entries is the area.

        The triangulation is that of `laplacian()`: before `delaunay()` it is not that of the mesh,
        and neither are the entries, one by one. On meshes with slivers they differ a hundred times.
        Integrals of functions that are linear on the faces of the mesh, such as what `to_input()`
        returns, need `flip=False`.
        """
        _arrays.expect_word(kind, "kind", ("lumped", "galerkin", "voronoi"))
        return _arrays.sparse(_core.mass(self._flipped(flip), kind), symmetric=True)

    # ---- Keeping --------------------------------------------------------------------------------

    def save(self, path: Path, *, plain: bool = False) -> None:
        """Writes the triangulation to a file `.idt` without loss; `intrinsic.load()` reads it. To
        .ply, .obj, .off, .stl and .vtp writes the common subdivision; with `plain`, .ply without
        labels and edges and .off of triangles without colours, for readers that take nothing
        else."""
        path, plain = os.fsdecode(_arrays.file_name(path)), _arrays.flag(plain, "plain")
        if path.lower().endswith((".ply", ".obj", ".off", ".stl", ".vtp")):
            save_surface(path, self, (), plain)
        elif path.lower().endswith(".idt"):
            if plain:
                raise ValueError("plain is of meshes; an intrinsic triangulation has no labels and "
                                 "colours to be left out: leave plain out")
            _core.save(self._core, path)
        else:
            raise ValueError(f"{path}: the extension must be .idt, .ply, .obj, .off, .stl or .vtp")

    def __reduce__(self):
        return Surface._of, (self._core,)

    def __copy__(self):
        return Surface._of(_core.copy(self._core))

    def __deepcopy__(self, memo):
        return self.__copy__()

    def copy(self) -> Surface:
        """Returns a surface with its own lock and cache, for another thread."""
        return self.__copy__()

    def __repr__(self):
        if self._is_cloud():
            return f"<intrinsic.Surface: a cloud of {self.number_of_vertices} points>"
        of = " of a double cover" if _core.sheets(self._core) > 1 else ""
        return f"<intrinsic.Surface: {self.number_of_vertices} vertices, " \
               f"{self.number_of_faces} faces{of}>"


_arguments.suggest(Surface)
