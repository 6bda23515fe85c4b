// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_LEAST_VALUE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_LEAST_VALUE_H

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Numbered values, and the number of the least one: a tournament. A value changes in log n steps,
// whose comparisons need no branches: a heap of half a dozen values takes twice as long.
class Least_value {
public:
  // Makes n values, all of them infinite.
  void start(std::size_t n) {
    size_ = std::bit_ceil(n);
    values_.assign(size_, std::numeric_limits<double>::infinity());
    winner_.resize(2 * size_);
    for (std::size_t i = 2 * size_; i-- > 1;)
      winner_[i] = i < size_ ? winner_[2 * i] : static_cast<std::uint32_t>(i - size_);
  }
  double value(std::uint32_t i) const { return values_[i]; }
  // The number of the least value; of equal ones, the first.
  std::uint32_t least() const { return winner_[1]; }
  void set(std::uint32_t i, double value) {
    values_[i] = value;
    for (std::size_t k = (size_ + i) / 2; k > 0; k /= 2) {
      const std::uint32_t left = winner_[2 * k], right = winner_[2 * k + 1];
      winner_[k] = values_[right] < values_[left] ? right : left;
    }
  }

private:
  std::size_t size_ = 0;
  std::vector<double> values_;
  std::vector<std::uint32_t> winner_; // the best number below each node; node 1 is the root
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_LEAST_VALUE_H
