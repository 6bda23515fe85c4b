// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "properties.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/input/mollification.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Mollification;

namespace {

using Exact = IT::Intrinsic_triangulation<>;
using Double = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;

// Two caps whose longest side is the same edge, inside a square: following longest sides goes in
// circles.
meshes::Mesh facing_caps() {
  return {{{-2, 0, 0}, {2, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, -2, 0}},
          {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {2, 1, 4}, {1, 3, 5}, {3, 0, 5}}};
}

meshes::Mesh cap_on_the_border() {
  return {{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}}};
}

// a chain of caps, each behind the longest side of the one before, and a proper face at its end
meshes::Mesh chain_of_caps() {
  return {{{0, 0, 0}, {8, 0, 0}, {4, 0, 0}, {2, 0, 0}, {5, 5, 0}, {3, -3, 0}},
          {{0, 1, 4}, {1, 0, 2}, {2, 0, 3}, {0, 5, 3}, {3, 5, 2}, {2, 5, 1}}};
}

template <class T>
bool needs_mollification(const meshes::Mesh& m) {
  return T(m.input(Mollification::automatic)).report().mollification.kind != Mollification::none;
}

TEST(Mollification, is_needed_where_flips_cannot_remove_degenerate_faces) {
  EXPECT_TRUE(needs_mollification<Exact>(facing_caps()));
  EXPECT_TRUE(needs_mollification<Exact>(cap_on_the_border()));
  EXPECT_TRUE(needs_mollification<Exact>(meshes::with_needle(meshes::box(1, 1, 1), 2, 0)));
  EXPECT_FALSE(needs_mollification<Exact>(chain_of_caps()));
  EXPECT_FALSE(needs_mollification<Exact>(meshes::with_cap(meshes::box(1, 1, 1), 2)));
  EXPECT_FALSE(needs_mollification<Exact>(meshes::with_needle(meshes::potato(1, 1), 2, 1e-15)));
  EXPECT_TRUE(needs_mollification<Double>(facing_caps()));
  EXPECT_FALSE(needs_mollification<Double>(chain_of_caps()));
}

TEST(Mollification, automatic_leaves_caps_to_flips) {
  Exact t(chain_of_caps().input(Mollification::automatic));
  EXPECT_EQ(t.report().degenerate_faces, 2U);
  EXPECT_EQ(t.report().mollification.kind, Mollification::none);
  EXPECT_EQ(t.report().mollification.delta, 0);
  IT::flip_to_delaunay(t);
  EXPECT_TRUE(IT::is_delaunay(t));
  for (const auto f : faces(t.mesh())) EXPECT_GT(t.area(f), 0);
  EXPECT_NEAR(properties::total_area(t), 20 + 12, 1e-12);
}

TEST(Mollification, automatic_acts_where_it_must_and_reports_what_it_added) {
  for (const meshes::Mesh& shape :
       {facing_caps(), cap_on_the_border(), meshes::with_needle(meshes::box(1, 1, 1), 2, 0)})
    for (const double unit : {1.0, 0x1p40, 0x1p-500}) {
      const meshes::Mesh m = meshes::scaled(shape, unit);
      Exact t(m.input(Mollification::automatic));
      EXPECT_GT(t.report().degenerate_faces, 0U);
      EXPECT_EQ(t.report().mollification.kind, Mollification::squared_lengths);
      const double delta = t.report().mollification.delta;
      EXPECT_GT(delta, 0);
      // 2^-72 in units in which edges are about 1
      EXPECT_LT(delta, 0x1p-64 * unit * unit);
      double shortest = t.squared_length(*edges(t.mesh()).begin());
      for (const auto e : edges(t.mesh())) shortest = std::min(shortest, t.squared_length(e));
      EXPECT_GE(shortest, delta);
      IT::flip_to_delaunay(t);
      EXPECT_TRUE(IT::is_delaunay(t));
      for (const auto f : faces(t.mesh())) EXPECT_GT(t.area(f), 0);
      for (const auto& [ij, w] : properties::laplacian(t)) EXPECT_TRUE(std::isfinite(w));
    }
}

