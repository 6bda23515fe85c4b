// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>

#include "gallery.h"
#include "ideal_triangulations.h"
#include "meshes.h"
#include "properties.h"

#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/certify_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using ideal::flip_at_random;
using ideal::random_factors;
template <class Correspondence = IT::No_correspondence>
using Exact =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_ideal_hyperbolic_traits, Correspondence>;
using Rational =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Ideal_hyperbolic_traits<CGAL::Gmpq>>;
using Inexact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Ideal_hyperbolic_traits<double>,
                                            IT::Integer_coordinates>;

static_assert(IT::IntrinsicTriangulationTraits<IT::Exact_ideal_hyperbolic_traits>);
static_assert(!IT::EuclideanMetric<IT::Exact_ideal_hyperbolic_metric>);

// decides from what it stores, without the input
template <class Metric>
concept Decides_alone = requires(const Metric& m, const IT::Diamond& d) {
  m.is_locally_delaunay(d);
};
static_assert(!Decides_alone<IT::Exact_ideal_hyperbolic_metric>);
static_assert(Decides_alone<IT::Ideal_hyperbolic_metric<double>>);

// the ends of the edges of the tessellation, sorted
template <class T>
std::vector<std::pair<std::uint32_t, std::uint32_t>> tessellation(const T& t) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  std::vector<char> is_tie(num_edges(t.mesh()), 0);
  for (const auto e : IT::check_delaunay(t).cocircular_edges) is_tie[t.index(e)] = 1;
  for (const auto e : edges(t.mesh()))
    if (!is_tie[t.index(e)])
      result.push_back(
          std::minmax({t.input_vertex(source(e, t.mesh())), t.input_vertex(target(e, t.mesh()))}));
  std::sort(result.begin(), result.end());
  return result;
}

template <class T>
void expect_lambdas(const T& t, const Rational& exact) {
  for (const auto e : edges(t.mesh())) {
    const double expected = exact.lambda(e);
    EXPECT_NEAR(t.lambda(e), expected, 1e-12 * expected);
    const typename T::Metric::Scope scope;
    const auto& i = t.metric().lambda(t.index(e));
    const CGAL::Gmpq& l = exact.metric().lambda(t.index(e));
    EXPECT_TRUE(CGAL::Gmpq(i.inf()) <= l && l <= CGAL::Gmpq(i.sup()));
  }
}

// Flips to Delaunay, and compares all decisions.
template <class T>
void flip_both(T& t, Rational& exact) {
  for (bool is_done = false; !is_done;) {
    is_done = true;
    for (const auto h : properties::flippable_by_connectivity(t)) {
      const CGAL::Sign s = exact.delaunay_sign(h);
      ASSERT_EQ(t.delaunay_sign(h), s);
      ASSERT_EQ(t.is_locally_delaunay(h), s != CGAL::NEGATIVE);
      if (s != CGAL::NEGATIVE) continue;
      ASSERT_EQ(t.flip_edge(h), IT::Move_status::done);
      ASSERT_EQ(exact.flip_edge(h), IT::Move_status::done);
      is_done = false;
    }
  }
}

template <class T>
void expect_agreement_with_rationals(const IT::Intrinsic_input& input, int powers) {
  T t(input);
  Rational exact(input);
  for (unsigned seed = 1; seed < 3; ++seed) {
    const std::vector<double> w = random_factors(t.number_of_vertices(), powers, seed);
    t.scale_vertices(w);
    exact.scale_vertices(w);
    flip_at_random(t, 20, seed);
    flip_at_random(exact, 20, seed);
    flip_both(t, exact);
    expect_lambdas(t, exact);
  }
}

TEST(Exact_ideal_hyperbolic_traits, agree_with_rationals) {
  for (const meshes::Mesh& m :
       {meshes::potato(2, 1), meshes::rough_grid(5, 2), meshes::box(3, 2, 2), meshes::grid(4, 5)})
    for (const int powers : {0, 4, 40}) {
      expect_agreement_with_rationals<Exact<>>(m.input(), powers);
      expect_agreement_with_rationals<Exact<IT::Integer_coordinates>>(m.input(), powers);
      expect_agreement_with_rationals<Exact<IT::Explicit_crossings>>(m.input(), powers);
    }
}

TEST(Exact_ideal_hyperbolic_traits, agree_with_rationals_on_delta_complexes) {
  for (const gallery::Surface& s : gallery::oriented())
    expect_agreement_with_rationals<Exact<>>(gallery::input(s), 5);
}

