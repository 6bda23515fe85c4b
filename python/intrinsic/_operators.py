# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The set of operators that networks on surfaces learn with."""

from __future__ import annotations

import errno
import os
from pathlib import Path as _Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from . import _arrays, _core, _options

if TYPE_CHECKING:
    from typing import Any
    from ._types import Integers, Matrix, Numbers, Path, Progress

_FORMAT = b"operators 1"  # another number if other numbers are computed
_MATRICES = {"L": "L", "gradX": "gradient_x", "gradY": "gradient_y"}


class Operators(NamedTuple):
    """Operators of a surface with n vertices, for functions of shape (n,) or (n, d).

    - `L`: the Laplacian, and `mass`, of shape (n,), the diagonal of the mass matrix.
    - `eigenvalues`, of shape (k,), and `eigenfunctions`, of shape (n, k).
    - `gradient_x` and `gradient_y`: sparse matrices of shape (n, n) that give the gradient at
      vertices in its two axes.
    - `frames`, of shape (n, 3, 3): these axes, and the normal; orthonormal.
    - `points` (n, 3) and `faces` (m, 3) of the mesh.
    """

    points: Numbers
    faces: Integers
    L: Matrix
    mass: Numbers
    eigenvalues: Numbers
    eigenfunctions: Numbers
    gradient_x: Matrix
    gradient_y: Matrix
    frames: Numbers

    def save(self, path: Path) -> None:
        """Writes a file `.npz`, with the keys that DiffusionNet reads from its cache."""
        import tempfile

        arrays: dict[str, Any] = {
            "verts": self.points, "faces": self.faces, "k_eig": len(self.eigenvalues),
            "mass": self.mass, "evals": self.eigenvalues, "evecs": self.eigenfunctions,
            "frames": self.frames}
        for key, name in _MATRICES.items():
            columns = getattr(self, name).tocsc()
            for part in "data", "indices", "indptr", "shape":
                arrays[f"{key}_{part}"] = getattr(columns, part)
        directory = _Path(os.fsdecode(_arrays.file_name(path))).parent
        if not directory.is_dir():
            raise FileNotFoundError(errno.ENOENT, "the directory does not exist; make it",
                                    os.fsdecode(path))
        handle, part_name = tempfile.mkstemp(suffix=".npz", dir=directory)
        try:
            with os.fdopen(handle, "wb") as file:
                np.savez(file, **arrays)
            os.replace(part_name, path)  # never half, also if processes share a cache
        except BaseException:
            os.unlink(part_name)
            raise

    @classmethod
    def load(cls, path: Path) -> Operators:
        """Reads what `save()` has written."""
        from scipy.sparse import csc_matrix

        arrays = _loaded(path)
        matrices = {
            name: csc_matrix(tuple(arrays[f"{key}_{part}"]
                                   for part in ("data", "indices", "indptr")),
                             shape=arrays[f"{key}_shape"]).tocsr()
            for key, name in _MATRICES.items()}
        return cls(points=arrays["verts"], faces=arrays["faces"], mass=arrays["mass"],
                   eigenvalues=arrays["evals"], eigenfunctions=arrays["evecs"],
                   frames=arrays["frames"], **matrices)

    def __repr__(self) -> str:
        return f"<intrinsic.Operators: {len(self.mass)} vertices, " \
               f"{len(self.eigenvalues)} eigenfunctions>"


def _loaded(path):
    """Returns the arrays of a file, which has those of operators."""
    import zlib
    from tokenize import TokenError  # of headers of arrays
    from zipfile import BadZipFile

    name = os.fsdecode(_arrays.file_name(path))
    damaged = "the file is damaged; delete it, and save the operators again"
    wrong = "the file has no operators; name one that Operators.save() has written"
    try:
        with open(name, "rb") as stream:
            file = np.load(stream)
            if isinstance(file, np.lib.npyio.NpzFile) and "L_data" in file and "evals" in file:
                wrong = damaged  # if they cannot be read
                return {key: file[key] for key in file}
    except (BadZipFile, EOFError, RuntimeError, TokenError, zlib.error):
        wrong = damaged
    except ValueError:  # no file of arrays, or damaged
        pass
    raise ValueError(f"{name}: {wrong}")


