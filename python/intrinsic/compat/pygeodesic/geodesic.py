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
        return way.length, way.points

    def geodesicDistances(self, source_indices=None, target_indices=None):
        """Returns the distances of the targets, by default of all vertices, from the nearest of
        the sources, and the number of that source in the list; infinity and -1 where no path
        leads."""
        sources = np.atleast_1d(source_indices)
        if len(sources) == 1:
            distances = self.surface.distance(sources)
            nearest = np.where(np.isfinite(distances), 0, -1)
        else:
            cells = self.surface.voronoi(sources)
            distances, nearest = cells.distances, np.asarray(cells.labels)
        if target_indices is None:
            return distances, nearest
        targets = np.atleast_1d(target_indices)
        return distances[targets], nearest[targets]
