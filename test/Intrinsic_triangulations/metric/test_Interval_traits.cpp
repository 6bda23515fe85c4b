// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/metric/Interval_traits.h>

#include "meshes.h"
#include "properties.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/metric/boost_float_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Interval_traits>;
using Exact = IT::Intrinsic_triangulation<>;
using Float = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<100, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;
using Interval = CGAL::Interval_nt<false>;

static_assert(IT::IntrinsicTriangulationTraits<IT::Interval_traits>);
static_assert(!Triangulation::Metric::is_exact);

TEST(Interval_traits, agree_with_exact_ones_away_from_ties_and_leave_nothing_open) {
  for (const meshes::Mesh& m :
       {meshes::rough_grid(8, 1), meshes::potato(3, 2), meshes::parabola_fan(9)}) {
    Triangulation t(m.input());
    Exact expected(m.input());
    EXPECT_EQ(IT::flip_to_delaunay(t).flips, IT::flip_to_delaunay(expected).flips);
    EXPECT_EQ(t.metric().statistics().undecided, 0U);
    EXPECT_EQ(properties::connectivity(t), properties::connectivity(expected));
    properties::expect_same_laplacian(properties::laplacian(t), properties::laplacian(expected),
                                      1e-10);
  }
}

TEST(Interval_traits, enclose_the_values_that_flips_make) {
  const meshes::Mesh m = meshes::parabola_fan(12); // many flips one after another
  Triangulation t(m.input());
  IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<Float>> precise(m.input());
  ASSERT_EQ(IT::flip_to_delaunay(t).flips, 9U);
  IT::flip_to_delaunay(precise);
  const auto contains = [](const Interval& i, const Float& x) {
    return Float(i.inf()) <= x && x <= Float(i.sup());
  };
  for (std::uint32_t e = 0; e < num_edges(t.mesh()); ++e)
    EXPECT_TRUE(contains(t.metric().squared_length(e), precise.metric().squared_length(e))) << e;
  for (std::uint32_t f = 0; f < num_faces(t.mesh()); ++f)
    EXPECT_TRUE(contains(t.metric().quadruple_area(f), precise.metric().quadruple_area(f))) << f;
}

// Right triangles whose quadruple area 2 sqrt(2) is not a double, so that zero stays an interval
// around it.
meshes::Mesh irrational_tie() {
  return {{{0, 0, 0}, {1, 0, 1}, {1, 1, 1}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

TEST(Interval_traits, leave_ties_as_they_are_and_count_them) {
  Triangulation t(irrational_tie().input());
  const auto h = properties::flippable_by_connectivity(t).at(0);
  ASSERT_EQ(t.flip_edge(h), IT::Move_status::done);
  t.metric().statistics() = {};
  EXPECT_EQ(t.delaunay_sign(h), CGAL::ZERO);
  EXPECT_EQ(t.metric().statistics().undecided, 1U);
  EXPECT_EQ(IT::flip_to_delaunay(t).flips, 0U);
  EXPECT_EQ(t.metric().statistics().undecided, 2U);
  EXPECT_TRUE(IT::is_delaunay(t));
}

TEST(Interval_traits, certain_zeros_are_not_counted) {
  Triangulation t(meshes::grid(1, 1).input()); // integers: intervals are points
  EXPECT_EQ(t.delaunay_sign(properties::flippable_by_connectivity(t).at(0)), CGAL::ZERO);
  EXPECT_EQ(t.metric().statistics().undecided, 0U);
}

TEST(Interval_traits, only_flip_edges_that_are_not_delaunay) {
  // symmetric: ties and near ties everywhere; every flip is checked exactly before it is done
  Triangulation t(meshes::folded_lattice(6, 6, 2).input());
  Exact exact(meshes::folded_lattice(6, 6, 2).input());
  bool flipped = true;
  std::size_t flips = 0;
  while (flipped) {
    flipped = false;
    for (const auto h : properties::flippable_by_connectivity(t)) {
      if (t.is_locally_delaunay(h)) continue;
      EXPECT_EQ(exact.delaunay_sign(h), CGAL::NEGATIVE);
      ASSERT_EQ(t.flip_edge(h), IT::Move_status::done);
      ASSERT_EQ(exact.flip_edge(h), IT::Move_status::done);
      flipped = true;
      ++flips;
    }
  }
  EXPECT_GT(flips, 0U);
}

IT::Diamond diamond() { return {2, 0, 1, 3, 4, 0, 1}; }
// two right isosceles triangles on their long sides: 4A = 2
IT::Interval_metric square(const Interval& area) {
  return {0, std::vector<Interval>{1, 1, 2, 1, 1}, std::vector<Interval>{area, area}};
}

TEST(Interval_traits, refuse_flips_whose_areas_may_be_zero) {
  const IT::Interval_metric::Scope scope;
  EXPECT_TRUE(square(2).compute_flip(diamond()));
  EXPECT_TRUE(square(Interval(1, 3)).compute_flip(diamond()));
  EXPECT_FALSE(square(Interval(0, 2)).compute_flip(diamond()));
}

TEST(Interval_traits, refuse_flips_with_infinite_bounds) {
  const IT::Interval_metric::Scope scope;
  EXPECT_FALSE(square(Interval(1, 1e200)).compute_flip(diamond())); // a square overflows
  EXPECT_FALSE(
      square(Interval(1, std::numeric_limits<double>::infinity())).compute_flip(diamond()));
}

TEST(Interval_traits, remove_caps) {
  Triangulation t(meshes::with_cap(meshes::box(2, 1, 1), 4).input());
  EXPECT_EQ(IT::flip_to_delaunay(t).flips, 1U);
  for (std::uint32_t f = 0; f < num_faces(t.mesh()); ++f) EXPECT_FALSE(t.metric().is_degenerate(f));
}

TEST(Interval_traits, insert_and_remove_vertices) {
  const meshes::Mesh m = meshes::rough_grid(3, 5);
  Triangulation t(m.input());
  const double area = properties::total_area(t);
  const auto h = properties::flippable_by_connectivity(t).at(3);
  const Triangulation::Insertion n = t.insert_vertex(h, {0.5, 0.25, 0.25});
  ASSERT_EQ(n.status, IT::Move_status::done);
  EXPECT_NEAR(properties::total_area(t), area, 1e-12 * area);
  EXPECT_EQ(t.remove_vertex(n.vertex), IT::Move_status::done);
  EXPECT_NEAR(properties::total_area(t), area, 1e-12 * area);
}

} // namespace
