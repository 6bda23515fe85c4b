// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_CURVE_SEGMENTS_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_CURVE_SEGMENTS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Segments of curves: each runs along a halfedge, has a segment before and after it on its curve, and lies in a stack with
// the others on its edge, in their order across it (Sharp and Crane 2020, section 3.2). Segments are named by numbers.
class Curve_segments {
public:
  static constexpr std::uint32_t none = Gluing::none;

  struct Segment {
    std::uint32_t halfedge = none;
    std::uint32_t previous = none, next = none; // on the curve
    std::uint32_t curve = none;
    // in the stack: [0] on the left of the even halfedge, [1] on the left of the odd one
    std::array<std::uint32_t, 2> beside{none, none};
    std::uint32_t generation = 0; // how many had this number before
  };

  explicit Curve_segments(std::size_t number_of_edges = 0)
      : outermost_(2 * number_of_edges, none) {}

  const Segment& operator[](std::uint32_t s) const { return segments_[s]; }

  // the segment nearest to the face on the left of a halfedge
  std::uint32_t outermost(std::uint32_t h) const {
    return h < outermost_.size() ? outermost_[h] : none;
  }
  bool is_free(std::uint32_t h) const { return outermost(h) == none; }
  // the next one on the left of a halfedge of its edge
  std::uint32_t beside(std::uint32_t s, std::uint32_t h) const {
    return segments_[s].beside[h & 1U];
  }

  // adds a segment that is in no stack yet
  std::uint32_t add(std::uint32_t h, std::uint32_t curve) {
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

  // puts it into the stack of its edge, so that `left` comes next on the left of h; none: it is nearest to the face of h
  void stack(std::uint32_t s, std::uint32_t h, std::uint32_t left = none) {
    if (h >= outermost_.size()) outermost_.resize((h | 1U) + std::size_t{1}, none);
    const std::uint32_t right =
        left == none ? outermost_[h] : segments_[left].beside[(h & 1U) ^ 1U];
    segments_[s].beside[h & 1U] = left;
    segments_[s].beside[(h & 1U) ^ 1U] = right;
    (left == none ? outermost_[h] : segments_[left].beside[(h & 1U) ^ 1U]) = s;
    (right == none ? outermost_[h ^ 1U] : segments_[right].beside[h & 1U]) = s;
  }

  // lets one follow another on a curve; either may be none
  void link(std::uint32_t s, std::uint32_t next) {
    if (s != none) segments_[s].next = next;
    if (next != none) segments_[next].previous = s;
  }

  // takes it off its stack; its number becomes free
  void remove(std::uint32_t s) {
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

private:
  std::vector<Segment> segments_;
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> outermost_; // per halfedge
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_CURVE_SEGMENTS_H
