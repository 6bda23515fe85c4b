// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_SHORTENING_IS_GEODESIC_H
#define CGAL_INTRINSIC_GEODESICS_SHORTENING_IS_GEODESIC_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/Curve_order.h>
#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_triangulations/metric/wedge_angle.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// One side of a joint, always seen as the left one: the right side of a joint is the left side of
// the curve in reverse. Where a curve turns back along its edge, one side has no angle, and the
// other has all angles about the vertex.
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

  // Whether the joint can move to this side without crossing a curve or the border. If so, finds
  // the wedge there, a `Wedge` or its `Angle_sum`, which is empty if the curve turns back.
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

} // namespace internal

/*!
\brief describes one side of a joint of a curve.
*/
struct Joint_side_report {
  /// Its angle, compared with pi; `LARGER` on the border, beyond which there is none.
  Comparison_result angle = LARGER;
  /// Whether the joint could move there: neither the border nor a curve is in between.
  bool is_flexible = false;
};

/*!
\brief describes how a curve passes a vertex.
*/
struct Joint_report {
  std::uint32_t curve;     ///< the curve
  std::uint32_t position;  ///< number of its halfedge to the vertex
  bool is_fixed;           ///< whether the vertex is fixed
  Joint_side_report left;  ///< its left side
  Joint_side_report right; ///< its right side

  /// returns whether the curve cannot be made shorter there.
  bool is_geodesic() const {
    const auto is_straight = [](const Joint_side_report& s) {
      return s.angle != SMALLER || !s.is_flexible;
    };
    return is_fixed || (is_straight(left) && is_straight(right));
  }
  /// returns whether the curve is straight there: at least pi on both sides.
  bool is_straight() const { return left.angle != SMALLER && right.angle != SMALLER; }
};

/*!
\brief holds the decisions of the traits on each joint of curves.
*/
struct Geodesic_report {
  /// Faces whose area is not positive, and edges that are not straight, among those of the
  /// certificate, and signs that are not proven; see `certify_geodesic()`.
  std::size_t invalid_elements = 0;
  /// The joints of all curves, in order.
  std::vector<Joint_report> joints;

  /// returns whether all curves are geodesic: as short as possible without crossing each other or
  /// passing fixed vertices.
  bool is_geodesic() const {
    return invalid_elements == 0 &&
           std::all_of(joints.begin(), joints.end(),
                       [](const Joint_report& j) { return j.is_geodesic(); });
  }
};

namespace internal {

// The joints of a network, their angles compared by a functor of two halfedges.
template <class Triangulation>
class Network_joints {
  using Side = Joint_side<Triangulation>;

public:
  explicit Network_joints(const Curve_network<Triangulation>& network)
      : network_(network), t_(network.triangulation()) {}

  template <class Compare>
  std::vector<Joint_report> reports(const Compare& compare) const {
    std::vector<Joint_report> result;
    for (std::uint32_t c = 0; c < network_.number_of_curves(); ++c) {
      std::uint32_t position = 0;
      network_.for_each_segment(c, [&](std::uint32_t s) {
        if (network_.segments_[s].next != Curve_segments::none)
          result.push_back({c, position,
                            network_.is_fixed(target(network_.halfedge_of(s), t_.mesh())),
                            report(s, true, compare), report(s, false, compare)});
        ++position;
      });
    }
    return result;
  }

private:
  template <class Compare>
  Joint_side_report report(std::uint32_t s, bool is_left, const Compare& compare) const {
    const Side side(t_, network_.segments_, s, is_left);
    Joint_side_report r;
    Wedge free, all;
    r.is_flexible = side.find_free_wedge(t_, network_.segments_, free);
    if (side.is_turn(t_, network_.segments_))
      r.angle = SMALLER;
    else if (internal::find_wedge(t_, side.in, side.out, all))
      r.angle = compare(side.in, side.out);
    return r;
  }

  const Curve_network<Triangulation>& network_;
  const Triangulation& t_;
};

} // namespace internal

/*!
\brief compares the angles on both sides of every joint of curves with pi, by the traits of their
  triangulation.

With exact traits the answers are proven.
\tparam Triangulation a model of `GeodesicTriangulation`
\complexity usually linear in the number of joints and the degrees of their vertices
*/
template <GeodesicTriangulation Triangulation>
Geodesic_report is_geodesic(const Curve_network<Triangulation>& network) {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  const typename Triangulation::Const_session session(network.triangulation());
  return {0, internal::Network_joints<Triangulation>(network).reports(
                 [&](Halfedge h, Halfedge g) { return session.compare_angle_to_pi(h, g); })};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_SHORTENING_IS_GEODESIC_H
