// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_CHANGING_VALUES_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_CHANGING_VALUES_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief is an array that goes back to its first values in a time that depends on the changes alone.
\tparam Value compares equal to `Value{}` until it is changed
*/
template <class Value>
class Changing_values {
public:
  explicit Changing_values(std::size_t size) : values_(size) {}

  /// returns a value.
  const Value& operator[](std::uint32_t i) const { return values_[i]; }
  /// changes a value.
  void set(std::uint32_t i, const Value& value) {
    if (values_[i] == Value{} && changed_.size() < most_changes()) changed_.push_back(i);
    values_[i] = value;
  }
  /// takes all changes back. \complexity linear in their number
  void reset() {
    if (changed_.size() == most_changes())
      values_.assign(values_.size(), Value{});
    else
      for (const std::uint32_t i : changed_) values_[i] = Value{};
    changed_.clear();
  }
  /// returns the number of bytes held.
  std::size_t bytes() const {
    return values_.capacity() * sizeof(Value) + changed_.capacity() * sizeof(std::uint32_t);
  }

private:
  // more need no list: all values are as quickly set anew
  std::size_t most_changes() const { return values_.size() / 8 + 1; }

  std::vector<Value> values_;
  std::vector<std::uint32_t> changed_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_CHANGING_VALUES_H
