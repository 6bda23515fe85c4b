// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_DISJOINT_SETS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_DISJOINT_SETS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Sets of numbers, of rows or vertices, that pairs join: components.
class Disjoint_sets {
public:
  explicit Disjoint_sets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  void join(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t r = root(i), s = root(j);
    parent_[std::max(r, s)] = std::min(r, s);
  }

  // the least of the set of each
  std::vector<std::uint32_t> least() && {
    for (std::uint32_t i = 0; i < parent_.size(); ++i) parent_[i] = root(i);
    return std::move(parent_);
  }

private:
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  std::vector<std::uint32_t> parent_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_DISJOINT_SETS_H
