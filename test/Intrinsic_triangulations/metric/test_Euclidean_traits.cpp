// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "properties.h"
#include "refusals.h"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Lazy_exact_nt.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/metric/boost_float_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Float = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<100, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;
template <class FT>
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<FT>>;
using Exact = IT::Intrinsic_triangulation<>;

static_assert(Triangulation<CGAL::Gmpq>::Metric::is_exact);
static_assert(Triangulation<CORE::Expr>::Metric::is_exact);
static_assert(Triangulation<CGAL::Lazy_exact_nt<CORE::Expr>>::Metric::is_exact);
static_assert(!Triangulation<double>::Metric::is_exact);
static_assert(!Triangulation<Float>::Metric::is_exact);

// Weights of thin faces lose some digits against lengths, which are good to about 1e-14.
constexpr double tolerance = 1e-10;

template <class FT>
void expect_agreement(const meshes::Mesh& m) {
  Triangulation<FT> t(m.input());
  Exact expected(m.input());
  EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done);
  IT::flip_to_delaunay(expected);
  EXPECT_TRUE(IT::is_delaunay(t));
  properties::expect_same_tessellation(properties::tessellation(t),
                                       properties::tessellation(expected), tolerance);
  properties::expect_same_laplacian(properties::laplacian(t), properties::laplacian(expected),
                                    tolerance);
}

template <class FT>
class Euclidean_traits_of_inexact_types : public ::testing::Test {};
using Inexact = ::testing::Types<double, long double, Float, CGAL::Interval_nt<true>>;
TYPED_TEST_SUITE(Euclidean_traits_of_inexact_types, Inexact);

TYPED_TEST(Euclidean_traits_of_inexact_types, agree_with_exact_ones_away_from_ties) {
  expect_agreement<TypeParam>(meshes::rough_grid(8, 1));
  expect_agreement<TypeParam>(meshes::potato(3, 2));
  expect_agreement<TypeParam>(meshes::parabola_fan(9));
}

// Errors of rounding must not grow with the number of flips: areas that do not fit lengths any more
// make them grow exponentially. The longest edges are some ten times as long as before, the
// thinnest faces 1e-4 times as high as long: flips lose about 1e-16 / 1e-4 of a length.
TEST(Euclidean_traits,
     of_doubles_have_their_values_again_when_many_random_flips_are_taken_back_by_flips) {
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    Triangulation<double> t(meshes::potato(4, seed).input());
    const Triangulation<double> before(t);
    std::mt19937 random(seed);
    std::uniform_int_distribution<std::uint32_t> number(
        0, static_cast<std::uint32_t>(num_edges(t.mesh())) - 1);
    std::vector<Triangulation<double>::halfedge_descriptor> flipped;
    while (flipped.size() < 200 * num_edges(t.mesh())) {
      const auto h = t.numbers().halfedge_at(2 * number(random));
      if (t.flip_edge(h) == IT::Move_status::done) flipped.push_back(h);
    }
    for (; !flipped.empty(); flipped.pop_back())
      ASSERT_EQ(t.flip_edge(flipped.back()), IT::Move_status::done) << "seed " << seed;
    for (const auto e : edges(t.mesh()))
      ASSERT_NEAR(t.squared_length(e) / before.squared_length(e), 1, 1e-9) << "seed " << seed;
    const Triangulation<double>::Const_session session(t), first(before);
    for (const auto e : edges(t.mesh()))
      ASSERT_NEAR(session.cotangent_weight(e), first.cotangent_weight(e), 1e-9) << "seed " << seed;
  }
}

