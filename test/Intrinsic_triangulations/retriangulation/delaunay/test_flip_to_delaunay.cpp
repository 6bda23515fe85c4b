// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../benchmark/synthetic_meshes.h"
#include "meshes.h"
#include "properties.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Exact = IT::Intrinsic_triangulation<>;
using Double = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;
using IT::Status;
using Edge = Exact::edge_descriptor;

// Values are midpoints of intervals of relative width about 1e-14 after few flips; weights of thin
// faces lose some digits more.
constexpr double tolerance = 1e-10;

Exact delaunay(const meshes::Mesh& m, IT::Mollification mollification = IT::Mollification::none) {
  Exact t(m.input(mollification));
  const auto r = IT::flip_to_delaunay(t);
  EXPECT_EQ(r.status, Status::done);
  EXPECT_EQ(r.refused_flips, 0U);
  EXPECT_TRUE(IT::is_delaunay(t));
  EXPECT_EQ(t.metric().statistics().probable_zero, 0U);
  const auto again = IT::flip_to_delaunay(t);
  EXPECT_EQ(again.flips, 0U);
  EXPECT_EQ(again.checks, num_edges(t.mesh()));
  return t;
}

void expect_same(Exact a, Exact b) {
  properties::expect_same_tessellation(properties::tessellation(a), properties::tessellation(b),
                                       tolerance);
  properties::expect_same_laplacian(properties::laplacian(a), properties::laplacian(b), tolerance);
}

std::vector<meshes::Mesh> shapes() {
  return {meshes::box(2, 3, 1),
          meshes::sheared_grid(5, 6, 3),
          meshes::folded_lattice(4, 6, 2),
          meshes::rough_grid(8, 1),
          meshes::potato(3, 2),
          meshes::integer_height_field(6, 4, 3),
          meshes::parabola_fan(12),
          meshes::l_shape(3)};
}

TEST(Flip_to_delaunay, result_does_not_depend_on_the_order_of_the_queue) {
  for (const meshes::Mesh& m : shapes()) {
    const Exact expected = delaunay(m);
    for (unsigned seed = 0; seed < 4; ++seed) {
      Exact t(m.input());
      std::vector<Edge> queue(edges(t.mesh()).begin(), edges(t.mesh()).end());
      if (seed == 0)
        std::reverse(queue.begin(), queue.end());
      else
        std::shuffle(queue.begin(), queue.end(), std::mt19937(seed));
      IT::flip_to_delaunay(t, queue);
      EXPECT_TRUE(IT::is_delaunay(t)) << seed;
      expect_same(t, expected);
    }
  }
}

// Every edge of the plates flips about once if long ones go first. In the order of memory, edges wind around the plates: 6 to 50
// flips per edge.
TEST(Flip_to_delaunay, few_flips_make_slivers_delaunay_whatever_the_order_of_starting_edges) {
  for (unsigned seed = 1; seed <= 6; ++seed)
    for (const double thickness : {0.1, 1.}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", thickness " << thickness);
      const auto mesh = IT::synthetic::to_surface_mesh<CGAL::Simple_cartesian<double>::Point_3>(
          IT::synthetic::sliver_plate(600, 100, thickness, seed % 2 == 0, seed));
      Exact t(mesh), shuffled(mesh);
      const auto r = IT::flip_to_delaunay(t);
      EXPECT_LT(r.flips, 2 * num_edges(t.mesh()));
      EXPECT_TRUE(IT::is_delaunay(t));
      std::vector<Edge> queue(edges(t.mesh()).begin(), edges(t.mesh()).end());
      std::shuffle(queue.begin(), queue.end(), std::mt19937(seed));
      EXPECT_LT(IT::flip_to_delaunay(shuffled, queue).flips, 2 * num_edges(t.mesh()));
      expect_same(t, shuffled);
      Double d(mesh);
      EXPECT_LT(IT::flip_to_delaunay(d).flips, 2 * num_edges(t.mesh()));
    }
}

TEST(Flip_to_delaunay,
     an_empty_range_of_edges_flips_nothing_and_one_edge_repairs_its_neighbourhood) {
  Exact t(meshes::potato(2, 3).input());
  EXPECT_EQ(IT::flip_to_delaunay(t, std::vector<Edge>()).checks, 0U);
  IT::flip_to_delaunay(t);
  const auto h = properties::flippable_by_connectivity(t);
  const auto flippable = std::find_if(h.begin(), h.end(), [&](auto x) {
    return t.delaunay_sign(x) == CGAL::POSITIVE && t.flip_status(x) == IT::Move_status::done;
  });
  ASSERT_NE(flippable, h.end());
  t.flip_edge(*flippable);
  EXPECT_FALSE(IT::is_delaunay(t));
  EXPECT_EQ(IT::flip_to_delaunay(t, std::vector<Edge>{edge(*flippable, t.mesh())}).flips, 1U);
  EXPECT_TRUE(IT::is_delaunay(t));
}

