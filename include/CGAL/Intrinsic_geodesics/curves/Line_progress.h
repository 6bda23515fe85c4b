// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_LINE_PROGRESS_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_LINE_PROGRESS_H

#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// Counts the faces that a line enters, and stops it where it makes no progress: rounding in needles
// sends lines around in circles.
class Line_progress {
public:
  explicit Line_progress(double length) : part_(0x1p-40 * length), rest_at_part_(length) {}

  void enter_face() { ++faces_; }

  // Whether the line may go on.
  // \param rest the length that is left
  bool may_go_on(double rest) {
    if (rest <= rest_at_part_ - part_) {
      rest_at_part_ = rest;
      faces_at_part_ = faces_;
    }
    return faces_ < maximum_faces && faces_ - faces_at_part_ <= maximum_faces_of_part;
  }

private:
  static constexpr std::size_t maximum_faces = std::size_t{1} << 22U; // as in `Trace_options`
  // A line that passes close to a vertex crosses half of its faces in no length: up to so many.
  static constexpr std::size_t maximum_faces_of_part = std::size_t{1} << 12U;

  double part_, rest_at_part_; // the length in which there must be progress; what was left then
  std::size_t faces_ = 0, faces_at_part_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_LINE_PROGRESS_H
