// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_PARAMETRIZATION_MEASURE_DISTORTION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_PARAMETRIZATION_MEASURE_DISTORTION_H

#include <CGAL/Intrinsic_triangulations/operators/Face_table.h>
#include <CGAL/Intrinsic_triangulations/triangulation/NumberedTriangulation.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief says how a map to the plane changes angles and areas. A face is mapped linearly, with stretches s1 >= s2 in two directions at right
angles.
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
};

namespace internal {

// Stretches and angles of one face.
struct Face_distortion {
  double quasi_conformal = 1;
  double area_ratio = 1; // signed, not divided by its mean
  std::array<double, 3> angle_changes{};

  Face_distortion(const Table_face& f, const std::array<std::complex<double>, 3>& w) {
    double sum = 0; // of squared stretches
    for (std::size_t k = 0; k < 3; ++k)
      sum += f.half_cotangent(k) * std::norm(w[(k + 1) % 3] - w[k]) / f.area();
    const auto corners = f.layout();
    area_ratio = std::imag(std::conj(w[1] - w[0]) * (w[2] - w[0])) / (2 * f.area());
    const double product = std::abs(area_ratio), plus = std::sqrt(std::max(0.0, sum + 2 * product)),
                 minus = std::sqrt(std::max(0.0, sum - 2 * product));
    quasi_conformal = product > 0 ? (plus + minus) * (plus + minus) / (4 * product)
                                  : std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k)
      angle_changes[k] = std::abs(angle(corners, k) - angle(w, k));
  }

private:
  static double angle(const std::array<std::complex<double>, 3>& w, std::size_t k) {
    return std::abs(std::arg((w[(k + 2) % 3] - w[k]) * std::conj(w[(k + 1) % 3] - w[k])));
  }
};

} // namespace internal

/*!
\brief measures how a map to the plane, linear on the faces of a triangulation, changes angles and areas.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param uv a point per row of `t.input_vertex()`
\return the figures, in doubles
\throws std::invalid_argument if a row is missing
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Map_distortion measure_distortion(const Triangulation& t, const Eigen::MatrixX2d& uv) {
  const internal::Face_table table = internal::face_table(t);
  if (uv.rows() < static_cast<Eigen::Index>(table.number_of_rows))
    throw std::invalid_argument("the map must have a point per vertex");
  double area = 0, of_image = 0;
  Map_distortion d{
      0, 1, 0, 0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
      0};
  const auto measure = [&](const internal::Table_face& f) {
    std::array<std::complex<double>, 3> w;
    for (std::size_t k = 0; k < 3; ++k) w[k] = {uv(f.rows[k], 0), uv(f.rows[k], 1)};
    return internal::Face_distortion(f, w);
  };
  for (const internal::Table_face& f : table.faces) {
    area += f.area();
    of_image += measure(f).area_ratio * f.area();
  }
  for (const internal::Table_face& f : table.faces) {
    const internal::Face_distortion face = measure(f);
    const double share = f.area() / area,
                 ratio = of_image != 0 ? face.area_ratio * area / of_image : 0;
    d.mean_quasi_conformal += share * face.quasi_conformal;
    d.maximum_quasi_conformal = std::max(d.maximum_quasi_conformal, face.quasi_conformal);
    for (const double change : face.angle_changes) {
      d.mean_angle_change += change / (3 * static_cast<double>(table.faces.size()));
      d.maximum_angle_change = std::max(d.maximum_angle_change, change);
    }
    d.minimum_area_ratio = std::min(d.minimum_area_ratio, ratio);
    d.maximum_area_ratio = std::max(d.maximum_area_ratio, ratio);
    d.mean_area_ratio +=
        share * (ratio > 0 ? std::max(ratio, 1 / ratio) : std::numeric_limits<double>::infinity());
  }
  return d;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_PARAMETRIZATION_MEASURE_DISTORTION_H
