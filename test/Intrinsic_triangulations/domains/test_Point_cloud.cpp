// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>

#include "dense_eigenvalues.h"
#include "refusals.h"
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Exact = IT::Intrinsic_triangulation<>;
using Matrix = Eigen::SparseMatrix<double>;
using Points = std::vector<std::array<double, 3>>;

Points sphere(std::size_t n, double density_change = 1) {
  std::mt19937 random(11);
  std::normal_distribution<double> x;
  std::uniform_real_distribution<double> chance;
  Points points;
  while (points.size() < n) {
    std::array<double, 3> p{x(random), x(random), x(random)};
    const double r = std::hypot(p[0], p[1], p[2]);
    for (double& c : p) c /= r;
    if (p[2] < 0 || chance(random) * density_change < 1) points.push_back(p);
  }
  return points;
}

struct Operators {
  Matrix laplacian, mass;
};

Operators operators(IT::Point_cloud cloud, const std::string& what) {
  Exact t(std::move(cloud.input));
  IT::flip_to_delaunay(t);
  EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 0U) << what;
  EXPECT_EQ(t.metric().statistics().probable_zero, 0U) << what;
  Operators o{IT::cotangent_laplacian(t), IT::lumped_mass_matrix(t)};
  for (int c = 0; c < o.laplacian.cols(); ++c)
    for (Matrix::InnerIterator i(o.laplacian, c); i; ++i)
      EXPECT_TRUE(i.row() == c || i.value() <= 0) << what;
  return o;
}

// the least eigenvalues of L x = lambda M x, by inverse iteration of a subspace
Eigen::VectorXd eigenvalues(const Operators& o, int count) {
  const int n = static_cast<int>(o.laplacian.rows());
  const Eigen::SimplicialLDLT<Matrix> solver(o.laplacian + o.mass);
  Eigen::MatrixXd x(n, count + 10);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int j = 0; j < x.cols(); ++j)
    for (int i = 0; i < n; ++i) x(i, j) = normal(random);
  Eigen::VectorXd values;
  for (int round = 0; round < 40; ++round) {
    x = solver.solve(o.mass * x).eval();
    const Eigen::MatrixXd a = x.transpose() * (o.laplacian * x), b = x.transpose() * (o.mass * x);
    const Dense_eigenpairs<Eigen::MatrixXd> small = dense_eigenpairs(a, b);
    values = small.values;
    x = (x * small.vectors).eval();
  }
  return values.head(count);
}

// the largest relative error of the first five groups: l(l + 1), 2l + 1 times
double error_of_sphere(const Operators& o) {
  const Eigen::VectorXd found = eigenvalues(o, 36);
  EXPECT_NEAR(found[0], 0, 1e-9);
  double error = 0;
  int i = 1;
  for (int l = 1; l <= 5; ++l)
    for (int m = -l; m <= l; ++m, ++i)
      error = std::max(error, std::abs(found[i] / (l * (l + 1)) - 1));
  return error;
}

TEST(Point_cloud, of_a_sphere_is_closed_and_has_its_area) {
  IT::Point_cloud cloud = IT::make_point_cloud(sphere(3000));
  EXPECT_EQ(cloud.report.sheets, 6U);
  EXPECT_EQ(cloud.points.neighbours, 30U);
  EXPECT_EQ(cloud.points.points_without_triangles, 0U);
  EXPECT_EQ(cloud.points.duplicated_points, 0U);
  for (const char border : cloud.points.is_on_border) EXPECT_EQ(border, 0);
  const Operators o = operators(std::move(cloud), "sphere");
  EXPECT_NEAR(o.mass.sum(), 4 * M_PI, 0.02 * 4 * M_PI);
}

// Eigenvalues have errors of second order in distances, which is first order in the number of points: a quarter is left of
// those of a quarter as many. Half is required, since the points are random.
TEST(Point_cloud, has_eigenvalues_that_converge_to_those_of_a_sphere) {
  for (const double density_change : {1., 4.}) {
    const auto error = [&](std::size_t n) {
      return error_of_sphere(
          operators(IT::make_point_cloud(sphere(n, density_change)), "sphere of points"));
    };
    const double coarse = error(750), fine = error(3000);
    EXPECT_LT(fine, coarse / 2) << density_change;
    EXPECT_LT(fine, density_change > 1 ? 0.08 : 0.04);
  }
}

// Random points of a torus with circles of 1 and r, of even density.
Points thin_torus(std::size_t n, double r, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> turn(0, 2 * M_PI), chance(0, 1 + r);
  Points points;
  while (points.size() < n) {
    const double a = turn(random), b = turn(random), out = 1 + r * std::cos(b);
    if (chance(random) < out)
      points.push_back({out * std::cos(a), out * std::sin(a), r * std::sin(b)});
  }
  return points;
}

