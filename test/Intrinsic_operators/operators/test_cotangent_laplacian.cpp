// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "delaunay.h"
#include "operator_test_meshes.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace operator_test;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/*
A weight of well-shaped faces is a handful of sums, products, a square root and a division, in intervals
whose ends are rounded outwards: some 20 roundings of which each cancels at most a few bits.
*/
constexpr double weight_error = 128 * epsilon;

Matrix delaunay_laplacian(IT::Intrinsic_input input) {
  return IT::cotangent_laplacian(delaunay<Exact>(std::move(input)));
}

Matrix laplacian(IT::Intrinsic_input input) {
  return IT::cotangent_laplacian(Exact(std::move(input)));
}

// the integral of |grad u|^2 from the gradients in space of u on each triangle
double dirichlet_energy(const Shape& s, const Eigen::VectorXd& u) {
  double energy = 0;
  for (const auto& [i, j, k] : s.triangles) {
    const Eigen::Vector3d a = s.point(j) - s.point(i), b = s.point(k) - s.point(i);
    const Eigen::Vector3d n = a.cross(b);
    const Eigen::Vector3d gradient =
        ((u[j] - u[i]) * b.cross(n) + (u[k] - u[i]) * n.cross(a)) / n.squaredNorm();
    energy += gradient.squaredNorm() * n.norm() / 2;
  }
  return energy;
}

TEST(Cotangent_laplacian, of_a_cube_is_the_graph_laplacian_of_its_twelve_edges) {
  const Matrix l = laplacian(cube().input());
  ASSERT_EQ(l.rows(), 8);
  EXPECT_EQ(l.nonZeros(), 8 + 2 * 12) << "diagonals of squares have weight zero and are left out";
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      const unsigned across = static_cast<unsigned>(i) ^ static_cast<unsigned>(j);
      const bool edge = across == 1 || across == 2 || across == 4;
      EXPECT_NEAR(l.coeff(i, j), i == j ? 3 : edge ? -1 : 0, weight_error);
    }
}

TEST(Cotangent_laplacian, of_a_lone_triangle_has_one_cotangent_per_edge) {
  const Matrix l = laplacian(Shape{{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 1, 2}}}.input());
  EXPECT_NEAR(l.coeff(0, 1), -0.5 * 3 / 4, weight_error);
  EXPECT_NEAR(l.coeff(0, 2), -0.5 * 4 / 3, weight_error);
  EXPECT_EQ(l.coeff(1, 2), 0) << "a right angle has cotangent zero";
}

/// The five point stencil of a grid, where vertex (x, y) has the number (n + 1) y + x in an order.
void expect_stencil(const Matrix& l, int n, const std::vector<std::uint32_t>& order) {
  const int row = n + 1;
  const auto number = [&](int x, int y) {
    return static_cast<int>(order[static_cast<std::size_t>(row * y + x)]);
  };
  EXPECT_EQ(l.nonZeros(), row * row + 4 * n * row);
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x < n; ++x) {
      const double expected = y == 0 || y == n ? -0.5 : -1;
      ASSERT_NEAR(l.coeff(number(x, y), number(x + 1, y)), expected, weight_error);
      ASSERT_NEAR(l.coeff(number(y, x), number(y, x + 1)), expected, weight_error);
    }
  EXPECT_NEAR(l.coeff(number(1, 1), number(1, 1)), 4, 4 * weight_error);
  EXPECT_NEAR(l.coeff(number(0, 0), number(0, 0)), 1, 2 * weight_error);
}

TEST(Cotangent_laplacian, of_a_square_grid_is_the_five_point_stencil_also_if_renumbered) {
  std::vector<std::uint32_t> same(49);
  std::iota(same.begin(), same.end(), 0U);
  expect_stencil(laplacian(grid(6).input()), 6, same);
  constexpr int n = 260; // 135200 faces; from 131073 on a bad order is improved
  const Shape s = grid(n);
  const auto order = random_order(s.points.size(), 15);
  const Double t(renumbered(s, order, 16).input());
  ASSERT_TRUE(t.report().renumbered);
  expect_stencil(IT::cotangent_laplacian(t), n, order);
}

