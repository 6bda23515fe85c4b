// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CURVECOORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CURVECOORDINATES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <concepts>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief asks for integers that tell how the edges of the input run over the intrinsic triangulation.

Syntax of \ref ::CurveCoordinates, where its meaning is described.
*/
template <class Coordinates>
concept CurveCoordinates = requires(const Coordinates& c, std::uint32_t i) {
  { c.input() } -> std::same_as<const Input&>;
  { c.fans() } -> std::same_as<const Vertex_fans&>;
  { c.number_of_edges() } -> std::same_as<std::uint32_t>;
  { c.normal_coordinate(i) } -> std::same_as<Normal_coordinate>;
  { c.roundabout(i) } -> std::same_as<std::uint32_t>;
  { c.is_inserted(i) } -> std::same_as<bool>;
  { c.location(i) } -> std::same_as<const Surface_point&>;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CURVECOORDINATES_H
