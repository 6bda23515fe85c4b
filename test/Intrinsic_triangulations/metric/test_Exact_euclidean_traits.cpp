// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "meshes.h"
#include "properties.h"
#include "wide_numbers.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using wide_numbers::may_be_below;
using wide_numbers::Wide;
using wide_numbers::wide;

namespace {

using Exact = IT::Intrinsic_triangulation<>;
using CGAL::Gmpq;
using IT::Move_status;
using Halfedge = Exact::halfedge_descriptor;

struct Exact_state {
  std::vector<Gmpq> lengths, squared_areas; // -1 where irrational
  explicit Exact_state(const Exact& t) {
    for (const Halfedge h : properties::flippable_by_connectivity(t)) {
      lengths.push_back(properties::rational_squared_length(t, h));
      squared_areas.push_back(properties::rational_squared_area(t, h));
      squared_areas.push_back(properties::rational_squared_area(t, opposite(h, t.mesh())));
    }
  }
  bool operator==(const Exact_state&) const = default;
};

std::vector<IT::Intrinsic_input> inputs() {
  std::vector<IT::Intrinsic_input> all;
  for (const gallery::Surface& s : gallery::oriented()) all.push_back(gallery::input(s));
  for (const meshes::Mesh& m :
       {meshes::box(1, 1, 1), meshes::rough_grid(2, 3), meshes::potato(1, 4)})
    all.push_back(m.input());
  return all;
}

TEST(Exact_euclidean_traits, two_and_four_flips_give_lengths_and_areas_back_exactly) {
  for (const IT::Intrinsic_input& in : inputs())
    for (const Halfedge h : properties::flippable_by_connectivity(Exact(in))) {
      Exact t(in);
      const auto state = [&t](Halfedge x) {
        return std::array{properties::rational_squared_length(t, x),
                          properties::rational_squared_area(t, x),
                          properties::rational_squared_area(t, opposite(x, t.mesh()))};
      };
      const Halfedge o = opposite(h, t.mesh());
      const auto before = state(h), swapped = state(o);
      if (t.flip_edge(h) != Move_status::done) continue;
      ASSERT_EQ(t.flip_edge(h), Move_status::done);
      EXPECT_EQ(state(h), swapped);
      ASSERT_EQ(t.flip_edge(h), Move_status::done);
      ASSERT_EQ(t.flip_edge(h), Move_status::done);
      EXPECT_EQ(state(h), before);
    }
}

TEST(Exact_euclidean_traits, random_flips_and_back_give_lengths_and_areas_back_exactly) {
  std::mt19937 random(20260711);
  for (const IT::Intrinsic_input& in : inputs()) {
    Exact t(in);
    const Exact_state before(t);
    const auto connectivity = properties::connectivity(t);
    const auto edges = properties::flippable_by_connectivity(t);
    std::vector<Halfedge> flipped;
    for (std::size_t i = 0; !edges.empty() && i < 10; ++i) {
      const Halfedge h = edges[random() % edges.size()];
      if (t.flip_edge(h) == Move_status::done) flipped.push_back(h);
    }
    for (; !flipped.empty(); flipped.pop_back())
      for (int i = 0; i < 3; ++i) ASSERT_EQ(t.flip_edge(flipped.back()), Move_status::done);
    EXPECT_EQ(properties::connectivity(t), connectivity);
    EXPECT_EQ(Exact_state(t), before);
  }
}

TEST(Exact_euclidean_traits, stored_intervals_contain_the_exact_values) {
  std::mt19937 random(20260711);
  for (const IT::Intrinsic_input& in : inputs()) {
    Exact t(in);
    const auto edges = properties::flippable_by_connectivity(t);
    for (std::size_t i = 0; !edges.empty() && i < 8; ++i)
      t.flip_edge(edges[random() % edges.size()]);
    for (const Halfedge h : properties::flippable_by_connectivity(t))
      properties::with_exact_values(t, h, [&](const auto& exact) {
        const IT::Mpfr_precision precision(300);
        const auto d = t.diamond(h);
        const auto contains = [](const CGAL::Interval_nt<false>& i, const auto& x) {
          const Wide e = wide(x);
          return may_be_below(Wide(i.inf()), e) && may_be_below(e, Wide(i.sup()));
        };
        EXPECT_TRUE(contains(t.metric().squared_length(d.ij), exact.ij));
        EXPECT_TRUE(contains(t.metric().quadruple_area(d.f), exact.area_f));
        EXPECT_TRUE(contains(t.metric().quadruple_area(d.g), exact.area_g));
      });
  }
}

TEST(Exact_euclidean_traits, signs_agree_with_exact_arithmetic_after_random_flips) {
  std::mt19937 random(20260711);
  int ties = 0;
  for (const meshes::Mesh& m : {meshes::box(2, 2, 1), meshes::folded_lattice(3, 4, 1),
                                meshes::integer_height_field(3, 2, 1)}) {
    Exact t(m.input());
    auto edges = properties::flippable_by_connectivity(t);
    for (int i = 0; i < 25; ++i) t.flip_edge(edges[random() % edges.size()]);
    for (const Halfedge h : properties::flippable_by_connectivity(t))
      properties::with_exact_values(t, h, [&](const auto& exact) {
        const auto value = IT::Delaunay_expression()(exact);
        const IT::Mpfr_precision precision(2000);
        const CGAL::Sign expected =
            value.is_zero() ? CGAL::ZERO : CGAL::get_certain(wide(value).sign());
        EXPECT_EQ(t.delaunay_sign(h), expected);
        ties += expected == CGAL::ZERO;
      });
  }
  EXPECT_GT(ties, 0);
}

TEST(Exact_euclidean_traits, cotangent_weights_are_zero_on_ties_and_of_the_right_sign_elsewhere) {
  for (const meshes::Mesh& m : {meshes::box(2, 3, 1), meshes::folded_lattice(4, 5, 2)}) {
    Exact t(m.input());
    for (int round = 0; round < 2; ++round) {
      Exact::Session session(t);
      for (const Halfedge h : properties::flippable_by_connectivity(t)) {
        const double w = session.cotangent_weight(edge(h, t.mesh()));
        EXPECT_EQ(CGAL::sign(w), session.delaunay_sign(h));
      }
      IT::flip_to_delaunay(t);
    }
  }
}

TEST(Exact_euclidean_traits, statistics_tell_how_predicates_were_decided) {
  Exact smooth(meshes::potato(2, 5).input());
  IT::flip_to_delaunay(smooth);
  EXPECT_GT(smooth.metric().statistics().checks, 0U);
  EXPECT_EQ(smooth.metric().statistics().filter_failures, 0U);
  EXPECT_EQ(smooth.metric().statistics().certified_zero, 0U);

  Exact ties(meshes::folded_lattice(4, 6, 1).input());
  IT::flip_to_delaunay(ties);
  const IT::Predicate_statistics& s = ties.metric().statistics();
  EXPECT_GT(s.certified_zero, 0U);
  EXPECT_EQ(s.probable_zero, 0U);
  std::uint64_t decided = s.certified_zero + s.probable_zero + s.integer;
  for (const auto& [bits, count] : s.escalations) decided += count;
  EXPECT_EQ(decided, s.filter_failures);
}

TEST(Exact_euclidean_traits, near_ties_are_decided_and_not_taken_for_ties) {
  for (int k = 1; k <= 52; ++k)
    for (const double sign : {-1.0, 1.0}) {
      // a square with one corner off by an ulp of 2^-k
      const double x = 1 + sign * std::ldexp(1.0, -k);
      Exact t(meshes::Mesh{{{0, 0, 0}, {1, 0, 0}, {x, x, 0}, {0, 1, 0}}, {{0, 1, 3}, {1, 2, 3}}}
                  .input());
      const Halfedge h = properties::flippable_by_connectivity(t).at(0);
      EXPECT_EQ(t.delaunay_sign(h), sign > 0 ? CGAL::POSITIVE : CGAL::NEGATIVE) << k;
    }
}

// a sheared grid in the plane, whose squares are nearly cocircular after flips
meshes::Mesh nearly_square_grid(unsigned seed, double noise) {
  meshes::Mesh m = meshes::sheared_grid(12, 12, 7);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-noise, noise);
  for (auto& p : m.points) p = {p[0] + shift(random), p[1] + shift(random), 0};
  // beside it another one that does not flip: with more flips than edges, values would follow flips
  const auto first = static_cast<std::uint32_t>(m.points.size());
  const meshes::Mesh other = meshes::translated(meshes::grid(20, 20), {200, 0, 0});
  m.points.insert(m.points.end(), other.points.begin(), other.points.end());
  for (auto t : other.triangles) {
    for (std::uint32_t& v : t) v += first;
    m.triangles.push_back(t);
  }
  return m;
}

