#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes pictures of the start page, beside itself: make_pictures.py PATH_OF_intrinsic PATH_OF_geodesics MESHES

`geodesics` is an example of this package, MESHES the directory of CGAL's data set.
"""
import os
import subprocess
import sys
import tempfile

import numpy

sys.dont_write_bytecode = True
import render
from subdivision import read_ply

HERE = os.path.dirname(os.path.abspath(__file__))
PART = os.path.join(HERE, "../../../examples/data/part.off")
GREY = 0.88


def draw_geodesics(program, mesh, scratch):
    """All that is straight from a point, on a mesh, as long as the model is wide."""
    lines = os.path.join(scratch, "lines.obj")
    points, faces = render.read_off(mesh)
    right, up, back = render.rotation(30, 20)
    axes = numpy.array([-up, right, back])  # the model stands: it is laid down
    centres = points[faces].mean(1)
    start = int(((centres - [0.13, -0.1, 0]) ** 2).sum(1).argmin())
    subprocess.run([program, mesh, str(start), "0.42", lines], check=True)
    picture = render.Picture(points, axes, 460)
    picture.triangles(points, faces, numpy.full(len(points), GREY), render.grey, 0.25)
    picture.lines(render.read_lines(lines), (0.70, 0.15, 0.12), 0.9)
    picture.write(os.path.join(HERE, "geodesics.png"))


def read_matrix(file):
    """Rows, columns and values of a symmetric matrix in Matrix Market format, both triangles of it."""
    i, j, x = numpy.loadtxt(file, comments="%", skiprows=2).T
    i, j = i.astype(int) - 1, j.astype(int) - 1
    lower = i != j
    return (numpy.r_[i, j[lower]], numpy.r_[j, i[lower]], numpy.r_[x, x[lower]])


def solve_with_fixed_values(matrix, fixed):
    """The harmonic function with some values, NaN elsewhere, by conjugate gradients with a diagonal preconditioner."""
    rows, columns, entries = matrix
    free = numpy.isnan(fixed)
    u = numpy.where(free, numpy.nanmean(fixed), fixed)
    times = lambda x: free * numpy.bincount(rows, entries * x[columns], len(x))
    diagonal = numpy.bincount(rows, entries * (rows == columns), len(u))
    r = -times(u)
    z = r / diagonal
    p, rz = z.copy(), r @ z
    while numpy.abs(r).max() > 1e-9:
        q = times(p)
        step = rz / (p @ q)
        u, r = u + step * p, r - step * q
        z = r / diagonal
        p, rz = z + (r @ z) / rz * p, r @ z
    return u


def fans(polygons):
    return numpy.array([(p[0], a, b) for p in polygons for a, b in zip(p[1:], p[2:])])


def draw_harmonic(intrinsic, scratch):
    """The harmonic function between two ends of the part, on the refined triangulation, as it lies on the part."""
    surface, matrix = (os.path.join(scratch, name) for name in ("part.ply", "part.mtx"))
    subprocess.run([intrinsic, "refine", PART, "-o", surface, "--laplacian", matrix], check=True)
    ply, laplacian = read_ply(surface), read_matrix(matrix)
    vertices = ply["vertex"]
    points = numpy.array([(v["x"], v["y"], v["z"]) for v in vertices])
    ends = numpy.array([(v["intrinsic_vertex_0"], v["intrinsic_vertex_1"]) for v in vertices])
    weights = numpy.array([(v["intrinsic_weight_0"], v["intrinsic_weight_1"]) for v in vertices])
    fixed = numpy.full(laplacian[0].max() + 1, numpy.nan)
    corners = ends[:, 1] < 0
    for value, axis in ((0, 2), (1, 0)):  # its upper and its right end
        x = points[:, axis]
        fixed[ends[corners & (x > x.max() - 1e-6 * numpy.ptp(x)), 0]] = value
    u = solve_with_fixed_values(laplacian, fixed)
    u = (u[ends] * numpy.where(ends < 0, 0, weights)).sum(1)
    faces = fans([f["vertex_indices"] for f in ply["face"]])
    picture = render.Picture(points, render.rotation(-28, 38), 460)
    picture.triangles(points, faces, u, render.bands)
    picture.write(os.path.join(HERE, "harmonic.png"))


def main():
    intrinsic, geodesics, meshes = (os.path.abspath(path) for path in sys.argv[1:4])
    with tempfile.TemporaryDirectory() as scratch:
        draw_geodesics(geodesics, os.path.join(meshes, "eight.off"), scratch)
        draw_harmonic(intrinsic, scratch)


if __name__ == "__main__":
    main()
