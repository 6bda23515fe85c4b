// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Replayed_faces.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "gallery.h"
#include "meshes.h"
#include "places.h"
#include "random_history.h"
#include "wide_numbers.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using IT::Multiquadratic_number;
using places::Exact_input;
using random_history::Map;
using random_history::Walk;
using random_history::walk_on;
using wide_numbers::Wide;

struct Rational_input {
  const IT::Input_metric* input;
  std::pair<std::array<Gmpq, 3>, Gmpq> operator()(std::uint32_t f) const {
    const Gmpq d = input->squared_quadruple_area<Gmpq>(f);
    CGAL::Gmpz n, m;
    mpz_sqrt(n.mpz(), d.numerator().mpz());
    mpz_sqrt(m.mpz(), d.denominator().mpz());
    EXPECT_EQ(Gmpq(n, m) * Gmpq(n, m), d);
    return {{input->squared_length<Gmpq>(f, 0), input->squared_length<Gmpq>(f, 1),
             input->squared_length<Gmpq>(f, 2)},
            Gmpq(n, m)};
  }
};

template <class Input, class FT>
IT::Diamond_values<FT> evaluate(const Walk& walk, Map::Halfedge h) {
  return walk.replayed(h).values<FT>(Input{&walk.input});
}

TEST(Replayed_faces, reproduces_all_values_after_four_flips_exactly) {
  Walk walk = walk_on(meshes::box(2, 2, 1));
  for (const Map::Halfedge h : walk.inner_edges()) {
    if (!walk.is_convex(h)) continue;
    const auto before = evaluate<Rational_input, Gmpq>(walk, h);
    for (int i = 0; i < 4; ++i) walk.flip(h);
    const auto after = evaluate<Rational_input, Gmpq>(walk, h);
    random_history::expect_same(before, after);
  }
}

// whether a ball contains a number, exactly
bool contains(const IT::Ball<IT::Double_double>& ball, const Gmpq& x) {
  const double high = ball.center().to_double();
  const IT::Double_double low = ball.center() - IT::Double_double(high);
  return CGAL::abs(Gmpq(high) + Gmpq(low.to_double()) - x) <= Gmpq(ball.radius());
}

TEST(Replayed_faces, in_106_bits_have_one_radius_per_flip_which_contains_exact_values) {
  using Number = IT::Ball<IT::Double_double>;
  std::mt19937 random(4);
  std::size_t flips = 0, values = 0;
  double widest = 0;
  for (const meshes::Mesh& m :
       {meshes::box(3, 2, 2), meshes::sheared_grid(6, 6, 4), meshes::stairs(4, 3)}) {
    Walk walk = walk_on(m);
    IT::Input_face_intervals<Number> memory;
    const auto input = memory.of(walk.input);
    for (int round = 0; round < 4; ++round) {
      walk.run(1000, random);
      for (const Map::Halfedge h : walk.inner_edges()) {
        const auto x = walk.replayed(h).values<Number>(input);
        const auto y = evaluate<Rational_input, Gmpq>(walk, h);
        using Pair = std::pair<Number, Gmpq>;
        for (const auto& [ball, exact] :
             {Pair(x.ij, y.ij), Pair(x.jk, y.jk), Pair(x.ki, y.ki), Pair(x.im, y.im),
              Pair(x.mj, y.mj), Pair(x.area_f, y.area_f), Pair(x.area_g, y.area_g)}) {
          if (!(ball.radius() < 0x1p100)) continue; // too many flips for 106 bits
          EXPECT_TRUE(contains(ball, exact));
          widest = std::max(widest, ball.radius() / ball.to_double());
          ++values;
        }
        if (y.area_f == 0 || y.area_g == 0) continue;
        const Number weight = IT::weight_in_106_bits(x), step_by_step = IT::cotangent_weight(x);
        if (!(step_by_step.radius() < 0x1p100)) continue;
        EXPECT_TRUE(contains(weight, IT::cotangent_weight(y)));
        EXPECT_LE(weight.radius(), 16 * step_by_step.radius()); // it decides as many
      }
    }
    flips += walk.flips.size();
  }
  EXPECT_GT(flips, 2000U);
  EXPECT_GT(values, 5000U);
  EXPECT_GT(widest, 0x1p-80); // flips have made some wide
}

// Values in 106 bits follow flips while rounding is upwards.
TEST(Replayed_faces, in_106_bits_contain_exact_values_whatever_the_rounding) {
  using Number = IT::Ball<IT::Double_double>;
  using Function = std::function<IT::Flipped_values<Number>(const IT::Diamond_values<Number>&)>;
  const Function flip = [](const auto& d) { // a call stays where rounding is upwards
    return IT::flipped(d, 4 * IT::Double_double::rounding());
  };
  std::mt19937 random(29);
  std::uniform_real_distribution<double> size(0.1, 1);
  double widest = 0;
  for (int n = 0; n < 300; ++n) {
    const std::array<double, 7> x{size(random), size(random), size(random), size(random),
                                  size(random), size(random), size(random)};
    IT::Diamond_values<Number> d{x[0], x[1], x[2], x[3], x[4], x[5], x[6]};
    IT::Diamond_values<Gmpq> e{x[0], x[1], x[2], x[3], x[4], x[5], x[6]};
    for (int i = 0; i < 4; ++i) {
      IT::Flipped_values<Number> f;
      {
        const CGAL::Protect_FPU_rounding<true> upwards;
        f = flip(d);
      }
      const IT::Flipped_values<Gmpq> g = IT::flipped(e);
      for (const auto& [ball, exact] :
           {std::pair(f.km, g.km), std::pair(f.area_f, g.area_f), std::pair(f.area_g, g.area_g)})
        EXPECT_TRUE(contains(ball, exact));
      widest = std::max(widest, f.km.radius() / f.km.to_double());
      d.jk = f.km; // the terms of the next one differ in size
      e.jk = g.km;
    }
  }
  EXPECT_LT(widest, 0x1p-85);
}