// Vertices on lines: rounding alone would make faces there.
TEST(Euclidean_traits, flips_in_doubles_are_possible_in_truth) {
  std::size_t flips = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    meshes::Mesh m =
        seed % 2 == 0 ? meshes::sheared_grid(6, 6, seed % 5) : meshes::grid(6, 6, 3, 7);
    for (meshes::Point& p : m.points) // a plane in space, whose lengths are rounded
      p = {0.1 * p[0] + 0.3 * p[1], 0.7 * p[0] - 0.2 * p[1], 1. / 3 * p[0] + 0.6 * p[1]};
    Triangulation<double> t(m.input());
    Exact exact(m.input());
    for (int i = 0; i < 400; ++i) { // errors grow with the length of edges
      const auto e = static_cast<std::uint32_t>(random() % num_edges(t.mesh()));
      if (t.flip_edge(t.numbers().halfedge_at(2 * e)) != IT::Move_status::done) continue;
      ++flips;
      ASSERT_EQ(exact.flip_edge(exact.numbers().halfedge_at(2 * e)), IT::Move_status::done) << i;
      // errors of lengths are some units of rounding, times that of the faces passed
      const double length = exact.length(edge(exact.numbers().halfedge_at(2 * e), exact.mesh()));
      ASSERT_NEAR(t.length(edge(t.numbers().halfedge_at(2 * e), t.mesh())) / length, 1, 1e-11);
    }
  }
  EXPECT_GT(flips, 10000U);
}

TEST(Euclidean_traits, of_rationals_are_exact_where_areas_are_rational) {
  expect_agreement<CGAL::Gmpq>(meshes::grid(4, 4, 3, 4));
  expect_agreement<CGAL::Gmpq>(meshes::sheared_grid(4, 5, 7));
  expect_agreement<CGAL::Gmpq>(meshes::box(2, 3, 4)); // right triangles, rational legs
  expect_agreement<CGAL::Gmpq>(meshes::folded_lattice(4, 6, 2));
  expect_agreement<CGAL::Gmpq>(meshes::random_planar(40, 8, 3));
  expect_agreement<CGAL::Gmpq>(meshes::with_cap(meshes::box(2, 1, 1), 4));
}

TEST(Euclidean_traits, of_rationals_name_the_face_whose_area_is_irrational) {
  refusals::expect_invalid([] { Triangulation<CGAL::Gmpq> t(meshes::potato(0, 1).input()); },
                           IT::Element_kind::face);
}

template <class FT>
class Euclidean_traits_of_algebraic_numbers : public ::testing::Test {};
using Algebraic = ::testing::Types<CORE::Expr, CGAL::Lazy_exact_nt<CORE::Expr>>;
TYPED_TEST_SUITE(Euclidean_traits_of_algebraic_numbers, Algebraic);

TYPED_TEST(Euclidean_traits_of_algebraic_numbers, are_exact_on_tiny_meshes) {
  expect_agreement<TypeParam>(meshes::box(1, 1, 1));
  expect_agreement<TypeParam>(meshes::integer_height_field(1, 9, 3));
  expect_agreement<TypeParam>(meshes::sheared_grid(2, 2, 1));
}

TEST(Euclidean_traits, of_intervals_refuse_to_guess_at_ties) {
  // right triangles: 4A = 2 sqrt(2) is not a double, so that zero stays an interval around it
  const meshes::Mesh m{{{0, 0, 0}, {1, 0, 1}, {1, 1, 1}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  Triangulation<CGAL::Interval_nt<true>> t(m.input());
  const auto h = properties::flippable_by_connectivity(t).at(0);
  t.flip_edge(h);
  EXPECT_THROW(t.delaunay_sign(h), CGAL::Uncertain_conversion_exception);
}

TEST(Euclidean_traits, a_flip_that_makes_no_area_is_refused_and_changes_nothing) {
  // two caps on the same edge, as rounding may make them
  const std::vector<double> lengths{1, 1, 4, 1, 1};
  IT::Euclidean_metric<double> flat(0, lengths, {0, 0});
  EXPECT_FALSE(flat.compute_flip({2, 0, 1, 3, 4, 0, 1}));
  EXPECT_EQ(flat.squared_length(2), 4);
  EXPECT_EQ(flat.quadruple_area(0), 0);
  EXPECT_EQ(flat.quadruple_area(1), 0);
}

} // namespace
