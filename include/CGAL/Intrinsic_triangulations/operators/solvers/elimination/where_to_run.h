// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_WHERE_TO_RUN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_WHERE_TO_RUN_H

#include <future>
#include <thread>

namespace CGAL::Intrinsic_triangulations::internal {

// How `std::async()` runs something: in a thread if that is worth one and there is a second processor, else, or if none can be had, when its
// result is asked for. The function must be one that has a name: libstdc++ takes it twice where there is no thread.
inline std::launch where_to_run(bool is_worth_a_thread) {
  static const bool are_several = std::thread::hardware_concurrency() > 1;
  return is_worth_a_thread && are_several ? std::launch::async | std::launch::deferred
                                          : std::launch::deferred;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_WHERE_TO_RUN_H
