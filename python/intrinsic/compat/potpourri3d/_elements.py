# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points given by an element of the mesh: `(vertex, [])`, `(edge, [t])`, `(face, [a, b, c])`."""

import numpy as np

from intrinsic import Point, _arrays
from intrinsic._points import is_point


def numbered_edges(faces):
    """Returns the ends of edges, of shape (e, 2), in the order in which triangles have them first,
    and the edge of each side, of shape (m, 3)."""
    ends = np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1).reshape(-1, 2)
    _, first, edge = np.unique(np.sort(ends, axis=1), axis=0, return_index=True,
                               return_inverse=True)
    order = np.argsort(first)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return ends[first[order]], rank[edge.ravel()].reshape(-1, 3)


class Elements:
    """The elements of a surface of triangles, by number."""

    def __init__(self, surface, F):
        self.faces = _arrays.indices(F, "F", (None, 3))
        self.edges, self.edge_of_side = numbered_edges(self.faces)
        # of a face that was turned around, the order of weights is another
        self._corners = surface.faces if surface.number_of_faces == len(self.faces) else self.faces
        self._face_of_edge = np.empty(len(self.edges), dtype=np.int64)
        self._face_of_edge[self.edge_of_side[::-1]] = np.arange(len(self.faces))[::-1, None]
        self._face_of_vertex = np.full(surface.number_of_vertices, -1)
        self._face_of_vertex[self.faces[::-1]] = np.arange(len(self.faces))[::-1, None]

    def point(self, element):
        """Returns the vertex or the `Point` of one of `(element, weights)`."""
        if is_point(element):
            return element
        i, weights = int(element[0]), list(element[1]) if len(element) > 1 else []
        if not weights:
            return i
        if len(weights) == 1:
            face, at = self._face_of_edge[i], dict(zip(self.edges[i], (1 - weights[0], weights[0])))
        else:
            face = i
            third = weights[2] if len(weights) > 2 else 1 - weights[0] - weights[1]
            at = dict(zip(self.faces[i], (*weights[:2], third)))
        return Point(int(face), tuple(float(at.get(v, 0)) for v in self._corners[face]))

    def in_face(self, vertex):
        """Returns the `Point` of a face that is a vertex."""
        face = int(self._face_of_vertex[vertex])
        return Point(face, tuple(float(v == vertex) for v in self._corners[face]))

    def curve(self, elements):
        """Returns points as `Surface.signed_distance()` takes them: straight in faces, or along
        edges between vertices that are not neighbours."""
        points = [self.point(e) for e in elements]
        if not any(isinstance(p, Point) for p in points):
            ends = np.stack([points[:-1], points[1:]], axis=1)
            if not np.isin(self._keys(ends), self._keys(self.edges)).all():
                return points
        return [p if isinstance(p, Point) else self.in_face(int(p)) for p in points]

    def _keys(self, ends):
        return ends.min(axis=1) * len(self._face_of_vertex) + ends.max(axis=1)

    def element(self, face, corners, weights):
        """Returns `(element, weights)` of the point with these weights of the corners of a face."""
        on = np.flatnonzero(weights)
        if len(on) == 1:
            return int(corners[on[0]]), []
        if len(on) == 3:
            at = dict(zip(corners.tolist(), weights.tolist()))
            return int(face), [at[v] for v in self.faces[face].tolist()]
        ends = corners[on]
        for edge in self.edge_of_side[face]:
            if set(self.edges[edge]) == set(ends):
                return int(edge), [float(weights[on[ends == self.edges[edge][1]]][0])]
        raise ValueError(f"face {face} has no side between vertices {ends[0]} and {ends[1]}")
