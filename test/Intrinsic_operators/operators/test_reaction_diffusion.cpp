// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>

#include "delaunay.h"
#include "operator_test_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

using namespace operator_test;
using Vector = Eigen::VectorXd;

// the condition numbers of the systems below are under 1e4
constexpr double solve_error = 1e-11;

TEST(Reaction_diffusion, satisfies_its_system_and_has_mean_zero_without_reaction) {
  const Exact t = delaunay<Exact>(rough_torus(12, 0.8, 7).input());
  const Matrix m = IT::galerkin_mass_matrix(t), l = IT::cotangent_laplacian(t);
  Vector load = random_vector(m.rows(), 1);
  load.array() -= load.mean();
  const Vector u = IT::solve_reaction_diffusion(t, {.diffusion = 3}, load);
  EXPECT_LE((3 * l * u - load).norm(), solve_error * load.norm());
  EXPECT_NEAR((m * u).sum(), 0, solve_error * m.sum() * u.cwiseAbs().maxCoeff());
  const Vector v = IT::solve_reaction_diffusion(t, {.diffusion = 3, .reaction = 0.5}, load);
  EXPECT_LE((3 * l * v + 0.5 * m * v - load).norm(), solve_error * load.norm());
}

TEST(Reaction_diffusion, is_zero_at_vertices_without_faces) {
  Shape s = tetrahedron();
  s.points.push_back({9, 9, 9});
  Exact t(s.input());
  const Vector u = IT::solve_reaction_diffusion(t, {.reaction = 1}, Vector::Ones(5));
  EXPECT_EQ(u[4], 0);
  EXPECT_GT(u[3], 0);
  Vector poles = Vector::Zero(5);
  poles[0] = 1;
  poles[1] = -1;
  EXPECT_EQ(IT::solve_reaction_diffusion(t, {}, poles)[4], 0);
}

TEST(Reaction_diffusion, does_not_mind_rows_of_removed_vertices) {
  Exact t(tetrahedron().input());
  const auto n = t.insert_vertex(halfedge(*faces(t.mesh()).begin(), t.mesh()), {0.25, 0.25, 0.5});
  ASSERT_EQ(n.status, IT::Move_status::done);
  ASSERT_EQ(t.remove_vertex(n.vertex), IT::Move_status::done);
  const int rows = IT::checked_matrix_size(t);
  Vector load = Vector::Zero(rows);
  load[0] = 1;
  load[1] = -1;
  const Vector u = IT::solve_reaction_diffusion(t, {}, load);
  EXPECT_LE((u - load * (std::sqrt(3.0) / 4)).norm(), 1e-14);
}

TEST(Reaction_diffusion, refuses_what_has_no_solution) {
  Exact t(tetrahedron().input());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector one = Vector::Ones(4), none = Vector::Zero(4);
  EXPECT_THROW(IT::solve_reaction_diffusion(t, {}, one), std::invalid_argument);
  EXPECT_THROW(IT::solve_reaction_diffusion(t, {}, Vector::Zero(3)), std::invalid_argument);
  for (const double x : {0., -1., nan})
    EXPECT_THROW(IT::solve_reaction_diffusion(t, {.diffusion = x}, none), std::invalid_argument);
  for (const double x : {-1., nan})
    EXPECT_THROW(IT::solve_reaction_diffusion(t, {.reaction = x}, none), std::invalid_argument);
  Exact pair(two_tetrahedra().input());
  EXPECT_THROW(IT::solve_reaction_diffusion(pair, {}, Vector::Zero(8)), std::invalid_argument);
  EXPECT_NO_THROW(IT::solve_reaction_diffusion(pair, {.reaction = 1}, Vector::Ones(8)));
}

} // namespace