TEST(Exact_ideal_hyperbolic_traits, decide_symmetric_ties) {
  // factors keep the symmetry of each face of a box: ties across its diagonals
  Exact<IT::Integer_coordinates> t(meshes::grid(6, 6).input());
  t.scale_vertices(std::vector<double>(t.number_of_vertices(), 3));
  IT::flip_to_delaunay(t);
  const std::size_t ties = IT::check_delaunay(t).cocircular_edges.size();
  const IT::Delaunay_certificate c = IT::certify_delaunay(t);
  EXPECT_TRUE(c.is_delaunay());
  EXPECT_EQ(c.ties, ties);
  EXPECT_EQ(c.statistics.probable_zero, 0U);
}

// Factors over forty powers of ten; the start does not matter.
TEST(Exact_ideal_hyperbolic_traits, end_certified_after_huge_factors) {
  const meshes::Mesh m = meshes::potato(3, 6);
  const auto input = m.input();
  const std::vector<double> w = random_factors(m.points.size(), 66, 7);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
  for (unsigned seed = 0; seed < 3; ++seed) {
    Exact<IT::Integer_coordinates> t(input);
    flip_at_random(t, 200 * seed, seed);
    t.scale_vertices(w);
    EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done);
    EXPECT_TRUE(IT::certify_delaunay(t).is_delaunay());
    if (seed == 0) expected = tessellation(t);
    EXPECT_EQ(tessellation(t), expected);
  }
}

// The expression overflows in doubles, but not after a division by a power of two.
TEST(Exact_ideal_hyperbolic_traits, no_rational_numbers_for_factors_over_120_powers_of_ten) {
  const auto input = meshes::potato(3, 6).input();
  Exact<IT::Integer_coordinates> t(input);
  t.scale_vertices(random_factors(t.number_of_vertices(), 199, 7));
  EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done);
  EXPECT_GT(t.metric().statistics().escalations[53], 0U);
  EXPECT_EQ(t.metric().statistics().escalations[106], 0U);
  EXPECT_EQ(t.metric().statistics().integer, 0U);
  EXPECT_TRUE(IT::certify_delaunay(t).is_delaunay());
}

TEST(Exact_ideal_hyperbolic_traits, factors_of_1e300_do_not_spoil_decisions) {
  Exact<IT::Integer_coordinates> t(meshes::potato(1, 8).input());
  std::vector<double> w(t.number_of_vertices(), 1e-300);
  for (std::size_t v = 0; v < w.size(); v += 3) w[v] = 1e300;
  t.scale_vertices(w);
  EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done);
  EXPECT_TRUE(IT::certify_delaunay(t).is_delaunay());
}

TEST(Exact_ideal_hyperbolic_traits, certificate_finds_edges_that_are_not_delaunay) {
  Inexact t(meshes::potato(2, 9).input());
  t.scale_vertices(random_factors(t.number_of_vertices(), 3, 10));
  const std::size_t bad = IT::check_delaunay(t).non_delaunay_edges;
  EXPECT_GT(bad, 0U);
  EXPECT_EQ(IT::certify_delaunay(t).non_delaunay_edges, bad);
  IT::flip_to_delaunay(t);
  EXPECT_TRUE(IT::certify_delaunay(t).is_delaunay());
}

TEST(Exact_ideal_hyperbolic_traits, decide_near_ties_that_doubles_leave_open) {
  // rectangles, ties but for the rounding of their diagonals
  std::size_t missed = 0;
  for (int n = 1; n < 50; ++n) {
    const meshes::Mesh m = meshes::grid(1, 1, 0.1 * n, 1.3);
    Inexact rounded(m.input());
    IT::flip_to_delaunay(rounded);
    missed += IT::certify_delaunay(rounded).non_delaunay_edges;
    Exact<IT::Integer_coordinates> exact(m.input());
    IT::flip_to_delaunay(exact);
    EXPECT_TRUE(IT::certify_delaunay(exact).is_delaunay());
  }
  EXPECT_GT(missed, 0U);
}

TEST(Exact_ideal_hyperbolic_traits, repeat_few_flips_that_make_very_many_crossings) {
  // flips around a torus of one vertex: lambda lengths grow like Fibonacci numbers
  Exact<> t(gallery::input(gallery::one_vertex_torus()));
  Rational exact(gallery::input(gallery::one_vertex_torus()));
  for (std::uint32_t n = 0; n < 60; ++n) {
    ASSERT_EQ(t.flip_edge({2 * (n % 2)}), IT::Move_status::done);
    ASSERT_EQ(exact.flip_edge({2 * (n % 2)}), IT::Move_status::done);
  }
  expect_lambdas(t, exact);
  EXPECT_EQ(IT::flip_to_delaunay(t).flips, IT::flip_to_delaunay(exact).flips);
}

} // namespace
