// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_REMEMBERED_SIGNS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_REMEMBERED_SIGNS_H

#include <CGAL/enum.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief stores how predicates on edges were decided, until a face at the edge changes. Otherwise
ties, and cases that doubles leave open, would be decided repeatedly.
*/
class Remembered_signs {
public:
  /// A stored sign.
  struct Known {
    Sign sign;        ///< the sign
    bool is_probable; ///< whether it was assumed to be zero without proof
  };

  /// stores the sign of an edge.
  void remember(std::uint32_t edge, const Known& known) {
    if (edge >= codes_.size()) codes_.resize(edge + std::size_t{1}, unknown);
    codes_[edge] = known.is_probable ? probable : static_cast<std::int8_t>(known.sign);
  }
  /// returns the sign of an edge, if it is stored.
  std::optional<Known> find(std::uint32_t edge) const {
    if (edge >= codes_.size() || codes_[edge] == unknown) return std::nullopt;
    if (codes_[edge] == probable) return Known{ZERO, true};
    return Known{static_cast<Sign>(codes_[edge]), false};
  }
  /// tells whether the stored sign of an edge is zero, proven or assumed.
  bool is_zero(std::uint32_t edge) const {
    const std::optional<Known> known = find(edge);
    return known && known->sign == ZERO;
  }
  /// forgets the signs of edges.
  void forget(std::span<const std::uint32_t> edges) noexcept {
    if (codes_.empty()) return; // nearly always, as there are few ties
    for (const std::uint32_t e : edges)
      if (e < codes_.size()) codes_[e] = unknown;
  }

private:
  static constexpr std::int8_t unknown = 2, probable = 3;
  std::vector<std::int8_t> codes_; // of each edge: a sign, or one of these
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_REMEMBERED_SIGNS_H
