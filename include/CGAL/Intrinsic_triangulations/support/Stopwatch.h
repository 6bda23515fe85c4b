// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_STOPWATCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_STOPWATCH_H

#include <chrono>

namespace CGAL::Intrinsic_triangulations {

/// measures wall clock time.
class Stopwatch {
public:
  /// returns the seconds since construction or the last call.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_STOPWATCH_H
