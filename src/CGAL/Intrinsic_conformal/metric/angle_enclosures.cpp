// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/triangle_angles.h>
#include <CGAL/Intrinsic_conformal/metric/angle_enclosures.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using Angle_interval = Interval_nt<false>;

// the double below pi, and the next one
Angle_interval enclosed_pi() { return {std::numbers::pi, std::nextafter(std::numbers::pi, 4.)}; }

// an enclosure of the arc tangent of a number that is not negative
Angle_interval enclosed_atan(const Angle_interval& x) {
  constexpr double error = 0x1p-50; // four units in the last place; glibc states an error of one
  const Angle_interval lower(std::atan(x.inf())), upper(std::atan(x.sup()));
  return {(lower * (Angle_interval(1) - error)).inf(), (upper * (Angle_interval(1) + error)).sup()};
}

Angle_interval prescribed(const Prescribed_angles& angles, std::size_t row) {
  if (!angles.is_multiple(row)) return angles.radians(row);
  const Multiple_of_pi m = angles.multiple(row);
  return Angle_interval(static_cast<double>(m.numerator)) * enclosed_pi() /
         static_cast<double>(m.denominator);
}

} // namespace

std::array<Angle_interval, 3> enclosed_angles(const std::array<Angle_interval, 3>& sides,
                                              const std::array<Angle_interval, 3>& surplus) {
  const Angle_interval sum = sides[0] + sides[1] + sides[2];
  std::array<Angle_interval, 3> x; // 1 - a_k if half of the sum is 1; positive in a triangle
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = surplus[k] / sum;
    x[k] = {std::max(x[k].inf(), 0.), std::max(x[k].sup(), 0.)};
  }
  std::array<Angle_interval, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    // the squared tangent of half of the angle increases with two, and decreases with the third
    const Angle_interval product = x[(k + 1) % 3] * x[(k + 2) % 3];
    const double infinity = std::numeric_limits<double>::infinity();
    const Angle_interval squared_tangent =
        x[k].inf() > 0
            ? product / x[k]
            : Angle_interval((Angle_interval(product.inf()) / x[k].sup()).inf(), infinity);
    result[k] = Angle_interval(2) * enclosed_atan(CGAL::sqrt(squared_tangent));
  }
  return result;
}

std::array<Angle_interval, 3>
enclosed_hyperbolic_angles(const std::array<Angle_interval, 3>& lambda,
                           const std::array<Angle_interval, 3>& surplus) {
  const auto positive = [](const Angle_interval& x) {
    return Angle_interval(std::max(x.inf(), 0.), std::max(x.sup(), 0.));
  };
  std::array<Angle_interval, 3> result = squared_half_tangents<Angle_interval>(
      {lambda[0] / 2, lambda[1] / 2, lambda[2] / 2},
      {surplus[0] / 2, surplus[1] / 2, surplus[2] / 2}, positive);
  for (Angle_interval& angle : result) angle = Angle_interval(2) * enclosed_atan(CGAL::sqrt(angle));
  return result;
}

// By how much the rounded factor and exp(u/2) differ from each factor, relatively, and 0.
// Functions of the C library err by few units in the last place of a long double.
static std::vector<Angle_interval> deviations(const Conformal_metric& m) {
  constexpr double error = 0x1p-60; // 16 of these units
  std::vector<Angle_interval> result;
  for (std::size_t row = 0; row < m.u.size(); ++row) {
    const long double factor = static_cast<long double>(m.scale_factors[row]) + m.scale_rests[row];
    const auto of_u =
        static_cast<double>(std::exp(static_cast<long double>(m.u[row]) / 2) / factor - 1);
    const auto of_factor = static_cast<double>(-m.scale_rests[row] / factor);
    result.emplace_back(std::min({0., of_u, of_factor}) - error,
                        std::max({0., of_u, of_factor}) + error);
  }
  return result;
}

// Changes sides and surpluses as factors of corners are changed by `deviation`, of each row.
// Corners at one row change together: in the tip of a thin cone, where an edge is a loop, hardly
// anything does.
static void stretch(const std::array<std::uint32_t, 3>& rows,
                    const std::vector<Angle_interval>& deviation,
                    std::array<Angle_interval, 3>& sides, std::array<Angle_interval, 3>& surplus) {
  std::array<Angle_interval, 3> first, second; // of side k, from corner k to the next one
  for (std::size_t k = 0; k < 3; ++k) {
    const Angle_interval &a = deviation[rows[k]], &b = deviation[rows[(k + 1) % 3]];
    first[k] = sides[k] * (a + b);
    second[k] = sides[k] * (a * b);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<std::size_t, 3> corner{k, (k + 1) % 3, (k + 2) % 3};
    const Angle_interval &side = sides[k], &next = sides[corner[1]], &last = sides[corner[2]];
    std::array<Angle_interval, 3> by{last - side, next - side, next + last};
    for (const auto& [i, j] : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {1, 2}})
      if (rows[corner[i]] == rows[corner[j]]) {
        by[j] += by[i];
        by[i] = 0;
      }
    for (std::size_t i = 0; i < 3; ++i) surplus[k] += by[i] * deviation[rows[corner[i]]];
    surplus[k] += second[corner[1]] + second[corner[2]] - second[k];
  }
  for (std::size_t k = 0; k < 3; ++k) sides[k] += first[k] + second[k];
}

std::optional<double> proven_residual(const Ideal_surface& surface, const Conformal_metric& metric,
                                      const Prescribed_angles& angles, Geometry geometry) {
  const std::vector<Angle_interval> deviation = deviations(metric);
  const Protect_FPU_rounding<true> upwards(CGAL_FE_UPWARD);
  const std::optional<std::vector<Enclosed_ideal_face>> faces = surface.enclosures();
  if (!faces) return std::nullopt;
  const std::vector<std::uint32_t>& rows = surface.row_of_vertex();
  std::vector<Angle_interval> sum(angles.size(), 0); // on all sheets
  std::vector<char> has_faces(angles.size(), 0);
  const double unit = std::ldexp(1., -surface.scale_exponent());
  for (Enclosed_ideal_face f : *faces) {
    stretch({rows[f.vertices[0]], rows[f.vertices[1]], rows[f.vertices[2]]}, deviation, f.lambda,
            f.surplus);
    std::array<Angle_interval, 3> sides, surplus; // opposite the corners
    for (std::size_t k = 0; k < 3; ++k) {
      sides[k] = f.lambda[(k + 1) % 3] * unit;
      surplus[k] = f.surplus[(k + 1) % 3] * unit;
    }
    const std::array<Angle_interval, 3> angle = geometry == Geometry::hyperbolic
                                                    ? enclosed_hyperbolic_angles(sides, surplus)
                                                    : enclosed_angles(sides, surplus);
    for (std::size_t k = 0; k < 3; ++k) {
      sum[rows[f.vertices[k]]] += angle[k];
      has_faces[rows[f.vertices[k]]] = 1;
    }
  }
  double largest = 0;
  for (std::size_t row = 0; row < angles.size(); ++row) {
    if (has_faces[row] == 0 || angles.is_free(row)) continue;
    const Angle_interval error =
        sum[row] / static_cast<double>(surface.sheets()) - prescribed(angles, row);
    largest = std::max({largest, error.sup(), -error.inf()});
  }
  return largest;
}

} // namespace CGAL::Intrinsic_triangulations::internal
