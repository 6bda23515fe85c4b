// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/vectors/Point_cloud_vectors.h>

#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

// Vectors on clouds of points, against closed forms in the plane and on the sphere.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Complex = std::complex<double>;
using Point = std::array<double, 3>;
using Vector = Eigen::Vector3d;
using Cloud = IT::Point_cloud_vectors;

Vector vector(const Point& p) { return Vector(p.data()); }
Point point(const Vector& v) { return {v[0], v[1], v[2]}; }

std::vector<Point> random_sphere(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> x;
  std::vector<Point> points;
  while (points.size() < n)
    points.push_back(point(Vector(x(random), x(random), x(random)).normalized()));
  return points;
}

/// A random square in a random plane, of any size.
std::vector<Point> random_square(std::size_t n, unsigned seed, double size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x(-1, 1);
  const Eigen::Quaterniond turn(x(random), x(random), x(random), x(random));
  std::vector<Point> points;
  while (points.size() < n)
    points.push_back(point(size * (turn.normalized() * Vector(x(random), x(random), 3))));
  return points;
}

TEST(Point_cloud_vectors, logarithms_in_a_plane_are_displacements) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const double size = std::pow(10., 60. * seed - 150);
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", size " << size);
    const std::vector<Point> points = random_square(300, seed, size);
    const Cloud cloud(points);
    EXPECT_EQ(cloud.seam_edges(), 0U);
    for (const std::size_t i : {0U, 117U}) {
      const std::vector<Complex> log = cloud.logarithmic_map(i);
      for (std::size_t j = 0; j < points.size(); ++j)
        // heat of a few units in the last place, over about thirty edges
        EXPECT_LE((vector(cloud.in_space(i, log[j])) - (vector(points[j]) - vector(points[i])))
                      .norm(),
                  1e-9 * size)
            << j;
    }
    // and transport leaves vectors as they are
    const IT::Tangent_field field = cloud.transport({{5, Complex(0.3, -2)}});
    const Vector start = vector(cloud.in_space(5, Complex(0.3, -2)));
    for (std::size_t j = 0; j < points.size(); ++j)
      EXPECT_LE((vector(cloud.in_space(j, field[j])) - start).norm(), 1e-7) << j;
  }
}

/// Two thousand points: the mean relative error of vectors and their lengths within 1.2 is below 3
/// %.
TEST(Point_cloud_vectors, logarithms_and_transport_on_a_sphere_are_near_closed_forms) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<Point> points = random_sphere(2000, seed);
    const Cloud cloud(points);
    const std::vector<Complex> log = cloud.logarithmic_map(0);
    const IT::Tangent_field field = cloud.transport({{0, 1}});
    const Vector p = vector(points[0]), start = vector(cloud.in_space(0, 1));
    double lengths = 0, vectors = 0, transport = 0;
    std::size_t count = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vector q = vector(points[i]), across = q - q.dot(p) * p;
      const double r = std::atan2(across.norm(), q.dot(p));
      EXPECT_GE(std::abs(log[i]), (q - p).norm() * (1 - 1e-14));
      if (r > 1.2) continue;
      ++count;
      lengths += std::abs(std::abs(log[i]) - r) / r;
      vectors += (vector(cloud.in_space(0, log[i])) - r * across.normalized()).norm() / r;
      const Vector expected = start - start.dot(q) / (1 + p.dot(q)) * (p + q);
      transport += (vector(cloud.in_space(i, field[i])) - expected).norm();
    }
    const auto n = static_cast<double>(count);
    EXPECT_LT(lengths / n, 0.02);
    EXPECT_LT(vectors / n, 0.03);
    EXPECT_LT(transport / n, 0.08);
  }
}

