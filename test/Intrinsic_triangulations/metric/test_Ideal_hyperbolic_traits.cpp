// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>

#include "gallery.h"
#include "ideal_triangulations.h"
#include "meshes.h"
#include "properties.h"

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Q = CGAL::Gmpq;
template <class FT, class Correspondence = IT::No_correspondence>
using Ideal =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Ideal_hyperbolic_traits<FT>, Correspondence>;
using Rational = Ideal<Q>;

static_assert(IT::IntrinsicTriangulationTraits<IT::Ideal_hyperbolic_traits<double>>);
static_assert(Rational::Metric::is_exact && !Ideal<double>::Metric::is_exact);

using ideal::flip_at_random;
using ideal::random_factors;

// the edges of the ideal Delaunay tessellation: ends and lambda lengths
std::vector<std::tuple<std::uint32_t, std::uint32_t, Q>> tessellation(const Rational& t) {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, Q>> result;
  std::vector<char> is_tie(num_edges(t.mesh()), 0);
  for (const auto e : IT::check_delaunay(t).cocircular_edges) is_tie[t.index(e)] = 1;
  for (const auto e : edges(t.mesh())) {
    const auto [a, b] =
        std::minmax({t.input_vertex(source(e, t.mesh())), t.input_vertex(target(e, t.mesh()))});
    if (!is_tie[t.index(e)]) result.emplace_back(a, b, t.metric().lambda(t.index(e)));
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <class T>
std::vector<typename T::FT> lambdas(const T& t) {
  std::vector<typename T::FT> result;
  for (std::uint32_t e = 0; e < num_edges(t.mesh()); ++e) result.push_back(t.metric().lambda(e));
  return result;
}

std::vector<meshes::Mesh> samples() {
  return {meshes::potato(2, 1), meshes::rough_grid(5, 2), meshes::box(2, 2, 2)};
}

TEST(Ideal_hyperbolic_traits, five_flips_of_a_pentagon_swap_its_diagonals) {
  const meshes::Mesh m{{{0, 0, 0}, {3, 0, 0}, {4, 2, 1}, {1, 4, 0}, {-1, 2, 2}},
                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}};
  Rational t(m.input());
  const auto diagonals = properties::flippable_by_connectivity(t);
  ASSERT_EQ(diagonals.size(), 2U);
  const auto lambda = [&](int k) { return t.metric().lambda(diagonals[k].index / 2); };
  const std::array<Q, 2> before{lambda(0), lambda(1)};
  for (int n = 0; n < 5; ++n) ASSERT_EQ(t.flip_edge(diagonals[n % 2]), IT::Move_status::done);
  EXPECT_EQ(lambda(0), before[1]);
  EXPECT_EQ(lambda(1), before[0]);
}

TEST(Ideal_hyperbolic_traits, tessellation_does_not_depend_on_flips_before) {
  for (const meshes::Mesh& m : samples()) {
    Rational t(m.input());
    t.scale_vertices(random_factors(t.number_of_vertices(), 2, 1));
    Rational shuffled(t);
    IT::flip_to_delaunay(t);
    flip_at_random(shuffled, 40, 2);
    EXPECT_EQ(IT::flip_to_delaunay(shuffled).status, IT::Status::done);
    EXPECT_EQ(IT::check_delaunay(shuffled).non_delaunay_edges, 0U);
    EXPECT_TRUE(tessellation(shuffled) == tessellation(t));
  }
}

TEST(Ideal_hyperbolic_traits, factors_are_exact_and_replace_those_before) {
  for (const meshes::Mesh& m : samples()) {
    Rational t(m.input()), unscaled(m.input());
    const std::vector<double> w = random_factors(t.number_of_vertices(), 30, 3);
    t.scale_vertices(random_factors(t.number_of_vertices(), 9, 4));
    flip_at_random(t, 30, 5);
    t.scale_vertices(w);
    flip_at_random(unscaled, 30, 5);
    for (const auto e : edges(t.mesh()))
      EXPECT_EQ(t.metric().lambda(t.index(e)), unscaled.metric().lambda(t.index(e)) *
                                                   Q(w[t.input_vertex(source(e, t.mesh()))]) *
                                                   Q(w[t.input_vertex(target(e, t.mesh()))]));
    t.scale_vertices(std::vector<double>(w.size(), 1));
    EXPECT_EQ(lambdas(t), lambdas(unscaled));
  }
}

TEST(Ideal_hyperbolic_traits, doubles_and_intervals_agree_with_rationals) {
  for (const meshes::Mesh& m : {meshes::potato(2, 1), meshes::rough_grid(6, 2)}) {
    Rational exact(m.input());
    Ideal<double> doubles(m.input());
    Ideal<CGAL::Interval_nt<false>> intervals(m.input());
    for (const int powers : {0, 3, 20}) {
      const std::vector<double> w = random_factors(exact.number_of_vertices(), powers, 6);
      exact.scale_vertices(w);
      doubles.scale_vertices(w);
      intervals.scale_vertices(w);
      const std::uint64_t flips = IT::flip_to_delaunay(exact).flips;
      EXPECT_EQ(IT::flip_to_delaunay(doubles).flips, flips);
      EXPECT_EQ(IT::flip_to_delaunay(intervals).flips, flips);
      EXPECT_EQ(properties::connectivity(doubles), properties::connectivity(exact));
      EXPECT_EQ(properties::connectivity(intervals), properties::connectivity(exact));
      for (std::uint32_t e = 0; e < num_edges(exact.mesh()); ++e) {
        const double expected = exact.metric().approximate_lambda(e);
        EXPECT_NEAR(doubles.metric().approximate_lambda(e), expected, 1e-12 * expected);
        EXPECT_NEAR(intervals.metric().approximate_lambda(e), expected, 1e-9 * expected);
      }
    }
  }
}

TEST(Ideal_hyperbolic_traits, curves_are_crossed_as_in_the_euclidean_metric) {
  const meshes::Mesh m = meshes::rough_grid(6, 3);
  IT::Corresponding_triangulation euclidean(m.input());
  Ideal<double, IT::Integer_coordinates> integers(m.input());
  Ideal<double, IT::Explicit_crossings> crossings(m.input());
  for (int round = 0; round < 3; ++round)
    for (const auto h : properties::flippable_by_connectivity(euclidean))
      if (!euclidean.is_locally_delaunay(h)) {
        ASSERT_EQ(euclidean.flip_edge(h), IT::Move_status::done);
        ASSERT_EQ(integers.flip_edge(h), IT::Move_status::done);
        ASSERT_EQ(crossings.flip_edge(h), IT::Move_status::done);
      }
  for (std::uint32_t e = 0; e < num_edges(euclidean.mesh()); ++e) {
    const auto expected = euclidean.correspondence().normal_coordinate(e);
    EXPECT_EQ(integers.correspondence().normal_coordinate(e), expected);
    EXPECT_EQ(crossings.correspondence().normal_coordinate(e), expected);
  }
}

TEST(Ideal_hyperbolic_traits, euclidean_delaunay_triangulations_are_ideal_delaunay) {
  for (const meshes::Mesh& m : {meshes::potato(3, 1), meshes::rough_grid(8, 2)}) {
    IT::Intrinsic_triangulation<> euclidean(m.input());
    IT::flip_to_delaunay(euclidean);
    std::vector<double> squared;
    for (const auto e : edges(euclidean.mesh())) squared.push_back(euclidean.squared_length(e));
    Rational t{IT::Intrinsic_input(euclidean.mesh(), squared)};
    EXPECT_EQ(IT::flip_to_delaunay(t).flips, 0U);
  }
}

TEST(Ideal_hyperbolic_traits, ideal_delaunay_triangles_satisfy_the_triangle_inequality) {
  for (const meshes::Mesh& m : {meshes::potato(2, 1), meshes::box(2, 2, 2)}) { // closed ones
    Rational t(m.input());
    t.scale_vertices(random_factors(t.number_of_vertices(), 12, 7));
    IT::flip_to_delaunay(t);
    for (const auto f : faces(t.mesh())) {
      std::array<Q, 3> l;
      auto h = halfedge(f, t.mesh());
      for (Q& x : l) {
        x = t.metric().lambda(t.index(edge(h, t.mesh())));
        h = next(h, t.mesh());
      }
      std::sort(l.begin(), l.end());
      EXPECT_LT(l[2], l[0] + l[1]);
    }
  }
}

TEST(Ideal_hyperbolic_traits, work_on_delta_complexes) {
  for (const gallery::Surface& s : gallery::oriented()) {
    Ideal<Q, IT::Integer_coordinates> t(gallery::input(s));
    t.scale_vertices(random_factors(t.number_of_vertices(), 3, 8));
    EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done) << s;
    EXPECT_TRUE(IT::is_delaunay(t)) << s;
    IT::Gluing_map cells;
    EXPECT_GT(IT::delaunay_tessellation(t, cells).number_of_cells, 0U) << s;
  }
}

