# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces and results as pages for browsers and notebooks. The library writes all pages; here
results become what it takes."""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING

import numpy as np

from . import _arrays, _core
from ._points import Point

if TYPE_CHECKING:
    from typing import Any
    from ._surface import Surface
    from ._types import Path, Places


class _PageContents:
    """What a page shows on a surface: fields, places in the plane, curves, vectors, points."""

    def __init__(self, surface):
        self.surface = surface
        self.fields = []  # name, place, numbers, whether they name classes
        self.texture, self.is_disk, self.is_logarithm = None, False, False
        self.curves, self.marks = [], []  # points, whether closed, label
        self.marks_name = "points"
        self.places, self.vectors, self.degree = np.zeros((0, 3)), np.zeros((0, 3)), 1

    def add_curve(self, curve, label=None):
        """Adds a curve, in a colour of its own, or dark if the label is -1."""
        if curve.points is not None:
            label = len(self.curves) if label is None else label
            self.curves.append((curve.points, curve.is_closed, label))

    def add_marks(self, points, labels=None, name="points"):
        """Adds points in space with labels."""
        labels = np.zeros(len(points), dtype=int) if labels is None else labels
        self.marks += [(np.asarray(p)[None, :], False, int(i)) for p, i in zip(points, labels)]
        self.marks_name = name

    def add_vectors(self, vectors):
        """Adds vectors in space, of shape (degree, n, 3), at the first n vertices."""
        self.degree, n, _ = vectors.shape
        places = self.surface.points[:n]
        self.places = np.repeat(places, self.degree, axis=0)
        self.vectors = vectors.transpose(1, 0, 2).reshape(-1, 3)

    def add_field(self, name, values, place="vertices"):
        """Adds numbers at vertices, or on "faces" or "input_faces"; whole numbers and truth values
        name classes."""
        values = np.asarray(values)
        if values.dtype.kind not in "biuf":
            raise ValueError(f"{name} has no numbers but {values.dtype}; give an array of numbers")
        name = re.sub(r"[^A-Za-z0-9_.-]", "_", name)  # which the page shows as spaces
        taken = [f[0] for f in self.fields]
        if name in taken:
            name = next(n for n in (f"{name}_{k}" for k in range(len(taken) + 1)) if n not in taken)
        self.fields.append((name, place, values.astype(float), values.dtype.kind in "biu"))

    def is_plain(self):
        """Tells whether nothing was added."""
        return not (self.fields or self.curves or self.marks or len(self.vectors)) \
            and self.texture is None

    def write(self, megabytes):
        """Returns the page."""
        core = self.surface._core
        if core.points is None:
            raise ValueError("the surface has lengths and no points, so that nothing can be drawn")
        of_faces = any(place == "faces" for _, place, _, _ in self.fields)
        if (self.fields or self.texture is not None) and not of_faces:
            core = self.surface._flipped()  # on whose faces others are linear
        title, text = _core.description(core)
        numbers = [f for f in self.fields if f[1] == "vertices" and not f[3]]
        return _core.page(core, {
            "title": title, "text": text, "fields": self.fields, "texture": self.texture,
            "is_disk": self.is_disk, "is_logarithm": self.is_logarithm, "curves": self.curves,
            "marks": self.marks, "marks_name": self.marks_name,
            "vectors": (self.places, self.vectors),
            "are_arrows": self.degree == 1, "has_edges": self.is_plain(),
            "isolines": 20 if numbers else 0}, megabytes)


def _add_array(contents, a, name):
    """Adds an array by its shape; see `Surface.show()`."""
    n = contents.surface.number_of_vertices, contents.surface.number_of_input_vertices
    m = contents.surface.number_of_input_faces, contents.surface.number_of_faces
    if a.ndim == 1 and len(a) in m and len(a) not in n:
        contents.add_field(name, a, "input_faces" if len(a) == m[0] else "faces")
    elif a.ndim == 1 and len(a) in n:
        if a.dtype.kind == "c":
            contents.add_vectors(contents.surface.frames().to_space(a)[None])
        else:
            contents.add_field(name, a)
    elif a.ndim == 2 and len(a) in n and a.shape[1] == 2:
        contents.texture, contents.is_logarithm = a.astype(float), True
    elif a.ndim == 2 and len(a) in n and a.shape[1] == 3:
        contents.add_vectors(a[None].astype(float))
    elif a.ndim == 3 and a.shape[1] in n and a.shape[2] == 3:
        contents.add_vectors(a.astype(float))
    elif a.ndim == 2 and (len(a) in n or a.shape[1] in n):
        _add_functions(contents, name, a)
    else:
        raise ValueError(f"an array of the shape {a.shape} cannot be shown on a surface with "
                         f"{n[0]} vertices and {m[0]} faces; give a number or a vector for each "
                         "vertex, or a number for each face")


def _add_functions(contents, name, a):
    """Adds the columns of an array, or its rows if these have the length of the surface."""
    a = np.asarray(a)
    if a.ndim not in (1, 2):
        raise ValueError(f"{name} is no array of numbers; give a number for each vertex")
    n = contents.surface.number_of_vertices, contents.surface.number_of_input_vertices
    columns = [a] if a.ndim == 1 else list(a.T if len(a) in n else a)
    for k, column in enumerate(columns):
        contents.add_field(name if len(columns) == 1 else f"{name} {k}", column)


def _add(contents, result, name):
    """Adds a result, or several."""
    if hasattr(result, "_add_to_page"):
        result._add_to_page(contents)
    elif isinstance(result, np.ndarray):
        _add_array(contents, result, name)
    elif isinstance(result, dict):
        for key, values in result.items():
            _add_functions(contents, str(key), values)
    elif isinstance(result, tuple) and len(result) == 2 and np.ndim(result[0]) == 1 \
            and np.ndim(result[1]) == 2:  # of eigen()
        for value, function in zip(result[0], np.asarray(result[1]).T):
            contents.add_field(f"eigenvalue {value:.4g}", function)
    elif isinstance(result, (list, tuple)) and result and not isinstance(result, Point):
        if np.asarray(result[0]).dtype.kind != "O" and np.ndim(result[0]) == 0:
            _add_array(contents, np.asarray(result), name)
        else:
            for part in result:
                _add(contents, part, name)
    else:
        raise TypeError(f"{type(result).__name__} cannot be shown; give values at vertices, or "
                        "what methods of Surface return, and points as marks=")


def _contents(surface, results, marks):
    if surface._core.points is None:
        raise ValueError("the surface has lengths and no points, so that nothing can be drawn")
    contents = _PageContents(surface)
    for i, result in enumerate(results):
        _add(contents, result, "values" if len(results) == 1 else f"values {i}")
    if marks is not None:
        faces, weights, vertices = surface._places(marks, "marks")
        corners = _core.input_triangles(surface._core)[0]
        points = surface.points
        contents.add_marks([points[v] if v >= 0 else w @ points[corners[f]]
                            for f, w, v in zip(faces, weights, vertices)])
    return contents


def _frame(page):
    """Returns a page as a part of another one."""
    import html

    page = html.escape(page, quote=True)
    return f'<iframe srcdoc="{page}" style="width: 100%; height: 480px; border: 0"></iframe>'


def _is_notebook():
    import sys

    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell is not None and hasattr(shell, "kernel")


def _present(page, path, open_browser):
    """Shows a page: in a notebook there, else from a file, in a browser."""
    import tempfile
    import webbrowser

    open_browser = _arrays.flag(open_browser, "open_browser")
    path = None if path is None else os.fsdecode(_arrays.file_name(path))
    if path is None and _is_notebook():
        from IPython.display import HTML, display

        display(HTML(_frame(page)))
        return None
    if path is None:
        handle, path = tempfile.mkstemp(suffix=".html", prefix="intrinsic-")
        os.close(handle)
    with open(path, "w", encoding="utf-8") as file:
        file.write(page)
    if open_browser and not webbrowser.open("file://" + os.path.abspath(path)):
        print(path)
    return path


class _Shown:
    """Results that show themselves on their surface."""

    __slots__ = ()

    def _page_contents(self):
        """Returns what the page of this result shows."""
        if self._surface is None:
            raise ValueError("the result has no surface in space, or left it behind when it was "
                             "pickled; give it to show() of a surface")
        contents = _PageContents(self._surface)
        self._add_to_page(contents)
        return contents

    def html(self, *, megabytes: float = 30) -> str:
        """Returns a page for browsers that shows the result on its surface."""
        return self._page_contents().write(megabytes)

    def show(self, *, path: Path | None = None, open_browser: bool = True) -> str | None:
        """Shows the page of `html()`, as `Surface.show()` does."""
        return _present(self.html(), path, open_browser)

    def _repr_html_(self):
        surface = self._surface
        if surface is None or surface._core.points is None:
            return None
        return _frame(self._page_contents().write(8))


class _Pages:
    def html(self, *results: Any, marks: Places | None = None, megabytes: float = 30) -> str:
        """Returns a page for browsers that shows results on the surface, or, without results, the
        triangulation. See `show()` for what it takes.

        `megabytes` is the most that the page may have: it shows less if it needs more.
        """
        return _contents(self, results, marks).write(_arrays.number(megabytes, "megabytes"))

    def show(self, *results: Any, marks: Places | None = None, path: Path | None = None,
             open_browser: bool = True) -> str | None:
        """Shows results on the surface, together on one page, or the triangulation.

        `results` are what methods return, lists of these, and arrays for the vertices: of numbers,
        shape (n,), where whole numbers name classes, or as many as the mesh or the triangulation
        has faces, if that is another number than that of vertices; of vectors in space, (n, 3), or
        complex ones in polar coordinates; of places in the plane as of `log_map()`, (n, 2); of
        functions, as of `eigen()` and `distances()`; or dicts from names to arrays of numbers.
        `marks` are points that are marked.

        In a notebook, the page appears there. Elsewhere it is written to `path`, by default a
        temporary file, and a browser opens it unless `open_browser` is false; where there is no
        browser, the name of the file is printed. Returns that name, in notebooks None.
        """
        return _present(self.html(*results, marks=marks), path, open_browser)

    def _repr_html_(self):
        return None if self._core.points is None else _frame(self.html(megabytes=8))

    def to_pyvista(self) -> Any:
        """Returns the common subdivision as a pyvista.PolyData, if PyVista is installed."""
        return self.common_subdivision().to_pyvista()
