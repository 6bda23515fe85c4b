// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "delaunay.h"
#include "meshes.h"
#include "operator_test_meshes.h"

#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace {

using namespace operator_test;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
// an area of a well-shaped face is some ten roundings, the sum over a vertex as many again
constexpr double area_error = 64 * epsilon;

Matrix lumped(IT::Intrinsic_input input) { return IT::lumped_mass_matrix(Exact(std::move(input))); }
Matrix galerkin(IT::Intrinsic_input input) {
  return IT::galerkin_mass_matrix(Exact(std::move(input)));
}

double face_area(const Shape& s, const std::array<std::uint32_t, 3>& t) {
  return (s.point(t[1]) - s.point(t[0])).cross(s.point(t[2]) - s.point(t[0])).norm() / 2;
}

double total_area(const Shape& s) {
  double sum = 0;
  for (const auto& t : s.triangles) sum += face_area(s, t);
  return sum;
}

// the integral of u v by the rule of edge midpoints, which is exact for quadratic polynomials
double integral(const Shape& s, const Eigen::VectorXd& u, const Eigen::VectorXd& v) {
  double sum = 0;
  for (const auto& t : s.triangles)
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t i = t[k], j = t[(k + 1) % 3];
      sum += face_area(s, t) / 3 * ((u[i] + u[j]) / 2) * ((v[i] + v[j]) / 2);
    }
  return sum;
}

TEST(Mass_matrix, of_the_galerkin_kind_sums_local_matrices_over_the_faces_of_every_delta_complex) {
  for (const gallery::Surface& s : gallery::oriented()) {
    const Matrix g = galerkin(input(s)), l = lumped(input(s));
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(g.rows(), g.cols());
    Eigen::VectorXd expected_lumped = Eigen::VectorXd::Zero(g.rows());
    const auto& origin = s.gluing.origin;
    for (std::size_t f = 0; f < origin.size(); f += 3) {
      const double a = std::sqrt(s.squared_length_of_side[f]),
                   b = std::sqrt(s.squared_length_of_side[f + 1]),
                   c = std::sqrt(s.squared_length_of_side[f + 2]);
      const double area =
          std::sqrt((a + b + c) * (a + b - c) * (a - b + c) * (-a + b + c)) / 4; // Heron
      for (std::size_t i = f; i < f + 3; ++i) {
        expected_lumped[origin[i]] += area / 3;
        for (std::size_t j = f; j < f + 3; ++j)
          expected(origin[i], origin[j]) += area / (i == j ? 6 : 12);
      }
    }
    const double error = 4 * area_error * expected.sum();
    EXPECT_LE((Eigen::MatrixXd(g) - expected).cwiseAbs().maxCoeff(), error) << s;
    EXPECT_LE((Eigen::VectorXd(l.diagonal()) - expected_lumped).cwiseAbs().maxCoeff(), error) << s;
    EXPECT_TRUE(is_symmetric_bit_by_bit(g)) << s;
    EXPECT_EQ(l.nonZeros(), l.rows()) << s;
    EXPECT_EQ(g.nonZeros(), (expected.array() > 0).count() + s.expected.isolated_vertices) << s;
  }
}

TEST(Mass_matrix, has_the_area_of_the_surface_as_its_sum_before_and_after_flips) {
  const Shape s = rough_grid(14, 0.4, 0.8, 1);
  const double area = total_area(s);
  Exact t(s.input());
  for (int flipped = 0; flipped < 2; ++flipped) {
    EXPECT_NEAR(IT::lumped_mass_matrix(t).diagonal().sum(), area, area_error * area);
    EXPECT_NEAR(IT::galerkin_mass_matrix(t).sum(), area, area_error * area);
    IT::flip_to_delaunay(t);
  }
}

TEST(Mass_matrix, of_the_galerkin_kind_integrates_products_of_linear_functions_exactly) {
  const Shape s = rough_grid(14, 0.4, 0.8, 2);
  const Matrix m = galerkin(s.input());
  for (const unsigned seed : {3U, 4U, 5U}) {
    const Eigen::VectorXd u = random_vector(m.rows(), seed), v = random_vector(m.rows(), seed + 9);
    // |u|, |v| <= 1: errors are relative to the area
    EXPECT_NEAR(u.dot(m * v), integral(s, u, v), area_error * total_area(s));
  }
}

