// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>

#include "delaunay.h"
#include "operator_test_meshes.h"

#include <CGAL/Intrinsic_operators/editing/Heat_flow.h>
#include <CGAL/Intrinsic_operators/editing/Surface_deformation.h>
#include <CGAL/Intrinsic_operators/editing/interpolate_harmonically.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_operators/parametrization/parametrize.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace operator_test;
using Vector = Eigen::VectorXd;
using Rows = std::vector<std::uint32_t>;

// the condition numbers of the systems below are under 1e4
constexpr double solve_error = 1e-11;

template <class T>
Rows border_rows(const T& t) {
  Rows rows;
  for (const auto h : halfedges(t.mesh()))
    if (CGAL::is_border(h, t.mesh())) rows.push_back(t.input_vertex(target(h, t.mesh())));
  return rows;
}

Vector at(const Rows& rows, const Vector& x) {
  return Vector::NullaryExpr(static_cast<Eigen::Index>(rows.size()),
                             [&](Eigen::Index i) { return x[rows[static_cast<std::size_t>(i)]]; });
}

template <class Function>
std::string message_of(Function f) {
  try {
    f();
  } catch (const std::exception& e) {
    return e.what();
  }
  return "no error";
}

TEST(Solve_with_fixed_values, of_the_border_of_a_flat_mesh_finds_the_linear_function) {
  const Shape s = rough_grid(9, 0.3, 0, 4); // any triangulation of the plane has it
  Vector linear(s.points.size());
  for (Eigen::Index i = 0; i < linear.size(); ++i)
    linear[i] =
        3 * s.points[static_cast<std::size_t>(i)][0] - 2 * s.points[static_cast<std::size_t>(i)][1];
  const auto expect_linear = [&](const auto& t) {
    const Matrix l = IT::cotangent_laplacian(t);
    const Rows border = border_rows(t);
    const Vector u =
        IT::solve_with_fixed_values(l, Vector::Zero(l.rows()), border, at(border, linear));
    EXPECT_LE((u - linear).cwiseAbs().maxCoeff(), solve_error);
    EXPECT_EQ(at(border, u), at(border, linear));
  };
  expect_linear(Exact(s.input()));
  expect_linear(Double(s.input()));
  expect_linear(delaunay<Exact>(s.input()));
}

template <class Correspondence, class Traits>
void expect_linear_on_refinement() {
  const Shape s = rough_grid(6, 0.3, 0, 7);
  IT::Intrinsic_triangulation<IT::Gluing_map, Traits, Correspondence> t(s.input());
  IT::delaunay_refine(t, IT::parameters::minimum_angle(28).maximum_edge_length(0.7));
  Eigen::MatrixX2d points(s.points.size(), 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = s.point(static_cast<std::uint32_t>(i)).head<2>();
  const Eigen::MatrixX2d all = IT::copy_to_intrinsic(t, points);
  const Rows border = border_rows(t);
  Eigen::MatrixX2d fixed(border.size(), 2);
  for (std::size_t i = 0; i < border.size(); ++i)
    fixed.row(static_cast<Eigen::Index>(i)) = all.row(border[i]);
  const Matrix l = IT::cotangent_laplacian(t);
  ASSERT_GT(l.rows(), points.rows());
  const Eigen::MatrixX2d u = // both coordinates at once
      IT::solve_with_fixed_values(l, Eigen::MatrixX2d::Zero(l.rows(), 2), border, fixed);
  EXPECT_LE((u - all).cwiseAbs().maxCoeff(), 1e-9) << "coordinates are harmonic";
}

TEST(Solve_with_fixed_values, lays_a_refined_flat_mesh_out_by_its_border_with_each_correspondence) {
  using Doubles = IT::Euclidean_traits<double>;
  expect_linear_on_refinement<IT::Integer_coordinates, IT::Exact_euclidean_traits>();
  expect_linear_on_refinement<IT::Explicit_crossings, IT::Exact_euclidean_traits>();
  expect_linear_on_refinement<IT::Signposts, IT::Exact_euclidean_traits>();
  expect_linear_on_refinement<IT::Integer_coordinates, Doubles>();
}

TEST(Solve_with_fixed_values, is_the_stationary_point_of_the_energy_under_constraints) {
  // independent: Lagrange multipliers, dense, with full pivoting
  const Matrix l = IT::cotangent_laplacian(Exact(rough_torus(6, 0.4, 3).input()));
  const Eigen::Index n = l.rows();
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::mt19937 random(seed);
    Rows rows = random_order(static_cast<std::size_t>(n), seed);
    rows.resize(1 + random() % 20);
    const auto m = static_cast<Eigen::Index>(rows.size());
    const Vector b = random_vector(n, seed + 100), values = random_vector(m, seed + 200);
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n + m, n + m);
    all.topLeftCorner(n, n) = Eigen::MatrixXd(l);
    for (Eigen::Index i = 0; i < m; ++i)
      all(n + i, rows[static_cast<std::size_t>(i)]) =
          all(rows[static_cast<std::size_t>(i)], n + i) = 1;
    Vector right(n + m);
    right << b, values;
    const Vector expected = Eigen::FullPivLU<Eigen::MatrixXd>(all).solve(right).head(n);
    const Vector u = IT::solve_with_fixed_values(l, b, rows, values);
    EXPECT_LE((u - expected).norm(), solve_error * expected.norm()) << seed;
    const Vector negative = IT::solve_with_fixed_values(Matrix(-l), -b, rows, values);
    EXPECT_LE((negative - expected).norm(), solve_error * expected.norm()) << seed;
  }
}