// the weight of an edge between points of the plane, and min(1, E); see `Enclosed_values::stored_weight()`
std::array<Gmpq, 2> weight_in_plane(const Exact& t, const meshes::Mesh& m,
                                    Exact::edge_descriptor e) {
  Gmpq sum = 0, energy = 0;
  for (const Halfedge h : {halfedge(e, t.mesh()), opposite(halfedge(e, t.mesh()), t.mesh())}) {
    const auto point = [&](Halfedge x) {
      const auto& p = m.points[t.input_vertex(target(x, t.mesh()))];
      return std::array<Gmpq, 2>{p[0], p[1]};
    };
    const auto i = point(opposite(h, t.mesh())), j = point(h), k = point(next(h, t.mesh()));
    const Gmpq ax = i[0] - k[0], ay = i[1] - k[1], bx = j[0] - k[0], by = j[1] - k[1];
    const Gmpq x = ax - bx, y = ay - by, twice_area = ax * by - ay * bx;
    sum += (ax * bx + ay * by) / twice_area / 2;
    energy += twice_area / (x * x + y * y) / 2; // the gradient is parallel to the edge
  }
  return {sum, std::min(energy, Gmpq(1))};
}

TEST(Exact_euclidean_traits,
     weights_that_nearly_cancel_after_many_flips_are_right_beside_the_energy_of_their_faces) {
  std::size_t nearly_cancelled = 0;
  for (const double noise : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const meshes::Mesh m = nearly_square_grid(5, noise);
    Exact t(m.input());
    EXPECT_GT(IT::flip_to_delaunay(t).flips, 400U);
    // with the last tolerance again: that changes nothing
    for (const double tolerance : {0x1p-30, 0x1p-40, 0x1p-40})
      for (const auto e : edges(t.mesh())) {
        if (CGAL::is_border(e, t.mesh())) continue;
        const auto [expected, energy] = weight_in_plane(t, m, e);
        const double weight = Exact::Const_session(t).cotangent_weight(e, tolerance);
        const Gmpq error = CGAL::abs(Gmpq(weight) - expected), size = CGAL::abs(expected);
        EXPECT_LE(error, std::max(size, energy) * Gmpq(tolerance)) << noise;
        EXPECT_EQ(CGAL::sign(weight), CGAL::sign(expected)) << noise;
        if (size < Gmpq(1e-5)) ++nearly_cancelled;
      }
    EXPECT_GT(t.metric().statistics().sharpenings.count(106), 0U) << noise;
  }
  EXPECT_GT(nearly_cancelled, 100U);
}

