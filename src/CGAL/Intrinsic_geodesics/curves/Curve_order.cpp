// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/curves/Curve_order.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

std::uint32_t Curve_segments::add(std::uint32_t h, std::uint32_t curve) {
  std::uint32_t s = none;
  if (free_.empty()) {
    s = static_cast<std::uint32_t>(segments_.size());
    segments_.emplace_back();
  } else {
    s = free_.back();
    free_.pop_back();
  }
  segments_[s] = {h, none, none, curve, {none, none}, segments_[s].generation};
  return s;
}

void Curve_segments::stack(std::uint32_t s, std::uint32_t h, std::uint32_t left) {
  if (h >= outermost_.size()) outermost_.resize((h | 1U) + std::size_t{1}, none);
  const std::uint32_t right = left == none ? outermost_[h] : segments_[left].beside[(h & 1U) ^ 1U];
  segments_[s].beside[h & 1U] = left;
  segments_[s].beside[(h & 1U) ^ 1U] = right;
  (left == none ? outermost_[h] : segments_[left].beside[(h & 1U) ^ 1U]) = s;
  (right == none ? outermost_[h ^ 1U] : segments_[right].beside[h & 1U]) = s;
}

void Curve_segments::remove(std::uint32_t s) {
  Segment& x = segments_[s];
  const std::uint32_t h = x.halfedge & ~1U;
  for (const unsigned side : {0U, 1U}) {
    const std::uint32_t on_side = x.beside[side], other = x.beside[side ^ 1U];
    (on_side == none ? outermost_[h | side] : segments_[on_side].beside[side ^ 1U]) = other;
  }
  x.halfedge = none;
  ++x.generation;
  free_.push_back(s);
}

} // namespace CGAL::Intrinsic_triangulations::internal
