// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMS_FROM_PLACE_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMS_FROM_PLACE_H

#include <CGAL/Intrinsic_operators/vectors/Point_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cmath>
#include <complex>
#include <concepts>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// From a corner of the user's face, in its frame.
template <class Triangulation, class Logarithm>
std::vector<std::complex<double>> logarithms_at_corner_of_face(const Triangulation& t,
                                                               const Place& place,
                                                               const Logarithm& logarithm) {
  const Input& input = t.correspondence().input();
  const Surface_point p = point_on_input(input, place);
  const Geodesic_face face(input, p.halfedge);
  const unsigned k = corner_of(p);
  const double half = angle_at_source(input, face.side[k]) / 2;
  const Plane_vector<double> middle = face.from_relative_to(k, {std::cos(half), std::sin(half)});
  const Tangent_vector there = tangent_to_intrinsic(t, {p, middle}).value();
  const Point_frames<Triangulation> frames(t);
  auto corner = frames.corners(there.point)[0];
  corner.polar_angle = std::arg(corner.to_here({there.vector[0], there.vector[1]}));
  corner.angle = std::atan2(middle[1], middle[0]);
  std::vector<std::complex<double>> result =
      logarithm(t.numbers().vertex_at(input.source(face.side[k])));
  for (std::complex<double>& z : result) z = corner.from_here(frames.from_field(corner.vertex, z));
  return result;
}

} // namespace internal

/*!
\brief finds a logarithmic map from a place that a user names.

Vectors are in the polar coordinates of the vertex if the place was named as a vertex, else in the
frame of the face that names it: along its first side, and to the left of that. At a corner of the
face, angles from the middle of the corner are those on the surface.
\tparam Triangulation a model of `CorrespondingTriangulation`
\tparam Logarithm called with a vertex or a `Surface_point` of the triangulation; it returns a
  `Tangent_field`, such as `logarithmic_map()` does
\param t the triangulation
\param place the place, normalized
\param logarithm the method
\throws Invalid_input as `Place_finder::append()`
*/
template <QueriedTriangulation Triangulation, std::invocable<Surface_point> Logarithm>
std::vector<std::complex<double>> logarithms_from_place(const Triangulation& t, const Place& place,
                                                        const Logarithm& logarithm) {
  Place_finder<Triangulation> find(t);
  if (!place.has_face()) return logarithm(find.vertex(place.vertex));
  if (place.is_vertex()) return internal::logarithms_at_corner_of_face(t, place, logarithm);
  const Tangent_vector axis = find.tangent(place, {1, 0});
  std::vector<std::complex<double>> result = logarithm(axis.point);
  const auto turn = std::polar(1., -std::atan2(axis.vector[1], axis.vector[0]));
  for (std::complex<double>& z : result) z *= turn;
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMS_FROM_PLACE_H