TEST(Flip_to_delaunay, permuted_and_mirrored_input_gives_the_permuted_and_mirrored_result) {
  for (const meshes::Mesh& m : shapes()) {
    Exact expected = delaunay(m);
    expect_same(delaunay(meshes::mirrored(m)), expected);
    const auto order = meshes::permutation(m.points.size(), 17);
    Exact permuted = delaunay(meshes::permuted(m, order, 5));
    auto edges_expected = properties::tessellation(expected);
    for (auto& [i, j, length] : edges_expected) std::tie(i, j) = std::minmax({order[i], order[j]});
    std::sort(edges_expected.begin(), edges_expected.end());
    properties::expect_same_tessellation(properties::tessellation(permuted), edges_expected,
                                         tolerance);
    std::map<properties::Vertex_pair, double> weights;
    for (const auto& [ij, w] : properties::laplacian(expected))
      weights[std::minmax({order[ij.first], order[ij.second]})] = w;
    properties::expect_same_laplacian(properties::laplacian(permuted), weights, tolerance);
  }
}

TEST(Flip_to_delaunay, scaling_by_powers_of_two_changes_nothing_but_units) {
  for (const meshes::Mesh& m : shapes())
    for (const int k : {-900, -531, -1, 1, 398, 900}) {
      Exact a(m.input()), b(meshes::scaled(m, std::ldexp(1.0, k)).input());
      EXPECT_EQ(IT::flip_to_delaunay(a).flips, IT::flip_to_delaunay(b).flips);
      EXPECT_EQ(properties::connectivity(a), properties::connectivity(b));
      EXPECT_EQ(a.metric().scale_exponent() - k, b.metric().scale_exponent());
      EXPECT_EQ(properties::laplacian(a), properties::laplacian(b));
    }
}

TEST(Flip_to_delaunay, huge_and_tiny_input_gives_the_same_flips) {
  for (const meshes::Mesh& m : {meshes::rough_grid(8, 1), meshes::potato(3, 2)}) // no ties
    for (const double factor : {1e120, 1e-160, 1e300, 1e-300}) {
      Exact a(m.input()), b(meshes::scaled(m, factor).input());
      EXPECT_EQ(IT::flip_to_delaunay(a).flips, IT::flip_to_delaunay(b).flips);
      EXPECT_EQ(properties::connectivity(a), properties::connectivity(b));
      Double c(m.input()), d(meshes::scaled(m, factor).input());
      IT::flip_to_delaunay(c);
      IT::flip_to_delaunay(d);
      EXPECT_EQ(properties::connectivity(c), properties::connectivity(a));
      EXPECT_EQ(properties::connectivity(d), properties::connectivity(a));
    }
}

TEST(Flip_to_delaunay, is_certified_far_from_the_origin_with_tiny_edges) {
  // coordinates around 1e8 are multiples of 2^-26, about 1.5e-8
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const meshes::Mesh m =
        meshes::translated(meshes::scaled(meshes::rough_grid(10, seed), 1e-6), {1e8, -1e8, 1e8});
    Exact t = delaunay(m, IT::Mollification::automatic);
    EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 0U);
    EXPECT_EQ(t.report().mollification.kind, IT::Mollification::none);
  }
}

TEST(Flip_to_delaunay, is_certified_on_needles_of_1e_15) {
  for (std::size_t f = 0; f < 20; ++f) {
    Exact t(
        meshes::with_needle(meshes::potato(2, 9), f, 1e-15).input(IT::Mollification::automatic));
    EXPECT_EQ(t.report().mollification.kind, IT::Mollification::none);
    const double area = properties::total_area(t);
    IT::flip_to_delaunay(t);
    EXPECT_TRUE(IT::is_delaunay(t));
    EXPECT_NEAR(properties::total_area(t), area, 1e-12 * area);
    for (const auto& [ij, w] : properties::laplacian(t)) EXPECT_TRUE(std::isfinite(w));
  }
}

TEST(Flip_to_delaunay, flips_caps_away_without_mollification) {
  for (const meshes::Mesh& m :
       {meshes::box(2, 2, 2), meshes::potato(2, 1), meshes::folded_lattice(3, 4, 1)})
    for (std::size_t f = 0; f < m.triangles.size(); f += 3) {
      const meshes::Mesh capped = meshes::with_cap(m, f);
      Exact t(capped.input(IT::Mollification::automatic));
      // midpoints are exact, or rounded off the edge: then there is no cap
      const bool is_border_cap = t.report().mollification.kind != IT::Mollification::none;
      if (t.report().degenerate_faces == 0 || is_border_cap) continue;
      IT::flip_to_delaunay(t);
      EXPECT_TRUE(IT::is_delaunay(t));
      for (const auto g : faces(t.mesh())) EXPECT_GT(t.area(g), 0);
      Exact original(m.input());
      EXPECT_NEAR(properties::total_area(t), properties::total_area(original),
                  1e-11 * properties::total_area(t));
    }
}