TEST(Solve_with_fixed_values, of_a_tetrahedron_is_the_mean_of_its_neighbours) {
  const Matrix l = IT::cotangent_laplacian(Exact(tetrahedron().input()));
  const Vector u = IT::solve_with_fixed_values(l, Vector::Zero(4), Rows{2, 0, 3, 0},
                                               Eigen::Vector4d(1, 2, 6, 2));
  EXPECT_EQ(u[0], 2);
  EXPECT_EQ(u[2], 1);
  EXPECT_EQ(u[3], 6);
  EXPECT_NEAR(u[1], 3, 1e-14);
}

TEST(Solve_with_fixed_values, may_fix_all_rows_or_none_of_a_definite_matrix) {
  const Exact t(rough_torus(6, 0.4, 3).input());
  const Matrix m = IT::galerkin_mass_matrix(t);
  const Vector x = random_vector(m.rows(), 5);
  Rows all(static_cast<std::size_t>(m.rows()));
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(IT::solve_with_fixed_values(m, Vector::Zero(m.rows()), all, x), x);
  const Vector y = IT::solve_with_fixed_values(m, m * x, Rows(), Vector());
  EXPECT_LE((y - x).norm(), solve_error * x.norm());
}

TEST(Solve_with_fixed_values, refuses_a_component_without_fixed_value_and_names_it) {
  Shape two = two_tetrahedra();
  two.points.push_back({0, 0, 20}); // isolated
  const Matrix l = IT::cotangent_laplacian(Exact(two.input()));
  const Vector zero = Vector::Zero(9);
  const auto solve = [&](const Rows& rows) {
    return message_of([&] {
      IT::solve_with_fixed_values(l, zero, rows,
                                  Vector::Ones(static_cast<Eigen::Index>(rows.size())));
    });
  };
  EXPECT_NE(solve({0, 8}).find("component of row 4"), std::string::npos) << solve({0, 8});
  EXPECT_NE(solve({5, 8}).find("component of row 0"), std::string::npos) << solve({5, 8});
  EXPECT_NE(solve({0, 5}).find("component of row 8"), std::string::npos) << solve({0, 5});
  EXPECT_EQ(solve({0, 5, 8}), "no error");
  EXPECT_THROW(IT::solve_with_fixed_values(l, zero, Rows{0}, Vector::Ones(1)),
               std::invalid_argument);
  // more fixed values than one leave no kernel, but a component in between may be cut off
  EXPECT_EQ(solve({0, 1, 2, 5, 8}), "no error");
}

TEST(Solve_with_fixed_values, refuses_a_matrix_whose_kernel_is_not_that_of_constants) {
  Eigen::MatrixXd a(3, 3); // rank two: the last row is the sum of the others
  a << 2, 1, 3, 1, 4, 5, 3, 5, 8;
  const Matrix sparse = a.sparseView();
  EXPECT_THROW(IT::solve_with_fixed_values(sparse, Vector::Ones(3), Rows(), Vector()),
               std::runtime_error);
  EXPECT_EQ(message_of([&] {
              IT::solve_with_fixed_values(sparse, Vector::Ones(3), Rows{1}, Vector::Ones(1));
            }),
            "no error");
}

