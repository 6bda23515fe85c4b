// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MOVE_STATUS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MOVE_STATUS_H

namespace CGAL::Intrinsic_triangulations {

/// What became of a move.
enum class Move_status {
  done,       ///< the move was made
  border,     ///< refused: the edge is on the border
  same_face,  ///< refused: both sides of the edge are in one face (an end has degree one)
  not_convex, ///< refused: the faces at the edge do not make a strictly convex quadrilateral
  crossings,  ///< refused: the edge would cross more input edges than can be counted
  arithmetic, ///< refused: the number type made an area that is not positive; never with exact types
  weights, ///< refused: barycentric coordinates that are not those of a point in a face or on a side
  not_inserted,  ///< refused: a vertex of the input cannot be removed
  not_removable, ///< refused: flips do not reduce the degree of the vertex
  not_traceable  ///< refused: the correspondence cannot find the point on the input
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MOVE_STATUS_H
