// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_VALUE_TABLE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_VALUE_TABLE_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <type_traits>
#include <unordered_map>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Values by number, in references that stay valid. In `Short_ball`, nearly all values are computed:
each has a place. In other types few are, and a map holds them.
*/
template <class FT, class T = FT>
class Value_table {
  static constexpr bool is_dense = std::is_same_v<FT, Short_ball>;

public:
  // null if there is none
  const T* find(std::uint32_t id) const {
    if constexpr (is_dense) {
      return id < values_.size() && values_[id] ? &*values_[id] : nullptr;
    } else {
      const auto known = values_.find(id);
      return known == values_.end() ? nullptr : &known->second;
    }
  }
  const T& add(std::uint32_t id, T value) {
    if constexpr (is_dense) {
      if (id >= values_.size()) values_.resize(id + std::size_t{1});
      return values_[id].emplace(std::move(value));
    } else {
      return values_.emplace(id, std::move(value)).first->second;
    }
  }

private:
  std::conditional_t<is_dense, std::deque<std::optional<T>>, std::unordered_map<std::uint32_t, T>>
      values_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_VALUE_TABLE_H