TEST(Point_cloud_vectors, extends_values_between_their_extremes_and_by_the_nearest_source) {
  const std::vector<Point> points = random_square(800, 4, 1);
  const Cloud cloud(points);
  const std::vector<double> values = cloud.extend_scalars({{0, -2}, {9, 5}});
  const double apart = (vector(points[0]) - vector(points[9])).norm();
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_GE(values[i], -2);
    EXPECT_LE(values[i], 5);
    const double first = (vector(points[i]) - vector(points[0])).norm(),
                 second = (vector(points[i]) - vector(points[9])).norm();
    if (std::abs(first - second) < 0.5 * apart) continue; // near the middle
    EXPECT_NEAR(values[i], first < second ? -2 : 5, 0.2) << i;
  }
  EXPECT_EQ(cloud.extend_scalars({{3, 1.5}}), std::vector<double>(points.size(), 1.5));
  EXPECT_THROW((void)cloud.extend_scalars({}), std::invalid_argument);
  EXPECT_THROW((void)cloud.extend_scalars({{800, 1}}), std::invalid_argument);
}

TEST(Point_cloud_vectors, does_not_depend_on_the_order_of_points) {
  const std::vector<Point> points = random_sphere(500, 9);
  std::vector<Point> reversed(points.rbegin(), points.rend());
  const Cloud cloud(points), other(reversed);
  const std::vector<Complex> log = cloud.logarithmic_map(3),
                             log_of_other = other.logarithmic_map(points.size() - 4);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LE((vector(cloud.in_space(3, log[i])) -
               vector(other.in_space(points.size() - 4, log_of_other[points.size() - 1 - i])))
                  .norm(),
              1e-9);
}

/// In the plane the smoothest field is constant.
TEST(Point_cloud_vectors, direction_fields_keep_what_is_fixed) {
  const std::vector<Point> points = random_square(300, 3, 1);
  const Cloud cloud(points);
  for (const int degree : {1, 4}) {
    const IT::Direction_field field = cloud.smoothest_direction_field(degree, {{7, {0, 2}}});
    const Vector start = vector(cloud.in_space(7, {0, 1}));
    for (std::size_t i = 0; i < points.size(); ++i) {
      double best = 2;
      for (int k = 0; k < degree; ++k)
        best = std::min(best,
                        (vector(cloud.in_space(i, field.directions(k)[i])) - start).norm());
      EXPECT_LE(best, 1e-6) << i;
    }
  }
}

TEST(Point_cloud_vectors, says_where_it_does_not_know) {
  std::vector<Point> points = random_sphere(200, 5);
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i)
    points.push_back({points[i][0] + 9, points[i][1], points[i][2]});
  points.push_back(points[4]); // at the place of another
  const Cloud cloud(points, 12);
  const std::vector<Complex> log = cloud.logarithmic_map(0);
  const IT::Tangent_field field = cloud.transport({{0, 1}});
  for (std::size_t i = 0; i < 2 * n; ++i) {
    EXPECT_EQ(std::isnan(log[i].real()), i >= n) << i;
    EXPECT_EQ(std::isnan(field[i].imag()), i >= n) << i;
  }
  // the last point is its twin
  EXPECT_EQ(log[2 * n], log[4]);
  EXPECT_EQ(field[2 * n], field[4]);
  EXPECT_EQ(cloud.logarithmic_map(2 * n)[1], cloud.logarithmic_map(4)[1]);
  EXPECT_THROW(cloud.logarithmic_map(2 * n + 1), std::invalid_argument);
  EXPECT_THROW(cloud.transport({}), std::invalid_argument);
  EXPECT_THROW(Cloud(points, 12, 0), std::invalid_argument);
}

/// The sheets of the surface of a cloud have no tangent plane in common.
TEST(Point_cloud_vectors, is_asked_for_where_a_cover_is_refused) {
  using Triangulation = IT::Intrinsic_triangulation<>;
  const Triangulation t(IT::make_point_cloud(random_sphere(100, 1)).input);
  EXPECT_THROW(IT::Vector_heat_method<Triangulation>{t}, std::invalid_argument);
  EXPECT_THROW(IT::smoothest_direction_field(t, 4), std::invalid_argument);
  EXPECT_THROW(IT::logarithmic_map(t, t.numbers().vertex_at(0)), std::invalid_argument);
}

} // namespace