TEST(Flip_to_delaunay, ends_where_degenerate_faces_must_stay) {
  Exact t(meshes::with_needle(meshes::box(1, 1, 1), 3, 0).input(IT::Mollification::none));
  EXPECT_EQ(t.report().degenerate_faces, 2U);
  EXPECT_EQ(IT::flip_to_delaunay(t).status, Status::done);
  EXPECT_TRUE(IT::is_delaunay(t));
}

struct Constraints {
  using key_type = Edge;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  const std::set<std::uint32_t>* edges;
  friend bool get(const Constraints& c, Edge e) { return c.edges->count(e.index) != 0; }
};

TEST(Flip_to_delaunay, never_flips_constrained_edges) {
  for (const meshes::Mesh& m : shapes()) {
    Exact t(m.input());
    std::set<std::uint32_t> constrained;
    std::map<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>> ends;
    std::mt19937 random(3);
    for (const Edge e : edges(t.mesh()))
      if (random() % 3 == 0) {
        constrained.insert(e.index);
        ends[e.index] = {source(e, t.mesh()).index, target(e, t.mesh()).index};
      }
    const auto r = IT::flip_to_delaunay(
        t, CGAL::parameters::edge_is_constrained_map(Constraints{&constrained}));
    EXPECT_EQ(r.status, Status::done);
    for (const Edge e : edges(t.mesh()))
      if (constrained.count(e.index) != 0) {
        const std::pair now{source(e, t.mesh()).index, target(e, t.mesh()).index};
        EXPECT_EQ(now, ends[e.index]);
      } else {
        EXPECT_TRUE(t.is_locally_delaunay(halfedge(e, t.mesh())));
      }
  }
}

struct Visitor : IT::Flip_to_delaunay_visitor {
  std::vector<std::uint64_t> checks;
  std::size_t stop_after = 1000;
  bool progress(const IT::Flip_to_delaunay_result& r) {
    checks.push_back(r.checks);
    // the default rounding mode is in force, for every arithmetic
    volatile double one = 1, third = one / 3;
    EXPECT_EQ(third, 0x1.5555555555555p-2);
    return checks.size() < stop_after;
  }
};

TEST(Flip_to_delaunay, visitor_sees_progress_and_may_cancel) {
  const meshes::Mesh m = meshes::sheared_grid(90, 90, 12.3);
  Exact t(m.input());
  Visitor patient;
  const auto r = IT::flip_to_delaunay(t, CGAL::parameters::visitor(std::ref(patient)));
  EXPECT_EQ(r.status, Status::done);
  ASSERT_GE(patient.checks.size(), 2U);
  EXPECT_TRUE(std::is_sorted(patient.checks.begin(), patient.checks.end()));
  EXPECT_LE(patient.checks.back(), r.checks);

  Exact u(m.input());
  Visitor impatient;
  impatient.stop_after = 1;
  const auto s = IT::flip_to_delaunay(u, CGAL::parameters::visitor(std::ref(impatient)));
  EXPECT_EQ(s.status, Status::cancelled);
  EXPECT_EQ(impatient.checks.size(), 1U);
  EXPECT_FALSE(IT::is_delaunay(u));
  // the result is a triangulation, and can be used further
  IT::flip_to_delaunay(u);
  properties::expect_same_tessellation(properties::tessellation(u), properties::tessellation(t),
                                       tolerance);
}

template <class T>
void expect_cap_is_kept() {
  const meshes::Mesh m = meshes::sheared_grid(5, 5, 4);
  T t(m.input());
  const auto r = IT::flip_to_delaunay(t, CGAL::parameters::maximum_number(3));
  EXPECT_EQ(r.status, Status::cap);
  EXPECT_EQ(r.flips, 3U);
  EXPECT_FALSE(IT::is_delaunay(t));
  T u(m.input());
  const auto all = IT::flip_to_delaunay(u);
  T v(m.input());
  EXPECT_EQ(IT::flip_to_delaunay(v, IT::parameters::maximum_number(all.flips)).status,
            Status::done);
}

TEST(Flip_to_delaunay, stops_at_the_cap_on_flips_and_says_so) {
  expect_cap_is_kept<Double>();
  expect_cap_is_kept<Exact>();
}

} // namespace
