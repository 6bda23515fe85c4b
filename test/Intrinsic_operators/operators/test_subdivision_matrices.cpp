// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "dense_eigenvalues.h"
#include "transferred_meshes.h"

#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

namespace {

using namespace transferred;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
// Parameters of crossings are computed along strips, areas from them: each some ten roundings, on
// faces whose aspect ratio magnifies them.
constexpr double tolerance = 1e-11;

template <class P>
Matrix galerkin(const P& p, const Matrix& m) {
  return Matrix(p.transpose()) * m * Matrix(p);
}

void expect_mass_matrices(const Case& c) {
  const Matrix m = IT::subdivision_mass_matrix(c.triangulation, c.subdivision);
  const auto input = IT::interpolation_from_input(c.subdivision);
  const auto intrinsic = IT::interpolation_from_intrinsic(c.subdivision);
  const double area = c.input_mass.sum();
  EXPECT_NEAR(m.sum(), area, tolerance * area) << c.name;
  EXPECT_LE(Matrix(galerkin(input, m) - c.input_mass).norm(), tolerance * c.input_mass.norm())
      << c.name;
  const Matrix expected = IT::galerkin_mass_matrix(c.triangulation);
  EXPECT_LE(Matrix(galerkin(intrinsic, m) - expected).norm(), tolerance * expected.norm())
      << c.name;
}

TEST(Interpolation_matrices, have_rows_that_sum_to_one_and_at_most_three_entries) {
  for (const Case& c : all_cases())
    for (const auto& p : {IT::interpolation_from_input(c.subdivision),
                          IT::interpolation_from_intrinsic(c.subdivision)}) {
      ASSERT_EQ(p.rows(), static_cast<Eigen::Index>(c.subdivision.number_of_vertices()));
      const Eigen::VectorXd sums = p * Eigen::VectorXd::Ones(p.cols());
      EXPECT_LE((sums.array() - 1).abs().maxCoeff(), 4 * epsilon) << c.name;
      for (int row = 0; row < p.rows(); ++row) {
        EXPECT_LE(p.innerVector(row).nonZeros(), 3) << c.name;
        EXPECT_GE(p.innerVector(row).coeffs().minCoeff(), 0) << c.name;
      }
    }
}

TEST(Interpolation_matrices, take_classes_to_the_vertex_with_the_largest_weight) {
  IT::Interpolation_matrix p(3, 3);
  for (const auto& [row, column, weight] :
       {std::tuple{0, 2, 1.}, {1, 0, .25}, {1, 1, .75}, {2, 0, .5}, {2, 1, .5}})
    p.insert(row, column) = weight;
  const Eigen::Vector3d expected{7, 4, 9};
  EXPECT_EQ(IT::nearest_values(p, Eigen::Vector3d{9, 4, 7}), expected);
}

TEST(Interpolated_field, fits_the_number_of_values) {
  for (const Case& c : all_cases()) {
    const IT::Common_subdivision& s = c.subdivision;
    const std::vector<IT::Interpolation_matrix> matrices{IT::interpolation_from_input(s),
                                                         IT::interpolation_from_intrinsic(s)};
    for (const IT::Interpolation_matrix& p : matrices) {
      const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(p.cols(), 0, 1);
      const bool is_unique = matrices[0].cols() != matrices[1].cols();
      const Eigen::VectorXd linear = (is_unique ? p : matrices[1]) * values;
      const IT::Subdivision_field field = IT::interpolated_field("x", s, values);
      EXPECT_EQ(field.name, "x");
      EXPECT_TRUE(std::ranges::equal(field.values, linear)) << c.name;
      EXPECT_TRUE(IT::interpolated_field("x", p, values, true).has_classes);
      EXPECT_TRUE(std::ranges::equal(IT::interpolated_field("x", p, values, true).values,
                                     IT::nearest_values(p, values)))
          << c.name;
    }
  }
}

TEST(Interpolation_matrices, agree_on_functions_that_are_linear_in_the_plane) {
  for (const Case& c : all_cases()) {
    if (!c.is_planar()) continue;
    const Eigen::VectorXd f = c.values([](double x, double y) { return 1 + 2 * x - 3 * y; });
    const Eigen::VectorXd difference =
        IT::interpolation_from_intrinsic(c.subdivision) * c.inserted(f) -
        IT::interpolation_from_input(c.subdivision) * f;
    EXPECT_LE(difference.cwiseAbs().maxCoeff(), tolerance * f.cwiseAbs().maxCoeff()) << c.name;
  }
}

TEST(Subdivision_mass_matrix, gives_the_mass_matrices_of_both_triangulations) {
  for (const Case& c : all_cases()) expect_mass_matrices(c);
}

TEST(Subdivision_mass_matrix, gives_the_mass_matrices_of_both_triangulations_of_delta_complexes) {
  for (const gallery::Surface& s : gallery::oriented())
    for (const unsigned flips : {0U, 30U}) {
      if (s.gluing.origin.empty()) continue;
      expect_mass_matrices(Case(s.name, gallery::input(s), flips));
    }
}

TEST(Subdivision_mass_matrix,
     gives_the_mass_matrices_of_both_triangulations_with_exact_arithmetic) {
  const meshes::Mesh mesh = meshes::sheared_grid(6, 6, 7);
  using T = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                        IT::Integer_coordinates>;
  T t(mesh.input());
  const Matrix before = IT::galerkin_mass_matrix(t);
  IT::flip_to_delaunay(t);
  const IT::Common_subdivision s = IT::common_subdivision(t);
  const Matrix m = IT::subdivision_mass_matrix(t, s);
  EXPECT_LE(Matrix(galerkin(IT::interpolation_from_input(s), m) - before).norm(),
            tolerance * before.norm());
}

TEST(Subdivision_mass_matrix, is_symmetric_and_positive_semidefinite) {
  const Case c("rough grid", meshes::rough_grid(4, 3).input(), 60);
  const Matrix m = IT::subdivision_mass_matrix(c.triangulation, c.subdivision);
  EXPECT_EQ(Matrix(m - Matrix(m.transpose())).norm(), 0);
  const Eigen::MatrixXd dense = m;
  EXPECT_GE(dense_eigenvalues(dense)[0], -100 * epsilon * m.sum());
}

TEST(Subdivision_areas, are_those_of_the_polygons_in_space_and_sum_to_those_of_input_faces) {
  for (const Case& c : all_cases()) {
    const std::vector<double> areas = IT::subdivision_areas(c.triangulation, c.subdivision);
    std::vector<double> sums(c.input_areas.size(), 0);
    for (std::size_t f = 0; f < areas.size(); ++f) sums[c.subdivision.input_face[f]] += areas[f];
    for (std::size_t f = 0; f < sums.size(); ++f)
      EXPECT_NEAR(sums[f], c.input_areas[f], tolerance * c.input_mass.sum()) << c.name;
    if (c.points.empty()) continue;
    const auto points = IT::positions(c.subdivision, c.points);
    for (std::size_t f = 0; f < areas.size(); ++f) {
      Eigen::Vector3d twice(0, 0, 0);
      const auto corners = c.subdivision.face(f);
      const auto at = [&](std::size_t k) { return Eigen::Vector3d(points[corners[k]].data()); };
      for (std::size_t k = 2; k < corners.size(); ++k)
        twice += (at(k - 1) - at(0)).cross(at(k) - at(0));
      EXPECT_NEAR(areas[f], twice.norm() / 2, tolerance * c.input_mass.sum())
          << c.name << " face " << f;
    }
  }
}

} // namespace
