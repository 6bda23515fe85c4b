// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/escalation.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/History_evaluator.h>

#include "gallery.h"
#include "meshes.h"
#include "random_history.h"

#include <CGAL/Gmpfi.h>
#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <utility>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpfi;
using CGAL::Gmpq;
using random_history::Map;
using random_history::Walk;

struct Interval_input {
  const IT::Input_metric* input;
  std::pair<std::array<Gmpfi, 3>, Gmpfi> operator()(std::uint32_t f) const {
    return {{Gmpfi(input->squared_length<Gmpq>(f, 0)), Gmpfi(input->squared_length<Gmpq>(f, 1)),
             Gmpfi(input->squared_length<Gmpq>(f, 2))},
            Gmpfi(input->squared_quadruple_area<Gmpq>(f)).sqrt()};
  }
};

// flat and axis-aligned: all areas are rational
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

Walk walk_on(const meshes::Mesh& m) {
  Map map = m.map();
  IT::Input_metric input = IT::Input_metric::from_points(map, m.points, 0);
  return {std::move(map), std::move(input)};
}

template <class Input, class FT>
IT::Diamond_values<FT> evaluate(const Walk& walk, Map::Halfedge h) {
  const Input input{&walk.input};
  IT::History_values<FT> memory;
  const auto faces = IT::History_evaluator<FT, Input>(walk.history, input, memory)
                         .faces({walk.side(h), walk.side(Map::opposite(h))});
  return IT::diamond_values(faces[0], faces[1]);
}

TEST(History_evaluator, reproduces_all_values_after_four_flips_exactly) {
  Walk walk = walk_on(meshes::box(2, 2, 1));
  for (const Map::Halfedge h : walk.inner_edges()) {
    if (!walk.is_convex(h)) continue;
    const auto before = evaluate<Rational_input, Gmpq>(walk, h);
    for (int i = 0; i < 4; ++i) walk.flip(h);
    const auto after = evaluate<Rational_input, Gmpq>(walk, h);
    random_history::expect_same(before, after);
  }
}

TEST(History_evaluator, gives_up_where_more_flips_are_to_be_repeated_than_it_may) {
  Walk walk = walk_on(meshes::box(2, 2, 1));
  std::mt19937 random(1);
  walk.run(60, random);
  const auto none = [](std::uint32_t) { return false; };
  std::size_t most_in_all = 0;
  for (const Map::Halfedge h : walk.inner_edges()) {
    const std::vector<IT::Flip_history::Side> sides{walk.side(h), walk.side(Map::opposite(h))};
    const std::size_t n = walk.history.ancestors(sides[0].face, sides[1].face, none).size();
    most_in_all = std::max(most_in_all, n);
    const Rational_input input{&walk.input};
    IT::History_values<Gmpq> memory;
    IT::History_evaluator<Gmpq, Rational_input> evaluator(walk.history, input, memory);
    if (n > 0) {
      EXPECT_FALSE(evaluator.diamond(sides[0], sides[1], n - 1));
      EXPECT_TRUE(memory.empty());
    }
    const auto diamond = evaluator.diamond(sides[0], sides[1], n);
    ASSERT_TRUE(diamond);
    random_history::expect_same(*diamond, evaluate<Rational_input, Gmpq>(walk, h));
    EXPECT_TRUE(evaluator.diamond(sides[0], sides[1], 0)) << "all are known by now";
  }
  EXPECT_GT(most_in_all, 5U);
}

TEST(History_evaluator, overlaps_unfolding_in_intervals_of_256_bits_after_hundreds_of_flips) {
  const IT::Gmpfi_precision precision(256);
  std::mt19937 random(1);
  Walk walk = walk_on(meshes::integer_height_field(4, 5, 3));
  for (int i = 0; i < 30; ++i) {
    walk.run(10, random);
    // some come back, so that strips stay short
    for (const Map::Halfedge h : walk.inner_edges())
      if (walk.sign(h, IT::Delaunay_expression()) == CGAL::NEGATIVE) walk.flip(h);
  }
  EXPECT_GT(walk.history.number_of_flips(), 200U);
  const Interval_input input{&walk.input};
  std::size_t compared = 0;
  for (const Map::Halfedge h : walk.inner_edges()) {
    const auto d = walk.unfolded(h);
    if (!d) continue;
    ++compared;
    const auto x = d->values<Gmpfi>(input);
    const auto y = evaluate<Interval_input, Gmpfi>(walk, h);
    EXPECT_TRUE(x.ij.do_overlap(y.ij) && x.jk.do_overlap(y.jk) && x.ki.do_overlap(y.ki) &&
                x.im.do_overlap(y.im) && x.mj.do_overlap(y.mj) && x.area_f.do_overlap(y.area_f) &&
                x.area_g.do_overlap(y.area_g));
  }
  EXPECT_GT(compared, 0U);
}

} // namespace
