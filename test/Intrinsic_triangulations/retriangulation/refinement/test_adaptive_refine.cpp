// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/adaptive_refine.h>

#include "meshes.h"
#include "properties.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_operators/operators/residual_indicators.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Status = IT::Status;
using subdivision_oracle::defect;
using subdivision_oracle::Exact;
using subdivision_oracle::input;
using subdivision_oracle::Rounded;
using Vector = Eigen::VectorXd;

/// Areas of the faces at input vertex 0, zero elsewhere: requires small faces there.
template <class T>
std::vector<double> areas_at_first_vertex(const T& t) {
  std::vector<double> x(t.numbers().face_capacity(t.mesh()), 0);
  for (const auto f : faces(t.mesh())) {
    auto h = halfedge(f, t.mesh());
    for (int k = 0; k < 3; ++k, h = next(h, t.mesh()))
      if (t.index(source(h, t.mesh())) == 0) x[t.index(f)] = t.area(f);
  }
  return x;
}

template <class T>
class Adaptive_refine : public testing::Test {};
using Triangulations = testing::Types<Exact, Rounded>;
TYPED_TEST_SUITE(Adaptive_refine, Triangulations);

TYPED_TEST(Adaptive_refine, Reaches_the_tolerance_where_it_is_asked_to_and_keeps_the_surface) {
  TypeParam t(input(meshes::sphere(2)));
  const double before = properties::total_area(t);
  std::size_t calls = 0;
  const auto result = IT::adaptive_refine(
      t,
      [&](TypeParam& s) {
        EXPECT_EQ(&s, &t);
        ++calls;
        return areas_at_first_vertex(s);
      },
      IT::parameters::tolerance(1e-6));
  EXPECT_EQ(result.status, Status::done);
  EXPECT_EQ(result.rounds.size(), calls);
  EXPECT_EQ(result.rounds.back().vertices, num_vertices(t.mesh()));
  EXPECT_LE(result.rounds.back().estimated_error, 1e-6);
  double sum = 0;
  for (const double x : areas_at_first_vertex(t)) sum += x * x;
  EXPECT_EQ(result.rounds.back().estimated_error, std::sqrt(sum));
  for (std::size_t i = 0; i + 1 < result.rounds.size(); ++i) {
    EXPECT_GT(result.rounds[i].estimated_error, 1e-6);
    EXPECT_LT(result.rounds[i].vertices, result.rounds[i + 1].vertices);
    EXPECT_GT(result.rounds[i].marked_faces, 0U);
  }
  // areas fall geometrically towards the vertex: a number of vertices logarithmic in the tolerance
  EXPECT_LE(num_vertices(t.mesh()), 66 + 12 * std::log2(1 / 1e-6));
  EXPECT_GE(IT::measure_quality(t).minimum_angle, 25 - 1e-9);
  EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 0U);
  EXPECT_NEAR(properties::total_area(t), before, 1e-12 * before);
  EXPECT_EQ(defect(t), "");
}

TYPED_TEST(Adaptive_refine, Stops_at_its_caps_and_when_it_is_told_to) {
  const auto ones = [](TypeParam& t) {
    return std::vector<double>(t.numbers().face_capacity(t.mesh()), 1);
  };
  TypeParam t(input(meshes::sphere(2)));
  const auto capped = IT::adaptive_refine(t, ones, IT::parameters::maximum_vertices(100));
  EXPECT_EQ(capped.status, Status::cap);
  EXPECT_EQ(num_vertices(t.mesh()), 100U);
  EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 0U);
  const auto rounds = IT::adaptive_refine(t, ones, IT::parameters::maximum_rounds(2));
  EXPECT_EQ(rounds.status, Status::cap);
  EXPECT_EQ(rounds.rounds.size(), 3U); // two of refinement
  struct Impatient : IT::Adaptive_refinement_visitor {
    std::size_t calls = 0;
    bool progress(const IT::Adaptive_refinement_round&) { return ++calls < 2; }
  } visitor;
  const auto cancelled = IT::adaptive_refine(t, ones, IT::parameters::visitor(std::ref(visitor)));
  EXPECT_EQ(cancelled.status, Status::cancelled);
  EXPECT_EQ(visitor.calls, 2U);
  const std::size_t n = num_vertices(t.mesh());
  EXPECT_EQ(IT::adaptive_refine(t, ones, IT::parameters::maximum_vertices(5)).status, Status::cap);
  EXPECT_EQ(num_vertices(t.mesh()), n);
}