TEST(Solve_with_fixed_values, refuses_what_makes_no_sense) {
  const Matrix l = IT::cotangent_laplacian(Exact(tetrahedron().input()));
  const Vector zero = Vector::Zero(4), one = Vector::Ones(1);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const auto&... arguments) {
    try {
      IT::solve_with_fixed_values(arguments...);
    } catch (const std::invalid_argument&) {
      return true;
    }
    return false;
  };
  EXPECT_TRUE(refused(l, Vector::Zero(3), Rows{0}, one)) << "size of b";
  EXPECT_TRUE(refused(l, zero, Rows{0}, Vector::Ones(2))) << "number of values";
  EXPECT_TRUE(refused(l, zero, Rows{0}, Eigen::MatrixXd::Ones(1, 2))) << "columns of values";
  EXPECT_TRUE(refused(l, zero, Rows{4}, one)) << "row";
  EXPECT_TRUE(refused(l, zero, Rows{1, 1}, Eigen::Vector2d(0, 1))) << "values that disagree";
  EXPECT_TRUE(refused(l, zero, Rows{0}, nan * one)) << "value";
  EXPECT_TRUE(refused(l, nan * zero, Rows{0}, one)) << "right side";
  EXPECT_TRUE(refused(Matrix(nan * l), zero, Rows{0}, one)) << "matrix";
  EXPECT_TRUE(refused(Matrix(l.triangularView<Eigen::Lower>()), zero, Rows{0}, one)) << "symmetry";
  EXPECT_TRUE(refused(Matrix(l.leftCols(3)), zero, Rows{0}, one)) << "square";
  EXPECT_FALSE(refused(l, zero, Rows{0}, one));
}

/// The Laplacian of springs in a row.
Matrix chain(const std::vector<double>& weights) {
  const auto n = static_cast<int>(weights.size()) + 1;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i + 1 < n; ++i) {
    const double w = weights[static_cast<std::size_t>(i)];
    entries.insert(entries.end(), {{i, i, w}, {i + 1, i + 1, w}, {i, i + 1, -w}, {i + 1, i, -w}});
  }
  Matrix l(n, n);
  l.setFromTriplets(entries.begin(), entries.end());
  return l;
}

/// Values of a chain whose ends have the values 0 and 1.
Vector between_ends(const Matrix& a) {
  const Rows ends{0, static_cast<std::uint32_t>(a.rows() - 1)};
  return IT::solve_with_fixed_values(a, Vector::Zero(a.rows()), ends, Eigen::Vector2d(0, 1));
}

/// Each spring is stretched by 1 / stiffness.
TEST(Solve_with_fixed_values, is_exact_where_weights_differ_by_many_powers_of_ten) {
  std::vector<double> weights, stretched{0};
  for (int i = 0; i < 59; ++i) {
    weights.push_back(std::pow(10., (i * 37) % 41 - 20));
    stretched.push_back(stretched.back() + 1 / weights.back());
  }
  const Vector x = between_ends(chain(weights));
  for (int i = 1; i < 59; ++i)
    EXPECT_NEAR(x[i] / (stretched[static_cast<std::size_t>(i)] / stretched.back()), 1, 1e-12) << i;
}

// A chain of equal springs, each mass except the first tied to zero by a weak one: all numbers are
// in the matrix exactly.
TEST(Solve_with_fixed_values, weak_diagonals_beside_strong_weights_count) {
  const int n = 301;
  const double strong = 0x1p49, weak = 10, tie = 100;
  std::vector<double> weights(n - 1, strong);
  weights[0] = tie;
  Matrix a = chain(weights);
  for (int i = 2; i < n; ++i) a.coeffRef(i, i) += weak;
  const Vector x =
      IT::solve_with_fixed_values(a, Vector::Zero(n), Rows{0}, Vector(Vector::Ones(1)));
  // the chain is stiff: tie (1 - x) = weak (n - 2) x
  EXPECT_NEAR(x[n - 1], tie / (tie + weak * (n - 2)), 1e-9);
}

