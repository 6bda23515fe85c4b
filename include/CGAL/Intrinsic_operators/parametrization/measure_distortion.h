// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_MEASURE_DISTORTION_H
#define CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_MEASURE_DISTORTION_H

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief describes how a map to the plane changes angles and areas. A face is mapped linearly, with
stretches s1 >= s2 in two directions at right angles.

The figures do not depend on the unit of the map. They leave out, and count, faces without area or
with so little that stretches or their products exceed the range of doubles. No figure is NaN:
without any face left, figures are those of the identity.
*/
struct Map_distortion {
  double mean_quasi_conformal =
      1; ///< mean of s1 / s2 by area: 1 if angles are kept; infinite with degenerate faces
  double maximum_quasi_conformal = 1; ///< the greatest
  double mean_angle_change = 0;    ///< mean over the corners of the change of the angle, in radians
  double maximum_angle_change = 0; ///< the greatest
  double minimum_area_ratio =
      1; ///< least of s1 s2 by its mean: 1 if areas are kept up to scale; negative of flipped faces
  double maximum_area_ratio = 1; ///< the greatest
  double mean_area_ratio =
      1; ///< mean by area of the greater of the ratio and its inverse: 1 at best
  std::size_t faces_left_out = 0; ///< number of faces without area
};

namespace internal {

Map_distortion measure_distortion(const Face_table& table, const Eigen::MatrixX2d& uv);

} // namespace internal

/*!
\brief measures how a map to the plane, linear on the faces of a triangulation, changes angles and
areas.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param uv a point per row of `t.input_vertex()`
\return the figures, in doubles
\throws std::invalid_argument if a row is missing, or a coordinate is not finite
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Map_distortion measure_distortion(const Triangulation& t, const Eigen::MatrixX2d& uv) {
  return internal::measure_distortion(internal::face_table(t), uv);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_MEASURE_DISTORTION_H
