// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POSITION_ON_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POSITION_ON_FACE_H

#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief computes mean value coordinates of a point in a simple planar polygon (Floater 2003; Hormann
and Floater 2006).

They sum to 1, reproduce linear functions, and are smooth inside. On a side they are linear, those
of other corners zero, so that what is interpolated in two polygons agrees on a common side. In
convex polygons they are not negative.
\param polygon the corners, counterclockwise
\param p a point in the polygon or on its boundary
\return a weight per corner
\complexity linear
*/
std::vector<double> mean_value_weights(std::span<const std::array<double, 2>> polygon,
                                       const std::array<double, 2>& p);

namespace internal {

using Space_point = std::array<double, 3>;

// \param coordinates functor from a user's vertex to its coordinates
template <class Coordinates>
Space_point combination(std::span<const std::uint32_t> vertices, std::span<const double> weights,
                        const Coordinates& coordinates) {
  Space_point x{0, 0, 0};
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const Space_point corner = coordinates(vertices[k]);
    for (std::size_t c = 0; c < 3; ++c) x[c] += weights[k] * corner[c];
  }
  return x;
}

// Where a combination of corners of one face of the input is in space. A planar polygon that took
// the place of one in space is mapped there by mean value coordinates, linear on its sides.
// \param vertices numbers of the user's vertices
template <class Coordinates>
Space_point position_on_face(const Input& input, std::uint32_t face,
                             std::span<const std::uint32_t> vertices,
                             std::span<const double> weights, const Coordinates& coordinates) {
  Planar_polygons::Polygon polygon;
  if (!input.planar_polygons().empty())
    polygon = input.planar_polygons()(input.names().polygon(face));
  if (polygon.points.empty()) return combination(vertices, weights, coordinates);
  std::array<double, 2> p{0, 0};
  std::vector<std::size_t> used;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (weights[k] == 0) continue;
    used.push_back(polygon.corner(vertices[k]));
    for (std::size_t c = 0; c < 2; ++c) p[c] += weights[k] * polygon.points[used.back()][c];
  }
  if (used.size() < 2 || (used.size() == 2 && polygon.is_side(used[0], used[1])))
    return combination(vertices, weights, coordinates);
  return combination(polygon.vertices, mean_value_weights(polygon.points, p), coordinates);
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POSITION_ON_FACE_H