// Where a tube is thin, points of its other side are neighbours. Projected, they come before nearer
// points, and areas are 4 to 15 % too large for these radii. In their distances they do not: areas
// are 1.5 to 2.2 % too small, since triangles with random vertices are chords.
TEST(Point_cloud, of_a_thin_tube_does_not_join_its_sides) {
  std::mt19937 random(3);
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const double r = std::uniform_real_distribution<double>(0.06, 0.08)(random);
    const double area = 4 * M_PI * M_PI * r;
    IT::Point_cloud cloud = IT::make_point_cloud(thin_torus(2000, r, seed));
    EXPECT_NEAR(operators(std::move(cloud), "torus").mass.sum() / area, 1, 0.025)
        << "r " << r << ", seed " << seed;
  }
}

TEST(Point_cloud, of_a_noisy_square_has_a_border_and_its_area) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> x(0, 1);
  std::normal_distribution<double> noise(0, 1e-3);
  Points points;
  for (int i = 0; i < 2000; ++i) points.push_back({x(random), x(random), noise(random)});
  IT::Point_cloud cloud = IT::make_point_cloud(points, 20);
  std::size_t border = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const auto& p = points[v];
    if (cloud.points.is_on_border[v] == 0) continue;
    ++border;
    EXPECT_LT(std::min({p[0], p[1], 1 - p[0], 1 - p[1]}), 0.1) << "the border is there";
  }
  EXPECT_GT(border, 20U);
  const Operators o = operators(std::move(cloud), "square");
  EXPECT_NEAR(o.mass.sum(), 1, 0.05);
}

TEST(Point_cloud, takes_lattices_whose_squares_are_ties) {
  Points points;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 9; ++j) points.push_back({double(i), double(j), 0});
  const Operators o = operators(IT::make_point_cloud(points, 12), "lattice");
  EXPECT_GT(o.mass.sum(), 0);
}

TEST(Point_cloud, reports_duplicated_and_lonely_points) {
  Points points = sphere(200);
  points.push_back(points[17]);
  points.push_back(points[17]);
  points.push_back({0, 0, 9}); // far off, but it has neighbours
  IT::Point_cloud cloud = IT::make_point_cloud(points, 12);
  EXPECT_EQ(cloud.points.duplicated_points, 2U);
  const Operators o = operators(std::move(cloud), "duplicates");
  ASSERT_EQ(o.laplacian.rows(), 203);
  EXPECT_EQ(o.laplacian.coeff(200, 200), 0);
  EXPECT_EQ(o.mass.coeff(201, 201), 0);
  EXPECT_GT(o.laplacian.coeff(17, 17), 0);
}

TEST(Point_cloud, takes_any_number_of_neighbours_and_few_points) {
  const Points three{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  IT::Point_cloud cloud = IT::make_point_cloud(three, 1000);
  EXPECT_EQ(cloud.points.neighbours, 2U);
  EXPECT_EQ(cloud.points.triangles, 3U);
  const Operators o = operators(std::move(cloud), "three points");
  EXPECT_NEAR(o.mass.sum(), 0.5, 1e-12) << "three times the triangle, divided by three";
  EXPECT_NEAR(-o.laplacian.coeff(0, 1), 0.5, 1e-12) << "as of the tufted cover of the triangle";
  EXPECT_EQ(o.laplacian.coeff(1, 2), 0) << "a tie";
}

TEST(Point_cloud, does_not_depend_on_units_where_squares_overflow_or_vanish) {
  const Points points = sphere(300);
  const Matrix laplacian = operators(IT::make_point_cloud(points), "").laplacian;
  for (const int exponent : {-1000, -600, -200, 200, 600, 1020}) {
    Points scaled = points;
    for (auto& p : scaled)
      for (double& x : p) x = std::ldexp(x, exponent);
    const Matrix other = operators(IT::make_point_cloud(scaled), "scaled").laplacian;
    EXPECT_EQ(Matrix(laplacian - other).norm(), 0) << exponent;
  }
  const double most = std::numeric_limits<double>::max(), least = 5e-324;
  const Points extreme{{0, 0, least}, {most, 0, 0}, {-most, 0, 0}, {0, most, 0}, {0, least, 0}};
  EXPECT_GT(IT::make_point_cloud(extreme).points.triangles, 0U);
}

TEST(Point_cloud, refuses_what_is_no_surface) {
  const auto refusal = [](const Points& points, std::size_t neighbours) {
    return refusals::refusal([&] { IT::make_point_cloud(points, neighbours); });
  };
  EXPECT_NE(refusal({}, 30).find("0 points"), std::string::npos);
  EXPECT_NE(refusal({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}}, 30).find("triangle"),
            std::string::npos);
  EXPECT_NE(refusal({{1, 2, 3}, {1, 2, 3}}, 30).find("triangle"), std::string::npos);
  EXPECT_NE(refusal(sphere(50), 1).find("two neighbours"), std::string::npos);
  Points bad = sphere(50);
  bad[3][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(bad, 30).find("vertex 3"), std::string::npos);
}

} // namespace
