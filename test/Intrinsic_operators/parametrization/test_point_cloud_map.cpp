// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/parametrization/point_cloud_map.h>

#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

// Conformal maps of points, against the stereographic projection: of a round cap it is the map of
// least distortion.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Complex = std::complex<double>;
using Point = std::array<double, 3>;

struct Cap {
  std::vector<Point> points;
  std::vector<Complex> projected;
};

/// Random points of a unit sphere up to an angle from a pole; with the angle 0, of the unit disk.
Cap random_cap(std::size_t n, double angle, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x(0, 1);
  Cap cap;
  while (cap.points.size() < n) {
    const double longitude = 2 * std::numbers::pi * x(random);
    const double z = angle > 0 ? 1 - (1 - std::cos(angle)) * x(random) : 0;
    const double r = angle > 0 ? std::sqrt(1 - z * z) : std::sqrt(x(random));
    cap.points.push_back({r * std::cos(longitude), r * std::sin(longitude), z});
    cap.projected.push_back(std::polar(r / (1 + z), longitude));
  }
  return cap;
}

/// The root of the mean squared distance after the similarity that fits best, by the extent.
double misfit(const Eigen::MatrixX2d& uv, const std::vector<Complex>& expected) {
  double best = std::numeric_limits<double>::infinity();
  for (const bool is_mirrored : {false, true}) {
    Eigen::VectorXcd w(uv.rows()), e(uv.rows());
    for (Eigen::Index i = 0; i < w.size(); ++i) {
      w[i] = Complex(uv(i, 0), is_mirrored ? -uv(i, 1) : uv(i, 1));
      e[i] = expected[static_cast<std::size_t>(i)];
    }
    w.array() -= w.mean();
    e.array() -= e.mean();
    const Complex factor = w.dot(e) / w.squaredNorm();
    best = std::min(best, (factor * w - e).norm() / e.norm());
  }
  return best;
}

TEST(Point_cloud_map, of_a_disk_is_the_disk) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Cap cap = random_cap(400, 0, seed);
    const Eigen::MatrixX2d uv = IT::conformal_map_of_points(cap.points);
    EXPECT_LE(misfit(uv, cap.projected), 1e-9) << seed; // an eigenvalue of zero, shifted by 1e-9
    // scaled to the area, turned so that a point of the border is on the axis
    const double size = std::abs(Complex(uv(0, 0) - uv(1, 0), uv(0, 1) - uv(1, 1)));
    EXPECT_NEAR(size, std::abs(cap.projected[0] - cap.projected[1]), 1e-9) << seed;
  }
}

TEST(Point_cloud_map, of_a_cap_is_the_stereographic_projection) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    EXPECT_LE(misfit(IT::conformal_map_of_points(random_cap(2000, 0.6, seed).points),
                     random_cap(2000, 0.6, seed).projected),
              0.02)
        << seed;
    EXPECT_LE(misfit(IT::conformal_map_of_points(random_cap(2000, 1.2, seed).points),
                     random_cap(2000, 1.2, seed).projected),
              0.04)
        << seed;
  }
}

TEST(Point_cloud_map, ends_when_the_visitor_says_so) {
  struct Visitor {
    std::size_t last;
    bool progress(std::size_t solutions) const { return solutions < last; }
  };
  const Cap cap = random_cap(100, 0.6, 1);
  for (const std::size_t last : {0U, 1U, 2U})
    EXPECT_EQ(
        IT::conformal_map_of_points(cap.points, 30, IT::parameters::visitor(Visitor{last})).rows(),
        0);
}

TEST(Point_cloud_map, refuses_what_is_no_disk) {
  std::mt19937 random(3);
  std::normal_distribution<double> x;
  std::vector<Point> sphere;
  while (sphere.size() < 400) {
    const Point p{x(random), x(random), x(random)};
    const double r = std::hypot(p[0], p[1], p[2]);
    sphere.push_back({p[0] / r, p[1] / r, p[2] / r});
  }
  EXPECT_THROW(IT::conformal_map_of_points(sphere), IT::Invalid_input);
  std::vector<Point> two = random_cap(100, 0, 1).points;
  for (std::size_t i = 0; i < 100; ++i) two.push_back({two[i][0] + 50, two[i][1], two[i][2]});
  EXPECT_THROW(IT::conformal_map_of_points(two), IT::Invalid_input);
}

} // namespace
