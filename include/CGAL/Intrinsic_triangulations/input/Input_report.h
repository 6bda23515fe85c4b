// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INPUT_REPORT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INPUT_REPORT_H

#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

/// How degenerate faces of the input are treated.
enum class Mollification {
  none,           ///< the metric stays as it is
  automatic,      ///< `squared_lengths`, only where flips cannot remove the degenerate faces
  lengths,        ///< an epsilon is added to all lengths (§4.7 of the course)
  squared_lengths ///< a delta is added to all squared lengths
};

/*!
\brief reports what was done about degenerate faces.
*/
struct Mollification_report {
  /// What was applied: `none`, `lengths` or `squared_lengths`.
  Mollification kind = Mollification::none;
  /// What was added to the lengths (`lengths`) or squared lengths (`squared_lengths`), in the units
  /// of the input.
  double delta = 0;
};

/*!
\brief reports what was found in the input and done about it.
*/
struct Input_report {
  /// Input faces of zero area, counted exactly.
  std::size_t degenerate_faces = 0;
  /// Treatment of degenerate faces.
  Mollification_report mollification;
  /// Whether faces and vertices were renumbered for locality.
  bool renumbered = false;
  /// Number of polygonal faces that were triangulated; faces of the report are numbered after that.
  std::size_t triangulated_polygons = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INPUT_REPORT_H
