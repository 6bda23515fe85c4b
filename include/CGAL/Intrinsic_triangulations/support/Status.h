// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_STATUS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_STATUS_H

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells how an algorithm or a query ended.

All of them use these words. The reason for refusing a single move is a `Move_status`; algorithms
count refusals and go on.
*/
enum class Status : std::uint8_t {
  done,         ///< the result is complete, up to the precision of the arithmetic
  stopped,      ///< the length or the angle to stop at was reached
  contracted,   ///< a loop has shrunk to a vertex
  cap,          ///< a cap that was given, or that makes inexact arithmetic end, was reached before
  stalled,      ///< work is left, but none of it was possible
  cancelled,    ///< the visitor asked to stop
  inaccurate,   ///< rounding has spoilt the triangulation (never with exact traits): see
                ///< `Inaccuracy`; or it may have misled the query: see `Edge_path`
  border,       ///< the border was reached before
  not_traceable ///< the correspondence cannot find it: only because of rounding, with `Signposts`
};

/// The result of a move.
enum class Move_status {
  done,          ///< the move was made
  border,        ///< refused: the edge is on the border
  same_face,     ///< refused: both sides of the edge are in one face (an end has degree one)
  not_convex,    ///< refused: the faces at the edge do not make a strictly convex quadrilateral
  crossings,     ///< refused: the edge would cross more input edges than can be counted
  arithmetic,    ///< refused: rounding made an area that is not positive; never with exact types
  weights,       ///< refused: barycentric coordinates of no point in the face or on its sides
  not_inserted,  ///< refused: a vertex of the input cannot be removed
  not_removable, ///< refused: flips do not reduce the degree of the vertex
  not_traceable  ///< refused: the correspondence cannot find the point on the input
};

/// returns the word for how an algorithm ended, as in the documentation of `Status`.
inline const char* name_of(Status status) {
  switch (status) {
  case Status::done:
    return "done";
  case Status::stopped:
    return "stopped";
  case Status::contracted:
    return "contracted";
  case Status::cap:
    return "cap";
  case Status::stalled:
    return "stalled";
  case Status::cancelled:
    return "cancelled";
  case Status::inaccurate:
    return "inaccurate";
  case Status::border:
    return "border";
  case Status::not_traceable:
    return "not_traceable";
  }
  return "";
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_STATUS_H
