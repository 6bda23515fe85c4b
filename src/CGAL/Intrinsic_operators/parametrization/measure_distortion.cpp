// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/parametrization/measure_distortion.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stretches and angles of one face.
struct Face_distortion {
  double quasi_conformal = 1;
  double area = 0, image_area = 0; // the latter signed
  std::array<double, 3> angle_changes{};

  // The map is a z + b conj(z) with the vertices in the face as complex numbers, s1, s2 = |a| +-
  // |b|.
  Face_distortion(const Table_face& f, const std::array<std::complex<double>, 3>& w)
      : area(f.area()), image_area(std::imag(std::conj(w[1] - w[0]) * (w[2] - w[0])) / 2) {
    const auto z = f.layout();
    const std::complex<double> along = (w[1] - w[0]) / z[1].real(), // z[0] = 0, z[1] is real
        across = (w[2] - w[0] - z[2].real() * along) / z[2].imag();
    const std::complex<double> i(0, 1), a = (along - i * across) / 2.,
                                        b = (along + i * across) / 2.;
    const double s1 = std::abs(a) + std::abs(b);
    // squared, as areas are stretched
    is_defined = area > 0 && std::isfinite(s1 * s1);
    const double s2 = std::abs(image_area) / area / s1; // s1 s2 is the ratio of areas
    quasi_conformal = s2 > 0 ? s1 / s2 : std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) angle_changes[k] = std::abs(angle(z, k) - angle(w, k));
  }

  bool is_defined = false;

private:
  static double angle(const std::array<std::complex<double>, 3>& w, std::size_t k) {
    return std::abs(std::arg((w[(k + 2) % 3] - w[k]) * std::conj(w[(k + 1) % 3] - w[k])));
  }
};

// Multiplies by a power of two that makes the greatest coordinate about 1, so that areas stay in
// the range of doubles.
static Eigen::MatrixX2d scaled_to_one(const Eigen::MatrixX2d& uv) {
  const double greatest = uv.size() == 0 ? 0 : uv.cwiseAbs().maxCoeff();
  if (!(greatest > 0)) return uv;
  const int e = std::ilogb(greatest);
  return uv.unaryExpr([e](double x) { return std::ldexp(x, -e); });
}

static Map_distortion summed_distortion(const std::vector<Face_distortion>& faces, double area,
                                        double of_image, std::size_t left_out) {
  Map_distortion d;
  d.faces_left_out = left_out;
  if (faces.empty()) return d;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  d.mean_quasi_conformal = d.mean_area_ratio = 0;
  d.minimum_area_ratio = infinity;
  d.maximum_area_ratio = -infinity;
  for (const Face_distortion& face : faces) {
    const double share = face.area / area,
                 ratio = of_image != 0 ? face.image_area / face.area * (area / of_image) : 0;
    if (share > 0) d.mean_quasi_conformal += share * face.quasi_conformal;
    d.maximum_quasi_conformal = std::max(d.maximum_quasi_conformal, face.quasi_conformal);
    for (const double change : face.angle_changes) {
      d.mean_angle_change += change / (3 * static_cast<double>(faces.size()));
      d.maximum_angle_change = std::max(d.maximum_angle_change, change);
    }
    d.minimum_area_ratio = std::min(d.minimum_area_ratio, ratio);
    d.maximum_area_ratio = std::max(d.maximum_area_ratio, ratio);
    if (share > 0) d.mean_area_ratio += share * (ratio > 0 ? std::max(ratio, 1 / ratio) : infinity);
  }
  return d;
}

Map_distortion measure_distortion(const Face_table& table, const Eigen::MatrixX2d& uv) {
  if (uv.rows() < static_cast<Eigen::Index>(table.number_of_rows))
    throw std::invalid_argument("the map must have a point per vertex");
  if (!uv.allFinite()) throw std::invalid_argument("the coordinates of a map must be finite");
  const Eigen::MatrixX2d unit = scaled_to_one(uv);
  std::vector<Face_distortion> faces;
  double area = 0, of_image = 0;
  for (const Table_face& f : table.faces) {
    std::array<std::complex<double>, 3> w;
    for (std::size_t k = 0; k < 3; ++k) w[k] = {unit(f.rows[k], 0), unit(f.rows[k], 1)};
    const Face_distortion face(f, w);
    if (!face.is_defined) continue;
    faces.push_back(face);
    area += face.area;
    of_image += face.image_area;
  }
  return summed_distortion(faces, area, of_image, table.faces.size() - faces.size());
}

} // namespace CGAL::Intrinsic_triangulations::internal
