// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/triangle_angles.h>

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// With the sides divided by half of their sum, x_k = 1 - a_k and the radius r of the incircle is
// sqrt(x_0 x_1 x_2).
struct Incircle {
  double half;
  std::array<double, 3> x;
  double r;

  Incircle(const std::array<double, 3>& sides, const std::array<double, 3>& surplus)
      : half((sides[0] + sides[1] + sides[2]) / 2) {
    // In an ideal Delaunay triangulation all x are positive; rounding may lose that.
    // 2^-60 is below rounding of these parts of 1, and its cube is far above the least double.
    constexpr double least = 0x1p-60;
    for (std::size_t k = 0; k < 3; ++k) x[k] = std::max(surplus[k] / (2 * half), least);
    r = std::sqrt(x[0] * x[1] * x[2]);
  }
  // 2 r times the cotangent of the angle opposite side k
  double cotangent(std::size_t k) const { return x[k] - x[(k + 1) % 3] * x[(k + 2) % 3]; }
};

} // namespace

// tan(angle_k / 2) = r / x_k, and cot(angle_k) = (x_k - x_i x_j) / (2 r).
Triangle_angles euclidean_angles(const std::array<double, 3>& sides,
                                 const std::array<double, 3>& surplus) {
  const Incircle t(sides, surplus);
  Triangle_angles result{};
  for (std::size_t k = 0; k < 3; ++k) {
    result.angle[k] = 2 * std::atan2(t.r, t.x[k]);
    result.weight[k] = t.cotangent(k) / (4 * t.r);
  }
  return result;
}

// The second derivative of the energy is the sum of
//
//     tan(d) ((du_i - du_j)^2 + tanh^2(l/2) (du_i + du_j)^2) / 2
//
// over the sides of triangles, where d is the angle between the side and the radius to its end of
// the circumcircle (Bobenko, Pinkall, Springborn 2015, §6). The Euclidean triangle with sides
// lambda has the same circumcircle in the plane through its corners in the hyperboloid model, of
// radius sinh R there, and the angle A opposite the side: tan(d) = cot(A) / cosh(R).
Triangle_angles hyperbolic_angles(const std::array<double, 3>& lambda,
                                  const std::array<double, 3>& surplus) {
  const Incircle t(lambda, surplus);
  std::array<double, 3> s, x;
  double product = t.half; // sides are up to 2 times half of their sum
  for (std::size_t k = 0; k < 3; ++k) {
    s[k] = lambda[k] / 2;
    x[k] = surplus[k] / 2;
    product *= lambda[k] / t.half;
  }
  const double least = 0x1p-60 * t.half;
  const std::array<double, 3> squares =
      squared_half_tangents(s, x, [least](double y) { return std::max(y, least); });
  Triangle_angles result{};
  for (std::size_t k = 0; k < 3; ++k) {
    result.angle[k] = 2 * std::atan(std::sqrt(squares[k]));
    const double half_tangent = t.cotangent(k) / std::hypot(4 * t.r, product); // tan(d) / 2
    const double squared_cosh = 1 + s[k] * s[k], squared_tanh = s[k] * s[k] / squared_cosh;
    result.weight[k] = half_tangent / squared_cosh;
    result.excess[k] = 2 * half_tangent * squared_tanh;
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