TYPED_TEST(Adaptive_refine, Is_done_at_once_where_there_is_no_error) {
  TypeParam t(input(meshes::sphere(2)));
  const auto result = IT::adaptive_refine(
      t, [](TypeParam& s) { return std::vector<double>(num_faces(s.mesh()), 0); });
  EXPECT_EQ(result.status, Status::done);
  EXPECT_EQ(result.rounds.size(), 1U);
  EXPECT_EQ(result.rounds[0].marked_faces, 0U);
}

TYPED_TEST(Adaptive_refine, Refuses_options_and_errors_that_make_no_sense) {
  TypeParam t(input(meshes::sphere(1)));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto estimate = [&](double x) {
    return [x](TypeParam& s) { return std::vector<double>(num_faces(s.mesh()), x); };
  };
  EXPECT_THROW(IT::adaptive_refine(t, estimate(1), IT::parameters::tolerance(-1)),
               std::invalid_argument);
  EXPECT_THROW(IT::adaptive_refine(t, estimate(1), IT::parameters::tolerance(nan)),
               std::invalid_argument);
  EXPECT_THROW(IT::adaptive_refine(t, estimate(1), IT::parameters::bulk(0)), std::invalid_argument);
  EXPECT_THROW(IT::adaptive_refine(t, estimate(1), IT::parameters::minimum_angle(60)),
               std::invalid_argument);
  EXPECT_THROW(IT::adaptive_refine(t, estimate(nan)), std::invalid_argument);
  const auto too_few = [](TypeParam&) { return std::vector<double>(3, 1); };
  EXPECT_THROW(IT::adaptive_refine(t, too_few), std::invalid_argument);
}

// ---- problems

struct Measured {
  double vertices, error;
};

/// The exponent of error against vertices.
double rate(const Measured& coarse, const Measured& fine) {
  return std::log(fine.error / coarse.error) / std::log(fine.vertices / coarse.vertices);
}