TEST(Replayed_faces, overlaps_unfolding_in_balls_of_256_bits_after_hundreds_of_flips) {
  std::mt19937 random(1);
  Walk walk = walk_on(meshes::integer_height_field(4, 5, 3));
  for (int i = 0; i < 30; ++i) {
    walk.run(10, random);
    // some come back, so that strips stay short
    for (const Map::Halfedge h : walk.inner_edges())
      if (walk.sign(h, IT::Delaunay_expression()) == CGAL::NEGATIVE) walk.flip(h);
  }
  EXPECT_GT(walk.flips.size(), 200U);
  IT::Input_face_intervals<Wide> memory;
  const auto input = memory.of(walk.input);
  std::size_t compared = 0;
  for (const Map::Halfedge h : walk.inner_edges()) {
    const auto d = walk.unfolded(h);
    if (!d) continue;
    ++compared;
    const auto x = d->values<Wide>(input);
    const auto y = walk.replayed(h).values<Wide>(input);
    for (const Wide& rest : {x.ij - y.ij, x.jk - y.jk, x.ki - y.ki, x.im - y.im, x.mj - y.mj,
                             x.area_f - y.area_f, x.area_g - y.area_g})
      EXPECT_TRUE(wide_numbers::may_be_zero(rest));
  }
  EXPECT_GT(compared, 0U);
}

std::size_t check_all_edges(const Walk& walk) {
  std::size_t checked = 0;
  for (const Map::Halfedge h : walk.inner_edges()) {
    const std::optional<IT::Unfolded_diamond> d = walk.unfolded(h);
    if (!d || d->triangles.size() > 40) continue;
    const Exact_input input(walk.input);
    random_history::expect_same(d->values<Multiquadratic_number>(input),
                                walk.replayed(h).values<Multiquadratic_number>(input));
    ++checked;
  }
  return checked;
}

TEST(Replayed_faces, agrees_exactly_with_unfolding_on_a_box) {
  std::mt19937 random(1);
  Walk walk = walk_on(meshes::box(2, 2, 2));
  for (int round = 0; round < 5; ++round) {
    walk.run(20, random);
    EXPECT_EQ(check_all_edges(walk), walk.inner_edges().size());
  }
  EXPECT_GT(walk.flips.size(), 30U);
}

TEST(Replayed_faces, agrees_exactly_with_unfolding_where_every_face_has_its_own_square_class) {
  std::mt19937 random(2);
  Walk walk = walk_on(meshes::integer_height_field(3, 3, 5));
  for (int round = 0; round < 3; ++round) {
    walk.run(8, random);
    EXPECT_GT(check_all_edges(walk), 0U);
  }
}

TEST(Replayed_faces, agrees_exactly_with_unfolding_on_Delta_complexes) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    std::mt19937 random(3);
    Walk walk = walk_on(s);
    for (int round = 0; round < 4; ++round) {
      walk.run(4, random);
      check_all_edges(walk);
    }
  }
}

TEST(Replayed_faces, and_unfolding_give_the_input_triangles_back_after_four_flips) {
  Walk walk = walk_on(meshes::box(1, 1, 1));
  for (const Map::Halfedge h : walk.inner_edges()) {
    if (!walk.is_convex(h)) continue;
    for (int i = 0; i < 4; ++i) walk.flip(h);
    const auto d = walk.unfolded(h);
    ASSERT_TRUE(d);
    EXPECT_EQ(d->triangles.size(), 2U);
    EXPECT_EQ(check_all_edges(walk), walk.inner_edges().size());
  }
}

// Two triangles with the lattice vectors (F_n+1, F_n) and (F_n, F_n-1) of the Fibonacci numbers: after n flips they are a square.
// The last edges cross F_n of the first ones.
template <class Correspondence>
void expect_square(unsigned n) {
  using T = IT::Intrinsic_triangulation<Map, IT::Exact_euclidean_traits, Correspondence>;
  double a = 1, b = 1;
  for (unsigned i = 1; i < n; ++i) a = std::exchange(b, a + b);
  const auto square = [](double x, double y) { return x * x + y * y; };
  T t(IT::Intrinsic_input(Map(gallery::one_vertex_torus().gluing),
                          std::vector<double>{square(b, a), square(a, b - a), square(a + b, b)}));
  const auto result = IT::flip_to_delaunay(t);
  EXPECT_EQ(result.status, IT::Status::done);
  EXPECT_EQ(result.flips, n);
  const auto report = IT::check_delaunay(t);
  EXPECT_EQ(report.non_delaunay_edges, 0U);
  EXPECT_EQ(report.cocircular_edges.size(), 1U); // a diagonal of the square
  EXPECT_EQ(t.metric().statistics().probable_zero, 0U);
  EXPECT_NEAR(t.squared_length(report.cocircular_edges.front()), 2, 1e-12);
}

TEST(Replayed_faces, decide_where_flips_are_few_and_crossings_millions) {
  for (unsigned n = 8; n <= 36; ++n) {
    SCOPED_TRACE(n);
    expect_square<IT::No_correspondence>(n);
    expect_square<IT::Integer_coordinates>(n);
    expect_square<IT::Signposts>(n);
    if (n <= 24) expect_square<IT::Explicit_crossings>(n); // which stores them one by one
  }
}

} // namespace