TEST(Solve_with_fixed_values, values_reach_rows_by_weights_that_rounding_loses_beside_others) {
  const Vector x = between_ends(chain({1e-20, 1, 1e-20}));
  EXPECT_NEAR(x[1], 0.5, 1e-12);
  EXPECT_NEAR(x[2], 0.5, 1e-12);
}

TEST(Solve_with_fixed_values, definite_matrices_need_not_be_laplacians) {
  const double s = 1e14;
  Matrix a(2, 2);
  const std::vector<Eigen::Triplet<double>> entries{
      {0, 0, 1.3}, {0, 1, .7 * s}, {1, 0, .7 * s}, {1, 1, 1.1 * s * s}};
  a.setFromTriplets(entries.begin(), entries.end());
  // of the solution (1, 1 / s)
  const Eigen::MatrixXd b = Eigen::Vector2d(1.3 + .7, .7 * s + 1.1 * s);
  const Eigen::MatrixXd x = IT::solve_with_fixed_values(a, b, Rows{}, Eigen::MatrixXd(0, 1));
  EXPECT_NEAR(x(0, 0), 1, 1e-12);
  EXPECT_NEAR(x(1, 0) * s, 1, 1e-12);
}

// A factor is the oracle of iterations, in all problems that take a solver. Iterations have at least
// two levels with so many vertices.
TEST(Linear_solver, solves_every_problem_up_to_its_residual) {
  using enum IT::Linear_solver;
  const auto t = delaunay<Exact>(rough_grid(40, 0.3, 0.5, 7).input());
  const Eigen::Index n = IT::cotangent_laplacian(t).rows();
  const auto expect_equal = [](const char* problem, const auto& solve) {
    const Eigen::MatrixXd found = solve(iterative), expected = solve(direct);
    EXPECT_LE((found - expected).norm(), 1e-6 * expected.norm()) << problem;
    EXPECT_GT((found - expected).norm(), 0) << problem; // was another way
  };
  const Rows rows{0, 77, 1000};
  const Vector values = Eigen::Vector3d(1, 3, 2);
  expect_equal("harmonic map", [&](auto s) { return Eigen::MatrixXd(IT::harmonic_map(t, s)); });
  expect_equal("interpolation", [&](auto s) {
    return Eigen::MatrixXd(IT::interpolate_harmonically(t, rows, values, s));
  });
  Vector load = Vector::Zero(n);
  load[5] = 1;
  load[900] = -1;
  for (const double reaction : {0., 0.1})
    expect_equal("reaction and diffusion", [&](auto s) {
      return Eigen::MatrixXd(
          IT::solve_reaction_diffusion(t, {.diffusion = 1, .reaction = reaction}, load, s));
    });
  expect_equal("heat", [&](auto s) { return IT::Heat_flow(t, 5., s).step(load); });
  for (const auto energy : {IT::Deformation_energy::harmonic, IT::Deformation_energy::biharmonic})
    expect_equal("deformation", [&](auto s) {
      return IT::Surface_deformation(t, rows, energy, s).displacements(values);
    });
  expect_equal("least squares map",
               [&](auto s) { return Eigen::MatrixXd(IT::least_squares_conformal_map(t, s)); });
  auto copy = t;
  EXPECT_THROW(IT::parametrize(copy, IT::Map_method::spectral, iterative), std::invalid_argument);
  using Fixed = std::vector<std::pair<Exact::vertex_descriptor, std::complex<double>>>;
  for (const Fixed& fixed : {Fixed{}, Fixed{{*vertices(t.mesh()).begin(), {1, 0}}}})
    expect_equal("directions", [&](auto s) {
      const auto f = IT::smoothest_direction_field(t, 4, fixed, s).powers;
      Eigen::MatrixXd result(static_cast<Eigen::Index>(f.size()), 2);
      for (std::size_t i = 0; i < f.size(); ++i)
        result.row(static_cast<Eigen::Index>(i)) << f[i].real(), f[i].imag();
      return result;
    });
}

TEST(Linear_solver, is_refused_for_the_square_of_the_laplacian) {
  const auto t = delaunay<Exact>(rough_grid(20, 0.3, 0.5, 7).input());
  EXPECT_NE(message_of([&] {
              IT::Surface_deformation(t, border_rows(t), IT::Deformation_energy::biharmonic,
                                      IT::Linear_solver::iterative);
            }).find("take a direct solver"),
            std::string::npos);
}

} // namespace