TEST(Cotangent_laplacian, of_a_flat_torus_has_the_eigenvalues_of_its_grid_however_it_is_sheared) {
  for (const int n : {1, 2, 3, 5})
    for (const double shear : {0.0, 2.0, -7.0}) {
      const Matrix l = delaunay_laplacian(torus(static_cast<std::uint32_t>(n), shear));
      std::vector<double> expected;
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k)
          expected.push_back(4 - 2 * std::cos(2 * std::numbers::pi * j / n) -
                             2 * std::cos(2 * std::numbers::pi * k / n));
      std::sort(expected.begin(), expected.end());
      if (n == 1) expected = {0}; // loops only
      const Eigen::VectorXd actual = eigenvalues(l);
      // Weyl: eigenvalues move by at most the norm of the error; needles of shear 7 lose 2^6
      for (int i = 0; i < n * n; ++i)
        EXPECT_NEAR(actual[i], expected[static_cast<std::size_t>(i)], 8 * 64 * weight_error)
            << n << " " << shear;
    }
}

TEST(Cotangent_laplacian, is_the_sum_over_the_corners_of_every_delta_complex_of_the_gallery) {
  for (const gallery::Surface& s : gallery::oriented()) {
    const Matrix l = laplacian(input(s));
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(l.rows(), l.cols());
    for (std::uint32_t h = 0; h < s.gluing.origin.size(); ++h) {
      const std::uint32_t n = IT::Gluing::next(h), p = IT::Gluing::next(n);
      const auto& squared = s.squared_length_of_side;
      const double cosine =
          (squared[n] + squared[p] - squared[h]) / (2 * std::sqrt(squared[n] * squared[p]));
      const double weight = 0.5 / std::tan(std::acos(cosine));
      const auto i = s.gluing.origin[h], j = s.gluing.origin[n];
      if (i == j) continue;
      expected(i, j) -= weight;
      expected(j, i) -= weight;
      expected(i, i) += weight;
      expected(j, j) += weight;
    }
    // up to ten weights per entry, each below 4
    EXPECT_LE((Eigen::MatrixXd(l) - expected).cwiseAbs().maxCoeff(), 40 * weight_error) << s;
    EXPECT_TRUE(is_symmetric_bit_by_bit(l)) << s;
  }
}

TEST(Cotangent_laplacian, is_symmetric_bit_by_bit_sorted_and_its_columns_sum_to_zero_in_order) {
  // on the torus two edges each join vertices: their weights are one entry
  for (const Matrix& l : {laplacian(rough_grid(12, 0.4, 0.7, 1).input()), laplacian(torus(2, 0))}) {
    EXPECT_TRUE(l.isCompressed());
    EXPECT_TRUE(is_symmetric_bit_by_bit(l));
    for (int c = 0; c < l.cols(); ++c) {
      double others = 0;
      Eigen::Index before = -1;
      for (Matrix::InnerIterator i(l, c); i; ++i) {
        EXPECT_LT(before, i.row());
        before = i.row();
        if (i.row() != c) others += i.value();
      }
      EXPECT_EQ(others, -l.coeff(c, c));
    }
    // in another order: one rounding per term, each below the largest partial sum
    const Eigen::VectorXd sums = l * Eigen::VectorXd::Ones(l.cols());
    const Eigen::VectorXd terms = l.cwiseAbs() * Eigen::VectorXd::Ones(l.cols());
    for (int c = 0; c < l.cols(); ++c) EXPECT_LE(std::abs(sums[c]), 16 * epsilon * terms[c]);
  }
}

TEST(Cotangent_laplacian, has_the_dirichlet_energy_as_its_quadratic_form) {
  const Shape s = rough_grid(20, 0.3, 0.5, 3);
  const Matrix l = laplacian(s.input());
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Eigen::VectorXd u = random_vector(l.rows(), seed);
    const double energy = dirichlet_energy(s, u);
    // all faces have angles over a degree: at most 2^12 of the relative error in each weight
    EXPECT_NEAR(u.dot(l * u), energy, 4096 * epsilon * energy);
  }
}

