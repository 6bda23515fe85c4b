// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_SHORTENING_JOINT_SIDE_H
#define CGAL_INTRINSIC_GEODESICS_SHORTENING_JOINT_SIDE_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_segments.h>
#include <CGAL/Intrinsic_triangulations/metric/wedge_angle.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

// One side of a joint, always seen as the left one: the right side of a joint is the left side of the curve in reverse.
// Of a curve that turns back along its edge, one side has no angle at all, the other all that there is about the vertex.
template <class Triangulation>
struct Joint_side {
  using Halfedge = typename Triangulation::halfedge_descriptor;

  std::uint32_t first, second; // segments, in the direction in which the joint is seen
  Halfedge in, out;            // their halfedges, in that direction
  bool is_reversed;            // against the curve

  Joint_side(const Triangulation& t, const Curve_segments& segments, std::uint32_t s, bool is_left)
      : first(is_left ? s : segments[s].next), second(is_left ? segments[s].next : s),
        in(seen(t, segments[first].halfedge, is_left)),
        out(seen(t, segments[second].halfedge, is_left)), is_reversed(!is_left) {}

  // whether the curve turns back on this side
  bool is_turn(const Triangulation& t, const Curve_segments& segments) const {
    if (out != opposite(in, t.mesh())) return false;
    const std::uint32_t h = t.numbers().halfedge(in);
    for (std::uint32_t s = first; s != Curve_segments::none; s = segments.beside(s, h))
      if (s == second) return true;
    return false;
  }

  // Whether nothing is on this side that would be crossed when the joint moves there: no curve, no border. If so, finds the
  // wedge there, a `Wedge` or its `Angle_sum`, which is empty if the curve turns back.
  template <class Corners>
  bool find_free_wedge(const Triangulation& t, const Curve_segments& segments,
                       Corners& wedge) const {
    const auto& number = t.numbers();
    const std::uint32_t h = number.halfedge(in);
    if (is_turn(t, segments)) return segments.beside(first, h) == second;
    return segments.outermost(h) == first && segments.outermost(number.halfedge(out)) == second &&
           internal::find_wedge(t, in, out, wedge,
                                [&](Halfedge g) { return segments.is_free(number.halfedge(g)); });
  }

private:
  static Halfedge seen(const Triangulation& t, std::uint32_t h, bool is_left) {
    return t.numbers().halfedge_at(is_left ? h : h ^ 1U);
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_SHORTENING_JOINT_SIDE_H