TEST(Ideal_hyperbolic_traits, flips_are_taken_back_exactly) {
  Ideal<double, IT::Integer_coordinates> t(meshes::potato(2, 4).input());
  t.scale_vertices(random_factors(t.number_of_vertices(), 4, 9));
  const auto before = lambdas(t);
  const auto h = properties::flippable_by_connectivity(t).at(7);
  {
    decltype(t)::Session session(t);
    const auto values = session.before_flip(h);
    ASSERT_EQ(session.flip_edge(h), IT::Move_status::done);
    session.undo_flip(h, values);
  }
  EXPECT_EQ(lambdas(t), before);
}

TEST(Ideal_hyperbolic_traits, lambdas_are_the_doubles_nearest_to_the_lengths) {
  std::mt19937 random(10);
  for (const double size : {1.0, 1e-140, 1e120})
    for (const double flatness : {1.0, 1e-9, 1e-170}) {
      meshes::Mesh m = meshes::potato(1, 5);
      std::uniform_real_distribution<double> x(-size, size);
      for (auto& p : m.points) p = {x(random), x(random) * flatness, x(random) * flatness};
      const Ideal<double> t(m.input());
      const IT::Input_metric& input = t.input().metric();
      for (const auto f : faces(t.mesh())) {
        auto h = halfedge(f, t.mesh());
        for (unsigned k = 0; k < 3; ++k, h = next(h, t.mesh())) {
          const double l = t.metric().lambda(t.index(edge(h, t.mesh())));
          const Q squared = input.squared_length<Q>(t.index(f), k);
          const auto middle = [l](double other) {
            return (Q(l) + Q(std::nextafter(l, other))) / 2;
          };
          EXPECT_LE(middle(0) * middle(0), squared);
          EXPECT_GE(middle(1e300) * middle(1e300), squared);
        }
      }
    }
}