TEST(Mollification, none_leaves_degenerate_faces_and_says_how_many) {
  for (const meshes::Mesh& m : {facing_caps(), cap_on_the_border()}) {
    Exact t(m.input(Mollification::none));
    EXPECT_EQ(t.report().mollification.kind, Mollification::none);
    std::size_t degenerate = 0;
    for (const auto f : faces(t.mesh())) degenerate += t.area(f) == 0;
    EXPECT_EQ(degenerate, t.report().degenerate_faces);
    EXPECT_GT(degenerate, 0U);
  }
}

TEST(Mollification, automatic_leaves_proper_meshes_alone) {
  for (const meshes::Mesh& m :
       {meshes::box(2, 2, 2), meshes::potato(2, 2), meshes::parabola_fan(20)}) {
    Exact t(m.input(Mollification::automatic));
    EXPECT_EQ(t.report().degenerate_faces, 0U);
    EXPECT_EQ(t.report().mollification.kind, Mollification::none);
  }
}

template <class T>
void expect_all_faces_proper(Mollification kind) {
  for (const meshes::Mesh& m : {facing_caps(), cap_on_the_border(), chain_of_caps(),
                                meshes::with_needle(meshes::box(1, 1, 1), 2, 0)}) {
    T t(m.input(kind));
    EXPECT_EQ(t.report().mollification.kind, kind);
    EXPECT_GT(t.report().mollification.delta, 0);
    for (const auto f : faces(t.mesh())) EXPECT_GT(t.area(f), 0);
    IT::flip_to_delaunay(t);
    EXPECT_TRUE(IT::is_delaunay(t));
  }
}

TEST(Mollification, both_kinds_give_all_faces_an_area_in_both_arithmetics) {
  expect_all_faces_proper<Exact>(Mollification::squared_lengths);
  expect_all_faces_proper<Exact>(Mollification::lengths);
  expect_all_faces_proper<Double>(Mollification::squared_lengths);
  expect_all_faces_proper<Double>(Mollification::lengths);
}

std::vector<double> lengths_in_space(const meshes::Mesh& m) {
  const IT::Gluing_map map = m.map();
  std::vector<double> lengths(map.number_of_edges());
  for (std::uint32_t e = 0; e < lengths.size(); ++e) {
    const auto p = m.points[map.source({2 * e}).index], q = m.points[map.target({2 * e}).index];
    lengths[e] = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }
  return lengths;
}

double mean(const std::vector<double>& x) {
  double sum = 0;
  for (const double y : x) sum += y;
  return sum / static_cast<double>(x.size());
}

/// By how much the triangle inequalities hold at least.
template <class T>
double least_slack(const T& t) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto f : faces(t.mesh())) {
    auto h = halfedge(f, t.mesh());
    double sum = 0, longest = 0;
    for (int k = 0; k < 3; ++k, h = next(h, t.mesh())) {
      const double l = t.length(edge(h, t.mesh()));
      sum += l;
      longest = std::max(longest, l);
    }
    least = std::min(least, sum - 2 * longest);
  }
  return least;
}

template <class T>
T mollified(const meshes::Mesh& m, Mollification kind, std::optional<double> amount) {
  IT::Intrinsic_input input = m.input(kind);
  input.may_renumber = false;
  input.mollification_amount = amount;
  return T(std::move(input));
}

TEST(Mollification, epsilon_is_the_least_that_gives_every_inequality_the_margin) {
  const IT::Gluing_map map = cap_on_the_border().map();
  const std::vector<double> lengths = lengths_in_space(cap_on_the_border());
  for (const double amount : {1e-3, 0.25, 1.0}) { // of the mean edge
    const double delta = amount * mean(lengths);
    const double epsilon = mollified<Exact>(cap_on_the_border(), Mollification::lengths, amount)
                               .report()
                               .mollification.delta;
    double least_margin = 1e300;
    for (std::uint32_t f = 0; f < map.number_of_faces(); ++f) {
      auto h = map.halfedge(IT::Gluing_map::Face{f});
      for (int k = 0; k < 3; ++k, h = map.next(h)) {
        const auto l = [&](auto x) { return lengths[x.index / 2] + epsilon; };
        const auto n = map.next(h), p = map.next(n);
        least_margin = std::min(least_margin, l(h) + l(n) - l(p));
      }
    }
    EXPECT_NEAR(least_margin, delta, 1e-14);
  }
  const meshes::Mesh regular{{{0, 0, 0}, {1, 1, 0}, {1, 0, 1}}, {{0, 1, 2}}};
  EXPECT_EQ(mollified<Exact>(regular, Mollification::lengths, 0.5).report().mollification.delta, 0);
}

