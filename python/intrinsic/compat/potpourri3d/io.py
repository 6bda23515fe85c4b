# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of meshes and of points."""

import os

import numpy as np

import intrinsic
from intrinsic import _arrays, _core


def read_polygon_mesh(filename):
    """Returns the points of a mesh file, of shape (n, 3), and its faces as a list of lists, as they
    are there."""
    points, corners, begins = _core.read_polygons(os.fspath(filename))
    return points, [face.tolist() for face in np.split(corners, begins[1:-1])]


def read_mesh(filename):
    """Returns the points of a mesh file, of shape (n, 3), and its faces, of shape (m, k)."""
    points, corners, begins = _core.read_polygons(os.fspath(filename))
    sizes = np.unique(np.diff(begins)).tolist()
    if len(sizes) != 1:
        raise ValueError(f"{filename} has faces with {sizes} corners; read_polygon_mesh() reads it")
    return points, corners.reshape(-1, sizes[0])


def read_point_cloud(filename):
    """Returns the points of a file, of shape (n, 3)."""
    return intrinsic.read(filename, domain="points").points


def write_mesh(V, F, filename, UV_coords=None, UV_type=None):
    """Writes a mesh to a file .obj, .off or .ply."""
    points = _arrays.points(V, "V")
    faces = [list(map(int, face)) for face in F]
    kind = str(filename).lower()[-4:]
    if kind not in (".obj", ".off", ".ply") or UV_coords is not None and kind != ".obj":
        raise ValueError(f"{filename}: give a name that ends with .obj, or .off or .ply without UV")
    with open(filename, "w", encoding="utf-8") as file:
        if kind == ".obj":
            _write_obj(file, points, faces, UV_coords, UV_type)
            return
        file.write(f"OFF\n{len(points)} {len(faces)} 0\n" if kind == ".off" else
                   f"ply\nformat ascii 1.0\nelement vertex {len(points)}\nproperty double x\n"
                   f"property double y\nproperty double z\nelement face {len(faces)}\n"
                   "property list uchar int vertex_indices\nend_header\n")
        file.writelines("%.17g %.17g %.17g\n" % tuple(p) for p in points)
        file.writelines(f"{len(f)} {' '.join(map(str, f))}\n" for f in faces)


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
    """Writes points to a file .obj, .off or .ply."""
    write_mesh(V, [], filename)
