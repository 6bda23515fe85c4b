// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Frame_maps.h>
#include <CGAL/Intrinsic_simplification/isometry/Plane_charts.h>

#include <cstdint>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

Frame_maps::Map Frame_maps::motion(const Plane_motion& m) {
  if (Plane_charts::is_identity(m)) return identity;
  if (const auto known = known_motions_.find(m); known != known_motions_.end())
    return known->second;
  const auto add_motion = [this](const Plane_motion& x) {
    motions_.push_back(x);
    const Map map = add({static_cast<std::uint32_t>(motions_.size()) - 1, 0, 0, 0});
    known_motions_.emplace(x, map);
    return map;
  };
  const Plane_motion back = charts_->inverse(m);
  const Map map = add_motion(m), inverse = m < back || back < m ? add_motion(back) : map;
  nodes_[map - 1 - number_at_start_].inverse = inverse;
  nodes_[inverse - 1 - number_at_start_].inverse = map;
  return map;
}

Frame_maps::Map Frame_maps::composed(Map a, Map b) {
  if (a == identity) return b;
  if (b == identity) return a;
  if (inverse(a) == b) return identity;
  const std::uint64_t key = (std::uint64_t{a} << 32U) | b;
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  const Plane_motion *x = motion_or_null(a), *y = motion_or_null(b);
  const Map map = x != nullptr && y != nullptr ? motion(charts_->composed(*x, *y)) : word(a, b);
  known_.emplace(key, map);
  return map;
}

Frame_maps::Map Frame_maps::word(Map a, Map b) {
  if (is_word(b) && node(b).first == inverse(a)) return node(b).second;
  if (is_word(a) && node(a).second == inverse(b)) return node(a).first;
  const Map map = add({none, a, b, 0}), back = add({none, inverse(b), inverse(a), map});
  nodes_[map - 1 - number_at_start_].inverse = back;
  return map;
}

} // namespace CGAL::Intrinsic_triangulations::internal
