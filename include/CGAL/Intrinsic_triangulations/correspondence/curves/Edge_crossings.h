// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EDGE_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EDGE_CROSSINGS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/CurveCoordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Input_locator.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/corner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/follow_curve.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief lists for every intrinsic edge the input edges that it crosses, and for every input edge the
crossings along it.

Crossings on edge `e` are consecutive, in the order in which halfedge `2e` meets them.
*/
struct Edge_crossings {
  /// First crossing of each intrinsic edge, and one entry more.
  std::vector<std::uint32_t> begin;
  /// For each crossing the input halfedge of the face that halfedge `2e` enters there.
  std::vector<std::uint32_t> entered;
  /// First entry in `on_curve` of each curve that is crossed, and one entry more. A curve is an input
  /// edge, or a part of one between inserted vertices, in the direction of its even halfedge.
  std::vector<std::uint32_t> curve_begin{0};
  /// Crossings on each curve, in order.
  std::vector<std::uint32_t> on_curve;

  /// returns the number of crossings.
  std::size_t size() const { return entered.size(); }
  /// returns the number of the crossing that is passed by intrinsic halfedge `h` after `position`
  /// others.
  std::uint32_t crossing(std::uint32_t h, Normal_coordinate position) const {
    const auto p = static_cast<std::uint32_t>(position);
    return h % 2 == 0 ? begin[h / 2] + p : begin[h / 2 + 1] - 1 - p;
  }
  /// returns the input halfedge of the face that intrinsic halfedge `h` enters at that crossing.
  std::uint32_t entered_by(std::uint32_t h, Normal_coordinate position) const {
    return entered[crossing(h, position)] ^ (h & 1U);
  }
  /// returns the input halfedges that halfedge `2 * edge` crosses.
  std::span<const std::uint32_t> entered_on(std::uint32_t edge) const {
    return {entered.data() + begin[edge], begin[edge + 1] - begin[edge]};
  }
};

namespace internal {

// Follows the curve from `start` along input halfedge `x`.
template <class View, CurveCoordinates Coordinates>
void add_curve(const View& view, const Coordinates& coordinates, const Curve_end& start,
               std::uint32_t x, Edge_crossings& result) {
  follow_curve(view, coordinates, first_crossing(view, coordinates, start),
               [&](const Curve_crossing& c) {
                 // the intrinsic halfedge that the curve leaves through is crossed by it from left
                 // to right, and enters the face on the left of the curve
                 const std::uint32_t i = result.crossing(c.halfedge, c.position);
                 result.entered[i] = x ^ (c.halfedge & 1U);
                 result.on_curve.push_back(i);
               });
  result.curve_begin.push_back(static_cast<std::uint32_t>(result.on_curve.size()));
}

} // namespace internal

/*!
\brief follows all input edges over the intrinsic triangulation.
\param t the triangulation
\param coordinates its normal coordinates and roundabouts, a model of `CurveCoordinates`
\throws std::length_error if there are more than 2^31 crossings
\complexity linear in the number of edges and crossings
*/
template <class Triangulation, CurveCoordinates Coordinates>
Edge_crossings edge_crossings(const Triangulation& t, const Coordinates& coordinates) {
  const Intrinsic_view<Triangulation> view(t);
  Edge_crossings result;
  std::uint64_t count = 0;
  for (std::uint32_t e = 0; e < coordinates.number_of_edges(); ++e) {
    result.begin.push_back(static_cast<std::uint32_t>(count));
    count += static_cast<std::uint64_t>(crossings(coordinates.normal_coordinate(e)));
    if (count >> 31U != 0)
      throw std::length_error("input and intrinsic edges cross more than 2^31 times");
  }
  result.begin.push_back(static_cast<std::uint32_t>(count));
  result.entered.resize(count, Gluing::none);
  result.on_curve.reserve(count);
  for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
    std::uint32_t h = view.halfedge_of_face(t.index(f));
    const Corner_coordinates c = corner_coordinates(view, coordinates, h);
    for (unsigned k = 0; k < 3; ++k, h = view.next(h))
      for (Normal_coordinate i = 0; i < c.emanating[k]; ++i) {
        const std::uint32_t x = input_halfedge(coordinates, Curve_end{h, i});
        if (x % 2 == 0) internal::add_curve(view, coordinates, Curve_end{h, i}, x, result);
      }
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EDGE_CROSSINGS_H
