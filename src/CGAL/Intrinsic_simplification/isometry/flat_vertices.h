// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_FLAT_VERTICES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_FLAT_VERTICES_H

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Moved_triangulation;

// For each vertex, whether several fans of faces meet there.
std::vector<char> pinched_vertices(const Gluing_map& mesh);

// For each vertex, whether its angles sum to exactly two pi, or pi on the
// border. Isolated vertices count as flat, pinched ones never.
std::vector<char> flat_vertices(const Corresponding_triangulation& t);

/*
Removes vertices by flips until they have three edges, or one inner edge on the
border; then makes the triangulation Delaunay.

The faces around a flat vertex develop into a polygon that is star-shaped about
it. A triangulation of the polygon without the vertex has two ears at least, of
which one does not contain the vertex: the edge to its tip can be flipped. Edges
from the vertex to itself go first: they lower the degree by two. Where other
vertices have to go first, the vertex is tried again after them. \throws
Undecidable
*/
void remove_vertices(Moved_triangulation& t, const std::vector<char>& are_removed);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_FLAT_VERTICES_H
