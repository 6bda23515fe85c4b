// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "soups.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

// That solutions of a Poisson problem converge where three faces meet at an edge.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
namespace parameters = IT::parameters;
using meshes::Mesh;
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;

meshes::Point point_of(const Exact& t, Exact::vertex_descriptor v, const Mesh& m) {
  if (!t.is_inserted(v)) return m.points[t.input_vertex(v)];
  return IT::point_in_space(t, t.places()->location(t.index(v)), m.points);
}

struct Errors {
  double rows;
  double maximum, mean;
};

// On page k of the book: u = (a_k sin(pi x / 2) + cos(pi x)) cos(pi y), where the a_k sum to zero, so that what flows
// out of one page flows into the others (Kirchhoff's law); without flux through the borders y = 0 and y = 1.
// With the values of u given on the border x = 1.
Errors solve_poisson(const Mesh& m, double circumradius) {
  constexpr double pi = std::numbers::pi;
  constexpr std::array<double, 3> amplitude{1, 2, -3};
  Exact t(IT::make_domain(soups::soup(m)).input);
  IT::delaunay_refine(t, parameters::maximum_circumradius(circumradius));
  const auto n = static_cast<Eigen::Index>(t.number_of_vertices());
  Eigen::VectorXd u(n), f(n);
  std::vector<std::uint32_t> fixed;
  std::vector<double> values;
  for (const auto v : vertices(t.mesh())) {
    const std::uint32_t row = t.input_vertex(v);
    const meshes::Point at = point_of(t, v, m);
    const double x = std::hypot(at[0], at[2]), y = at[1];
    const auto page =
        static_cast<std::size_t>(std::lround((std::atan2(at[2], at[0]) / (2 * pi) + 1) * 3)) % 3;
    const double s = amplitude[page] * std::sin(pi * x / 2), c = std::cos(pi * x);
    u[row] = (s + c) * std::cos(pi * y);
    f[row] = pi * pi * (1.25 * s + 2 * c) * std::cos(pi * y);
    if (x > 1 - 1e-9 && std::ranges::count(fixed, row) == 0) {
      fixed.push_back(row);
      values.push_back(u[row]);
    }
  }
  const Eigen::SparseMatrix<double> mass = IT::galerkin_mass_matrix(t);
  const Eigen::VectorXd right = mass * f;
  const Eigen::VectorXd given =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  const Eigen::VectorXd e =
      IT::solve_with_fixed_values(IT::cotangent_laplacian(t), right, fixed, given) - u;
  return {static_cast<double>(n), e.lpNorm<Eigen::Infinity>(), std::sqrt(e.dot(mass * e))};
}

TEST(Poisson_on_covers, converges_at_second_order_where_three_faces_meet) {
  const Mesh m = soups::book();
  std::vector<Errors> errors;
  for (const double h : {0.2, 0.1, 0.05, 0.025, 0.0125}) errors.push_back(solve_poisson(m, h));
  // h^2 in the mean, and up to a logarithm at the worst vertex
  const auto order = [](double first, double last) {
    return std::log(first / last) / std::log(16);
  };
  EXPECT_GT(order(errors.front().mean, errors.back().mean), 1.9);
  EXPECT_GT(order(errors.front().maximum, errors.back().maximum), 1.7);
  for (std::size_t i = 1; i < errors.size(); ++i) {
    EXPECT_LT(errors[i].mean, errors[i - 1].mean / 3.5) << i;
    EXPECT_LT(errors[i].maximum, errors[i - 1].maximum / 2.5) << i;
    EXPECT_LT(errors[i].rows, 4.5 * errors[i - 1].rows) << i;
  }
}

} // namespace
