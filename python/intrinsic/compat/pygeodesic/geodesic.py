# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The class of the package pygeodesic: exact distances and shortest paths."""

import numpy as np

import intrinsic


def read_mesh_from_file(filename):
    """Reads a text file with the numbers of points and faces, their coordinates, and the vertices
    of faces. Returns points, of shape (n, 3), and faces, of shape (m, 3)."""
    with open(filename, encoding="utf-8") as file:
        words = file.read().split()
    n, m = int(words[0]), int(words[1])
    if len(words) < 2 + 3 * (n + m):
        raise ValueError(f"{filename}: the file ends before its {n} points and {m} faces")
    points = np.array(words[2:2 + 3 * n], dtype=float).reshape(n, 3)
    faces = np.array(words[2 + 3 * n:2 + 3 * (n + m)], dtype=np.int64).reshape(m, 3)
    return points, faces


class PyGeodesicAlgorithmExact:
    """Finds exact distances on a triangle mesh."""

    def __init__(self, _points, _faces):
        self.surface = intrinsic.Surface(_points, _faces)

    def geodesicDistance(self, sourceIndex, targetIndex):
        """Returns the distance between two vertices, and a shortest path from the target to the
        source, of shape (k, 3)."""
        way = self.surface.path(int(targetIndex), int(sourceIndex))
        return way.length, _different_points(way)

    def geodesicDistances(self, source_indices=None, target_indices=None, max_distance=np.inf):
        """Returns the distances of the targets, by default of all vertices, from the nearest of
        the sources, by default vertex 0, and the number of that source in the list; infinity and -1
        where no path leads, or beyond `max_distance`."""
        sources = np.atleast_1d(0 if source_indices is None else source_indices)
        if len(sources) == 1:
            distances = self.surface.distance(sources, max_distance=max_distance)
            nearest = np.zeros(len(distances), dtype=np.int32)
        else:
            cells = self.surface.voronoi(sources)
            distances, nearest = cells.distances, cells.labels.astype(np.int32)
            distances[distances > max_distance] = np.inf
        nearest[np.isinf(distances)] = -1
        if target_indices is None:
            return distances, nearest
        targets = np.atleast_1d(target_indices)
        return distances[targets], nearest[targets]


def _different_points(way):
    """Returns the points of a path, of which those at a vertex, which each face there has, are
    one."""
    steps = np.linalg.norm(np.diff(way.points, axis=0), axis=1)
    return way.points[np.append(True, steps > 1e-12 * way.length)]
