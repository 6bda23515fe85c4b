// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_REMOVE_VERTICES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_REMOVE_VERTICES_H

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Moved_triangulation;

/*
Removes vertices by flips until they have three edges, or one inner edge on the border. A Delaunay
triangulation may stay one; another one is not flipped across creases without need.

The faces around a flat vertex develop into a polygon that is star-shaped about
it. A triangulation of the polygon without the vertex has two ears at least, of
which one does not contain the vertex: the edge to its tip can be flipped. Edges
from the vertex to itself go first: they lower the degree by two. Where other
vertices have to go first, the vertex is tried again after them. \throws
Undecidable
*/
void remove_vertices(Moved_triangulation& t, const std::vector<char>& are_removed,
                     bool stays_delaunay);

// Makes all faces Delaunay. \throws Undecidable also if that takes more moves, with those before
void make_delaunay(Moved_triangulation& t, std::size_t most_moves);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_REMOVE_VERTICES_H