TEST(Cotangent_laplacian, loses_trace_and_dirichlet_energy_by_delaunay_flips) { // Rippa 1990
  const Shape s = rough_grid(16, 0.45, 1.5, 4);
  Exact t(s.input());
  const Matrix before = IT::cotangent_laplacian(t);
  ASSERT_GT(IT::flip_to_delaunay(t).flips, 0U);
  const Matrix after = IT::cotangent_laplacian(t);
  EXPECT_LT(after.diagonal().sum(), before.diagonal().sum());
  for (const unsigned seed : {5U, 6U, 7U}) {
    const Eigen::VectorXd u = random_vector(before.rows(), seed);
    EXPECT_LT(u.dot(after * u), u.dot(before * u));
  }
}

TEST(Cotangent_laplacian, has_no_negative_weight_after_exact_flips_of_a_closed_surface) {
  for (const Shape& s : {rough_torus(16, 0.9, 8), cube()}) {
    const Matrix l = delaunay_laplacian(s.input());
    for (int c = 0; c < l.cols(); ++c)
      for (Matrix::InnerIterator i(l, c); i; ++i) {
        if (i.row() == c) continue;
        EXPECT_LT(i.value(), 0) << "zeros are left out";
      }
  }
}

TEST(Cotangent_laplacian, has_a_negative_weight_where_a_border_edge_faces_an_obtuse_angle) {
  const Matrix l =
      delaunay_laplacian(Shape{{{0, 0, 0}, {6, 0, 0}, {2, 1, 0}}, {{0, 1, 2}}}.input());
  // cot = <a, b> / |a x b| for the sides at vertex 2, (-2, -1) and (4, -1)
  EXPECT_NEAR(l.coeff(0, 1), 0.5 * 7 / 6, weight_error);
}

TEST(Cotangent_laplacian, is_positive_semidefinite_on_bad_triangles_too) {
  const Shape s = rough_grid(10, 0.45, 2, 9);
  for (const Matrix& l : {laplacian(s.input()), delaunay_laplacian(s.input())}) {
    const Eigen::VectorXd values = eigenvalues(l);
    // the solver is backward stable: errors of n epsilon of the norm
    const double tolerance = static_cast<double>(l.rows()) * epsilon * values.maxCoeff();
    EXPECT_NEAR(values[0], 0, tolerance);
    EXPECT_GT(values[1], 100 * tolerance) << "constants are the whole kernel";
  }
}

TEST(Cotangent_laplacian, does_not_depend_on_the_order_of_flips_nor_on_the_choice_among_ties) {
  for (const Shape& s : {rough_grid(12, 0.45, 1, 10), grid(8), cube()}) {
    Exact t = delaunay<Exact>(s.input()), r(s.input());
    std::vector<Exact::edge_descriptor> reversed(edges(r.mesh()).begin(), edges(r.mesh()).end());
    std::reverse(reversed.begin(), reversed.end());
    IT::flip_to_delaunay(r, reversed);
    const Matrix one = IT::cotangent_laplacian(t);
    const Matrix two = IT::cotangent_laplacian(r);
    EXPECT_TRUE(same_pattern(one, two));
    EXPECT_LE(relative_difference(two, one), 1024 * epsilon); // ten flips deep, at worst
    for (const Exact::edge_descriptor e : edges(r.mesh())) {
      const Exact::halfedge_descriptor h = halfedge(e, r.mesh());
      if (r.flip_status(h) == IT::Move_status::done && r.delaunay_sign(h) == CGAL::ZERO)
        r.flip_edge(h);
    }
    const Matrix three = IT::cotangent_laplacian(r);
    EXPECT_TRUE(same_pattern(one, three));
    EXPECT_LE(relative_difference(three, one), 1024 * epsilon);
  }
}

/// The Laplacian and both mass matrices.
template <class Triangulation>
std::array<Matrix, 3> matrices(const Triangulation& t) {
  return {IT::cotangent_laplacian(t), IT::lumped_mass_matrix(t), IT::galerkin_mass_matrix(t)};
}

void expect_matrices(const std::array<Matrix, 3>& actual, const std::array<Matrix, 3>& expected,
                     const std::array<double, 3>& errors, const char* name) {
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(same_pattern(actual[i], expected[i])) << name << ' ' << i;
    EXPECT_LE(relative_difference(actual[i], expected[i]), errors[i]) << name << ' ' << i;
  }
}