/// The square [-1, 1]^2 without a quadrant, n cells per unit of length.
meshes::Mesh flat_l_shape(std::uint32_t n) {
  meshes::Mesh m;
  for (const auto& [x, y] : {std::array{-1., -1.}, {-1., 0.}, {0., -1.}}) {
    const meshes::Mesh square = meshes::grid(n, n, 1. / n, 1. / n);
    const auto offset = static_cast<std::uint32_t>(m.points.size());
    for (const auto& p : square.points) m.points.push_back({p[0] + x, p[1] + y, 0});
    for (const auto& t : square.triangles)
      m.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  return meshes::welded(m);
}

/// The integral of the hat function of each vertex.
template <class T>
Vector thirds_of_areas(const T& t) {
  Vector sum = Vector::Zero(static_cast<Eigen::Index>(t.number_of_vertices()));
  for (const auto f : faces(t.mesh()))
    for (const auto v : CGAL::vertices_around_face(halfedge(f, t.mesh()), t.mesh()))
      sum[t.input_vertex(v)] += t.area(f) / 3;
  return sum;
}

/// Solves -div grad u = 1, u = 0 on the border.
template <class T>
Vector solve_torsion(T& t) {
  const Eigen::SparseMatrix<double> l = IT::cotangent_laplacian(t);
  std::vector<std::uint32_t> fixed;
  for (const auto h : halfedges(t.mesh()))
    if (face(h, t.mesh()) == boost::graph_traits<typename T::Mesh>::null_face())
      fixed.push_back(t.input_vertex(source(h, t.mesh())));
  for (int v = 0; v < l.rows(); ++v) // numbers of removed vertices
    if (l.coeff(v, v) == 0) fixed.push_back(static_cast<std::uint32_t>(v));
  return IT::solve_with_fixed_values(l, thirds_of_areas(t), fixed,
                                     Vector::Zero(static_cast<Eigen::Index>(fixed.size())));
}

/// Of the torsion of the L shape: the energy of the solution is the integral of u, by Galerkin
/// orthogonality that of the error is the difference. 0.2140758036 is the known energy.
template <class T>
double torsion_error(const T& t, const Vector& u) {
  return std::sqrt(0.2140758036 - u.dot(thirds_of_areas(t)));
}

Measured adaptive_torsion(std::size_t cap, double& effectivity) {
  Rounded t(input(flat_l_shape(2)));
  Vector u;
  const auto result = IT::adaptive_refine(
      t,
      [&u](Rounded& s) {
        u = solve_torsion(s);
        return IT::residual_indicators(
            s, {}, u, Vector::Ones(u.size()), IT::Error_norm::energy,
            IT::parameters::border_condition(IT::Border_condition::values));
      },
      IT::parameters::minimum_angle(20).maximum_vertices(cap));
  EXPECT_EQ(result.status, Status::cap);
  const double error = torsion_error(t, u);
  effectivity = result.rounds.back().estimated_error / error;
  return {static_cast<double>(num_vertices(t.mesh())), error};
}

Measured uniform_torsion(std::uint32_t n) {
  Rounded t(input(flat_l_shape(n)));
  const Vector u = solve_torsion(t);
  return {static_cast<double>(num_vertices(t.mesh())), torsion_error(t, u)};
}

TEST(Adaptive_refine_problems, A_reentrant_corner_has_the_rate_of_smooth_solutions) {
  // u is r^(2/3) in the corner: the energy error of uniform meshes falls like h^(2/3), N^(-1/3); that
  // of the best meshes like N^(-1/2)
  double effectivity = 0;
  const Measured coarse = adaptive_torsion(1000, effectivity);
  const Measured fine = adaptive_torsion(16000, effectivity);
  EXPECT_NEAR(rate(coarse, fine), -0.5, 0.05);
  EXPECT_GE(effectivity, 1);
  EXPECT_LE(effectivity, 10);
  const Measured uniform_coarse = uniform_torsion(16), uniform_fine = uniform_torsion(64);
  EXPECT_GT(rate(uniform_coarse, uniform_fine), -0.42); // -1/3 in the end
  EXPECT_LT(fine.error, uniform_fine.error);
}

TEST(Adaptive_refine_problems, A_point_source_has_the_rate_of_smooth_solutions) {
  const auto solve = [](Rounded& t) {
    const Vector u = IT::harmonic_green_function(t, 0);
    const Vector f = Vector::Constant(u.size(), -1 / properties::total_area(t));
    return IT::residual_indicators(t, {}, u, f, IT::Error_norm::L2);
  };
  const auto adaptive = [&](std::size_t cap) {
    Rounded t(input(meshes::sphere(2)));
    const auto r = IT::adaptive_refine(t, solve, IT::parameters::maximum_vertices(cap));
    return Measured{static_cast<double>(cap), r.rounds.back().estimated_error};
  };
  const auto uniform = [&](unsigned levels) {
    meshes::Mesh m = meshes::sphere(2); // the same polyhedron
    for (unsigned i = 0; i < levels; ++i) m = meshes::subdivided(m);
    Rounded t(input(m));
    const std::vector<double> indicators = solve(t);
    const double error = std::sqrt(
        std::inner_product(indicators.begin(), indicators.end(), indicators.begin(), 0.0));
    return Measured{static_cast<double>(num_vertices(t.mesh())), error};
  };
  // L2: h^2, or N^-1, at best; uniformly h, as the source is not smooth
  EXPECT_NEAR(rate(adaptive(1000), adaptive(8000)), -1, 0.1);
  EXPECT_NEAR(rate(uniform(2), uniform(4)), -0.5, 0.1);
}

TEST(Adaptive_refine_problems, Both_arithmetics_refine_alike) {
  const auto run = [](auto t) {
    using T = decltype(t);
    return IT::adaptive_refine(
        t,
        [](T& s) {
          const Vector u = IT::short_time_heat_kernel(s, 3, 0.05);
          return IT::residual_indicators(s, {.diffusion = 0.05, .reaction = 1}, u,
                                         Vector::Zero(u.size()), IT::Error_norm::L2);
        },
        IT::parameters::maximum_vertices(3000).maximum_rounds(6));
  };
  const auto exact = run(Exact(input(meshes::potato(2, 5))));
  const auto rounded = run(Rounded(input(meshes::potato(2, 5))));
  ASSERT_EQ(exact.rounds.size(), rounded.rounds.size());
  for (std::size_t i = 0; i < exact.rounds.size(); ++i) {
    EXPECT_EQ(exact.rounds[i].vertices, rounded.rounds[i].vertices);
    EXPECT_EQ(exact.rounds[i].marked_faces, rounded.rounds[i].marked_faces);
    EXPECT_NEAR(exact.rounds[i].estimated_error, rounded.rounds[i].estimated_error,
                1e-9 * exact.rounds[i].estimated_error);
  }
}

} // namespace