TEST(Mollification, amount_is_in_units_of_the_mean_edge) {
  for (const double unit : {1.0, 3.0, 0x1p40, 1e-100})
    for (const double amount : {1e-3, 1e-5, 0.1}) {
      const meshes::Mesh needle =
          meshes::scaled(meshes::with_needle(meshes::box(1, 1, 1), 2, 0), unit);
      const double h = mean(lengths_in_space(needle));
      const auto squared = mollified<Exact>(needle, Mollification::squared_lengths, amount);
      double shortest = h;
      for (const auto e : edges(squared.mesh())) shortest = std::min(shortest, squared.length(e));
      EXPECT_NEAR(shortest, amount * h, 1e-12 * h) << "an edge that had the length zero";
      EXPECT_NEAR(squared.report().mollification.delta, amount * amount * h * h, 1e-12 * h * h);
      const auto automatic = mollified<Exact>(needle, Mollification::automatic, amount);
      EXPECT_EQ(automatic.report().mollification.kind, Mollification::squared_lengths);
      EXPECT_EQ(automatic.report().mollification.delta, squared.report().mollification.delta);
      for (const meshes::Mesh& shape : {facing_caps(), cap_on_the_border()}) {
        const meshes::Mesh m = meshes::scaled(shape, unit);
        const std::vector<double> before = lengths_in_space(m);
        const auto t = mollified<Double>(m, Mollification::lengths, amount);
        EXPECT_NEAR(least_slack(t), amount * mean(before), 1e-12 * mean(before));
        const double added = t.report().mollification.delta;
        for (const auto e : edges(t.mesh()))
          EXPECT_NEAR(t.length(e), before[t.index(e)] + added, 1e-12 * mean(before));
      }
    }
}

TEST(Mollification, amount_must_be_a_part_of_the_mean_edge) {
  for (const double amount : {0., -1e-5, 1.5, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(mollified<Exact>(facing_caps(), Mollification::lengths, amount),
                 IT::Invalid_input);
}

TEST(Mollification, of_nearly_degenerate_faces_acts_where_doubles_would_lose_digits) {
  for (const double height : {0.0, 1e-12, 1e-9, 1e-6}) {
    meshes::Mesh m = facing_caps(); // caps of nearly no height, of which automatic sees none
    m.points[2][1] += height;
    m.points[3][1] -= height;
    for (const double unit : {1.0, 1e60}) {
      const auto t =
          mollified<Double>(meshes::scaled(m, unit), Mollification::nearly_degenerate, {});
      EXPECT_EQ(t.report().mollification.kind, Mollification::lengths) << height;
      EXPECT_GT(least_slack(t), 0.5e-5 * unit) << "of the mean edge, which is about 2";
    }
    if (height > 0) {
      EXPECT_EQ(Double(m.input(Mollification::automatic)).report().mollification.kind,
                Mollification::none);
    }
  }
  const auto needle = mollified<Double>(meshes::with_needle(meshes::potato(1, 1), 2, 1e-13),
                                        Mollification::nearly_degenerate, 1e-4);
  EXPECT_EQ(needle.report().mollification.kind, Mollification::lengths);
  for (const auto f : faces(needle.mesh())) EXPECT_GT(needle.area(f), 0);
}

TEST(Mollification, of_nearly_degenerate_faces_leaves_others_alone_bit_by_bit) {
  // thin faces, and some much smaller than others
  const double small = 1e-9;
  meshes::Mesh fan{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-small, 0, 0}, {0, -small, 0}},
                   {{0, 1, 2}, {0, 3, 4}}};
  for (const meshes::Mesh& m :
       {meshes::box(2, 2, 2), meshes::potato(2, 2), meshes::sheared_grid(4, 4, 100), fan}) {
    const auto t = mollified<Double>(m, Mollification::nearly_degenerate, {}),
               none = mollified<Double>(m, Mollification::none, {});
    EXPECT_EQ(t.report().mollification.kind, Mollification::none);
    EXPECT_EQ(t.report().mollification.delta, 0);
    for (const auto e : edges(t.mesh())) EXPECT_EQ(t.squared_length(e), none.squared_length(e));
  }
}

} // namespace