// an area of a well-shaped face is some ten roundings, the sum over a vertex as many again
constexpr std::array<double, 3> few_roundings{1024 * epsilon, 64 * epsilon, 64 * epsilon};

TEST(Matrices, hold_the_sums_of_entries_also_of_many_in_a_row) {
  std::mt19937 random(9);
  for (const int size : {1, 2, 60}) {
    std::vector<IT::Symmetric_entry> entries; // row 0 has more than are sorted one by one
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
    dense.diagonal() = Eigen::VectorXd::LinSpaced(size, 1, 2);
    const Eigen::VectorXd diagonal = dense.diagonal();
    for (int k = 0; size > 1 && k < 400; ++k) {
      const int i = k % 3 == 0 ? 0 : static_cast<int>(random() % unsigned(size));
      const int j = (i + 1 + static_cast<int>(random() % unsigned(size - 1))) % size;
      entries.push_back({i, j, static_cast<double>(k)}); // sums are exact
      dense(i, j) += k;
      dense(j, i) += k;
    }
    const Eigen::SparseMatrix<double> m = IT::symmetric_matrix(entries, diagonal);
    EXPECT_EQ(Eigen::MatrixXd(m), dense);
    EXPECT_TRUE(m.isCompressed());
    for (int c = 0; c < size; ++c)
      for (int k = m.outerIndexPtr()[c] + 1; k < m.outerIndexPtr()[c + 1]; ++k)
        EXPECT_LT(m.innerIndexPtr()[k - 1], m.innerIndexPtr()[k]);
  }
}

TEST(Matrices, agree_across_mesh_types_and_arithmetics) {
  const Shape s = rough_grid(12, 0.4, 0.8, 11);
  const auto expected = matrices(delaunay<Exact>(s.input()));
  const auto check = [&](auto t, const char* name) {
    IT::flip_to_delaunay(t);
    expect_matrices(matrices(t), expected, few_roundings, name);
  };
  check(IT::Intrinsic_triangulation<Surface_mesh>(s.input()), "flipped in Surface_mesh");
  check(IT::Intrinsic_triangulation<Polyhedron_with_ids>(s.input()), "flipped in Polyhedron_3");
  check(IT::Intrinsic_triangulation<OpenMesh_triangles>(s.input()), "flipped in OpenMesh");
  check(Exact(mesh_of<Surface_mesh>(s)), "read from Surface_mesh");
  check(Exact(mesh_of<Polyhedron_with_ids>(s)), "read from Polyhedron_3");
  check(Exact(mesh_of<OpenMesh_triangles>(s)), "read from OpenMesh");
  check(Double(s.input()), "double");
  check(IT::Intrinsic_triangulation<OpenMesh_triangles, IT::Euclidean_traits<double>>(
            mesh_of<OpenMesh_triangles>(s)),
        "double in OpenMesh");
}

TEST(Matrices, are_permuted_with_the_vertices_of_the_input) {
  const Shape s = rough_grid(12, 0.4, 0.8, 12);
  const auto order = random_order(s.points.size(), 13);
  std::array<Matrix, 3> expected = matrices(delaunay<Exact>(s.input()));
  for (Matrix& m : expected) m = renumbered(m, order);
  expect_matrices(matrices(delaunay<Exact>(renumbered(s, order, 14).input())), expected,
                  few_roundings, "");
}

TEST(Matrices, of_a_surface_that_is_scaled_by_a_power_of_two_are_scaled_exactly) {
  Shape s = rough_grid(6, 0.4, 0.8, 17);
  std::array<Matrix, 3> expected = matrices(delaunay<Exact>(s.input()));
  expected[1] *= 0x1p+800;
  expected[2] *= 0x1p+800;
  for (auto& p : s.points)
    for (double& x : p) x *= 0x1p+400;
  expect_matrices(matrices(delaunay<Exact>(s.input())), expected, {0, 0, 0}, "");
}

TEST(Cotangent_laplacian, stores_zeros_on_the_diagonal_for_isolated_vertices) {
  Shape s = tetrahedron();
  s.points.insert(s.points.begin(), {7, 7, 7});
  for (auto& t : s.triangles)
    for (std::uint32_t& v : t) ++v;
  const Matrix l = laplacian(s.input());
  ASSERT_EQ(l.rows(), 5);
  EXPECT_EQ(l.nonZeros(), 1 + 16);
  EXPECT_EQ(l.coeff(0, 0), 0);
  EXPECT_NEAR(l.coeff(1, 1), std::sqrt(3.0), 3 * weight_error);
}