def _frames(core, neighbors):
    """Returns orthonormal axes: the first one of vectors at the vertex, the one to its left in
    their plane, and the normal of that."""
    x, y = (_core.axes_in_space(core, angle, neighbors) for angle in (0.0, np.pi / 2))
    normal = np.cross(x, y)
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    return np.stack([x, np.cross(normal, x), normal], axis=1)


def _ways(core):
    """Returns for each edge, seen from both ends: the vertex, the other one, the length, and the
    angle in the polar coordinates of the vertex."""
    faces, lengths, angles = _core.faces(core), _core.lengths(core), _core.side_angles(core)
    ends = np.roll(faces, -1, axis=1)
    border = _core.glue(core)[..., 0] < 0  # seen from its end, such a side is the last one
    return (np.concatenate([faces.ravel(), ends[border]]),
            np.concatenate([ends.ravel(), faces[border]]),
            np.concatenate([lengths.ravel(), lengths[border]]),
            np.concatenate([angles.ravel(), np.full(border.sum(), np.pi)]))


def _gradients(core, size):
    """Returns the matrices of both coordinates of the vector at each vertex that fits the slopes
    along its edges best."""
    from scipy.sparse import coo_matrix

    start, end, length, angle = _ways(core)
    used = (length > 0) & (start != end)
    start, end, length, angle = start[used], end[used], length[used], angle[used]
    x, y = np.cos(angle), np.sin(angle)
    xx, xy, yy = (np.bincount(start, products, size) for products in (x * x, x * y, y * y))
    area = xx * yy - xy * xy
    safe = np.where(area > 1e-12 * (xx + yy) ** 2, area, np.inf)[start]  # else all are on a line
    gradients = []
    for slope in ((yy[start] * x - xy[start] * y), (xx[start] * y - xy[start] * x)):
        values = slope / safe / length
        gradients.append(coo_matrix(
            (np.concatenate([values, -values]),
             (np.concatenate([start, start]), np.concatenate([end, start]))),
            shape=(size, size)).tocsr())
    return gradients


class _Learning:
    def operators(self, k: int = 128, *, cache: Path | None = None, flip: bool = True,
                  progress: Progress = None) -> Operators:
        """Returns what networks on surfaces learn with: the Laplacian, the mass matrix, `k`
        eigenfunctions, and gradients at vertices, as `Operators`.

        With `cache`, a directory, they are kept there in a file `.npz`, which is named after the
        hash of the vertices and faces, and found there the next time. `flip` is that of
        `laplacian()`. The surface must be an oriented manifold in space.

        >>> s.operators(k=3).eigenfunctions.shape
        (4, 3)
        """
        k = _options.number(k, "count", "k")
        flip = _arrays.flag(flip, "flip")
        points = self.points
        if points is None or _core.sheets(self._core) > 1:
            raise ValueError("gradients need an oriented manifold in space; take laplacian(), "
                             "mass() and eigen(), which need none")
        path = None
        if cache is not None:
            folder = _Path(os.fsdecode(_arrays.file_name(cache, "cache")))
            if folder.exists() and not folder.is_dir():
                raise ValueError(f"cache is the file {folder}; give a directory")
            path = folder / f"{self._content(points, flip)}_{k}.npz"
            if path.exists():
                return Operators.load(path)
            folder.mkdir(parents=True, exist_ok=True)
        found = self._operators(points, k, flip, progress)
        if path is not None:
            found.save(path)
        return found

    def _content(self, points, flip):
        """Returns the hash of the surface."""
        import hashlib

        hashed = hashlib.sha256(_FORMAT + bytes([flip, self._core.is_flipped,
                                                 self._core.is_exact]))
        for x in points, self.faces, _core.glue(self._core):
            hashed.update(np.ascontiguousarray(x))
        return hashed.hexdigest()

    def _operators(self, points, k, flip, progress):
        core = self._flipped(flip)
        eigenvalues, eigenfunctions = _core.eigen(core, k, "auto", progress)
        x, y = _gradients(core, len(points))
        return Operators(points, self.faces, self.laplacian(flip=flip),
                         self.mass(flip=flip).diagonal(),
                         eigenvalues, eigenfunctions, x, y,
                         _frames(core, self._cloud_neighbors()))
