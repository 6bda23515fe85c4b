// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_CURVE_ORDER_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_CURVE_ORDER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Segments of curves, by number: each runs along a halfedge, has a segment before and after it on
// its curve, and lies in a stack of those on its edge, in their order across it (Sharp and Crane
// 2020, section 3.2).
class Curve_segments {
public:
  static constexpr std::uint32_t none = Gluing::none;

  struct Segment {
    std::uint32_t halfedge = none;
    std::uint32_t previous = none, next = none; // on the curve
    std::uint32_t curve = none;
    // in the stack: [0] on the left of the even halfedge, [1] on the left of the odd one
    std::array<std::uint32_t, 2> beside{none, none};
    std::uint32_t generation = 0; // counts the earlier segments of this number
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
  std::uint32_t add(std::uint32_t h, std::uint32_t curve);

  // puts it into the stack of its edge, with `left` next on the left of h; none: nearest to the
  // face of h
  void stack(std::uint32_t s, std::uint32_t h, std::uint32_t left = none);

  // connects consecutive segments of a curve; either may be none
  void link(std::uint32_t s, std::uint32_t next) {
    if (s != none) segments_[s].next = next;
    if (next != none) segments_[next].previous = s;
  }

  // takes it off its stack; its number becomes free
  void remove(std::uint32_t s);

private:
  std::vector<Segment> segments_;
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> outermost_; // per halfedge
};

// The order of curves across an edge in which they do not cross: the curve that leaves to the left
// where they part is on the left all the way. Curves that never part keep the order of insertion,
// from left to right.
template <class Triangulation>
class Curve_order {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  static constexpr std::uint32_t none = Curve_segments::none;

public:
  Curve_order(const Triangulation& t, const Curve_segments& segments)
      : t_(t), segments_(segments) {}

  // the segment whose right neighbour s becomes on its edge; s is in no stack yet
  std::uint32_t left_neighbor(std::uint32_t s) const {
    const std::uint32_t h = segments_[s].halfedge;
    std::uint32_t left = none;
    for (std::uint32_t x = segments_.outermost(h); x != none; x = segments_.beside(x, h ^ 1U)) {
      if (is_left(s, x)) break;
      left = x;
    }
    return left;
  }

  // whether curves cross at the source of h: their joints are nested about it, unless they cross
  bool has_crossing(Halfedge h) const {
    std::vector<std::uint32_t> open = without_nested(joints_about_source(h));
    std::unordered_map<std::uint32_t, unsigned> ends;
    for (const std::uint32_t j : open) ++ends[j];
    // what is met once leads to another fan of the vertex
    open.erase(
        std::remove_if(open.begin(), open.end(), [&](std::uint32_t j) { return ends[j] == 1; }),
        open.end());
    return !without_nested(open).empty();
  }

private:
  // Joints by the segment that comes in, counterclockwise, each where a segment of it ends: from
  // right to left of the halfedge from the vertex.
  std::vector<std::uint32_t> joints_about_source(Halfedge h) const {
    std::vector<std::uint32_t> joints;
    Halfedge g = h;
    do {
      const std::uint32_t out = t_.numbers().halfedge(g);
      for (std::uint32_t s = segments_.outermost(out ^ 1U); s != none; s = segments_.beside(s, out))
        if (segments_[s].halfedge != out && segments_[s].next != none)
          joints.push_back(s);
        else if (segments_[s].halfedge == out && segments_[s].previous != none)
          joints.push_back(segments_[s].previous);
      g = turned_left(g);
    } while (g != h);
    return joints;
  }

  // leaves out joints with nothing between their ends, and so on; this does not change whether
  // others nest
  static std::vector<std::uint32_t> without_nested(const std::vector<std::uint32_t>& joints) {
    std::vector<std::uint32_t> open;
    for (const std::uint32_t j : joints)
      if (!open.empty() && open.back() == j)
        open.pop_back();
      else
        open.push_back(j);
    return open;
  }

  // the next halfedge from the same source, counterclockwise, across a border too
  Halfedge turned_left(Halfedge h) const { return opposite(previous(h), t_.mesh()); }
  Halfedge previous(Halfedge h) const {
    const auto& mesh = t_.mesh();
    Halfedge p = next(next(h, mesh), mesh);
    if (next(p, mesh) == h) return p;
    for (p = opposite(h, mesh); next(p, mesh) != h;) p = opposite(next(p, mesh), mesh);
    return p;
  }

  // a segment and the direction in which it is followed
  struct Step {
    std::uint32_t segment;
    bool is_forward;
  };
  Step next_step(Step x) const {
    return {x.is_forward ? segments_[x.segment].next : segments_[x.segment].previous, x.is_forward};
  }
  std::uint32_t along(Step x) const {
    return segments_[x.segment].halfedge ^ (x.is_forward ? 0U : 1U);
  }

  // whether a lies on the left of b, which is on the same edge, seen in the direction of a
  bool is_left(std::uint32_t a, std::uint32_t b) const {
    const bool is_along = segments_[a].halfedge == segments_[b].halfedge;
    const int ahead = parting({a, true}, {b, is_along});
    if (ahead != 0) return ahead > 0;
    return parting({a, false}, {b, !is_along}) < 0; // looking back, left is right
  }

  // 1 if a leaves to the left of b, -1 if to the right, 0 if one of them ends before, or they never
  // part
  int parting(Step a, Step b) const {
    const Step first_a = a, first_b = b;
    while (true) {
      const std::uint32_t h = along(a);
      a = next_step(a);
      b = next_step(b);
      if (a.segment == none || b.segment == none) return 0;
      if (along(a) != along(b)) return is_met_first(h, along(a), along(b)) ? 1 : -1;
      if (a.segment == first_a.segment && b.segment == first_b.segment) return 0;
    }
  }

  // whether a, from the target of h, comes before b clockwise from h: it is on the left of b
  bool is_met_first(std::uint32_t h, std::uint32_t a, std::uint32_t b) const {
    const auto& number = t_.numbers();
    Halfedge g = number.halfedge_at(h);
    const Halfedge first = g;
    do {
      g = next(g, t_.mesh());
      if (number.halfedge(g) == a) return true;
      if (number.halfedge(g) == b) return false;
      g = opposite(g, t_.mesh());
    } while (g != first);
    return false; // both in another fan of a vertex that is not manifold
  }

  const Triangulation& t_;
  const Curve_segments& segments_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_CURVE_ORDER_H
