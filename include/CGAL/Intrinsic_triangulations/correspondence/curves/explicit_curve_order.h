// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EXPLICIT_CURVE_ORDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EXPLICIT_CURVE_ORDER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/CurveCoordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/corner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/follow_curve.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief links the crossings of one face with those after them on the same curves.
\param sides the sides of the face
\param normal their normal coordinates
\param crossings `begin` and `entered` are set
\param next per crossing the one after it on its curve; set for the curves that cut off a corner
\param starts the first crossings of the curves that emanate from a corner here are added
*/
inline void link_crossings_of_face(const std::array<std::uint32_t, 3>& sides,
                                   const std::array<Normal_coordinate, 3>& normal,
                                   const Edge_crossings& crossings,
                                   std::vector<std::uint32_t>& next,
                                   std::vector<std::uint32_t>& starts) {
  const Corner_coordinates c = corner_coordinates(normal);
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned opposite = (k + 1) % 3, before = (k + 2) % 3;
    for (Normal_coordinate i = 0; i < c.cutting[k]; ++i) {
      const std::uint32_t out = crossings.crossing(sides[k], i);
      const std::uint32_t in = crossings.crossing(sides[before], normal[before] - 1 - i);
      // an even input halfedge leaves the face through side k, or comes in there
      if (crossings.entered_by(sides[k], i) % 2 == 0)
        next[in] = out;
      else
        next[out] = in;
    }
    for (Normal_coordinate i = 0; i < c.emanating[k]; ++i) {
      const Normal_coordinate position = c.cutting[opposite] + i;
      if (crossings.entered_by(sides[opposite], position) % 2 == 0)
        starts.push_back(crossings.crossing(sides[opposite], position));
    }
  }
}

/*!
\brief orders the crossings along the curves, of which the labels are known.
\param t the triangulation
\param coordinates its normal coordinates
\param crossings `begin` and `entered` are set; the rest is computed
\complexity linear in the number of faces and crossings
*/
template <class Triangulation, CurveCoordinates Coordinates>
void order_crossings_on_curves(const Triangulation& t, const Coordinates& coordinates,
                               Edge_crossings& crossings) {
  const Intrinsic_view<Triangulation> view(t);
  std::vector<std::uint32_t> next(crossings.size(), Gluing::none), starts;
  for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
    const std::array<std::uint32_t, 3> s = sides_of_face(view, view.halfedge_of_face(t.index(f)));
    link_crossings_of_face(s,
                           {coordinates.normal_coordinate(s[0] / 2),
                            coordinates.normal_coordinate(s[1] / 2),
                            coordinates.normal_coordinate(s[2] / 2)},
                           crossings, next, starts);
  }
  crossings.on_curve.reserve(crossings.size());
  crossings.curve_begin.reserve(starts.size() + 1);
  for (const std::uint32_t start : starts) {
    for (std::uint32_t i = start; i != Gluing::none; i = next[i]) crossings.on_curve.push_back(i);
    crossings.curve_begin.push_back(static_cast<std::uint32_t>(crossings.on_curve.size()));
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EXPLICIT_CURVE_ORDER_H