std::string error_of(Ideal<double>& t, const std::vector<double>& factors) {
  try {
    t.scale_vertices(factors);
  } catch (const IT::Invalid_input& e) {
    return e.what();
  }
  return "";
}

TEST(Ideal_hyperbolic_traits, wrong_factors_are_refused_by_vertex) {
  Ideal<double> t(meshes::box(1, 1, 1).input());
  std::vector<double> w(t.number_of_vertices(), 2);
  EXPECT_EQ(error_of(t, w), "");
  const auto before = lambdas(t);
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
    w[5] = bad;
    EXPECT_NE(error_of(t, w).find("vertex 5 "), std::string::npos) << error_of(t, w);
  }
  w.pop_back();
  EXPECT_NE(error_of(t, w).find("pass one factor for each vertex"), std::string::npos);
  EXPECT_EQ(lambdas(t), before);
}

TEST(Ideal_hyperbolic_traits, edges_without_length_are_mollified_or_refused) {
  meshes::Mesh m = meshes::box(1, 1, 1);
  m.points[1] = m.points[0];
  const Ideal<double> t(m.input(IT::Mollification::automatic));
  EXPECT_EQ(t.report().mollification.kind, IT::Mollification::squared_lengths);
  EXPECT_THROW(Ideal<double>(m.input(IT::Mollification::none)), IT::Invalid_input);
}

} // namespace
