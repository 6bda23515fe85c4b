// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_JOINED_NUMBERS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_JOINED_NUMBERS_H

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Disjoint sets of numbers, which can be joined and asked for at any time.
class Joined_numbers {
public:
  explicit Joined_numbers(std::size_t size) : parent_(size), size_(size, 1) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  // a number of the set, the same for all of its numbers until it is joined
  std::uint32_t set_of(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  // returns whether they were in different sets
  bool join(std::uint32_t i, std::uint32_t j) {
    i = set_of(i);
    j = set_of(j);
    if (i == j) return false;
    if (size_[i] < size_[j]) std::swap(i, j);
    parent_[j] = i;
    size_[i] += size_[j];
    return true;
  }

private:
  std::vector<std::uint32_t> parent_, size_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_JOINED_NUMBERS_H