template <class Triangulation>
void expect_refusal_of_the_last_face(double height) {
  // the last face lies on the border, where no flip helps it
  const Shape s{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, height, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  Triangulation t(s.input());
  try {
    const Matrix l = IT::cotangent_laplacian(t);
    ADD_FAILURE() << "accepted " << height << ": " << l;
  } catch (const IT::Invalid_input& e) {
    EXPECT_EQ(e.kind(), IT::Element_kind::face);
    EXPECT_EQ(e.index(), 1U);
    EXPECT_NE(std::string(e.what()).find("face 1 "), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("mollification"), std::string::npos) << e.what();
  }
}

TEST(Cotangent_laplacian, refuses_a_face_without_area_or_whose_cotangents_overflow_by_name) {
  for (const double height : {0., -1e-315}) {
    expect_refusal_of_the_last_face<Exact>(height);
    expect_refusal_of_the_last_face<Double>(height);
  }
}

// A bipyramid over a regular polygon. With the chord c and the height h the angles opposite the
// edges at an apex have the cotangent (c / 2) / m, where m^2 = h^2 + cos^2(pi / n) is the height of
// a face.
Shape bipyramid(int n, double height) {
  Shape s;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    s.points.push_back({std::cos(angle), std::sin(angle), 0});
  }
  s.points.push_back({0, 0, height});
  s.points.push_back({0, 0, -height});
  for (int k = 0; k < n; ++k) {
    const auto i = static_cast<std::uint32_t>(k), j = static_cast<std::uint32_t>((k + 1) % n),
               apex = static_cast<std::uint32_t>(n);
    s.triangles.push_back({i, j, apex});
    s.triangles.push_back({j, i, apex + 1});
  }
  return s;
}

// Doubles know chords by the squares of sides, h^2, to u h^2: their cotangents are right to some u
// h^2 / c^2, and lost beyond 1.
TEST(Cotangent_laplacian, has_no_zero_row_of_a_vertex_with_thin_faces) {
  constexpr unsigned seed = 7;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> sides(50, 500);
  std::uniform_real_distribution<double> exponent(1, 8);
  int refused = 0;
  for (int k = 0; k < 30; ++k) {
    const int n = sides(random);
    const double height = std::pow(10, exponent(random));
    SCOPED_TRACE(testing::Message() << seed << ": " << n << " sides, height " << height);
    const Shape s = bipyramid(n, height);
    const double half = std::sin(std::numbers::pi / n), cosine = std::cos(std::numbers::pi / n);
    const double expected = n * half / std::hypot(height, cosine);
    const Exact exact(s.input());
    EXPECT_NEAR(IT::cotangent_laplacian(exact).coeff(n, n), expected, 1e-9 * expected);
    const double error = 16 * epsilon * height * height / (half * half);
    const Double rounded(s.input());
    try {
      EXPECT_NEAR(IT::cotangent_laplacian(rounded).coeff(n, n), expected, error * expected);
    } catch (const IT::Invalid_input& e) {
      ++refused;
      EXPECT_GT(error, 1);
      EXPECT_EQ(e.kind(), IT::Element_kind::vertex);
      EXPECT_GE(e.index(), static_cast<std::size_t>(n));
    }
  }
  EXPECT_GT(refused, 2);
}

TEST(Cotangent_laplacian, of_caps_is_finite_once_they_are_flipped_away) {
  // vertex 3 lies on the edge between two proper faces: a cap between them
  const Shape s{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {1, -1, 0}},
                {{0, 1, 2}, {1, 0, 3}, {0, 4, 3}, {4, 1, 3}}};
  EXPECT_THROW(laplacian(s.input()), IT::Invalid_input);
  const Matrix l = delaunay_laplacian(s.input());
  EXPECT_TRUE(l.coeffs().isFinite().all());
  const Eigen::VectorXd values = eigenvalues(l);
  EXPECT_GT(values[1], 0.1);
}

} // namespace
