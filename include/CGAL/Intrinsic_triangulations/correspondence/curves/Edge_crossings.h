// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EDGE_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EDGE_CROSSINGS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/CurveCoordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Input_locator.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>

#include <array>
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

// The crossings as faces see them: their numbers twice, and the last bit of the halfedge of the face.
template <class Triangulation, CurveCoordinates Coordinates>
struct Linked_crossings {
  std::vector<std::uint32_t>
      linked; // the other end of the curve in the face; none if it is at a corner
  std::vector<std::array<std::uint32_t, 2>>
      starts; // where curves leave their first faces, input halfedge

  Linked_crossings(const Triangulation& t, const Coordinates& coordinates,
                   const Edge_crossings& crossings)
      : linked(2 * crossings.size(), Gluing::none) {
    const Intrinsic_view<Triangulation> view(t);
    const auto seen = [&](std::uint32_t h, Normal_coordinate position) {
      return 2 * crossings.crossing(h, position) + (h & 1U);
    };
    for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
      const auto s = sides_of_face(view, view.halfedge_of_face(t.index(f)));
      const Corner_coordinates c = corner_coordinates(view, coordinates, s[0]);
      for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t next = s[(k + 1) % 3], last = s[(k + 2) % 3];
        for (Normal_coordinate i = 0; i < c.cutting[k]; ++i) {
          const Normal_coordinate from_end = coordinates.normal_coordinate(last / 2) - 1 - i;
          const std::uint32_t a = seen(s[k], i), b = seen(last, from_end);
          linked[a] = b;
          linked[b] = a;
        }
        for (Normal_coordinate i = 0; i < c.emanating[k]; ++i) {
          const std::uint32_t x = input_halfedge(coordinates, Curve_end{s[k], i});
          if (x % 2 == 0) starts.push_back({seen(next, c.cutting[(k + 1) % 3] + i), x});
        }
      }
    }
  }
};

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
  const internal::Linked_crossings<Triangulation, Coordinates> all(t, coordinates, result);
  result.curve_begin.reserve(all.starts.size() + 1);
  for (const auto& [first, x] : all.starts) {
    for (std::uint32_t i = first; i != Gluing::none; i = all.linked[i ^ 1U]) {
      result.entered[i / 2] = x ^ (i & 1U); // leaves a face from left to right
      result.on_curve.push_back(i / 2);
    }
    result.curve_begin.push_back(static_cast<std::uint32_t>(result.on_curve.size()));
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EDGE_CROSSINGS_H