TEST(Exact_euclidean_traits, stored_values_tell_that_cotangents_of_right_angles_are_zero) {
  std::size_t zeros = 0;
  for (const meshes::Mesh& m : {meshes::grid(9, 7), meshes::box(3, 4, 5)}) {
    const Exact t(m.input());
    const Exact::Const_session session(t);
    for (const auto e : edges(t.mesh()))
      if (!CGAL::is_border(e, t.mesh()) && session.cotangent_weight(e) == 0) ++zeros;
    EXPECT_TRUE(t.metric().statistics().sharpenings.empty());
  }
  EXPECT_GT(zeros, 100U);
}

TEST(Exact_euclidean_traits, weights_that_enclosures_do_not_tell_are_the_nearest_doubles) {
  std::size_t nearest = 0, sharpened = 0;
  for (const double noise : {1e-3, 1e-12, 1e-15}) {
    const meshes::Mesh m = nearly_square_grid(6, noise);
    Exact t(m.input());
    IT::flip_to_delaunay(t);
    const auto& sharpenings = t.metric().statistics().sharpenings;
    for (const auto e : edges(t.mesh())) {
      if (CGAL::is_border(e, t.mesh())) continue;
      const auto before = sharpenings;
      const double weight = Exact::Const_session(t).cotangent_weight(e);
      if (sharpenings == before || weight == 0) continue;
      ++sharpened;
      const Gmpq expected = weight_in_plane(t, m, e)[0];
      const Gmpq error = CGAL::abs(Gmpq(weight) - expected);
      bool is_nearest = true;
      for (const double direction : {-HUGE_VAL, HUGE_VAL})
        is_nearest =
            is_nearest && error <= CGAL::abs(Gmpq(std::nextafter(weight, direction)) - expected);
      nearest += is_nearest ? 1U : 0U;
    }
  }
  EXPECT_GT(sharpened, 100U);
  EXPECT_EQ(nearest, sharpened);
}

} // namespace