TEST(Mass_matrix, has_the_numbering_of_the_input_where_the_triangulation_is_renumbered) {
  const std::uint32_t n = 260, row = n + 1; // 135200 faces; from 131073 on a bad order is improved
  const Shape s = grid(n);
  const auto order = random_order(s.points.size(), 12);
  Double t(renumbered(s, order, 13).input());
  ASSERT_TRUE(t.report().renumbered);
  const Matrix l = IT::lumped_mass_matrix(t), g = IT::galerkin_mass_matrix(t);
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) {
      const auto i = static_cast<int>(order[row * y + x]);
      // six faces of area 1/2 inside, three on sides, one or two at corners
      const bool x_border = x == 0 || x == n, y_border = y == 0 || y == n;
      const int faces = x_border && y_border ? 1 + (x == y) : x_border || y_border ? 3 : 6;
      ASSERT_NEAR(l.coeff(i, i), faces / 6.0, area_error);
      ASSERT_NEAR(g.coeff(i, i), faces / 12.0, area_error);
      if (x == n) continue;
      const auto j = static_cast<int>(order[row * y + x + 1]);
      ASSERT_NEAR(g.coeff(i, j), (y_border ? 1 : 2) / 24.0, area_error);
    }
}

TEST(Mass_matrix, is_zero_at_isolated_vertices_and_takes_faces_without_area) {
  const Shape s{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {9, 9, 9}}, {{0, 1, 2}, {1, 0, 3}}};
  const Matrix l = lumped(s.input()), g = galerkin(s.input());
  for (const int i : {3, 4}) {
    EXPECT_EQ(l.coeff(i, i), 0);
    EXPECT_EQ(g.coeff(i, i), 0);
  }
  EXPECT_EQ(l.nonZeros(), 5) << "the diagonal is stored";
  EXPECT_NEAR(g.sum(), 2, area_error * 2);
}

/// Brute force: the part of a large square that is nearer to point i than to all others; its area,
/// and whether the square bounds it.
std::pair<double, bool> voronoi_cell(const std::vector<std::array<double, 3>>& points,
                                     std::size_t i) {
  constexpr double far = 1e4;
  using Point = std::array<double, 2>;
  std::vector<Point> cell{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
  const auto& p = points[i];
  for (const auto& q : points) {
    const double x = q[0] - p[0], y = q[1] - p[1];
    const double level = (q[0] * q[0] + q[1] * q[1] - p[0] * p[0] - p[1] * p[1]) / 2;
    if (x == 0 && y == 0) continue;
    const auto beyond = [&](const Point& c) { return x * c[0] + y * c[1] - level; };
    std::vector<Point> kept;
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const Point &a = cell[k], &b = cell[(k + 1) % cell.size()];
      const double s = beyond(a), t = beyond(b);
      if (s <= 0) kept.push_back(a);
      if ((s < 0 && t > 0) || (s > 0 && t < 0))
        kept.push_back({a[0] + s / (s - t) * (b[0] - a[0]), a[1] + s / (s - t) * (b[1] - a[1])});
    }
    cell = kept;
  }
  double area = 0;
  bool is_bounded_by_square = false;
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const Point &a = cell[k], &b = cell[(k + 1) % cell.size()];
    area += (a[0] * b[1] - a[1] * b[0]) / 2;
    is_bounded_by_square |= std::abs(a[0]) == far || std::abs(a[1]) == far;
  }
  return {area, is_bounded_by_square};
}

TEST(Mass_matrix, of_the_voronoi_dual_has_the_areas_of_cells) {
  int compared = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const meshes::Mesh m = meshes::random_planar(60, 50, seed);
    std::vector<char> is_on_border(m.points.size(), 0);
    const Exact t = delaunay<Exact>(m.input());
    for (const auto h : halfedges(t.mesh()))
      if (CGAL::is_border(h, t.mesh())) is_on_border[t.input_vertex(source(h, t.mesh()))] = 1;
    const Matrix mass = IT::voronoi_mass_matrix(t);
    for (std::size_t i = 0; i < m.points.size(); ++i) {
      if (is_on_border[i]) continue;
      const auto [area, is_cut] = voronoi_cell(m.points, i);
      if (is_cut) continue;
      const auto k = static_cast<Eigen::Index>(i);
      // corners of cells near the border are up to 1e4 away and rounded there
      EXPECT_NEAR(mass.coeff(k, k), area, 1e-8 * (1 + area)) << "seed " << seed << ' ' << i;
      ++compared;
    }
    EXPECT_NEAR(mass.sum(), lumped(m.input()).sum(), 1e-10 * mass.cwiseAbs().sum());
  }
  EXPECT_GT(compared, 300);
}

TEST(Mass_matrix, of_the_voronoi_dual_is_positive_on_delaunay_triangulations_without_border) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Exact t(meshes::potato(2, seed).input());
    const double area = lumped(meshes::potato(2, seed).input()).sum();
    EXPECT_NEAR(IT::voronoi_mass_matrix(t).sum(), area, 1e-11 * area);
    IT::flip_to_delaunay(t);
    const Matrix mass = IT::voronoi_mass_matrix(t);
    EXPECT_GT(mass.diagonal().minCoeff(), 0) << "seed " << seed;
    EXPECT_NEAR(mass.sum(), area, 1e-12 * area);
  }
}

} // namespace
