// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMS_FROM_PLACE_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMS_FROM_PLACE_H

#include <CGAL/Intrinsic_triangulations/correspondence/queries/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Place_finder.h>

#include <cmath>
#include <complex>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds a logarithmic map from a place that a user names.

Vectors are in the polar coordinates of the vertex if the place was named as a vertex, else in the
frame of the face that names it: along its first side, and to the left of that.
\tparam Triangulation a model of `CorrespondingTriangulation`
\tparam Logarithm called with a vertex or a `Surface_point` of the triangulation; it returns a
  `Tangent_field`, such as `logarithmic_map()` does
\param t the triangulation
\param place the place, normalized
\param logarithm the method
\throws Invalid_input as `Place_finder::append()`
*/
template <QueriedTriangulation Triangulation, class Logarithm>
std::vector<std::complex<double>> logarithms_from_place(const Triangulation& t, const Place& place,
                                                        const Logarithm& logarithm) {
  Place_finder<Triangulation> find(t);
  if (!place.has_face()) return logarithm(find.vertex(place.vertex));
  const Tangent_vector axis = find.tangent(place, {1, 0});
  std::vector<std::complex<double>> result = logarithm(axis.point);
  const auto turn = std::polar(1., -std::atan2(axis.vector[1], axis.vector[0]));
  for (std::complex<double>& z : result) z *= turn;
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMS_FROM_PLACE_H
