// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_SEGMENTS_SHORTENING_RESULT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_SEGMENTS_SHORTENING_RESULT_H

#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reports what shortening curves did.
*/
struct Shortening_result {
  /// `done`: all curves are geodesic, or have contracted to a vertex; `stopped`, `cap` or `cancelled` before that.
  Status status = Status::done;
  /// Number of edges flipped.
  std::uint64_t flips = 0;
  /// Number of times that a piece of a curve was replaced by a shorter one.
  std::uint64_t shortenings = 0;
  /// Number of angles compared with pi.
  std::uint64_t wedge_checks = 0;
  /// Number of those that were exactly pi.
  std::uint64_t exact_ties = 0;
  /// Number of flips refused: the arithmetic made an area that is not positive, or an edge crosses too much of the input.
  std::uint64_t refused_flips = 0;

  /// adds counts; the status is the last one.
  Shortening_result& operator+=(const Shortening_result& r) {
    status = r.status;
    flips += r.flips;
    shortenings += r.shortenings;
    wedge_checks += r.wedge_checks;
    exact_ties += r.exact_ties;
    refused_flips += r.refused_flips;
    return *this;
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_SEGMENTS_SHORTENING_RESULT_H
