// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_REMOVE_VERTICES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_REMOVE_VERTICES_H

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Moved_triangulation;

/*
Removes flat vertices by flips, see `Flat_vertex_removal`. A Delaunay triangulation may stay one;
another one is not flipped across creases without need. Where other vertices have to go first, the
vertex is tried again after them. \throws Undecidable
*/
void remove_vertices(Moved_triangulation& t, const std::vector<char>& are_removed,
                     bool stays_delaunay);

// Makes all faces Delaunay. \throws Undecidable also if that takes more moves, with those before
void make_delaunay(Moved_triangulation& t, std::size_t most_moves);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_REMOVE_VERTICES_H
