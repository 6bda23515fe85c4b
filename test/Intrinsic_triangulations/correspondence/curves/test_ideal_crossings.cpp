// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/ideal_crossings.h>

#include "ideal_triangulations.h"
#include "meshes.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_ideal_hyperbolic_traits,
                                                  IT::Integer_coordinates>;

// A horocycle as a spinor: lambda lengths are determinants, and x x^T is its light-like vector.
using Spinor = std::array<double, 2>;
double det(const Spinor& x, const Spinor& y) { return x[0] * y[1] - x[1] * y[0]; }
// the apex of a triangle on p, q: between them on the circle at infinity, or beyond (side: -1)
Spinor apex(const Spinor& p, const Spinor& q, double qr, double rp, double side) {
  const double pq = std::abs(det(p, q));
  return {(p[0] * qr * side + q[0] * rp) / pq, (p[1] * qr * side + q[1] * rp) / pq};
}
using Light = std::array<double, 3>; // xx, xy, yy
Light combination(double s, const Spinor& p, double t, const Spinor& q) {
  return {s * p[0] * p[0] + t * q[0] * q[0], s * p[0] * p[1] + t * q[0] * q[1],
          s * p[1] * p[1] + t * q[1] * q[1]};
}

Triangulation triangulation(const meshes::Mesh& m, int powers, unsigned seed) {
  Triangulation t(m.input());
  t.scale_vertices(ideal::random_factors(t.number_of_vertices(), powers, seed));
  IT::flip_to_delaunay(t);
  return t;
}

TEST(ideal_crossings, are_one_point_of_the_hyperbolic_plane_on_both_edges) {
  const Triangulation t = triangulation(meshes::potato(2, 1), 3, 1);
  const IT::Edge_crossings crossings = IT::edge_crossings(t, t.correspondence());
  const auto p = IT::ideal_crossing_parameters(t, t.correspondence(), crossings);
  const std::vector<double> lambda = IT::nearest_lengths(t.input().metric(), t.input().mesh());
  const IT::Input& input = t.input();
  const auto factor = [&](std::uint32_t v) { return t.metric().factor(t.input_vertex({v})); };
  ASSERT_GT(crossings.size(), 200U);
  for (std::uint32_t e = 0; e + 1 < crossings.begin.size(); ++e) {
    const auto entered = crossings.entered_on(e);
    if (entered.empty()) continue;
    // lays out the strip from the first triangle on, in the plane of spinors
    const std::uint32_t first = entered[0] ^ 1U, n = input.next(first), l = input.next(n);
    std::vector<std::array<Spinor, 2>> sides; // source and target of what is entered
    const Spinor a{lambda[first / 2], 0}, b{0, 1};
    const Spinor i = apex(a, b, lambda[n / 2], lambda[l / 2], -1);
    Spinor j{};
    sides.push_back({b, a});
    for (std::size_t k = 0; k < entered.size(); ++k) {
      const auto [s, u] = sides.back();
      const std::uint32_t x = entered[k], y = input.next(x), z = input.next(y);
      j = apex(s, u, lambda[y / 2], lambda[z / 2], 1);
      if (k + 1 < entered.size())
        sides.push_back((entered[k + 1] ^ 1U) == y ? std::array{j, u} : std::array{s, j});
    }
    const double w_i = factor(t.mesh().source(IT::Gluing_map::Halfedge{2 * e}).index),
                 w_j = factor(t.mesh().target(IT::Gluing_map::Halfedge{2 * e}).index);
    for (std::size_t k = 0; k < entered.size(); ++k) {
      const std::size_t c = crossings.begin[e] + k;
      const double on_input = entered[k] % 2 == 0 ? p.on_input[c] : 1 - p.on_input[c];
      const Light x = combination(1 - on_input, sides[k][0], on_input, sides[k][1]);
      const double s = p.on_intrinsic[c];
      const Light y =
          combination(p.weight[c] * (1 - s) * w_i * w_i, i, p.weight[c] * s * w_j * w_j, j);
      for (int r = 0; r < 3; r += 2) EXPECT_NEAR(x[r], y[r], 1e-9 * (x[0] + x[2]));
      EXPECT_NEAR(x[1], y[1], 1e-9 * (x[0] + x[2]));
    }
  }
}

TEST(ideal_crossings, make_a_common_subdivision) {
  const meshes::Mesh m = meshes::potato(2, 3);
  const Triangulation t = triangulation(m, 2, 4);
  const IT::Common_subdivision s = IT::common_subdivision(t);
  EXPECT_EQ(s.number_of_vertices() + s.number_of_faces(), s.number_of_edges() + 2); // a sphere
  EXPECT_GT(s.crossings.size(), 0U);
  for (const IT::Common_subdivision::Crossing& c : s.crossings)
    for (const double x : {c.on_input.parameter, c.on_intrinsic.parameter}) {
      EXPECT_GT(x, 0);
      EXPECT_LT(x, 1);
    }
  EXPECT_EQ(IT::positions(s, m.points).size(), s.number_of_vertices());
}

TEST(ideal_crossings, diagonals_of_a_square_halve_each_other) {
  Triangulation t(meshes::grid(1, 1).input());
  const auto h = properties::flippable_by_connectivity(t).at(0);
  ASSERT_EQ(t.flip_edge(h), IT::Move_status::done);
  const IT::Common_subdivision s = IT::common_subdivision(t);
  ASSERT_EQ(s.crossings.size(), 1U);
  EXPECT_NEAR(s.crossings[0].on_input.parameter, 0.5, 1e-15);
  EXPECT_NEAR(s.crossings[0].on_intrinsic.parameter, 0.5, 1e-15);
}

} // namespace
