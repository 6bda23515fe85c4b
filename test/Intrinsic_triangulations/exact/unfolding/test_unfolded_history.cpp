// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/unfolding/History_evaluator.h>

#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>

#include "gallery.h"
#include "meshes.h"
#include "places.h"
#include "random_history.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using IT::Multiquadratic_number;
using places::Exact_input;
using random_history::Map;
using random_history::Walk;

// what unfolding gives against what repeating the flips gives
std::size_t check_all_edges(const Walk& walk) {
  std::size_t checked = 0;
  for (const Map::Halfedge h : walk.inner_edges()) {
    const auto l = walk.side(h), r = walk.side(Map::opposite(h));
    const std::optional<IT::Unfolded_diamond> d = walk.unfolded(h);
    if (!d || d->triangles.size() > 40) continue;
    const Exact_input input(walk.input);
    IT::History_values<Multiquadratic_number> memory;
    IT::History_evaluator<Multiquadratic_number, Exact_input> flips(walk.history, input, memory);
    const auto faces = flips.faces({l, r});
    random_history::expect_same(d->values<Multiquadratic_number>(input),
                                IT::diamond_values(faces[0], faces[1]));
    ++checked;
  }
  return checked;
}

Walk walk_on(const meshes::Mesh& m) {
  Map map = m.map();
  IT::Input_metric input = IT::Input_metric::from_points(map, m.points, 0);
  return {std::move(map), std::move(input)};
}

TEST(History_evaluator, agrees_exactly_with_unfolding_on_a_box) {
  std::mt19937 random(1);
  Walk walk = walk_on(meshes::box(2, 2, 2));
  for (int round = 0; round < 5; ++round) {
    walk.run(20, random);
    EXPECT_EQ(check_all_edges(walk), walk.inner_edges().size());
  }
  EXPECT_GT(walk.history.number_of_flips(), 30U);
}

TEST(History_evaluator, agrees_exactly_with_unfolding_where_every_face_has_its_own_square_class) {
  std::mt19937 random(2);
  Walk walk = walk_on(meshes::integer_height_field(3, 3, 5));
  for (int round = 0; round < 3; ++round) {
    walk.run(8, random);
    EXPECT_GT(check_all_edges(walk), 0U);
  }
}

TEST(History_evaluator, agrees_exactly_with_unfolding_on_Delta_complexes) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    std::mt19937 random(3);
    Map map(s.gluing);
    std::vector<double> lengths = gallery::squared_lengths(s);
    IT::Input_metric input = IT::Input_metric::from_squared_lengths(map, std::move(lengths), 0);
    Walk walk(std::move(map), std::move(input));
    for (int round = 0; round < 4; ++round) {
      walk.run(4, random);
      check_all_edges(walk);
    }
  }
}

TEST(History_evaluator, and_unfolding_give_the_input_triangles_back_after_four_flips) {
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

} // namespace
