// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_ENTERED_HALFEDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_ENTERED_HALFEDGES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/CurveCoordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds the input halfedges over which faces of the input are entered where curves are crossed.

A curve is followed to its end, which tells on which input edge it runs. What was found is remembered where a curve is the only
one that crosses an intrinsic edge, there and on the way: an input edge that many intrinsic edges cross is not followed again and
again. Until it is flipped, what crosses an edge stays the same, even if a vertex cuts the curve in two.

Its memory stays from call to call.
*/
class Entered_halfedges {
public:
  /*!
  \brief finds those of curves that leave a face side by side.
  \param view the intrinsic triangulation
  \param coordinates its coordinates; they are to remember if they are not constant
  \param bundle the curves
  \param visit called with the number of each curve, and the input halfedge over which a face is entered when the curve is
  crossed from left to right along the halfedge of the bundle
  \complexity linear in the number of steps, at most that of all crossings; constant for a curve that is remembered
  */
  template <class View, CurveCoordinates Coordinates, class Visit>
  void operator()(const View& view, Coordinates& coordinates, const Curve_bundle& bundle,
                  const Visit& visit) {
    passed_.clear();
    const auto found = [&](Normal_coordinate number, std::uint32_t halfedge) {
      if constexpr (requires { coordinates.remember_entry(0, 0); })
        for (const std::uint32_t h : passed_) coordinates.remember_entry(h, halfedge);
      passed_.clear();
      visit(number, halfedge);
    };
    const auto is_known = [&](const Curve_bundle& b) {
      if constexpr (requires { coordinates.remembered_entry(0); }) {
        if (coordinates.normal_coordinate(b.halfedge / 2) != 1) return false;
        const std::uint32_t halfedge = coordinates.remembered_entry(b.halfedge);
        if (halfedge != Gluing::none)
          found(b.number, halfedge);
        else
          passed_.push_back(b.halfedge);
        return halfedge != Gluing::none;
      } else {
        return false;
      }
    };
    follow_curves(
        view, coordinates, bundle, stack_,
        [&](Normal_coordinate number, const Curve_end& end) {
          found(number, input_halfedge(coordinates, end) ^ 1U);
        },
        is_known);
  }

private:
  std::vector<Curve_bundle> stack_;
  std::vector<std::uint32_t>
      passed_; // halfedges that only the curve crosses that is being followed
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_ENTERED_HALFEDGES_H
